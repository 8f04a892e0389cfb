"""From placements to the published scene: repeated attempts, each checked by the gate.

If a scene fails its gate, the object that the failures name most often is put on a weighted foot,
provided that it moves. If that does not help, it is left out. Otherwise one wrong detection (two
objects merged into one, a shadow taken for an object) would discard the whole table. The provenance
and the report list the objects that were left out.

The scene of a text, however, must contain the planned objects (``planned``). Objects that fail the
gate, or whose relations do not hold at rest, are replaced by the plan's and, as a last resort, all
objects are.

Assembly moves objects after the joint refinement, so the finished scene is measured again in the
same way. If assembly undoes a refinement, the latter is discarded.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

import numpy as np
from jaxtyping import Float

from ..layout.relation_check import (
    correct_supports,
    list_unmet,
    observe,
    record_relations,
    warn_unmet,
)
from ..scene import (
    TABLE,
    Failure,
    Instance,
    Model,
    Placement,
    Provenance,
    Reference,
    Rotation,
    Scene,
    SizePrior,
    View,
)
from .assembly import AssemblyConfig, assemble
from .attempts import Candidate, try_layouts
from .planned import ALIKE, REAL, Laid, SceneDraft, Turn, draft_scene, lay_out_draft
from .refinement import Refinement, RefinementConfig, outline_misfit

WORSE = 0.005
"""Maximum increase of the outlines' misfit from before the refinement to the finished scene."""

_FEET = 4  # maximum number of objects in a picture that get a foot to pass the gate
_FULFILLED = 4  # number of scenes after which one with unmet relations is accepted
_FAITHFUL = 2  # number of scenes that keep objects from the drawing
_MISPLACED = "the reconstruction violates its relations"

UNREFINED = "The joint refinement was discarded: the scene matches the picture better without it."

Placements = tuple[Placement, ...]


@dataclass(frozen=True, eq=False)
class Reconstruction:
    """Results of the stages before assembly, and settings for the stages after it.

    ``instances`` and ``models`` include the table; ``table_scale`` is its extent, metres. Warnings
    of the attempt are added to ``provenance``. ``seed`` determines the appearance and the positions
    of the plan's objects. ``supplements`` means that the plan of a text corrects the
    reconstruction; ``of_catalogue`` means that the drawing shows the catalogue's own objects.
    ``refinement`` has the settings with which outlines are measured; ``leave_out`` is the fraction
    of the detected objects that may be left out, in [0, 1]. ``rotations`` are the rotations of the
    instances' models, and ``turn`` estimates that of another model in the picture. If ``turn`` is
    None, all models of an object share its front.
    """

    reference: Reference
    instances: tuple[Instance, ...]
    sizes: Mapping[str, SizePrior]
    models: Mapping[str, Model]
    view: View
    table_scale: Float[np.ndarray, "3"]
    provenance: Provenance
    name: str
    seed: int = 0
    assembly: AssemblyConfig = field(default_factory=AssemblyConfig)
    refinement: RefinementConfig = field(default_factory=RefinementConfig)
    supplements: bool = True
    of_catalogue: bool = False
    leave_out: float = 0.2
    rotations: Mapping[str, Rotation] = field(default_factory=dict[str, Rotation])
    turn: Turn | None = None

    def assemble(self, attempt: Attempt) -> Scene:
        """Return the settled scene of an attempt, with its report (Sec. 3.4)."""
        models = {name: model for name, model in self.models.items() if name != TABLE}
        provenance = self._warn(attempt.warnings)
        return assemble(
            models, attempt.placements, self.models[TABLE], self.table_scale, name=self.name,
            provenance=provenance, config=self.assembly, view=self.view, plan=self.reference.plan,
            footed=attempt.footed,
        )  # fmt: skip

    def draft(self, placements: Placements) -> SceneDraft | None:
        """Return the reconstruction corrected by the text's plan, or None if there is no plan."""
        plan = self.reference.plan
        if plan is None or not self.supplements:
            return None
        return draft_scene(
            plan, self.instances, self.models, placements, self.table_scale, self.seed,
            ALIKE if self.of_catalogue else REAL, self.rotations, self.turn,
        )  # fmt: skip

    def assemble_laid(self, laid: Laid) -> Scene:
        """Return the settled scene of the objects of a laid-out draft, with its report."""
        plan, size = laid.draft.plan, laid.table.size
        table = replace(plan.table, size=(float(size[0]), float(size[1]), float(size[2])))
        return assemble(
            laid.draft.models, laid.placements, laid.table, size, name=self.name,
            provenance=self._warn((*laid.draft.warnings, *laid.warnings)), config=self.assembly,
            view=self.view, plan=replace(plan, table=table),
        )  # fmt: skip

    def _warn(self, warnings: Sequence[str]) -> Provenance:
        known = self.provenance.warnings
        return replace(self.provenance, warnings=tuple(dict.fromkeys([*known, *warnings])))

    def misfit(self, scene: Scene) -> float:
        """Return one minus the overlap between the finished scene's outlines and the picture's."""
        height, width = self.reference.image.shape[:2]
        return outline_misfit(
            self.instances, scene.objects, self.view, (width, height), self.refinement, self.seed
        )


