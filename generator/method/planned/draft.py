"""Object-by-object comparison of a reconstruction with its plan."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import MappingProxyType

import numpy as np
from jaxtyping import Float

from ...errors import SceneError
from ...geometry import rotation_z, wrap
from ...layout import build_models, natural_yaw, table_size
from ...layout.furniture import find_fitted
from ...layout.rest import support_of
from ...scene import TABLE, Instance, Model, Placement, Rotation, ScenePlan
from .matches import fresh_names, match_planned, rename_plan

ALIKE = 1.35, 1.2
"""Maximum ratio between corresponding sides of a drawn object and of its planned model, and of
another variant of its kind, at which the sizes agree, if the drawing shows catalogue objects."""

REAL = 2.0, 1.5
"""Like ``ALIKE``, for a drawing that shows arbitrary objects of the planned kinds."""

UNKNOWN = 2.0
"""Like ``ALIKE``, for objects whose sizes and shapes are guesses because the catalogue lacks
them."""

TABLES = 1.3
"""Maximum ratio between corresponding sides of the drawn and the planned table."""

_HARDLY = 0.05  # logarithm of the factor below which no warning is given
_VARIANTS = 4  # number of variants of a catalogue object with which sizes are compared
_APART = 104_729  # difference between the seeds of two variants
_SLACK = 0.008, 0.1  # tolerated difference between sides: metres, and fraction of the longest side

LOOSE = ("group", "heap")
"""Kinds of groups without a fixed arrangement."""

_SHAPE = "the object's outline in the drawing does not have the planned proportions"
_FITTED = "the object must fit another object"
_ALIKE = "the object must match the other place settings"


@dataclass(frozen=True, eq=False)
class SceneDraft:
    """A scene before layout: its plan, and the models, placements and yaws of the planned objects.

    Attributes:
        models: the model of every planned object, at its size in metres.
        planned: the plan's own models of these objects.
        seen: names of the objects that are in the reconstruction.
        shown: placements, in the reconstruction, of the objects that are on their planned support.
        table: the table's model, at its size in metres.
        warnings: descriptions of the corrections.
        found: yaws of the objects in the reconstruction.
        yaws: yaws of objects in the drawing, radians, if the drawing determines them. Members of
            groups are omitted, since groups are arranged as a whole.
    """

    plan: ScenePlan
    models: Mapping[str, Model]
    planned: Mapping[str, Model]
    seen: tuple[str, ...]
    shown: Mapping[str, Placement]
    table: Model
    warnings: tuple[str, ...] = ()
    found: FoundYaws = field(default_factory=lambda: FoundYaws({}))
    yaws: Mapping[str, float] = field(default_factory=dict[str, float])

    def doubt(self, names: Collection[str], reason: str) -> SceneDraft:
        """Return the draft with the plan's models of these objects and without their placements."""
        mine = [n for n in self.models if n in names and self.models[n] is not self.planned[n]]
        yaws, warnings = dict(self.yaws), list(self.warnings)
        for name in mine:
            yaw = self.found.of(name, self.planned[name]) if name in yaws else None
            told = name not in yaws or yaw is not None
            yaws.pop(name, None)
            if yaw is not None:
                yaws[name] = yaw
            warnings.append(_plan_warning(name, reason, told))
        return replace(
            self, models={**self.models, **{n: self.planned[n] for n in mine}},
            shown={n: p for n, p in self.shown.items() if n not in names},
            warnings=tuple(warnings), yaws=yaws,
        )  # fmt: skip


