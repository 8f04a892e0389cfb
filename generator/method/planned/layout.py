"""Positions for a draft's objects: those in the drawing if they are valid, otherwise the plan's."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from ...errors import SceneError
from ...layout import arrange_more, lay_out
from ...layout.footprint import Footprint, footprint, gaps, margins
from ...layout.furniture import outline_of
from ...layout.relation_check import check_relations, foresee
from ...layout.rest import support_of
from ...scene import TABLE, Model, Placement, RelationOutcome
from .draft import LOOSE, SceneDraft

_ROUNDS = 3  # number of rounds, each of which keeps fewer placements from the drawing
_OVERLAP = 0.015  # tolerated overlap between kept footprints, metres; positions are guesses
_BEYOND = 0.01  # how far these may extend beyond the table's edge, metres
_LOST = 3  # number of unmet relations that an object without a position counts as

Places = Mapping[str, Placement]


@dataclass(frozen=True, eq=False)
class Laid:
    """A draft with a position for each of its objects."""

    draft: SceneDraft
    placements: tuple[Placement, ...]
    table: Model
    warnings: tuple[str, ...]
    unmet: tuple[RelationOutcome, ...]

    @property
    def faults(self) -> int:
        """Number of unmet relations, plus ``_LOST`` for each object without a position."""
        return len(self.unmet) + _LOST * (len(self.draft.models) - len(self.placements))


def lay_out_draft(draft: SceneDraft, seed: int) -> Laid:
    """Return the draft with drawn positions or, where they contradict the plan, planned positions.

    Rows, circles and place settings are arranged as a whole, as planned. If a relation would not
    hold, its objects are placed again too and, as a last resort, all objects. The first of the
    layouts with the fewest faults is used. If an object still does not fit on or in another one,
    both are rebuilt from the plan.

    Raises:
        SceneError: no placement is known, and the objects do not fit on any plausible table.
    """
    laid = _lay_out(draft, seed)
    unfit = {n for o in laid.unmet if o.kind in ("on", "in") for n in (o.name, o.target)}
    if any(draft.models[n] is not draft.planned[n] for n in unfit - {TABLE}):
        return lay_out_draft(
            draft.doubt(unfit, "the objects did not stay on or in each other"), seed
        )
    return laid


def _lay_out(draft: SceneDraft, seed: int) -> Laid:
    kept = _list_kept(draft)
    best: Laid | None = None
    for _ in range(_ROUNDS if kept else 0):
        laid, culprits = _complete(draft, kept, seed)
        if best is None or laid.faults < best.faults:
            best = laid
        if not culprits & {*kept}:
            break
        kept = _without(draft, kept, culprits)
    if best is None or best.faults:
        try:
            layout, table = lay_out(draft.plan, draft.models, seed, draft.yaws)
        except SceneError:
            if best is None:
                raise
            return best
        warnings = (
            *layout.warnings,
            "The planned table is used, and all objects were placed on it again.",
        )
        laid, _ = _judge(draft, layout.placements, table, warnings, ())
        if best is None or laid.faults < best.faults:
            best = laid
    return best


def _complete(draft: SceneDraft, kept: Places, seed: int) -> tuple[Laid, set[str]]:
    """Return a layout around the kept placements, and the objects that violate relations in it."""
    layout = arrange_more(draft.plan, kept, draft.models, draft.table, seed, draft.yaws)
    placements = (*kept.values(), *layout.placements)
    return _judge(draft, placements, draft.table, layout.warnings, kept)


def _judge(
    draft: SceneDraft,
    placements: tuple[Placement, ...],
    table: Model,
    warnings: tuple[str, ...],
    kept: Collection[str],
) -> tuple[Laid, set[str]]:
    places = {p.name: p for p in placements}
    ordered = tuple(places[o.name] for o in draft.plan.objects if o.name in places)
    outcomes = check_relations(draft.plan, foresee(ordered, draft.models, table))
    unmet = [
        o for o in outcomes
        if not o.holds and not (o.kind in ("on", "in") and places[o.name].on == o.target)
    ]  # fmt: skip
    lost = {o.name for o in draft.plan.objects} - {*places}
    culprits = {o.name for o in unmet if o.name in kept}
    culprits |= {o.target for o in unmet if o.name not in kept}
    moved = [n for n in draft.seen if n in places and n not in kept]
    if moved:
        warnings = (*warnings, f"Placed as planned instead of as drawn: {', '.join(moved)}.")
    if lost:  # it is not known what the obstacle is
        culprits |= {*kept}
    return Laid(draft, ordered, table, warnings, tuple(unmet)), culprits


def _list_kept(draft: SceneDraft) -> dict[str, Placement]:
    """Return the placements from the drawing that do not contradict the plan."""
    supports = {o.name: support_of(o) or TABLE for o in draft.plan.objects}

    def stand(name: str) -> str:
        return name if supports[name] == TABLE else stand(supports[name])

    kept = dict(draft.shown)
    kept = _without(draft, kept, _find_crowding(draft))
    for group in draft.plan.groups:
        members = {stand(n) for n in (*group.members, *([group.around] if group.around else []))}
        if group.kind not in LOOSE or not members <= {*kept}:
            kept = _without(draft, kept, members)
    return _without(draft, kept, ())


def _without(draft: SceneDraft, kept: Places, names: Collection[str]) -> dict[str, Placement]:
    """Return the placements without ``names`` and without objects whose support is removed."""
    left = {name: place for name, place in kept.items() if name not in names}
    while gone := [n for n, p in left.items() if p.on != TABLE and p.on not in left]:
        left = {name: place for name, place in left.items() if name not in gone}
    return left


def _find_crowding(draft: SceneDraft) -> set[str]:
    """Return objects that overlap others or extend off the table; larger objects have priority."""
    outline = outline_of(draft.table)
    standing = {n: p for n, p in draft.shown.items() if p.on == TABLE}
    shapes = {n: footprint(draft.models[n], p.yaw) for n, p in standing.items()}
    stays: dict[str, Footprint] = {}
    order = sorted(standing, key=lambda n: (draft.models[n] is draft.planned[n], -shapes[n].area))
    for name in order:
        center = standing[name].translation[None, :2]
        free = float(margins(shapes[name], center, outline)[0]) > -_BEYOND
        for other, shape in stays.items():
            room = gaps(shapes[name], center, shape, standing[other].translation[:2])
            free = free and float(room[0]) > -_OVERLAP
        if free:
            stays[name] = shapes[name]
    return {*standing} - {*stays}
