"""3D scene assembly (Sec. 3.4): models with poses and scales become bodies at rest.

The paper imports the canonical models m_i with (r_i, t_i, s_i) into a simulator, gives each a
collision shape by convex decomposition, and enables gravity and friction. This implementation uses
convex parts, inertia computed from volumes, least-displacement separation, placement by contact,
settling in MuJoCo, and a gate that records whether the result is valid.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from jaxtyping import Float

from ..errors import InputError, choices, require
from ..geometry import convex_outline, yaw_quaternion
from ..physics.decomposition import CutBudget
from ..physics.gate import GateLimits, find_fallen, find_toppling, judge
from ..physics.inertia import body_mass
from ..physics.parts import body_parts, model_parts
from ..physics.separation import ancestry, separate, with_poses
from ..physics.settling import has_toppled, on_foot, settle
from ..physics.simulation import Simulation, shift_distances, turn_angles
from ..physics.standing_height import carry, relocate, seat_on_table, seat_stacked
from ..scene import (
    TABLE,
    Model,
    Object,
    Placement,
    Pose,
    Provenance,
    Report,
    Scene,
    ScenePlan,
    Table,
    View,
)

_SHAKE = 1.5  # as a multiple of the gate's tilt
_STAYS = 1e-4, 1e-3  # metres, radians: smaller motions are ignored when objects settle again


@dataclass(frozen=True)
class AssemblyConfig:
    """Settings of the assembly.

    Attributes:
        clearance: gap left between objects that overlapped before separation, metres.
        settle_seconds: maximum settling time.
        topple: an object that leans by more than this angle (radians) after settling has toppled;
            it is set upright on a weighted foot.
        attempts: maximum number of settling attempts.
        drop_failing: whether to leave out objects that cannot be freed or made to stand, instead of
            recording a failure.
        limits: limits of the gate.
    """

    clearance: float = 1e-3
    settle_seconds: float = 4.0
    topple: float = float(np.deg2rad(30.0))
    attempts: int = 4
    drop_failing: bool = False
    limits: GateLimits = field(default_factory=GateLimits)

    def __post_init__(self) -> None:
        require(self, "clearance", minimum=0)
        require(self, "settle_seconds", above=0)
        require(self, "topple", above=0, maximum=np.pi)
        require(self, "attempts", minimum=1, integer=True)


@dataclass(frozen=True, eq=False)
class Rested:
    """A scene at rest, not yet checked by the gate (see :func:`finish`).

    Attributes:
        wanted: the scene with all objects in their requested positions.
        arranged: the scene without overlaps.
        scene: the scene at rest.
        stuck: names of objects without a free position.
        unstable: names of objects that do not stand.
        dropped: names of objects that were left out.
        loose: names of objects that may be moved to pass the gate; None means all.
    """

    wanted: Scene
    arranged: Scene
    scene: Scene
    stuck: tuple[str, ...] = ()
    unstable: tuple[str, ...] = ()
    dropped: frozenset[str] = frozenset()
    loose: frozenset[str] | None = None


def assemble(
    models: Mapping[str, Model],
    placements: Sequence[Placement],
    table_model: Model,
    table_scale: Float[np.ndarray, "3"],
    *,
    provenance: Provenance,
    name: str,
    config: AssemblyConfig | None = None,
    view: View | None = None,
    plan: ScenePlan | None = None,
    footed: Collection[str] = (),
) -> Scene:
    """Return a settled scene of canonical models at their placements, with a report.

    The scene may have failed the gate; the report says so, and is checked before publishing. The
    arguments are those of :func:`bring_to_rest`.

    Raises:
        InputError: a placement has no model, or an unknown support.
        SceneError: a mesh has no convex parts and cannot be decomposed.
    """
    config = config or AssemblyConfig()
    rested = bring_to_rest(
        models, placements, table_model, table_scale, provenance=provenance, name=name,
        config=config, view=view, plan=plan, footed=footed,
    )  # fmt: skip
    return finish(rested, config)


def bring_to_rest(
    models: Mapping[str, Model],
    placements: Sequence[Placement],
    table_model: Model,
    table_scale: Float[np.ndarray, "3"],
    *,
    provenance: Provenance,
    name: str,
    config: AssemblyConfig | None = None,
    view: View | None = None,
    plan: ScenePlan | None = None,
    footed: Collection[str] = (),
) -> Rested:
    """Return canonical models at their placements as a scene at rest.

    Args:
        models: canonical models by object name.
        placements: r_i, t_i, s_i and the support of each object, in the world frame.
        table_model: canonical model of the table.
        table_scale: the table's extent in metres.
        provenance: origin of the scene; warnings of this stage are added to it.
        name: name of the scene.
        config: settings.
        view: the reference image's camera; None means the scene's default.
        plan: the plan of the text, stored with the scene.
        footed: names of objects that get a weighted foot from the start.

    Raises:
        InputError: a placement has no model, or an unknown support.
        SceneError: a mesh has no convex parts and cannot be decomposed.
    """
    config = config or AssemblyConfig()
    table = table_body(table_model, np.asarray(table_scale, float))
    _check_supports(placements, models)
    objects = tuple(body(models[p.name], p) for p in placements)
    scene = Scene(name, table, objects, provenance, plan=plan)
    if view is not None:
        scene = scene.replace(view=view)

    arranged, stuck = arrange(scene, config)
    feet = (on_foot(o) if o.name in footed else o for o in arranged.objects)
    arranged = arranged.replace(objects=tuple(feet))
    rested, unstable = rest(arranged, config)
    dropped = {*stuck, *unstable} if config.drop_failing else set[str]()
    if dropped:
        scene, arranged = _without(scene, dropped), _without(arranged, dropped)
        rested, unstable = rest(arranged, config)
    return Rested(scene, arranged, rested, stuck, unstable, frozenset(dropped))


def reassemble(
    wanted: Scene, arranged: Scene, fresh: Collection[str], config: AssemblyConfig | None = None
) -> Scene:
    """Settle a scene whose objects are already in position, and run the gate on it.

    ``wanted`` is the scene with all objects in their requested positions; in ``arranged`` there are
    no overlaps, and every object is on or just above its support. ``fresh`` names the new objects.
    The others get no foot, and keep their pose bit for bit unless settling moves them. The tilt of
    gravity is the one in the report of ``arranged``.
    """
    config = with_lean_of(arranged, config or AssemblyConfig())
    rested, unstable = rest(arranged, config, fresh)
    rested = keep_unmoved(arranged, rested, fresh)
    return finish(Rested(wanted, arranged, rested, unstable=unstable), config, fresh)


def with_lean_of(scene: Scene, config: AssemblyConfig) -> AssemblyConfig:
    """Return the settings with the tilt of gravity from a scene's report, if it records one."""
    if scene.report is None or scene.report.lean is None:
        return config
    return replace(config, limits=replace(config.limits, lean=scene.report.lean))