def draft_scene(
    plan: ScenePlan,
    instances: Sequence[Instance],
    models: Mapping[str, Model],
    placements: Sequence[Placement],
    table_scale: Float[np.ndarray, "3"],
    seed: int,
    alike: tuple[float, float] = REAL,
    rotations: Mapping[str, Rotation] = MappingProxyType({}),
    turn: Turn | None = None,
) -> SceneDraft:
    """Match a reconstruction to the plan, and correct sizes and shapes that differ.

    ``models`` are the models of the instances and the table; ``placements`` are in the world frame;
    ``table_scale`` is the table's extent, metres. ``seed`` determines the appearance of the objects
    that the plan adds. ``alike`` is the tolerance of sizes (``ALIKE``, ``REAL``). ``rotations`` are
    the rotations of the instances' models, and ``turn`` estimates that of another model. An object
    whose sides all differ by about the same factor is scaled; one with other proportions is
    replaced by the plan's model. Instances that match no planned object are left out.
    """
    table, placed = _fit_table(plan, models[TABLE], placements, table_scale, seed)
    pairs = match_planned(plan, instances, placed, build_models(plan, seed))
    missing = [planned for planned in plan.objects if planned.name not in pairs]
    names = pairs | fresh_names(missing, {TABLE, *(i.name for i in instances)})
    renamed = rename_plan(plan, names)
    warnings = [
        *(f"{i.name} is left out: the prompt describes no further {i.label}." for i in instances
          if i.name in placed and i.name not in pairs.values()),
        *(f"{names[o.name]} is not visible in the drawing; it is placed as planned."
          for o in missing),
    ]  # fmt: skip
    if not np.allclose(table.size, table_scale):
        warnings.append("The table has the planned size instead of the size in the drawing.")
    scales = {name: placed[name].scale for name in pairs.values()}
    factors = _size_factors(renamed, scales, seed, alike)
    own = build_models(renamed, seed)
    found = FoundYaws({n: placed[n].yaw for n in pairs.values()}, rotations, turn)
    chosen, shown, yaws = dict(own), dict[str, Placement](), dict[str, float]()
    grouped, formed = _list_grouped(renamed), _list_grouped(renamed, besides=LOOSE)
    rng = np.random.default_rng([int(seed) & 0xFFFFFFFF, 11])
    for planned in renamed.objects:
        name, yaw = planned.name, natural_yaw(planned, own[planned.name], renamed, rng)
        if name not in placed:
            continue
        factor, below = factors[name], support_of(planned) or TABLE
        there = below in (TABLE, placed[name].on)
        if isinstance(factor, str):
            turned = None if name in formed else found.of(name, own[name])
            warnings.append(_plan_warning(name, factor, turned is not None or name in formed))
        else:
            turned = placed[name].yaw
            chosen[name] = replace(models[name], size=scales[name] * factor, slots=own[name].slots)
            if abs(np.log(factor)) > _HARDLY:
                warnings.append(
                    f"{name} has the planned size, {factor:.2f} times the reconstructed one."
                )
        if turned is not None and name not in grouped:
            yaws[name] = turned
        inside = any(r.kind == "in" and r.target == below for r in planned.relations)
        if there:
            shown[name] = replace(
                placed[name], yaw=yaw if turned is None else turned, scale=chosen[name].size,
                on=below, inside=inside,
            )  # fmt: skip
    return SceneDraft(
        renamed, chosen, own, tuple(pairs.values()), shown, table, tuple(warnings), found, yaws
    )


def _plan_warning(name: str, reason: str, told: bool) -> str:
    """Return a warning that an object's shape and, unless ``told``, its yaw come from the plan."""
    tail = "" if told else " The plan also determines the yaw, which the drawing does not show."
    return f"{name} is built from the plan: {reason}.{tail}"


def _list_grouped(plan: ScenePlan, besides: Collection[str] = ()) -> set[str]:
    """Return the names of the objects in groups, except groups of the kinds in ``besides``."""
    groups = [g for g in plan.groups if g.kind not in besides]
    return {n for g in groups for n in (*g.members, *([g.around] if g.around else []))}


def _size_factors(
    plan: ScenePlan,
    scales: Mapping[str, Float[np.ndarray, "3"]],
    seed: int,
    alike: tuple[float, float],
) -> dict[str, float | str]:
    """Return each reconstructed object's scale factor, or the reason for using the plan's model.

    A size that the text states ("small") must be matched exactly; a usual size need only match some
    variant of the object's kind approximately. The plan's models replace objects that must fit each
    other, and also corresponding objects of several place settings unless all of these were
    reconstructed.
    """
    variants = [build_models(plan, seed)]
    fitted = find_fitted(plan)
    factors: dict[str, float | str] = {}
    for planned in plan.objects:
        name = planned.name
        if name not in scales:
            continue
        told = planned.size is not None or "size" in planned.attributes
        stand_in = variants[0][name].stand_in
        tolerance = UNKNOWN if stand_in and not told else alike[0]
        factor = compare_sizes(scales[name], variants[0][name].size, tolerance)
        for k in range(1, 1 if told or factor == 1 else _VARIANTS):
            if k == len(variants):
                variants.append(build_models(plan, seed + _APART * k))
            if compare_sizes(scales[name], variants[k][name].size, alike[1]) == 1:
                factor = 1.0
                break
        if (stand_in and factor is None) or (told and factor == 1):
            factor = _mean_factor(scales[name], variants[0][name].size)
        factors[name] = _FITTED if name in fitted else _SHAPE if factor is None else factor
    for names in _list_laid_alike(plan):
        if not all(isinstance(factors.get(name), float) for name in names):
            known = {n: factors[n] for n in names if n in factors}
            factors |= {n: _ALIKE for n, f in known.items() if isinstance(f, float)}
    return factors


