"""The physical gate: what a scene must show in simulation before it is published."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..geometry import inside_margin
from ..scene import Report, Scene
from .simulation import ON_FLOOR, ON_TABLE, Simulation, shifted, supported, turned


@dataclass(frozen=True)
class Limits:
    """What passes. Lengths in metres, angles in radians, time in seconds."""

    penetration: float = 1e-3
    drift: float = 0.01
    tilt: float = float(np.deg2rad(5.0))
    gap: float = 2e-3
    seconds: float = 2.0


def judge(scene: Scene, limits: Limits | None = None) -> Report:
    """Simulate a scene from its settled poses and report what happens.

    Penetration and floating are judged at the start; drift, turning and falling after
    ``limits.seconds``. ``moved``, ``settling`` and ``dropped`` are kept from ``scene.report``.
    """
    limits = limits or Limits()
    simulation = Simulation(scene)
    poses = [o.pose for o in scene.objects]
    simulation.place(poses)
    names = [o.name for o in scene.objects]
    overlaps = simulation.contacts().deepest()
    held = supported(simulation.contacts(margin=limits.gap), len(names))
    off = inside_margin(simulation.centers_of_mass[:, :2], scene.table.outline) < 0
    simulation.run(limits.seconds)
    drift, tilt = shifted(poses, simulation.poses), turned(poses, simulation.poses)
    fell = fallen(simulation)
    report = Report(
        penetration=max(overlaps.values(), default=0.0),
        drift=float(drift.max(initial=0.0)),
        tilt=float(tilt.max(initial=0.0)),
        floating=tuple(n for n, ok in zip(names, held, strict=True) if not ok),
        fallen=tuple(names[i] for i in fell),
        off_table=tuple(n for n, out in zip(names, off, strict=True) if out),
        moved=scene.report.moved if scene.report else 0.0,
        settling=scene.report.settling if scene.report else 0.0,
        reach=reach(scene),
        seconds=limits.seconds,
        dropped=scene.report.dropped if scene.report else (),
    )
    failures = [
        *_overlapping(overlaps, names, limits.penetration),
        *(f"{n} moved {1e3 * d:.1f} mm in {limits.seconds:g} s"
          for n, d in zip(names, drift, strict=True) if d > limits.drift),
        *(f"{n} turned {np.rad2deg(t):.1f}° in {limits.seconds:g} s"
          for n, t in zip(names, tilt, strict=True) if t > limits.tilt),
        *(f"{n} floats" for n in report.floating),
        *(f"{n} fell from the table" for n in report.fallen),
        *(f"{n} has its centre of mass beyond the table's edge" for n in report.off_table),
    ]  # fmt: skip
    return dataclasses.replace(report, failures=tuple(failures))


def reach(scene: Scene) -> float:
    """Return, from the best of the table's four sides, the farthest object's distance to it."""
    if not scene.objects:
        return 0.0
    low, high = scene.table.outline.min(0), scene.table.outline.max(0)
    xy = np.array([o.pose.position[:2] for o in scene.objects])
    return float(max(0.0, min((high - xy).max(0).min(), (xy - low).max(0).min())))


def _overlapping(
    overlaps: Mapping[tuple[int, int], float], names: Sequence[str], limit: float
) -> list[str]:
    called = {ON_TABLE: "the table", ON_FLOOR: "the floor"}
    return [
        f"{names[max(a, b)]} overlaps {called.get(a) or names[a]} by {1e3 * depth:.1f} mm"
        for (a, b), depth in sorted(overlaps.items())
        if depth > limit
    ]


def fallen(simulation: Simulation) -> tuple[int, ...]:
    """Return the objects that touch the floor, or whose mass hangs 5 cm below the tabletop."""
    low = simulation.centers_of_mass[:, 2] < simulation.scene.table.height - 0.05
    touching = {int(b) for a, b in simulation.contacts().pairs if a == ON_FLOOR}
    return tuple(sorted(touching | set(np.flatnonzero(low).tolist())))
