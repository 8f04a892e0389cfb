"""The physical gate: what a scene must show in simulation before it is published."""

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
    """What passes. Lengths in metres, angles in radians, time in seconds.

    penetration: deepest overlap of two collision shapes at the start.
    drift, tilt: how far a thing may move and turn.
    gap: what nothing touches within this distance floats.
    seconds: how long it is watched.
    lean: the same must hold with gravity leaning by this angle, at most ``MAX_LEAN``, to each of
        four sides; 0 leaves that out.

    Raises:
        InputError: not a number, negative, or no time at all.
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
"""Of drift and tilt: metres, radians."""

_STRIDE = 0.25  # seconds between two looks
_SMALL = 5e-3  # of the limits: motion between two looks that may be a tremble in place
_TINY = 0.4  # of that: motion that is one
_LOST = 2.0  # times the limits: what has moved so far as gravity leans is not watched on
_LEANING_TIMESTEP = 4e-3  # coarser than the scene's own: what leans must hold with that too
_FIXED: Mapping[int, Literal["table", "floor"]] = {ON_TABLE: "table", ON_FLOOR: "floor"}


def judge(scene: Scene, limits: GateLimits | None = None) -> Report:
    """Simulate a scene from its settled poses and report what happens.

    ``limits`` are by default those that the scene was judged by (:func:`limits_of`).
    Penetration and floating are judged at the start; drift, turning and falling over
    ``limits.seconds`` (:func:`watch`), then drift and turning again as the table leans, up to the
    first side to which something moves. ``moved``, ``settling`` and ``dropped`` stay as they were.
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
    """Return the usual limits, with the lean that the scene was judged by.

    An imported scene is judged on a level table: its round things roll as their file says.
    """
    lean = scene.report.lean if scene.report else None
    return GateLimits() if lean is None else GateLimits(lean=lean)


def watch(simulation: Simulation, limits: GateLimits) -> tuple[PerObject, PerObject]:
    """Simulate ``limits.seconds``; return how far each object moved and turned.

    What creeps evenly is not watched to the end (:func:`_watch`): its forecast is returned. Once
    the simulation has broken down the figures say nothing.
    """
    return _watch(simulation, limits, np.array([limits.drift, limits.tilt]))


def _watch(
    simulation: Simulation, limits: GateLimits, bounds: PerKind, lost: float = np.inf
) -> tuple[PerObject, PerObject]:
    """Simulate until it is clear how far each object will have moved and turned in the end.

    That is so once two looks in a row show no object moving or turning faster than in the looks
    before, and going on at twice its pace would keep each within ``bounds``, as would going on to
    speed up by what it has since the last look (:func:`_speeds_up`); and once one has moved by
    ``lost`` times the bounds.
    """
    begin = simulation.time
    start = now = simulation.states
    small = _SMALL * np.array([limits.drift, limits.tilt])
    looks = max(1, round(limits.seconds / _STRIDE))
    gone = np.zeros((len(start), 2))
    steps: list[Motion] = []
    calm = 0
    for k in range(looks):  # what topples speeds up, and is watched to the end
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
    """Whether motion would leave the bounds if each look's grew on as that of the last two did."""
    if len(steps) < 2:
        return np.zeros(gone.shape, bool)
    growth = np.clip(steps[-1] / np.maximum(steps[-2], 1e-12), 1.0001, 10.0)
    forecast = gone + steps[-1] * growth * (growth**left - 1) / (growth - 1)
    return (growth > 1.05) & (steps[-1] > _TINY * small) & (forecast > bounds)


def _leaning(simulation: Simulation, limits: GateLimits) -> tuple[float, float, list[Failure]]:
    """Return how far anything moves as gravity leans, the least time simulated, and failures."""
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
    """Return what topples (``has_toppled`` by ``angle``, radians) as gravity leans to any side.

    ``among`` names what is asked about; None is everything. What lies as still, or creeps as
    evenly, as :func:`watch` demands is not simulated to the end.
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
    """Start anew from the scene's poses, with gravity leaning to one of four sides."""
    simulation.place([o.pose for o in simulation.scene.objects])
    with simulation.conditions(limits.lean, side * np.pi / 2, _LEANING_TIMESTEP):
        yield


def _moving(
    simulation: Simulation, drift: PerObject, tilt: PerObject, limits: GateLimits, *, leaning: bool
) -> list[Failure]:
    """Return what the run just ended shows: what moved too far, or at what it broke down."""
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
    """Return, from the best of the table's four sides, the farthest object's distance to it."""
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
    """Return the objects that touch the floor, or whose mass hangs 5 cm below the tabletop."""
    low = simulation.centers_of_mass[:, 2] < simulation.scene.table.height - 0.05
    touching = {int(b) for a, b in simulation.contacts().pairs if a == ON_FLOOR}
    return tuple(sorted(touching | set(np.flatnonzero(low).tolist())))