def arrange(scene: Scene, config: AssemblyConfig) -> tuple[Scene, tuple[str, ...]]:
    """Remove overlaps by putting objects on the table, separating, stacking and relocating them.

    Returns the scene and the names of objects without a free position.
    """
    height = scene.table.height
    standing = [o if o.placement.on != TABLE else seat_on_table(o, height) for o in scene.objects]
    scene = scene.replace(objects=tuple(standing))
    roots = tuple(o for o in scene.objects if o.placement.on == TABLE)
    apart, _ = separate(scene.replace(objects=roots), config.clearance)
    scene = seat_stacked(carry(scene, {o.name: o.pose for o in apart.objects}))
    scene, stuck = separate(scene, config.clearance)
    return relocate(scene, stuck, {o.name: o.pose for o in standing})


def rest(
    scene: Scene,
    config: AssemblyConfig,
    may: Collection[str] | None = None,
    loose: Collection[str] | None = None,
) -> tuple[Scene, tuple[str, ...]]:
    """Settle a scene; stand toppled objects upright on a weighted foot, and settle the scene again.

    ``may`` names the objects that may get a foot, and ``loose`` those that may move; None means
    all. Objects that may not move keep their poses and support the others. Returns the scene at
    rest and the names of objects that do not stand.
    """
    moving, fixed = _split(scene, loose)
    footed: set[str] = set()
    while moving.objects:
        simulation = Simulation(moving, fixed)
        poses = settle(moving, config.settle_seconds, simulation=simulation)
        down = _find_toppled(simulation, poses, config.topple)
        able = _only(down, may)
        if able <= footed or len(footed) >= len(moving.objects):
            return _merge(scene, with_poses(moving.objects, poses)), tuple(sorted(down))
        footed |= able
        objects = tuple(on_foot(o) if o.name in able else o for o in moving.objects)
        moving = moving.replace(objects=objects)
    return scene, ()


