"""The refinement stage and what it minimizes: the mismatch of rendered and observed outlines."""

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

_WORSE = 0.02  # an object's pose is not changed if its misfit would increase by more than this


@dataclass(frozen=True, eq=False)
class Refinement:
    """The result of the joint refinement.

    ``before`` and ``after`` are one minus the overlap of outlines (Eq. 2), averaged over the
    objects, for the given and the returned placements. Both are 0 if nothing was refined.
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
    """Optimise the poses of all objects and the camera's position to match the observed outlines.

    ``instances``, ``view`` and ``image_size`` (width, height) are those of the reference picture.
    The table's model, if given, determines the outline of its top; ``table_scale`` is its extent,
    metres. ``placements`` are in the world frame; ``seed`` is the seed of the surface samples.

    The camera's direction is fixed. Outlines agree equally well at an elevation 3 degrees off, so
    they do not determine it; the table's edges do. A result with a higher misfit is discarded, for
    the whole scene or for a single object. A picture with fewer than two objects, which does not
    determine the camera's position, is left unchanged.
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
    """Return one minus the mean overlap of a finished scene's outlines with the picture's.

    This is the measure of ``Refinement`` for objects at rest, as seen by a camera that has the
    picture's direction and the best-matching position. An instance counts as 1 if it has no object
    or if its object is far from its outline. The table and instances without visible pixels are
    ignored.
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
    found = np.nan_to_num(found, nan=1.0)  # the object is too far from its outline in the picture
    return float((found.sum() + len(shown) - len(there)) / len(shown))


def _shown_instances(instances: Sequence[Instance]) -> dict[str, Instance]:
    return {i.name: i for i in instances if i.name != TABLE and (i.crop[..., 3] > 127).any()}


def _resting_mesh(thing: Object) -> Mesh:
    """Return an object's mesh in metres, rotated as it is at rest."""
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
    """Return the placements, each changed by one step and lowered onto its support."""
    across = carries @ steps[:, 1:3]
    moved = {
        p.name: replace(
            p, yaw=wrap(p.yaw + steps[k, 0]), scale=p.scale * np.exp(steps[k, 3]),
            translation=p.translation + np.append(across[k], 0.0),
        )
        for k, p in enumerate(moving)
    }  # fmt: skip
    return at_rest([moved.get(p.name, p) for p in placements], models, height)
