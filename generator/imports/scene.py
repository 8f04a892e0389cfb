"""Conversion of a foreign scene: building its objects, settling them and running the gate."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Hashable, Sequence
from dataclasses import replace
from typing import cast

import numpy as np
from jaxtyping import Float

from ..bundle import BOUNDS
from ..bundle.fields import arguments
from ..errors import BundleError, InputError, SceneError
from ..geometry import convex_outline, inside_margin, quaternion_matrix
from ..layout.relation_check import correct_supports, observe
from ..method.assembly import AssemblyConfig, reassemble
from ..physics.decomposition import CutBudget
from ..scene import TABLE, ConvexPart, Model, Object, Provenance, Scene, Table
from ..scene.provenance import plain
from .bodies import SurfaceCache, build_object, build_table
from .foreign import ForeignScene, ImportOutcome, Refusals, check_count

_RIM = 0.01  # metres below a container's rim at which an object counts as inside
_ROUNDS = 20  # maximum number of objects left out
_OUTCOMES, _MOST_OUTCOMES = "outcomes", 10_000


def build_scene(
    foreign: ForeignScene,
    provenance: Provenance,
    name: str,
    config: AssemblyConfig | None = None,
    leave_out: bool = False,
) -> Scene:
    """Return the converted and settled scene with its report, whether or not it passes the gate.

    The world is translated so that the table stands on the floor z = 0 at the origin. Objects keep
    their exact poses unless settling moves them. Objects that cannot be built are refused without
    affecting the others; ``list_outcomes`` gives the outcome of each. ``leave_out`` removes the
    objects that a failed gate names, one at a time.

    Raises:
        InputError: there are too many objects, or none that can be built.
        SceneError: no object comes to rest.
    """
    check_count(len(foreign.objects))
    if foreign.table is None:
        raise InputError(f"The scene {foreign.name!r} has no table.")
    drawn, budget = SurfaceCache(), CutBudget()
    table, shift, of_table = build_table(foreign.table, drawn, budget)
    objects: list[Object] = []
    outcomes = [of_table] if of_table.kind != "taken" else []
    refusals = Refusals([*foreign.refused])
    shapes = _Shapes()
    shapes.add(table)
    names = _free_names([body.name for body in foreign.objects])
    for body, called in zip(foreign.objects, names, strict=True):
        with refusals.catching(called):
            shapes.check(body.parts)
            moved = replace(body, position=body.position + shift)
            thing, outcome = build_object(moved, called, table, drawn, budget)
            shapes.add(thing)
            objects.append(thing)
            outcomes.append(outcome)
    refusals.check_left(objects)
    provenance = replace(provenance, warnings=(*provenance.warnings, *foreign.warnings))
    scene = Scene(name, table, tuple(objects), provenance)
    done, dropped = _settle(scene, config, leave_out)
    gone = {outcome.name for outcome in dropped}
    outcomes = [*(o for o in outcomes if o.name not in gone), *dropped, *refusals.outcomes]
    done = done.replace(provenance=_record(done.provenance, outcomes))
    return _mark_inside(correct_supports(done, observe(done)))


class _Shapes:
    """Counts a scene's convex parts as a bundle does: once per body and once per distinct model."""

    def __init__(self) -> None:
        self._parts = self._points = 0
        self._models: set[Hashable] = set()

    def check(self, *lists: Sequence[ConvexPart]) -> tuple[int, int]:
        """Return the total numbers of parts and points after adding the given lists of parts.

        Raises:
            InputError: they exceed the limits of a bundle.
        """
        parts = self._parts + sum(map(len, lists))
        points = self._points + sum(len(part.vertices) for some in lists for part in some)
        if parts > BOUNDS.all_parts or points > BOUNDS.all_part_vertices:
            raise InputError(
                f"The models and collision shapes of the scene have {parts} convex parts with "
                f"{points} points in total; at most {BOUNDS.all_parts} parts with "
                f"{BOUNDS.all_part_vertices} points are allowed. Use fewer shapes, or fewer "
                "objects."
            )
        return parts, points

    def add(self, body: Object | Table) -> None:
        """Count the parts of a body; see ``check``."""
        key = _content(body.model)
        own = () if key in self._models else body.model.parts
        self._parts, self._points = self.check(body.parts, own)
        self._models.add(key)


def _content(model: Model) -> Hashable:
    """Return a key that is equal, up to rounding, for models that a bundle stores only once."""
    arrays = (model.size, model.mesh.vertices, model.mesh.faces, model.mesh.uv, model.mesh.texture)
    parts = tuple((part.kind, part.axis, part.vertices.tobytes()) for part in model.parts)
    looks = hashlib.sha256(b"".join(np.ascontiguousarray(array).tobytes() for array in arrays))
    return model.name, model.label, model.category, model.physics, looks.digest(), parts


