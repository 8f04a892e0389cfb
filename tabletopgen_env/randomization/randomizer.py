"""Randomisation of worlds at each reset, and of readings and actions at each step."""

from __future__ import annotations

import zlib
from collections import deque
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, Any
from weakref import WeakKeyDictionary

import numpy as np
from jaxtyping import Float

from ..goals.goal import begin_goals, named_by
from ..observations.bounds import Noise
from ..rendering.views import SLOTS
from ..tasks.task import Episode
from ..tasks.task import episode as begin
from . import arrangement, dynamics, looks, start
from .originals import Originals
from .settings import SWITCHES, Randomization, resolve

if TYPE_CHECKING:
    from ..world.world import World

    Draw = Callable[[Randomization, World, np.random.Generator], dict[str, Any]]
    Apply = Callable[[World, dict[str, Any]], None]

_MODEL: Mapping[str, tuple[Draw, Apply]] = MappingProxyType(
    {
        "lights": (looks.draw_lights, looks.apply_lights),
        "cameras": (looks.draw_cameras, looks.apply_cameras),
        "colors": (looks.draw_colors, looks.apply_colors),
        "mass": (dynamics.draw_mass, dynamics.apply_mass),
        "friction": (dynamics.draw_friction, dynamics.apply_friction),
        "gains": (dynamics.draw_gains, dynamics.apply_gains),
        "table": (dynamics.draw_table, dynamics.apply_table),
    }
)  # functions of a switch: draw values for a world, and write them to it


class Randomizer:
    """A randomizer of one environment's worlds, given a ``Randomization`` or a preset's name.

    Each episode calls ``restart``, ``begin`` for each world that is tried (instead of
    ``World.reset``), and ``finish`` after the task is drawn. A copy starts without worlds.
    """

    def __init__(self, choice: Randomization | str | None) -> None:
        self.settings = settings = resolve(choice)
        self._on = frozenset(switch for switch in SWITCHES if settings.is_on(switch))
        self._originals: WeakKeyDictionary[World, Originals] = WeakKeyDictionary()
        self._seed = 0
        self._drawn: dict[str, Any] = {}
        self._late: deque[Float[np.ndarray, "a"]] = deque()
        self._delay = 0
        self._noise = np.random.default_rng(0)

    @property
    def drawn(self) -> dict[str, Any]:
        """The values drawn in this episode, keyed by switch, as plain numbers, lists and dicts."""
        return self._drawn

    @property
    def rearranged(self) -> bool:
        """Whether objects are displaced from their original poses in this episode."""
        return bool(self._drawn.get("poses", {}).get("moved"))

    def restart(self, rng: np.random.Generator) -> None:
        """Derive a new random stream from ``rng`` without advancing it."""
        if self._on:
            self._seed = int(rng.spawn(1)[0].integers(2**63))

    def begin(self, world: World) -> None:
        """Revert the previous randomisation of a world, draw a new one, and reset the world."""
        import mujoco

        self._drawn, self._late = {}, deque()
        if not self._on:
            world.reset()
            return
        if world not in self._originals:
            self._originals[world] = Originals.of(world)
        self.restore(world)
        if "poses" in self._on:
            self._pose(world)
        for switch, (draw, apply) in _MODEL.items():
            if switch in self._on:
                self._drawn[switch] = draw(self.settings, world, self._stream(switch))
                apply(world, self._drawn[switch])
        mujoco.mj_setConst(world.model, world.data)  # values derived from masses and poses
        if "delay" in self._on:
            self._delay = int(self._stream("delay").integers(self.settings.delay + 1))
            self._drawn["delay"] = {"steps": self._delay}
        if "noise" in self._on:
            self._noise = self._stream("noise")
            self._drawn["noise"] = {k: getattr(self.settings, k) for k in SWITCHES["noise"]}
        world.reset()

    def __getstate__(self) -> dict[str, Any]:
        return {k: v for k, v in self.__dict__.items() if k != "_originals"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state, _originals=WeakKeyDictionary())

    def finish(self, world: World, episode: Episode) -> Episode:
        """Perturb the start and remove distractors; return the episode adapted to the new start."""
        if "start" in self._on:
            self._drawn["start"] = start.start_off(
                world, episode.goals, self.settings, self._stream("start")
            )
            episode = begin(world, begin_goals(world, episode.goals))
        if "distractors" in self._on:
            drawn = arrangement.draw_distractors(self.settings, world, self._stream("distractors"))
            keep = named_by(episode.goals)
            gone = arrangement.leaving(arrangement.bundles(world), keep, **drawn)
            arrangement.take_away(world, gone)
            self._drawn["distractors"] = {"most": drawn["most"], "absent": list(gone)}
        return episode

    def restore(self, world: World) -> None:
        """Restore the compiled model of a world; ``World.reset`` then restores its state."""
        if world in self._originals:
            self._originals[world].restore(world)

    def delay(self, action: Float[np.ndarray, "a"]) -> Float[np.ndarray, "a"] | None:
        """Store ``action``; return the one that is due, or None until the delay has elapsed."""
        if "delay" not in self._on:
            return action
        self._late.append(action)
        return self._late.popleft() if len(self._late) > self._delay else None

    def noise(self) -> Noise | None:
        """Return the noise of the next observation, or None if noise is off."""
        if "noise" not in self._on:
            return None
        draw, settings = self._noise.standard_normal, self.settings
        return Noise(
            joints=settings.joint_noise * draw(7),
            positions=settings.position_noise * draw((SLOTS, 3)),
            turns=settings.rotation_noise * draw((SLOTS, 3)),
        )

    def _pose(self, world: World) -> None:
        """Draw new poses of objects, and apply those that are unobstructed and at rest."""
        world.reset()
        drawn = arrangement.draw_poses(self.settings, world, self._stream("poses"))
        stayed = arrangement.apply_poses(world, drawn)
        moved = {name: move for name, move in drawn.items() if name not in stayed}
        self._drawn["poses"] = {"moved": moved, "stayed": stayed}

    def _stream(self, switch: str) -> np.random.Generator:
        """Return the random stream of a switch for this episode."""
        return np.random.default_rng([self._seed, zlib.crc32(switch.encode())])