@dataclass(frozen=True)
class Attempt:
    """One scene to try: the detected objects and their placements.

    ``warnings`` explain the changes and go into the provenance. ``left_out`` names the detected
    objects that are left out; ``removals`` counts those left out because the gate failed.
    ``footed`` names the objects that stand on a weighted foot from the start because they do not
    rest without one.
    """

    placements: Placements
    warnings: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()
    removals: int = 0
    footed: tuple[str, ...] = ()

    def on_foot(self, name: str) -> Attempt:
        """Return the attempt with the object on a weighted foot."""
        return replace(self, footed=(*self.footed, name))

    def without(self, name: str, failures: Sequence[Failure]) -> Attempt:
        """Return the attempt without the object and its contents, with a warning for each."""
        contents = contents_of(self.placements, name)
        reason = "; ".join(str(f) for f in failures if name in f.objects)
        told = [f"{name} was left out: {reason}."]
        told += [f"{other} was left out with {name}." for other in contents]
        return replace(
            self, placements=without(self.placements, name), warnings=(*self.warnings, *told),
            left_out=(*self.left_out, name, *contents), removals=self.removals + 1,
            footed=tuple(n for n in self.footed if n not in (name, *contents)),
        )  # fmt: skip


def publish(found: Reconstruction, refined: Refinement, unrefined: Placements) -> Scene:
    """Return the scene to publish, with its report and misfit.

    If there is a plan, see ``publish_planned``. Otherwise the scene is assembled from the refined
    placements. If its outlines match the picture worse than those of the ``unrefined`` placements,
    the latter are tried as well. A scene that passes its gate is preferred; if both or neither
    does, the one that matches better. ``refined.before`` is 0 if nothing was refined. The support
    of an object is set to what it touches at rest.
    """
    draft = found.draft(refined.placements)
    if draft is not None:
        scene = publish_planned(found, draft)
        if not refined.before:
            return scene
        return _with_report(scene, misfit=_round(refined.before, found.misfit(scene)))
    scene = assemble_sound(found, Attempt(refined.placements))
    if not refined.before:
        return correct_supports(scene, observe(scene))
    misfit = found.misfit(scene)
    if misfit > refined.before + WORSE and refined.after < refined.before:
        other = assemble_sound(found, Attempt(unrefined, (UNREFINED,)))
        other_misfit = found.misfit(other)
        if (_is_sound(other), -other_misfit) > (_is_sound(scene), -misfit):
            scene, misfit = other, other_misfit
    scene = correct_supports(scene, observe(scene))
    return _with_report(scene, misfit=_round(refined.before, misfit))


def publish_planned(found: Reconstruction, draft: SceneDraft) -> Scene:
    """Return the scene of a draft that passes its gate and leaves the fewest relations unmet.

    The drawing's objects are tried first. Objects that the gate's failures name, or whose relations
    do not hold, are replaced by the plan's; from the third scene on, all objects are. Relations
    that do not hold in the final scene are listed in the warnings and in the report.
    """
    attempts = try_layouts(_Drafting(found, draft).lay_out, found.seed, fulfilled=_FULFILLED)
    return attempts.failed[0] if attempts.best is None else warn_unmet(attempts.best)


