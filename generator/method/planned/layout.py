"""Places for the things of a draft: those shown where they hold, the plan's for the others."""

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

_ROUNDS = 3  # in which more and more of what is shown gives way to relations that do not hold
_OVERLAP = 0.015  # metres by which footprints of things that stay may overlap: seats are guesses
_BEYOND = 0.01  # metres by which they may stick out over the table's edge
_LOST = 3  # relations that a thing without a place counts as

Places = Mapping[str, Placement]


@dataclass(frozen=True, eq=False)
class Laid:
    """A draft with a place for each of its things."""

    draft: SceneDraft
    placements: tuple[Placement, ...]
    table: Model
    warnings: tuple[str, ...]
    unmet: tuple[RelationOutcome, ...]

    @property
    def faults(self) -> int:
        """Relations that do not hold, and ``_LOST`` for each thing without a place."""
        return len(self.unmet) + _LOST * (len(self.draft.models) - len(self.placements))


def lay_out_draft(draft: SceneDraft, seed: int) -> Laid:
    """Return the draft with places: as shown where the plan agrees, by the plan elsewhere.

    Rows, circles and place settings are the plan's as a whole. If some relation would not hold
    then, the things it is between are placed anew too, and at last all things; the first layout of
    those with the fewest faults is taken. What still does not fit on or in another thing is built
    from the plan, and so is that.

    Raises:
        SceneError: nothing is shown, and the objects fit on no plausible table.
    """
    laid = _lay_out(draft, seed)
    unfit = {n for o in laid.unmet if o.kind in ("on", "in") for n in (o.name, o.target)}
    if any(draft.models[n] is not draft.planned[n] for n in unfit - {TABLE}):
        return lay_out_draft(draft.doubt(unfit, "nothing would stay on or in it, or it on"), seed)
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
            "The table is the plan's, and everything is placed on it anew.",
        )
        laid, _ = _judge(draft, layout.placements, table, warnings, ())
        if best is None or laid.faults < best.faults:
            best = laid
    return best


def _complete(draft: SceneDraft, kept: Places, seed: int) -> tuple[Laid, set[str]]:
    """Return a layout around what is kept, and what spoils relations in it."""
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
        warnings = (*warnings, f"Placed by the plan, not by the drawing: {', '.join(moved)}.")
    if lost:  # what is in the way is not known
        culprits |= {*kept}
    return Laid(draft, ordered, table, warnings, tuple(unmet)), culprits


def _list_kept(draft: SceneDraft) -> dict[str, Placement]:
    """Return the places shown that the plan does not speak against."""
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
    """Return the places without some, and without what stands on what has no known place."""
    left = {name: place for name, place in kept.items() if name not in names}
    while gone := [n for n, p in left.items() if p.on != TABLE and p.on not in left]:
        left = {name: place for name, place in left.items() if name not in gone}
    return left


def _find_crowding(draft: SceneDraft) -> set[str]:
    """Return what stands in another thing's place or off the table; large things stay first."""
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
