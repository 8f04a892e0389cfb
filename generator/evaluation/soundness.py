"""Physical soundness of a scene: objects that move, turn, float or hang over the edge (Sec. 4.1).

The rule is that of the gate which published scenes have passed. Here it is evaluated for each
object of any scene, and can be varied (``VARIANTS``), since a scene may satisfy the plain rule only
by chance: for one time step, or only if gravity is exactly vertical.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

import numpy as np

from ..errors import InputError
from ..geometry import inside_margin
from ..physics.gate import find_fallen
from ..physics.simulation import Simulation, find_supported, shift_distances, turn_angles
from ..scene import Scene


@dataclass(frozen=True)
class StillnessRule:
    """Criteria for standing still; lengths are in metres, angles in radians, and times in seconds.

    Attributes:
        seconds: simulated duration.
        drift, tilt: maximum displacement and rotation of an object in that time.
        gap: an object floats if it has no support within this distance.
        timestep: time step of the simulation; None means the scene's own (2 ms).
        lean, toward: angle by which gravity is tilted, and the direction towards which it is tilted
            (0 is +x, counter-clockwise).
    """

    seconds: float = 5.0
    drift: float = 5e-3
    tilt: float = float(np.deg2rad(2.0))
    gap: float = 1e-3
    timestep: float | None = None
    lean: float = 0.0
    toward: float = 0.0

    def __post_init__(self) -> None:
        positive = (self.seconds, self.drift, self.tilt, self.gap)
        if not (np.isfinite([*positive, self.lean, self.toward]).all() and min(positive) > 0):
            raise InputError(
                f"A soundness rule must have finite angles and positive limits, got {self}."
            )
        if self.timestep is not None and not 1e-5 <= self.timestep <= 0.01:
            raise InputError(
                "The timestep of a soundness rule must be in [1e-5, 0.01] s, got "
                f"{self.timestep!r}."
            )
        if not 0 <= self.lean < np.pi / 4:
            raise InputError(
                f"Gravity must be tilted by 0 to 45 degrees, got {np.rad2deg(self.lean):g}."
            )


PLAIN = StillnessRule()
"""The plain rule: an object may move by at most 5 mm and turn by at most 2 degrees in 5 s."""

VARIANTS: Mapping[str, StillnessRule] = MappingProxyType(
    {"plain": PLAIN}
    | {f"timestep {k} ms": replace(PLAIN, timestep=1e-3 * k) for k in (1, 2, 3, 4)}
    | {
        f"leaning to {way}": replace(PLAIN, lean=float(np.deg2rad(2.0)), toward=k * np.pi / 2)
        for k, way in enumerate(("+x", "+y", "-x", "-y"))
    }
)
"""The plain rule, and variants with other time steps or with gravity tilted by 2 degrees.

Gravity is tilted towards each of four sides. Round objects must also remain still: their rolling
resistance (``physics.mjcf.FLAT_SPOT``) keeps them in place on slopes of up to about six degrees.
"""


@dataclass(frozen=True)
class Behaviour:
    """The behaviour of one object in a simulation, measured in metres and radians.

    ``floats``: nothing supports it at the start. ``off_table``: at the start, its centre of mass is
    outside the outline of the tabletop. ``falls``: it has left the table by the end.
    """

    name: str
    drift: float
    turn: float
    floats: bool
    off_table: bool
    falls: bool


@dataclass(frozen=True)
class Soundness:
    """The behaviour of all objects in a scene under ``rule``, in the scene's order.

    ``diverged``: the simulation diverged and was reset, so that its values are meaningless and no
    object counts as standing still.
    """

    rule: StillnessRule
    objects: tuple[Behaviour, ...]
    diverged: bool = False

    @property
    def unstable(self) -> tuple[str, ...]:
        """The names of the objects that move or turn more than the rule allows, or that fall."""
        return tuple(o.name for o in self.objects if self.moves(o))

    @property
    def floating(self) -> tuple[str, ...]:
        """The names of the objects that float."""
        return tuple(o.name for o in self.objects if o.floats)

    @property
    def off_table(self) -> tuple[str, ...]:
        """The names of the objects that hang over the edge."""
        return tuple(o.name for o in self.objects if o.off_table)

    @property
    def stable(self) -> bool:
        """Whether all objects stand still."""
        return not self.unstable

    def moves(self, thing: Behaviour) -> bool:
        """Return whether an object does not stand still."""
        limits = thing.drift > self.rule.drift or thing.turn > self.rule.tilt
        return self.diverged or limits or thing.falls

    def facts(self) -> dict[str, Any]:
        """Return the values as JSON, in millimetres, degrees and seconds."""
        return {
            "seconds": self.rule.seconds,
            "stable": self.stable,
            "diverged": self.diverged,
            "unstable": list(self.unstable),
            "floating": list(self.floating),
            "off_table": list(self.off_table),
            "most_drift_mm": round(1e3 * max((o.drift for o in self.objects), default=0.0), 3),
            "most_turn_deg": _degrees(max((o.turn for o in self.objects), default=0.0)),
            "objects": [
                {
                    "name": o.name,
                    "drift_mm": round(1e3 * o.drift, 3),
                    "turn_deg": _degrees(o.turn),
                    "floats": o.floats,
                    "off_table": o.off_table,
                    "falls": o.falls,
                }
                for o in self.objects
            ],
        }


def soundness(scene: Scene, rule: StillnessRule = PLAIN) -> Soundness:
    """Simulate a scene from its settled poses and return the behaviour of each object.

    The simulation uses the collision parts, as in ``scene.xml``.
    """
    simulation = Simulation(scene)
    _set(simulation, rule)
    poses = [o.pose for o in scene.objects]
    simulation.place(poses)
    held = find_supported(simulation.contacts(margin=rule.gap), len(poses))
    off = inside_margin(simulation.centers_of_mass[:, :2], scene.table.outline) < 0
    simulation.run(rule.seconds)
    drift, turn = shift_distances(poses, simulation.poses), turn_angles(poses, simulation.poses)
    simulation.contacts()
    fell = set(find_fallen(simulation))
    objects = tuple(
        Behaviour(o.name, float(drift[k]), float(turn[k]), not held[k], bool(off[k]), k in fell)
        for k, o in enumerate(scene.objects)
    )
    return Soundness(rule, objects, bool(simulation.diverged))


def _set(simulation: Simulation, rule: StillnessRule) -> None:
    options = simulation.model.opt
    if rule.timestep is not None:
        options.timestep = rule.timestep
    strength = float(np.linalg.norm(options.gravity))
    aside, down = strength * np.sin(rule.lean), -strength * np.cos(rule.lean)
    options.gravity[:] = [aside * np.cos(rule.toward), aside * np.sin(rule.toward), down]


def _degrees(angle: float) -> float:
    return round(float(np.rad2deg(angle)), 3)
