"""A bank of scenes with episodes drawn for them, made here or in the background."""

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
"""Scenes that are drawn from a source that makes them, unless said otherwise."""


@dataclass(frozen=True)
class DeckConfig:
    """How many scenes and episodes there are, and of what size.

    Args:
        scenes: how many scenes are drawn from a source that makes them; None for ``SCENES``, and
            for all of fixed ones.
        episodes: how many episodes of each scene are drawn.
        max_parts: convex parts of an object beyond that number are merged; None for none.
        seed: of all draws.
        workers: processes that make fresh scenes; the deck does not depend on them.
        ray: address of a Ray cluster whose processes these are, None for this machine.

    Raises:
        InputError: a number out of range.
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
                require_number(f"DeckConfig needs {name}", count, minimum=1, integer=True)
        require_number(
            "DeckConfig needs workers", self.workers, minimum=1, maximum=1024, integer=True
        )
        require_seed(self.seed)


@dataclass(frozen=True, eq=False)
class Deck:
    """A bank, and the episodes of each world that it was made of.

    ``idle`` are the scenes that offer nothing to do; those that the bank left out it names itself.
    """

    bank: SceneBank
    episodes: list[list[DrawnEpisode]]
    idle: tuple[LeftOut, ...]


@dataclass(frozen=True, eq=False)
class DeckPlan:
    """What decks are made of: see ``TabletopBatchEnv``, whose arguments these are.

    Raises:
        InputError: a setting is wrong, or not for batches.
    """

    scenes: SceneChoice
    task: Task
    settings: Mapping[str, Any]
    max_objects: int
    config: DeckConfig

    def __post_init__(self) -> None:
        config = read_settings(self.settings)
        if config.render.mode is not None:
            raise InputError("A batch does not render; leave render_mode out.")
        chosen = randomization.resolve(config.randomization)
        if on := [switch for switch in SWITCHES if switch != "start" and chosen.is_on(switch)]:
            raise InputError(
                f"A batch randomises the start alone (randomization='starts'), not {', '.join(on)}."
            )
        check_core(config, "A batch", ("state", "goal", "pixels", "pixels+state"))
        if self.draws:
            _check_views(config.observation)

    @property
    def draws(self) -> bool:
        """Whether observations have pictures."""
        return read_settings(self.settings).observation.mode.startswith("pixels")

    def make(self, seed: int, shape: UnionShape | None = None) -> Deck:
        """Draw scenes and episodes; ``shape`` is the room that scenes have to fit into.

        Raises:
            InputError: no scene is left.
            BundleError: no bundle fits, or one is damaged.
            BackendError: no Ray.
            SceneError: a fresh scene cannot be made, or a process has ended abruptly.
        """
        seen = {"observation", *(f.name for f in fields(ObservationConfig))}  # not looked at here
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
        """Yield fixed scenes, or as many as are wanted that are drawn.

        Those of a curriculum come from its source: which are played next is the batch's choice.
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
    """A deck that a process of its own makes.

    Args:
        plan: of what.
        seed: of its draws.
        shape: the room that its scenes have to fit into.
    """

    def __init__(self, plan: DeckPlan, seed: int, shape: UnionShape) -> None:
        self._pool = WorkerPool(1)
        self._made: Future[Deck] = self._pool.submit(DeckPlan.make, plan, seed, shape)

    @property
    def ready(self) -> bool:
        """Whether it is made, or has failed."""
        return self._made.done()

    def result(self) -> Deck:
        """Return the deck, once it is made; the process ends.

        Raises:
            SceneError: the process has ended abruptly.
            InputError, BundleError: as ``DeckPlan.make``.
        """
        try:
            return self._made.result()
        finally:
            self.close()

    def close(self) -> None:
        """End the process, whether it is done or not."""
        self._pool.close()


def _check_views(views: ObservationConfig) -> None:
    """Check that a batch can draw what is asked for."""
    if tuple(views.kinds) != ("rgb",):
        raise InputError("A batch's pictures have colours alone; leave kinds out, or ['rgb'].")
    if len(set(views.sizes.values())) > 1:
        raise InputError("A batch's pictures are all of one size; give image_size one number.")
    if views.instruction != "none" or views.target_mark != "none" or views.calibration:
        raise InputError(
            "A batch shows neither instructions nor marks nor calibrations; leave instruction, "
            "target_mark and calibration out."
        )
