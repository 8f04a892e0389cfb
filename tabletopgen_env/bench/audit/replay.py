"""Episodes of a result played again from their seeds, and compared with what it says."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from generator.errors import InputError, require_number
from generator.jobs.pools import PoolOptions

from ..episode import Playing, stage_of
from ..instances import Suite
from ..players import SIMPLE, PlayerFacts, find_player
from ..results import BenchResult, EpisodeRow, row_of
from ..tables import make_tables

REWARD = 1e-4
"""How far two mean rewards of one episode may differ."""


@dataclass(frozen=True)
class EpisodeReplay:
    """An episode as a result lists it, and as it was played again; ``number`` is its place."""

    number: int
    listed: EpisodeRow
    played: EpisodeRow

    @property
    def agrees(self) -> bool:
        """Whether both are the same: solved or not, after as many steps, with the same reward.

        Processors differ in the last digits of mean rewards, so these agree within ``REWARD``.
        """
        near = abs(self.listed.reward - self.played.reward) <= REWARD
        return near and replace(self.played, reward=self.listed.reward) == self.listed


def draw_places(count: int, result: BenchResult, seed: int) -> tuple[int, ...]:
    """Return the places of ``count`` episodes drawn by a seed; of all, if there are fewer.

    Raises:
        InputError: less than one.
    """
    require_number("A check needs --episodes", count, minimum=1, integer=True)
    total = len(result.episodes)
    drawn = np.random.default_rng(seed).choice(total, min(count, total), replace=False)
    return tuple(sorted(map(int, drawn)))


def player_of(result: BenchResult, suite: Suite, player: str | None) -> str:
    """Return who plays a result's episodes again: ``player``, or who the result names.

    Raises:
        InputError: the result does not say who, or ``player`` is another one than it says.
    """
    listed = result.player
    name = player or (listed.kind if listed.kind in SIMPLE else listed.name)
    try:
        facts, _ = find_player(name, suite)
    except InputError as error:
        if player is not None:
            raise
        raise InputError(
            f"The result names its policy {listed.name!r}, which is not found here ({error}) Name "
            "the file or the function with --policy."
        ) from error
    _check_same(facts, listed, name)
    return name


def replay(
    result: BenchResult,
    suite: Suite,
    player: str,
    numbers: tuple[int, ...],
    tables: Path | None = None,
    pool: PoolOptions = PoolOptions(),  # noqa: B008
) -> Iterator[EpisodeReplay]:
    """Play the episodes at some places of a result again, and yield each.

    Raises:
        InputError: no such player.
        SceneError: a table is made here as another one.
        BundleError: a table is damaged.
    """
    episodes = suite.episodes()
    needed = {episodes[k].table.digest for k in numbers}
    listed = [table for table in suite.tables if table.digest in needed]
    with closing(make_tables(suite.of, listed, tables, pool)) as made:
        bundles = {t.digest: path.resolve() for t, path in zip(listed, made, strict=True)}
    stage = stage_of(Playing(suite, player, bundles))
    with closing(stage.env):
        for k in numbers:
            played = row_of(episodes[k], stage.play(episodes[k]))
            yield EpisodeReplay(k, result.episodes[k], played)


def _check_same(facts: PlayerFacts, listed: PlayerFacts, name: str) -> None:
    """Check that a player is the one of a result, whatever it is called there."""
    other = [
        part for part in ("kind", "digest", "settings")
        if getattr(facts, part) != getattr(listed, part)
    ]  # fmt: skip
    if other:
        raise InputError(
            f"{name} is not the policy of the result of {listed.name} (other {', '.join(other)}). "
            "Name the one that played it with --policy."
        )
