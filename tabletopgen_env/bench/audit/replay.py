"""Replay of a result's episodes from their seeds, and comparison with the listed outcomes."""

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
"""Tolerance of the mean reward of an episode."""


@dataclass(frozen=True)
class EpisodeReplay:
    """The listed and replayed outcomes of an episode; ``number`` is the episode's index."""

    number: int
    listed: EpisodeRow
    played: EpisodeRow

    @property
    def agrees(self) -> bool:
        """Whether the listed and replayed outcomes agree in success, number of steps and reward.

        Rewards agree within ``REWARD``, since processors differ in the last digits of the mean.
        """
        near = abs(self.listed.reward - self.played.reward) <= REWARD
        return near and replace(self.played, reward=self.listed.reward) == self.listed


def draw_places(count: int, result: BenchResult, seed: int) -> tuple[int, ...]:
    """Draw the indices of ``count`` random episodes, or of all episodes if there are fewer.

    Raises:
        InputError: ``count`` is less than one.
    """
    require_number("--episodes", count, minimum=1, integer=True)
    total = len(result.episodes)
    drawn = np.random.default_rng(seed).choice(total, min(count, total), replace=False)
    return tuple(sorted(map(int, drawn)))


def player_of(result: BenchResult, suite: Suite, player: str | None) -> str:
    """Return the name of the player for a replay, by default the one named in the result.

    Raises:
        InputError: the result names no player, or ``player`` differs from the one it names.
    """
    listed = result.player
    name = player or (listed.kind if listed.kind in SIMPLE else listed.name)
    try:
        facts, _ = find_player(name, suite)
    except InputError as error:
        if player is not None:
            raise
        raise InputError(
            f"The result's policy {listed.name!r} was not found: {error} Pass its file or "
            "function with --policy."
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
    """Replay a result's episodes with the given indices, and yield each replay.

    Raises:
        InputError: the player does not exist.
        SceneError: a table is generated differently here.
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
    """Check that a player matches the player of a result in everything but the name."""
    other = [
        part for part in ("kind", "digest", "settings")
        if getattr(facts, part) != getattr(listed, part)
    ]  # fmt: skip
    if other:
        raise InputError(
            f"{name} is not the policy of the result of {listed.name} (different "
            f"{', '.join(other)}). Pass the original policy with --policy."
        )
