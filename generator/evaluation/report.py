"""Evaluation of a whole scene: all measurements and findings in one value (Secs. 4.1 and 4.2)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from jaxtyping import UInt8

from ..bundle import Segments, load, load_picture, load_segments
from ..comparison import Comparison, compare
from ..errors import InputError
from ..scene import Scene
from . import findings as found_in
from .external import TRANSFORMS, load_external
from .findings import DefectLimits, Finding
from .judged import Marks, as_judge, judge_scene, marks_from_figures, rank_methods
from .perceptual import Available
from .soundness import Soundness, soundness
from .surfaces.collisions import Collisions, colliding, collisions
from .surfaces.silhouettes import SilhouetteFit, fits
from .surfaces.sweep import Best, SweepConfig, best_views
from .truth import TruthErrors, UsualSize, truth_errors, usual_sizes

Picture = UInt8[np.ndarray, "_ _ 3"]


@dataclass(frozen=True, eq=False)
class Evaluation:
    """The results for one scene; parts that could not be measured are None or empty.

    ``notes`` lists skipped parts with the reasons. ``perceptual`` has each metric at its best view
    in the sweep; ``missing`` has the reasons why metrics are unavailable. ``marks`` are derived
    from measured values or given by a judge.
    """

    scene: Scene
    findings: tuple[Finding, ...]
    collisions: Collisions
    sizes: tuple[UsualSize, ...]
    marks: Marks
    soundness: Soundness | None = None
    comparison: Comparison | None = None
    fits: tuple[SilhouetteFit, ...] = ()
    truth: TruthErrors | None = None
    perceptual: tuple[Best, ...] = ()
    missing: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))
    notes: tuple[str, ...] = ()

    @property
    def flawless(self) -> bool:
        """Whether there are no findings."""
        return not self.findings

    def of(self, name: str) -> tuple[Finding, ...]:
        """Return the findings that involve an object."""
        return tuple(f for f in self.findings if name in (f.name, f.other))

    def facts(self) -> dict[str, Any]:
        """Return all results as JSON values."""
        return {
            "name": self.scene.name,
            "objects": len(self.scene.objects),
            "flawless": self.flawless,
            "findings": [f.facts() for f in self.findings],
            "collisions": self.collisions.facts(),
            "soundness": None if self.soundness is None else self.soundness.facts(),
            "sizes": [
                {"name": s.name, "ratio": round(s.ratio, 4), "source": s.source} for s in self.sizes
            ],
            "picture": None if self.comparison is None else self._picture_facts(self.comparison),
            "perceptual": {best.metric: best.facts() for best in self.perceptual},
            "perceptual_missing": dict(self.missing),
            "marks": self.marks.facts(),
            "truth": None if self.truth is None else self.truth.facts(),
            "notes": list(self.notes),
        }

    def _picture_facts(self, compared: Comparison) -> dict[str, Any]:
        turned = [
            {
                "name": f.name,
                "iou_alone": round(f.iou, 4),
                "best_turn_deg": round(float(np.rad2deg(f.turn)), 1),
                "best_turn_iou": round(f.turned_iou, 4),
                "best_factor": f.factor,
                "best_factor_iou": round(f.scaled_iou, 4),
            }
            for f in self.fits
        ]
        return {**compared.facts(), "fits": turned}


def evaluate(
    scene: Scene,
    *,
    picture: Picture | None = None,
    segments: Segments | None = None,
    truth: Scene | None = None,
    limits: DefectLimits | None = None,
    simulate: bool = True,
    metrics: Available | None = None,
    sweep: SweepConfig | None = None,
    judge: object | None = None,
) -> Evaluation:
    """Measure a scene and list its defects.

    Args:
        scene: the scene, at its settled poses.
        picture: the reference picture, which all visual comparisons require.
        segments: the picture's segmentation, required to compare silhouettes.
        truth: the true scene, with objects of the same names.
        limits: limits above which deviations are defects.
        simulate: whether to simulate the scene at rest in MuJoCo.
        metrics: perceptual metrics (see ``perceptual.available``); None skips the sweep.
        sweep: settings of the camera sweep.
        judge: judge that marks the scene; if None, marks are derived from measured values.

    Raises:
        InputError: A required picture is missing, or it does not match ``segments``.
        SceneError: MuJoCo cannot build the scene.
        BackendError: ``judge`` is not a ``Judge``.
    """
    if picture is None and (metrics is not None or judge is not None):
        raise InputError("Metrics and judges require the reference picture; pass it as `picture`.")
    if judge is not None:
        as_judge(judge)
    limits = limits or DefectLimits()
    notes = []
    overlaps = collisions(scene, limits.overlap)
    held = soundness(scene, limits.rule) if simulate else None
    sizes = usual_sizes(scene)
    compared, fitted = None, ()
    if picture is not None and segments is not None:
        compared = compare(scene, segments, picture)
        fitted = fits(compared)
    else:
        lacking = "picture" if picture is None else "segmentation of its picture"
        notes.append(f"silhouettes were not compared: there is no {lacking}")
    if held is None:
        notes.append("not simulated")
    errors = None if truth is None else truth_errors(scene, truth)
    findings = [
        *found_in.of_collisions(overlaps, limits),
        *(found_in.of_soundness(held) if held else ()),
        *found_in.of_sizes(sizes, limits),
        *found_in.of_fits(fitted, limits),
        *(found_in.of_comparison(compared) if compared else ()),
        *(found_in.of_truth(errors, limits) if errors else ()),
    ]
    best: tuple[Best, ...] = ()
    if metrics is not None and picture is not None:
        best = best_views(scene, picture, metrics.metrics, sweep)
    return Evaluation(
        scene, tuple(findings), overlaps, sizes,
        _marks(scene, overlaps, held, compared, judge, picture),
        held, compared, fitted, errors, best,
        MappingProxyType({}) if metrics is None else metrics.missing, tuple(notes),
    )  # fmt: skip


def evaluate_bundle(
    path: str | Path,
    *,
    picture: Picture | None = None,
    metrics: Available | None = None,
    **options: Any,
) -> Evaluation:
    """Evaluate a bundle, or a folder with another method's result (see ``external``), from disk.

    The reference picture defaults to the one in the bundle. Without a picture, metrics are skipped
    and a note says so. Other ``options`` are those of :func:`evaluate`.

    Raises:
        BundleError: The bundle does not exist or is damaged.
        InputError: The other method's folder is invalid, or the picture does not match.
    """
    folder = Path(path)
    segments = None
    if (folder / TRANSFORMS).is_file():
        scene = load_external(folder)
    else:
        scene, segments = load(folder), load_segments(folder)
        picture = load_picture(folder, "reference") if picture is None else picture
    blind = metrics is not None and picture is None
    shown = None if blind else metrics
    found = evaluate(scene, picture=picture, segments=segments, metrics=shown, **options)
    note = ("no sweep was rendered: the scene has no picture; pass a picture",) if blind else ()
    return replace(found, notes=found.notes + note)


def ranking(
    evaluations: Mapping[str, Evaluation], picture: Picture, judge: object
) -> tuple[str, ...]:
    """Ask a judge to rank several methods' scenes of the same picture, from best to worst.

    Raises:
        BackendError: ``judge`` is not a ``Judge``, or does not name each method exactly once.
    """
    shown = {name: (_draw(e.scene, e.comparison),) for name, e in evaluations.items()}
    return rank_methods(judge, picture, shown)


def _draw(scene: Scene, compared: Comparison | None) -> Picture:
    """Draw a scene from its picture's camera or, if that is unknown, from the front and above."""
    from ..render.sheet import render_scene

    return render_scene(scene, camera=None if compared is None else compared.camera).image


def _marks(
    scene: Scene,
    overlaps: Collisions,
    held: Soundness | None,
    compared: Comparison | None,
    judge: object | None,
    picture: Picture | None,
) -> Marks:
    if judge is not None and picture is not None:
        return judge_scene(judge, picture, (_draw(scene, compared),))
    wrong: set[str] = set(colliding(overlaps))
    if held is not None:
        wrong |= {*held.unstable, *held.floating, *held.off_table}
    shown: Sequence[bool] = [s.built for s in compared.scores if s.found] if compared else []
    return marks_from_figures(
        iou=compared.mean_iou if compared else None,
        built=float(np.mean(shown)) if len(shown) else None,
        pair_collisions=overlaps.col_o,
        unsound=len(wrong) / max(len(scene.objects), 1),
        simulated=held is not None,
    )
