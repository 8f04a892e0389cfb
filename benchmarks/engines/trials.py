"""Trials of a scene in an engine: at rest, and on a table with increasing lean."""

from __future__ import annotations

import numpy as np

from generator.scene import TABLE, Object, Scene

from .simulations import EngineScene

SECONDS = 2.0
"""Duration of the simulation at rest."""

RATE, STEEPEST = 3.0, 60.0
"""Lean of the table in degrees per second, and maximum lean in degrees."""

_QUICKLY = 0.7  # share of the friction angle up to which the table leans within a second

MOVED = 2e-3
"""Displacement in metres from which an object counts as sliding."""

_EVERY = 0.05  # seconds between two samples


def rest_drift(simulation: EngineScene) -> tuple[float, str]:
    """Return the maximum displacement of any object in ``SECONDS``, metres, and that object."""
    first = simulation.positions()
    worst, whose = 0.0, ""
    for _ in range(round(SECONDS / _EVERY)):
        simulation.step(_EVERY)
        for name, place in simulation.positions().items():
            off = float(np.linalg.norm(place - first[name]))
            if not off <= worst:  # NaN counts as the worst
                worst, whose = off, name
    return worst, whose


def flattest(scene: Scene) -> Object:
    """Return the object on the bare table that is flattest, which slides instead of tipping."""
    standing = [thing for thing in scene.objects if thing.placement.on == TABLE]
    return min(standing, key=lambda thing: thing.scale[2] / min(thing.scale[:2]))


def expected_friction(scene: Scene, thing: Object) -> float:
    """Return MuJoCo's coefficient of friction between an object and the table."""
    return max(scene.table.friction, thing.friction)


def slide_angle(simulation: EngineScene, name: str, friction: float) -> float:
    """Return the lean in degrees at which a single object on the table has moved by ``MOVED``.

    The other objects are removed. Returns ``STEEPEST`` if it does not slide. ``friction`` is the
    expected coefficient; the table leans quickly to well below its angle.
    """
    for other in [*simulation.positions()]:
        if other != name:
            simulation.remove(other)
    simulation.step(0.2)  # removed objects may have touched it
    first, angle = simulation.positions()[name], 0.0
    start = _QUICKLY * float(np.rad2deg(np.arctan(friction)))
    while angle < STEEPEST:
        angle += _EVERY * (start if angle < start else RATE)
        simulation.tilt(float(np.deg2rad(angle)))
        simulation.step(_EVERY)
        if not np.linalg.norm(simulation.positions()[name] - first) < MOVED:
            break
    return angle