# ------------------------------------------------------------------------------------------ bodies


def table_body(
    model: Model, scale: Float[np.ndarray, "3"], budget: CutBudget | None = None
) -> Table:
    """Return a model as a table with the given extent (metres) and convex parts.

    A mesh without parts is decomposed within a ``budget`` that several meshes share.
    """
    parts = model_parts(model, scale, budget)
    points = np.concatenate([p.vertices for p in parts])
    top = points[points[:, 2] > points[:, 2].max() - 0.01]
    return Table(model, scale, parts, convex_outline(top[:, :2]), model.physics.friction)


def body(model: Model, placement: Placement) -> Object:
    """Return a model as an object at a placement, with convex parts, mass and inertia."""
    parts = body_parts(model, placement.scale)
    weighed = body_mass(model.mesh, placement.scale, model.physics, parts)
    pose = Pose(placement.translation, yaw_quaternion(placement.yaw))
    return Object(
        placement.name, model, placement, parts, weighed.mass, weighed.com, weighed.inertia,
        model.physics.friction, pose,
    )  # fmt: skip


def _check_supports(placements: Sequence[Placement], models: Mapping[str, Model]) -> None:
    """Check that every support and model exists, and that no object supports itself."""
    on = {p.name: p.on for p in placements}
    for name, below in on.items():
        seen = {name}
        while below != TABLE:
            if below not in on:
                raise InputError(f"{name!r} stands on unknown {below!r}." + choices(below, on))
            if below in seen:
                raise InputError(f"{name!r} stands on itself, through {sorted(seen)}.")
            seen.add(below)
            below = on[below]
    for name in on:
        if name not in models:
            raise InputError(f"No model for the placed object {name!r}." + choices(name, models))


# -------------------------------------------------------------------------------------- the scene


def _find_toppled(simulation: Simulation, poses: Sequence[Pose], limit: float) -> set[str]:
    """Return the objects that toppled although they should stand, and those that left the table."""
    simulation.place(poses)
    simulation.contacts()
    gone = set(find_fallen(simulation))
    return {
        o.name
        for k, (o, pose) in enumerate(zip(simulation.scene.objects, poses, strict=True))
        if k in gone or (not o.placement.inside and has_toppled(o, pose, limit))
    }


def _again(scene: Scene, config: AssemblyConfig, loose: Collection[str] | None) -> Scene:
    """Settle loose objects again, shaken beyond the gate's tilt unless the shaking topples more."""
    moving, fixed = _split(scene, loose)
    if not moving.objects:
        return scene
    simulation, start = Simulation(moving, fixed), [o.pose for o in moving.objects]
    down, poses = _find_toppled(simulation, start, config.topple), start
    for shake in (_SHAKE * config.limits.lean, 0.0):
        simulation.place(start)
        poses = settle(
            moving, config.settle_seconds, config.settle_seconds / 4, shake, simulation=simulation
        )
        if _find_toppled(simulation, poses, config.topple) <= down:
            break
    return _merge(scene, with_poses(moving.objects, poses))


def _split(scene: Scene, loose: Collection[str] | None) -> tuple[Scene, tuple[Object, ...]]:
    """Return the scene with only its loose objects (None means all), and the other objects."""
    if loose is None:
        return scene, ()
    moving = tuple(o for o in scene.objects if o.name in loose)
    return scene.replace(objects=moving), tuple(o for o in scene.objects if o.name not in loose)