@dataclass(eq=False)
class _Drafting:
    """A draft in which the plan's objects replace those that failed in earlier attempts."""

    found: Reconstruction
    draft: SceneDraft
    attempts: int = 0

    def lay_out(self, seed: int) -> Candidate:
        if self.attempts == _FAITHFUL:
            self.draft = self.draft.doubt({*self.draft.models}, _MISPLACED)
        self.attempts += 1
        layout = lay_out_draft(self.draft, seed)
        self.draft = layout.draft
        return Candidate(partial(self._judge, layout))

    def _judge(self, layout: Laid) -> Scene:
        scene, known = self.found.assemble_laid(layout), {*self.draft.models}
        if scene.report is not None and not scene.report.passed:
            failing = {name for failure in scene.report.failures for name in failure.objects}
            self.draft = self.draft.doubt(
                known & failing or known, "the object does not stand stably"
            )
            return scene
        scene = record_relations(scene)
        doubted = {name for each in list_unmet(scene) for name in (each.name, each.target)}
        if doubted:
            self.draft = self.draft.doubt(doubted, _MISPLACED)
        return scene


def assemble_sound(found: Reconstruction, attempt: Attempt) -> Scene:
    """Return the first scene that passes its gate, or else the first with all detected objects."""
    most = allowance(found.leave_out, len(attempt.placements))
    everything: Scene | None = None
    while True:
        scene = found.assemble(attempt)
        if scene.report is None or scene.report.passed:
            known = scene.report.dropped if scene.report else ()
            dropped = tuple(sorted({*known, *attempt.left_out}))
            return _with_report(scene, dropped=dropped) if attempt.left_out else scene
        failures = scene.report.failures
        everything = everything or scene
        culprit = most_named(failures, attempt.placements, found.sizes)
        if culprit is None:
            return everything
        restless = culprit in _list_restless(failures)
        if restless and culprit not in attempt.footed and len(attempt.footed) < _FEET:
            attempt = attempt.on_foot(culprit)
        elif attempt.removals == most:
            return everything
        else:
            attempt = attempt.without(culprit, failures)


def allowance(share: float, count: int) -> int:
    """Return how many of ``count`` objects may be left out: a fraction of them, but never all.

    If there are two or more objects, at least one may be left out, unless the fraction is 0.
    """
    return min(max(1, int(share * count + 1e-9)), count - 1) if share and count else 0


def most_named(
    failures: Sequence[Failure], placements: Sequence[Placement], sizes: Mapping[str, SizePrior]
) -> str | None:
    """Return the placed object that the gate's failures name most often, or None if they name none.

    Ties are resolved in favour of the object whose size deviates most from its usual size.
    """
    counts = Counter(name for failure in failures for name in failure.objects)
    named = [(counts[p.name], _oddness(p, sizes), p.name) for p in placements]
    count, _, name = max(named, default=(0, 0.0, ""))
    return name if count else None


def _list_restless(failures: Sequence[Failure]) -> set[str]:
    """Return the names of objects that moved or tilted, which a weighted foot may prevent."""
    return {name for failure in failures if failure.restless for name in failure.objects}


def without(placements: Sequence[Placement], name: str) -> Placements:
    """Return the placements without ``name`` and its contents.

    Objects on top of a removed one are placed on the support of ``name``.
    """
    (first,) = (p for p in placements if p.name == name)
    gone = {name, *contents_of(placements, name)}
    return tuple(
        replace(p, on=first.on, inside=first.inside) if p.on in gone else p
        for p in placements
        if p.name not in gone
    )


def contents_of(placements: Sequence[Placement], name: str) -> tuple[str, ...]:
    """Return the contents of ``name``, including nested ones, in the order of the placements."""
    gone = {name}
    while more := {p.name for p in placements if p.inside and p.on in gone} - gone:
        gone |= more
    return tuple(p.name for p in placements if p.name in gone - {name})


def _oddness(placement: Placement, sizes: Mapping[str, SizePrior]) -> float:
    """Return the absolute logarithm of the ratio of an object's longest side to the usual one."""
    prior = sizes.get(placement.name)
    return abs(float(np.log(placement.scale.max() / prior.extent.max()))) if prior else 0.0


def _is_sound(scene: Scene) -> bool:
    return scene.report is None or scene.report.passed


def _round(before: float, after: float) -> tuple[float, float]:
    return round(before, 6), round(after, 6)


def _with_report(scene: Scene, **entries: Any) -> Scene:
    """Return the scene with the given entries of its report replaced, if it has a report."""
    if scene.report is None:
        return scene
    return scene.replace(report=replace(scene.report, **entries))