def _list_laid_alike(plan: ScenePlan) -> list[list[str]]:
    """Return the objects of place settings, grouped by kind."""
    laid = {name for group in plan.groups if group.kind == "setting" for name in group.members}
    kinds: dict[str, list[str]] = {}
    for planned in plan.objects:
        if planned.name in laid:
            kind = f"{planned.noun} {sorted(planned.attributes.items())}"
            kinds.setdefault(kind, []).append(planned.name)
    return list(kinds.values())


def compare_sizes(
    found: Float[np.ndarray, "3"], planned: Float[np.ndarray, "3"], tolerance: float
) -> float | None:
    """Return the factor that scales an object to a planned size, or None if the shapes differ.

    Extents are (length, width, height) in metres; the order of the horizontal sides is ignored. A
    factor of 1 means that no side differs by more than ``tolerance``.
    """
    have, want = (np.array([*np.sort(e[:2]), e[2]], float) for e in (found, planned))
    slack = min(_SLACK[0], _SLACK[1] * float(want.max()))
    off = np.where(np.abs(have - want) < slack, 0.0, np.log(want / have))
    if (np.abs(off) <= np.log(tolerance)).all():
        return 1.0
    if np.ptp(np.log(want / have)) > np.log(tolerance):
        return None
    return _mean_factor(found, planned)


def _mean_factor(found: Float[np.ndarray, "3"], planned: Float[np.ndarray, "3"]) -> float:
    return float(np.cbrt(np.prod(planned) / np.prod(found)))


def _fit_table(
    plan: ScenePlan,
    model: Model,
    placements: Sequence[Placement],
    scale: Float[np.ndarray, "3"],
    seed: int,
) -> tuple[Model, dict[str, Placement]]:
    """Return the table, resized as planned if its size differs, and the placements on it."""
    try:
        wanted = np.array(table_size(plan, build_models(plan, seed)).size)
    except SceneError:  # Only the objects in the picture determine whether everything fits.
        wanted = np.array(plan.table.size)
    ratio = wanted / scale
    if (np.abs(np.log(ratio[:2])) <= np.log(TABLES)).all():
        ratio = np.ones(3)
    size = scale * ratio
    factors = np.array([*ratio[:2], 1.0])
    lift = np.array([0.0, 0.0, float(size[2] - scale[2])])
    placed = {p.name: replace(p, translation=p.translation * factors + lift) for p in placements}
    return replace(model, size=size), placed


Turn = Callable[[str, Model], Rotation]
"""Function that estimates how another model of the named instance is rotated in the drawing."""

AGREE = float(np.deg2rad(15.0))
"""Yaws of two shapes of one object agree if they differ by less than this angle."""

TOLD, SURE = 0.2, 0.5
"""Minimum margins (``Rotation.margin``) at which the drawing determines a yaw: a yaw on which two
shapes agree, and a yaw of only the plan's shape."""


@dataclass(frozen=True, eq=False)
class FoundYaws:
    """Yaws of objects in the drawing, in radians.

    Attributes:
        yaws: yaws of the reconstructed shapes, by name.
        rotations: the estimates of these yaws, with their certainty.
        turn: function that estimates the yaw of another shape. If None, the yaws are those of the
            objects' fronts, which all shapes share.
    """

    yaws: Mapping[str, float]
    rotations: Mapping[str, Rotation] = field(default_factory=dict[str, Rotation])
    turn: Turn | None = None

    def of(self, name: str, planned: Model) -> float | None:
        """Return the plan model's yaw that matches the drawing, or None if it cannot be determined.

        Modelers choose the axes of their meshes, so the yaw of a reconstructed shape is used only
        if the plan's shape matches the drawing at the same yaw.
        """
        yaw = self.yaws[name]
        if self.turn is None:
            return yaw
        other = self.turn(name, replace(planned, orientation=rotation_z(yaw)))
        if other.symmetric:
            return yaw
        known = self.rotations.get(name)
        margin = max(other.margin, known.margin if known else 0.0)
        apart = abs(wrap(other.order * (other.yaw - yaw))) / other.order
        if apart <= AGREE and margin >= TOLD:
            return yaw
        return other.yaw if other.margin >= SURE else None
