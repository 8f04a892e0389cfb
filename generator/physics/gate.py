"""The physical gate: the simulation that a scene must pass before it is published."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Literal

import numpy as np
from jaxtyping import Bool, Float

from ..errors import require
from ..geometry import inside_margin
from ..scene import MAX_LEAN, Failure, FailureKind, Report, Scene
from .settling import has_toppled
from .simulation import ON_FLOOR, ON_TABLE, Motion, Simulation, find_supported, measure_motion


@dataclass(frozen=True)
class GateLimits:
    """Limits of the gate, with lengths in metres, angles in radians and time in seconds.

    Attributes:
        penetration: maximum overlap of two collision shapes at the start.
        drift, tilt: maximum displacement and rotation of an object.
        gap: an object is floating if it has no contacts within this distance.
        seconds: duration of the simulation.
        lean: angle, at most ``MAX_LEAN``, by which gravity is tilted towards each of four sides to
            test drift and tilt again; 0 skips these tests.

    Raises:
        InputError: a limit is negative or not a number, or the duration is zero.
    """

    penetration: float = 5e-4
    drift: float = 5e-3
    tilt: float = float(np.deg2rad(2.0))
    gap: float = 1e-3
    seconds: float = 5.0
    lean: float = float(np.deg2rad(2.0))

    def __post_init__(self) -> None:
        require(self, "penetration", "drift", "tilt", "gap", minimum=0)
        require(self, "seconds", above=0)
        require(self, "lean", minimum=0, maximum=float(np.deg2rad(MAX_LEAN)))


PerObject = Float[np.ndarray, "n"]
PerKind = Float[np.ndarray, "2"]
"""Values for drift (metres) and tilt (radians)."""

_STRIDE = 0.25  # seconds between two samples
_SMALL = 5e-3  # motion per sample that may be jitter, relative to the limits
_TINY = 0.4  # motion that is certainly jitter, relative to the previous value
_LOST = 2.0  # multiple of the limits at which the simulation under tilted gravity stops
_LEANING_TIMESTEP = 4e-3  # an additional test with a coarser step than the scene's own
_FIXED: Mapping[int, Literal["table", "floor"]] = {ON_TABLE: "table", ON_FLOOR: "floor"}


def judge(scene: Scene, limits: GateLimits | None = None) -> Report:
    """Simulate a scene from its settled poses and return its report.

    ``limits`` default to those with which the scene was tested (:func:`limits_of`). Penetration and
    floating are measured at the start. Drift, rotation and falling are measured over
    ``limits.seconds`` (:func:`watch`). Drift and rotation are then measured again under tilted
    gravity, up to the first side to which an object moves. An existing report's ``moved``,
    ``settling`` and ``dropped`` are kept.
    """
    limits = limits or limits_of(scene)
    simulation = Simulation(scene)
    names = [o.name for o in scene.objects]
    overlaps = simulation.contacts().deepest()
    held = find_supported(simulation.contacts(margin=limits.gap), len(names))
    off = inside_margin(simulation.centers_of_mass[:, :2], scene.table.outline) < 0
    drift, tilt = watch(simulation, limits)
    simulated = simulation.time
    level = _moving(simulation, drift, tilt, limits, leaning=False)
    floating = tuple(n for n, ok in zip(names, held, strict=True) if not ok)
    fallen = tuple(names[i] for i in find_fallen(simulation))
    off_table = tuple(n for n, out in zip(names, off, strict=True) if out)
    leaning, leans = 0.0, list[Failure]()
    if limits.lean and not level:
        leaning, shortest, leans = _leaning(simulation, limits)
        simulated = min(simulated, shortest)
    return Report(
        penetration=max(overlaps.values(), default=0.0),
        drift=float(drift.max(initial=0.0)),
        tilt=float(tilt.max(initial=0.0)),
        floating=floating,
        fallen=fallen,
        off_table=off_table,
        moved=scene.report.moved if scene.report else 0.0,
        settling=scene.report.settling if scene.report else 0.0,
        leaning=leaning,
        reach=reach(scene),
        seconds=limits.seconds,
        dropped=scene.report.dropped if scene.report else (),
        failures=(
            *_overlapping(overlaps, names, limits.penetration),
            *level,
            *leans,
            *(Failure("floats", (name,)) for name in floating),
            *(Failure("fell", (name,)) for name in fallen),
            *(Failure("off-table", (name,)) for name in off_table),
        ),
        simulated=round(simulated, 6),
        lean=None if limits.lean == GateLimits.lean else limits.lean,
    )


def limits_of(scene: Scene) -> GateLimits:
    """Return the default limits, but with the tilt of gravity that was used to test the scene.

    An imported scene is tested on a level table, since its round objects roll as in its source.
    """
    lean = scene.report.lean if scene.report else None
    return GateLimits() if lean is None else GateLimits(lean=lean)


def watch(simulation: Simulation, limits: GateLimits) -> tuple[PerObject, PerObject]:
    """Simulate ``limits.seconds``; return each object's displacement and rotation.

    Objects in steady, slow motion are not simulated to the end (:func:`_watch`); their motion is
    extrapolated. The values are meaningless if the simulation diverges.
    """
    return _watch(simulation, limits, np.array([limits.drift, limits.tilt]))


def _watch(
    simulation: Simulation, limits: GateLimits, bounds: PerKind, lost: float = np.inf
) -> tuple[PerObject, PerObject]:
    """Simulate until the final displacement and rotation of each object are certain.

    They are certain if an object has moved by ``lost`` times the bounds. They are also certain if
    in two consecutive samples no object moves or turns faster than before, and each object stays
    within ``bounds`` when its motion is extrapolated at twice the speed and at the current
    acceleration (:func:`_speeds_up`).
    """
    begin = simulation.time
    start = now = simulation.states
    small = _SMALL * np.array([limits.drift, limits.tilt])
    looks = max(1, round(limits.seconds / _STRIDE))
    gone = np.zeros((len(start), 2))
    steps: list[Motion] = []
    calm = 0
    for k in range(looks):  # toppling objects accelerate, so they are simulated to the end
        earlier, left = steps, looks - 1 - k
        simulation.run(begin + limits.seconds * (k + 1) / looks - simulation.time)
        if simulation.diverged:
            break
        last, now = now, simulation.states
        gone = measure_motion(start, now)
        steps = [*earlier[-2:], measure_motion(last, now)]
        pace = np.max(steps, axis=0)
        even = steps[-1] <= np.maximum(1.05 * np.max(earlier, axis=0, initial=0.0), small)
        even &= (gone + 2 * pace * left <= bounds) & ~_speeds_up(steps, gone, left, bounds, small)
        calm = calm + 1 if earlier and even.all() else 0
        if calm == 2:
            gone = gone + pace * left
        if calm == 2 or (gone > lost * bounds).any():
            break
    return gone[:, 0], gone[:, 1]


def _speeds_up(
    steps: Sequence[Motion], gone: Motion, left: int, bounds: PerKind, small: PerKind
) -> Bool[np.ndarray, "n 2"]:
    """Return whether motion would exceed the bounds if it grew as in the last two samples."""
    if len(steps) < 2:
        return np.zeros(gone.shape, bool)
    growth = np.clip(steps[-1] / np.maximum(steps[-2], 1e-12), 1.0001, 10.0)
    forecast = gone + steps[-1] * growth * (growth**left - 1) / (growth - 1)
    return (growth > 1.05) & (steps[-1] > _TINY * small) & (forecast > bounds)


def _leaning(simulation: Simulation, limits: GateLimits) -> tuple[float, float, list[Failure]]:
    """Test under tilted gravity; return the largest displacement, shortest run (s) and failures."""
    worst, shortest = 0.0, limits.seconds
    bounds = np.array([limits.drift, limits.tilt])
    for side in range(4):
        with _leaning_to(side, simulation, limits):
            drift, tilt = _watch(simulation, limits, bounds, _LOST)
        worst = max(worst, float(drift.max(initial=0.0)))
        shortest = min(shortest, simulation.time)
        if failures := _moving(simulation, drift, tilt, limits, leaning=True):
            return worst, shortest, failures
    return worst, shortest, []


def find_toppling(
    scene: Scene, limits: GateLimits, angle: float, among: Collection[str] | None = None
) -> tuple[str, ...]:
    """Return the objects that topple (``has_toppled``) by ``angle`` radians under tilted gravity.

    ``among`` names the objects to test; None means all. The simulation stops early if the tested
    objects are as still as :func:`watch` requires.
    """
    asked = {o.name for o in scene.objects if among is None or o.name in among}
    if not asked:
        return ()
    simulation = Simulation(scene)
    bounds = np.array([np.inf, angle])
    down: set[str] = set()
    for side in range(4):
        with _leaning_to(side, simulation, limits):
            _watch(simulation, limits, bounds)
        pairs = zip(scene.objects, simulation.poses, strict=True)
        down |= {o.name for o, pose in pairs if o.name in asked and has_toppled(o, pose, angle)}
        if down == asked:
            break
    return tuple(sorted(down))


@contextmanager
def _leaning_to(side: int, simulation: Simulation, limits: GateLimits) -> Iterator[None]:
    """Restart the simulation at the scene's poses with gravity tilted towards one of four sides."""
    simulation.place([o.pose for o in simulation.scene.objects])
    with simulation.conditions(limits.lean, side * np.pi / 2, _LEANING_TIMESTEP):
        yield


