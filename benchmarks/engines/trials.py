"""Trials of a scene in an engine: at rest, and on a table that leans more and more."""

from __future__ import annotations

import numpy as np

from generator.scene import TABLE, Object, Scene

from .simulations import EngineScene

SECONDS = 2.0
"""How long a scene is watched at rest."""

RATE, STEEPEST = 3.0, 60.0
"""Degrees per second by which the table leans, and degrees at which it stops."""

_QUICKLY = 0.7  # of the angle of friction: up to here the table leans in a second

MOVED = 2e-3
"""Metres from where a thing slides."""

_EVERY = 0.05  # seconds between two looks


def rest_drift(simulation: EngineScene) -> tuple[float, str]:
    """Return how far a thing is at most from where it began in ``SECONDS``, metres; and which."""
    first = simulation.positions()
    worst, whose = 0.0, ""
    for _ in range(round(SECONDS / _EVERY)):
        simulation.step(_EVERY)
        for name, place in simulation.positions().items():
            off = float(np.linalg.norm(place - first[name]))
            if not off <= worst:  # NaN is the worst
                worst, whose = off, name
    return worst, whose


def flattest(scene: Scene) -> Object:
    """Return the thing on the bare table that is lowest for its width: it slides, not tips."""
    standing = [thing for thing in scene.objects if thing.placement.on == TABLE]
    return min(standing, key=lambda thing: thing.scale[2] / min(thing.scale[:2]))


def expected_friction(scene: Scene, thing: Object) -> float:
    """Return the coefficient of friction between a thing and the table, MuJoCo's."""
    return max(scene.table.friction, thing.friction)


def slide_angle(simulation: EngineScene, name: str, friction: float) -> float:
    """Return the lean in degrees at which a thing alone on the table has moved by ``MOVED``.

    The things beside it are taken away. ``STEEPEST`` if it stays. ``friction`` is the coefficient
    that is expected; the table leans quickly to well below its angle.
    """
    for other in [*simulation.positions()]:
        if other != name:
            simulation.remove(other)
    simulation.step(0.2)  # what was beside it may have touched it
    first, angle = simulation.positions()[name], 0.0
    start = _QUICKLY * float(np.rad2deg(np.arctan(friction)))
    while angle < STEEPEST:
        angle += _EVERY * (start if angle < start else RATE)
        simulation.tilt(float(np.deg2rad(angle)))
        simulation.step(_EVERY)
        if not np.linalg.norm(simulation.positions()[name] - first) < MOVED:
            break
    return angle
