"""The refinement as a stage, and the agreement of outlines it optimises."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from ...geometry import quaternion_matrix, wrap
from ...render.contact import at_rest
from ...scene import TABLE, Instance, Mesh, Model, Object, Placement, View
from ...threads import single_thread
from .descent import descend, misfits
from .problem import RefinementConfig, make_posed, make_problem, make_seen, pose_placements

_WORSE = 0.02  # an object whose own outline agrees that much less keeps its place


@dataclass(frozen=True, eq=False)
class Refinement:
    """What the joint refinement found.

    ``before`` and ``after`` are one minus the overlap of outlines (Eq. 2), the mean over the
    objects, of the placements given and of those returned; 0 where nothing was to be done.
    """

    placements: tuple[Placement, ...]
    before: float
    after: float


def refine_scene(
    instances: Sequence[Instance],
    models: Mapping[str, Model],
    placements: Sequence[Placement],
    table_scale: Float[np.ndarray, "3"],
    view: View,
    image_size: tuple[int, int],
    config: RefinementConfig,
    seed: int = 0,
) -> Refinement:
    """Move all objects, and the camera's place, together to where the outlines agree best.

    ``instances``, ``view`` and ``image_size`` (width, height) are the reference picture's. The
    table's model, if it is there, gives the top's outline; ``table_scale`` is its extent, metres.
    ``placements`` are in the world frame; ``seed`` is of the surface samples.

    The camera's direction is not moved: outlines agree as well with an elevation 3 degrees off, so
    they do not tell it; the table's edges do. A result that is worse is not used, for the whole
    scene or for an object. A picture with fewer than two objects, which cannot tell where the
    camera stands, is left as it is.
    """
    shown = _shown_instances(instances)
    moving = [p for p in placements if p.name in shown]
    if len(moving) < 2 or not config.steps:
        return Refinement(tuple(placements), 0.0, 0.0)

    def measure(placed: Sequence[Placement]) -> Float[np.ndarray, "n"]:
        there = [p for p in placed if p.name in shown]
        return misfits(seen, pose_placements(there, models, config, seed), config)[0]

    with single_thread():
        things = [shown[p.name] for p in moving]
        seen = make_seen(things, list(shown.values()), view, image_size, config)
        problem = make_problem(seen, moving, placements, models, table_scale, config, seed)
        start, camera = misfits(seen, problem.posed, config)
        steps = descend(problem, camera, config)
        carries = problem.links.carries.numpy().astype(float)
        height = float(table_scale[2])
        found = _move(placements, moving, steps, carries, models, height)
        after = measure(found)
        worse = after > start + _WORSE
        if worse.any():
            steps = np.where(worse[:, None], 0.0, steps)
            found = _move(placements, moving, steps, carries, models, height)
            after = measure(found)
    if after.mean() >= start.mean():
        return Refinement(tuple(placements), float(start.mean()), float(start.mean()))
    return Refinement(found, float(start.mean()), float(after.mean()))


def outline_misfit(
    instances: Sequence[Instance],
    objects: Sequence[Object],
    view: View,
    image_size: tuple[int, int],
    config: RefinementConfig | None = None,
    seed: int = 0,
) -> float:
    """Return one minus the overlap of outlines, the mean over the instances, of a finished scene.

    The measure of ``Refinement``: of objects as they rest, seen by a camera of the picture's
    direction from where they agree best. An instance that no object is made of counts 1, as
    does one whose object stands far off its outline; the table, and what shows nothing, are left
    out.
    """
    config = config or RefinementConfig()
    shown = _shown_instances(instances)
    there = [o for o in objects if o.name in shown]
    if not there:
        return 1.0
    with single_thread():
        things = [shown[o.name] for o in there]
        seen = make_seen(things, list(shown.values()), view, image_size, config)
        posed = make_posed(
            [_resting_mesh(o) for o in there], [np.ones(3)] * len(there), [0.0] * len(there),
            np.array([o.pose.position for o in there]), config, seed,
        )  # fmt: skip
        found, _ = misfits(seen, posed, config)
    found = np.nan_to_num(found, nan=1.0)  # what stands so far off that its outline is lost
    return float((found.sum() + len(shown) - len(there)) / len(shown))


def _shown_instances(instances: Sequence[Instance]) -> dict[str, Instance]:
    return {i.name: i for i in instances if i.name != TABLE and (i.crop[..., 3] > 127).any()}


def _resting_mesh(thing: Object) -> Mesh:
    """Return an object's mesh in metres, turned as it rests."""
    mesh = thing.model.mesh
    turn = quaternion_matrix(thing.pose.quaternion)
    return replace(mesh, vertices=(mesh.vertices * thing.scale) @ turn.T)


def _move(
    placements: Sequence[Placement],
    moving: Sequence[Placement],
    steps: Float[np.ndarray, "n 4"],
    carries: Float[np.ndarray, "n n"],
    models: Mapping[str, Model],
    height: float,
) -> tuple[Placement, ...]:
    """Return the placements after a step each, lowered onto what they stand on."""
    across = carries @ steps[:, 1:3]
    moved = {
        p.name: replace(
            p, yaw=wrap(p.yaw + steps[k, 0]), scale=p.scale * np.exp(steps[k, 3]),
            translation=p.translation + np.append(across[k], 0.0),
        )
        for k, p in enumerate(moving)
    }  # fmt: skip
    return at_rest([moved.get(p.name, p) for p in placements], models, height)