def _moving(
    simulation: Simulation, drift: PerObject, tilt: PerObject, limits: GateLimits, *, leaning: bool
) -> list[Failure]:
    """Return the failures of the last run: objects that moved too far or whose motion diverged."""
    names = [o.name for o in simulation.scene.objects]
    if broken := simulation.diverged:
        return [Failure("diverged", (names[k],), leaning=leaning) for k in broken]
    kinds: tuple[tuple[FailureKind, PerObject, float], ...] = (
        ("moved", drift, limits.drift), ("turned", tilt, limits.tilt),
    )  # fmt: skip
    return [
        Failure(kind, (name,), float(value), limit, simulation.time, leaning)
        for kind, values, limit in kinds
        for name, value in zip(names, values, strict=True)
        if value > limit
    ]


def reach(scene: Scene) -> float:
    """Return the smallest reach in metres that covers all objects from one side of the table."""
    if not scene.objects:
        return 0.0
    low, high = scene.table.outline.min(0), scene.table.outline.max(0)
    xy = np.array([o.pose.position[:2] for o in scene.objects])
    return float(max(0.0, min((high - xy).max(0).min(), (xy - low).max(0).min())))


def _overlapping(
    overlaps: Mapping[tuple[int, int], float], names: Sequence[str], limit: float
) -> list[Failure]:
    found: list[Failure] = []
    for (a, b), depth in sorted(overlaps.items()):
        if depth > limit:
            fixed = _FIXED.get(a)
            objects = (names[max(a, b)],) if fixed else (names[max(a, b)], names[a])
            found.append(Failure("overlap", objects, float(depth), limit, support=fixed or ""))
    return found


def find_fallen(simulation: Simulation) -> tuple[int, ...]:
    """Return objects that touch the floor or whose centre of mass is 5 cm below the tabletop."""
    low = simulation.centers_of_mass[:, 2] < simulation.scene.table.height - 0.05
    touching = {int(b) for a, b in simulation.contacts().pairs if a == ON_FLOOR}
    return tuple(sorted(touching | set(np.flatnonzero(low).tolist())))
