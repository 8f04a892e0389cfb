"""Decks, each a bank of scenes with drawn episodes, built in this process or in a separate one."""

from __future__ import annotations

from collections.abc import Generator, Mapping
from concurrent.futures import Future
from contextlib import closing
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from generator.errors import InputError, require_number, require_seed
from generator.jobs.workers import WorkerPool

from ...env import TabletopEnv
from ...randomization import settings as randomization
from ...randomization.settings import SWITCHES
from ...scenes import CurriculumScenes, FixedScenes, FreshScenes, SceneChoice, SceneRef, resolve
from ...scenes.production.ahead import make_ahead
from ...scenes.source import close
from ...settings import ObservationConfig, read_settings
from ...settings.core_limits import check_core
from ...tasks.task import Task
from .bank import LeftOut, SceneBank
from .episodes import DrawnEpisode, EpisodeDraw
from .union.shape import UnionShape
from .union.simplification import MOST_PARTS

SCENES = 64
"""Default number of scenes drawn from a source that generates them."""


@dataclass(frozen=True)
class DeckConfig:
    """The numbers of scenes and episodes of a deck, and limits on its scenes.

    Args:
        scenes: number of scenes drawn from a source that generates them; None for ``SCENES``, or
            for all scenes of a fixed source.
        episodes: number of episodes drawn per scene.
        max_parts: maximum number of convex parts per object; further parts are merged. None for no
            limit.
        seed: seed of all draws.
        workers: number of processes that generate fresh scenes; the deck does not depend on it.
        ray: address of a Ray cluster for these processes, None for this machine.

    Raises:
        InputError: a number is out of range.
    """

    scenes: int | None = None
    episodes: int = 8
    max_parts: int | None = MOST_PARTS
    seed: int = 0
    workers: int = 1
    ray: str | None = None

    def __post_init__(self) -> None:
        for name in ("scenes", "episodes", "max_parts"):
            count = getattr(self, name)
            if count is not None or name == "episodes":
                require_number(f"DeckConfig.{name}", count, minimum=1, integer=True)
        require_number("DeckConfig.workers", self.workers, minimum=1, maximum=1024, integer=True)
        require_seed(self.seed)


@dataclass(frozen=True, eq=False)
class Deck:
    """A bank of scenes, and the episodes drawn for each source world.

    ``idle`` lists the scenes without a valid task; ``bank.left_out`` lists the scenes excluded from
    the bank.
    """

    bank: SceneBank
    episodes: list[list[DrawnEpisode]]
    idle: tuple[LeftOut, ...]


@dataclass(frozen=True, eq=False)
class DeckPlan:
    """Settings of decks; see ``TabletopBatchEnv``, which has the same arguments.

    Raises:
        InputError: a setting is invalid, or not available for batches.
    """

    scenes: SceneChoice
    task: Task
    settings: Mapping[str, Any]
    max_objects: int
    config: DeckConfig

    def __post_init__(self) -> None:
        config = read_settings(self.settings)
        if config.render.mode is not None:
            raise InputError("A batch cannot render; remove render_mode.")
        chosen = randomization.resolve(config.randomization)
        if on := [switch for switch in SWITCHES if switch != "start" and chosen.is_on(switch)]:
            raise InputError(f"A batch supports only randomization='starts', not {', '.join(on)}.")
        check_core(config, "A batch", ("state", "goal", "pixels", "pixels+state"))
        if self.draws:
            _check_views(config.observation)

    @property
    def draws(self) -> bool:
        """Whether observations include pictures."""
        return read_settings(self.settings).observation.mode.startswith("pixels")

    def make(self, seed: int, shape: UnionShape | None = None) -> Deck:
        """Build a deck of drawn scenes and episodes; the scenes must fit ``shape`` if it is given.

        Raises:
            InputError: no scene is left.
            BundleError: no bundle matches, or one is damaged.
            BackendError: Ray is not available.
            SceneError: a fresh scene cannot be generated, or a process ended unexpectedly.
        """
        # observations are not used here
        seen = {"observation", *(f.name for f in fields(ObservationConfig))}
        settings = {name: value for name, value in self.settings.items() if name not in seen}
        env = TabletopEnv(task=self.task, scenes=self.task.scenes, **settings)
        draw = EpisodeDraw(env, self.config.episodes, seed)
        try:
            with closing(self._refs(seed)) as refs:
                bank = SceneBank(
                    draw.worlds(refs), max_objects=self.max_objects,
                    max_parts=self.config.max_parts, shape=shape,
                    robot=read_settings(self.settings).worlds.arm, pictures=self.draws,
                )  # fmt: skip
        except InputError as error:
            raise draw.explain(error) from error
        finally:
            env.close()
        return Deck(bank, draw.episodes, tuple(draw.left_out))

    def _refs(self, seed: int) -> Generator[SceneRef, None, None]:
        """Yield all scenes of a fixed source, or the requested number of drawn scenes.

        The scenes of a curriculum come from its source; the batch chooses which of them to play
        next.
        """
        source, config = resolve(self.scenes, self.task.needs, self.task.scenes), self.config
        drawing = source.scenes if isinstance(source, CurriculumScenes) else source
        try:
            if isinstance(drawing, FixedScenes) and config.scenes is None:
                yield from drawing.refs
                return
            rng = np.random.default_rng((seed, 8))
            refs = [drawing.draw(rng) for _ in range(config.scenes or SCENES)]
            if isinstance(drawing, FreshScenes) and (config.workers > 1 or config.ray):
                yield from make_ahead(refs, config.workers, config.ray)
            else:
                yield from refs
        finally:
            if source is not self.scenes:
                close(source)


class DeckOrder:
    """A deck being built in a separate process.

    Args:
        plan: settings of the deck.
        seed: seed of its draws.
        shape: the shape that its scenes must fit.
    """

    def __init__(self, plan: DeckPlan, seed: int, shape: UnionShape) -> None:
        self._pool = WorkerPool(1)
        self._made: Future[Deck] = self._pool.submit(DeckPlan.make, plan, seed, shape)

    @property
    def ready(self) -> bool:
        """Whether the deck is complete, or has failed."""
        return self._made.done()

    def result(self) -> Deck:
        """Wait for the deck, end the process and return the deck.

        Raises:
            SceneError: the process ended unexpectedly.
            InputError, BundleError: as ``DeckPlan.make``.
        """
        try:
            return self._made.result()
        finally:
            self.close()

    def close(self) -> None:
        """End the process, even if the deck is incomplete."""
        self._pool.close()


def _check_views(views: ObservationConfig) -> None:
    """Check that a batch can render the requested observations."""
    if tuple(views.kinds) != ("rgb",):
        raise InputError("A batch's pictures are RGB only; remove kinds, or set it to ['rgb'].")
    if len(set(views.sizes.values())) > 1:
        raise InputError("A batch's pictures all have the same size; set image_size to one number.")
    if views.instruction != "none" or views.target_mark != "none" or views.calibration:
        raise InputError(
            "A batch does not support instructions, target marks or calibrations; remove "
            "instruction, target_mark and calibration."
        )