def list_outcomes(scene: Scene) -> tuple[ImportOutcome, ...]:
    """Return the import outcome of each object of a scene, or () if the scene was not imported.

    The table is included if it was repaired.

    Raises:
        BundleError: the scene is from a bundle whose provenance has another format.
    """
    listed: object = scene.provenance.config.get(_OUTCOMES, ())
    what = f"{scene.name}: provenance.config[{_OUTCOMES!r}]"
    if not isinstance(listed, list | tuple) or len(listed) > _MOST_OUTCOMES:
        raise BundleError(
            f"{what} must be a list of at most {_MOST_OUTCOMES} import outcomes. Import the scene "
            "again."
        )
    entries = enumerate(cast("Sequence[object]", listed))
    return tuple(ImportOutcome(**arguments(ImportOutcome, o, f"{what}[{k}]")) for k, o in entries)


def _record(provenance: Provenance, outcomes: Sequence[ImportOutcome]) -> Provenance:
    """Return the provenance with the outcomes, and a warning for each object that was changed."""
    changed = (str(o) for o in outcomes if o.kind != "taken")
    return replace(
        provenance, config={**provenance.config, _OUTCOMES: plain([*outcomes])},
        warnings=(*provenance.warnings, *changed),
    )  # fmt: skip


def _settle(
    scene: Scene, config: AssemblyConfig | None, leave_out: bool
) -> tuple[Scene, list[ImportOutcome]]:
    """Settle a scene; return it with its report, and the objects omitted to pass the gate."""
    done = reassemble(scene, scene, (), config)
    dropped: list[ImportOutcome] = []
    while leave_out and len(dropped) < _ROUNDS and (worst := _find_failing(done)):
        assert done.report is not None
        reasons = (str(f) for f in done.report.failures if worst in f.objects)
        dropped.append(ImportOutcome(worst, "left out", "; ".join(reasons)))
        left = tuple(o for o in scene.objects if o.name != worst)
        if not left:
            raise SceneError(
                "No object of the scene comes to rest on its table. " + "; ".join(map(str, dropped))
            )
        scene = scene.replace(objects=left)
        done = reassemble(scene, scene, (), config)
    if dropped and done.report is not None:
        names = tuple(sorted(outcome.name for outcome in dropped))
        done = done.replace(report=replace(done.report, dropped=names))
    return done, dropped


def _find_failing(scene: Scene) -> str | None:
    """Return the object that the report's failures name most often, or None if they name none."""
    failures = scene.report.failures if scene.report else ()
    counts = Counter(name for failure in failures for name in failure.objects)
    named = (o.name for o in scene.objects if counts[o.name])
    return max(named, key=lambda name: counts[name], default=None)


# ------------------------------------------------------------------------------------------- names


def _free_names(names: Sequence[str]) -> list[str]:
    """Return a unique, valid name for each object; valid ones are unchanged."""
    taken = {TABLE, "world"}
    found = []
    for given in names:
        plain = "".join(c if c.isprintable() and c != "/" else "_" for c in given)[:100]
        word, number = plain or "thing", 1
        name = word if plain and plain not in taken else f"{word}_{number}"
        while name in taken:
            number += 1
            name = f"{word}_{number}"
        taken.add(name)
        found.append(name)
    return found


def _mark_inside(scene: Scene) -> Scene:
    """Return the scene; objects below the rim of their container are marked as inside it."""
    things = {o.name: o for o in scene.objects}
    marked = []
    for thing in scene.objects:
        holder = things.get(thing.placement.on)
        if holder is not None and holder.model.container and _is_inside(thing, holder):
            thing = replace(thing, placement=replace(thing.placement, inside=True))
        marked.append(thing)
    return scene.replace(objects=tuple(marked))


def _is_inside(thing: Object, holder: Object) -> bool:
    own, about = _points(thing), _points(holder)
    middle = (own.min(0) + own.max(0))[None, :2] / 2
    within = float(inside_margin(middle, convex_outline(about[:, :2]))[0]) > 0
    return within and own[:, 2].min() < about[:, 2].max() - _RIM


def _points(thing: Object) -> Float[np.ndarray, "n 3"]:
    points = np.concatenate([part.vertices for part in thing.parts])
    return points @ quaternion_matrix(thing.pose.quaternion).T + thing.pose.position