def _merge(scene: Scene, objects: Sequence[Object]) -> Scene:
    """Return the scene with ``objects`` in place of its objects with the same names."""
    known = {o.name: o for o in objects}
    return scene.replace(objects=tuple(known.get(o.name, o) for o in scene.objects))


def keep_unmoved(arranged: Scene, rested: Scene, fresh: Collection[str]) -> Scene:
    """Return the scene at rest; objects that are neither new nor moved keep their exact poses."""
    poses = [[o.pose for o in scene.objects] for scene in (arranged, rested)]
    moved = (shift_distances(*poses) > _STAYS[0]) | (turn_angles(*poses) > _STAYS[1])
    triples = zip(arranged.objects, rested.objects, moved, strict=True)
    objects = (b if b.name in fresh or far else a for a, b, far in triples)
    return rested.replace(objects=tuple(objects))


def _only(names: set[str], may: Collection[str] | None) -> set[str]:
    return names if may is None else names & {*may}


def _steady(
    arranged: Scene, rested: Scene, config: AssemblyConfig, may: Collection[str] | None
) -> Scene:
    """Return the scene with a weighted foot under each object that topples in tilted gravity."""
    if not config.limits.lean:
        return rested
    standing = {o.name for o in rested.objects if not o.placement.inside}
    asked = _only(standing - {*_list_footed(arranged, rested)}, may)
    down = find_toppling(rested, config.limits, config.topple, asked)
    objects = tuple(on_foot(o) if o.name in down else o for o in rested.objects)
    return rested.replace(objects=objects) if down else rested


def _list_footed(arranged: Scene, rested: Scene) -> tuple[str, ...]:
    """Return the names of objects that received a weighted foot in :func:`rest`, in scene order."""
    pairs = zip(arranged.objects, rested.objects, strict=True)
    return tuple(after.name for before, after in pairs if len(after.parts) > len(before.parts))


def _without(scene: Scene, names: set[str]) -> Scene:
    """Return the scene without ``names`` and without everything that stands on them."""
    pairs = zip(scene.objects, ancestry(scene.objects), strict=True)
    kept = (o for o, c in pairs if names.isdisjoint(scene.objects[k].name for k in c))
    return scene.replace(objects=tuple(kept))


def finish(
    rested: Rested, config: AssemblyConfig | None = None, may: Collection[str] | None = None
) -> Scene:
    """Run the gate; until it passes, shake the scene and add weighted feet to toppling objects."""
    config = config or AssemblyConfig()
    wanted, arranged, scene = rested.wanted, rested.arranged, rested.scene
    poses = [[o.pose for o in each.objects] for each in (wanted, arranged)]
    moved = [np.linalg.norm((b.position - a.position)[:2]) for a, b in zip(*poses, strict=True)]
    report = Report(
        0.0, 0.0, 0.0, moved=float(max(moved, default=0.0)), dropped=tuple(sorted(rested.dropped))
    )
    for _ in range(config.attempts if rested.loose is None or rested.loose else 0):
        settling = shift_distances(poses[1], [o.pose for o in scene.objects])
        report = replace(report, settling=float(settling.max(initial=0.0)))
        report = judge(scene.replace(report=report), config.limits)
        if report.passed:
            break
        scene = _again(_steady(arranged, scene, config, may), config, rested.loose)
        if may is not None:
            scene = keep_unmoved(arranged, scene, may)
    else:
        report = judge(scene.replace(report=report), config.limits)
    warnings = (
        *(f"{name} has no free place on the table" for name in rested.stuck),
        *(f"{name} does not stand stably" for name in rested.unstable),
        *(f"{name} stands on a weighted foot that is not part of its model"
          for name in _list_footed(arranged, scene)),
        *(f"{name} was left out" for name in sorted(rested.dropped)),
    )  # fmt: skip
    provenance = replace(scene.provenance, warnings=scene.provenance.warnings + warnings)
    return scene.replace(report=report, provenance=provenance)
