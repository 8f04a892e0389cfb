"""Statistics of raters' answers: means, choices, wins, and agreement, with intervals."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from itertools import combinations
from typing import Any

import numpy as np
from jaxtyping import Int

from generator.errors import InputError, require_number, require_seed
from tabletopgen_env.statistics import wilson

from .agreement import krippendorff
from .answers import RaterAnswers, Refusal
from .design import CRITERIA
from .key import StudyKey

RESAMPLES = 10_000
"""Number of bootstrap samples."""

Interval = tuple[float, float]


@dataclass(frozen=True)
class CountedMean:
    """A mean and its 95 % confidence interval, which is None for fewer than two raters."""

    mean: float
    interval: Interval | None


@dataclass(frozen=True)
class MethodFigures:
    """The mean ratings of a method, and how often it was chosen.

    ``means`` has a mean per entry of ``CRITERIA``, and ``average`` is the mean of the first three,
    as in Table 2. ``chosen`` is how often this method was chosen, ``share`` that number as a share
    of all choices, and ``share_interval`` its Wilson interval.
    """

    method: str
    means: Mapping[str, CountedMean]
    average: CountedMean
    chosen: int
    share: float
    share_interval: Interval


@dataclass(frozen=True)
class PairFigures:
    """Comparison of two methods.

    ``rate`` is the share of rated scenes in which the first method has the higher overall score,
    with ties counted as half. ``chosen`` and ``other_chosen`` are how often each of the two was
    chosen; ``chosen_share`` is the first's share of both, with Wilson's interval, or None if
    neither was chosen.
    """

    method: str
    other: str
    wins: int
    ties: int
    losses: int
    rate: CountedMean
    chosen: int
    other_chosen: int
    chosen_share: float | None
    chosen_interval: Interval | None


@dataclass(frozen=True)
class Exclusions:
    """Excluded raters by id; a rater may be in both lists."""

    inattentive: tuple[str, ...]
    too_fast: tuple[str, ...]
    allowed_failures: int
    min_seconds: float


@dataclass(frozen=True)
class StudyReport:
    """The results of a study; ``raters`` is the number of counted raters out of ``read``."""

    study: str
    title: str
    read: int
    raters: int
    ratings_each: int
    mean_seconds: float
    languages: Mapping[str, int]
    excluded: Exclusions
    left_out: tuple[Refusal, ...]
    methods: tuple[MethodFigures, ...]
    pairs: tuple[PairFigures, ...]
    agreement: Mapping[str, float | None]
    raters_by_scene: Mapping[str, int]
    seed: int

    def facts(self) -> dict[str, Any]:
        """Return the report as JSON values."""
        return asdict(self) | {"bootstrap_resamples": RESAMPLES}


def measure(
    answers: Sequence[RaterAnswers],
    left_out: Sequence[Refusal],
    key: StudyKey,
    *,
    min_seconds: float | None = None,
    allowed_failures: int = 0,
    seed: int = 0,
) -> StudyReport:
    """Evaluate a study; equal answers and seed give equal figures.

    Raters who failed more attention checks than allowed, or took less than ``min_seconds`` (by
    default the study's), are excluded. Means are over all ratings of the others. Their 95 %
    intervals are percentiles (2.5 and 97.5) of 10,000 bootstrap samples of *raters*, drawn with
    ``seed``, each with all of the rater's answers, since scores of one rater are correlated. They
    apply to the study's scenes. Wilson's intervals assume independent choices.

    Raises:
        InputError: no rater remains, or a setting is out of range.
    """
    require_seed(seed)
    require_number("--allow-failed", allowed_failures, minimum=0, integer=True)
    least = key.min_seconds if min_seconds is None else min_seconds
    require_number("--min-seconds", least, minimum=0)
    inattentive = tuple(a.rater for a in answers if a.failed > allowed_failures)
    fast = tuple(a.rater for a in answers if a.seconds < least)
    kept = [a for a in answers if a.rater not in {*inattentive, *fast}]
    if not kept:
        raise InputError(
            f"No rater remains: of {len(answers)} read, {len(inattentive)} failed the attention "
            f"checks and {len(fast)} took less than {least:g} s; {len(left_out)} files were "
            f"excluded" + (f", the first because {left_out[0].reason}" if left_out else ".")
        )
    drawn = _resample(len(kept), seed)
    languages = sorted(a.language for a in kept)
    return StudyReport(
        key.study, key.title, len(answers), len(kept), key.scenes_each * len(key.methods),
        sum(a.seconds for a in kept) / len(kept),
        {one: languages.count(one) for one in languages},
        Exclusions(inattentive, fast, allowed_failures, float(least)), tuple(left_out),
        tuple(_method(m, kept, drawn) for m in key.methods),
        tuple(_pair(a, b, kept, drawn) for a, b in combinations(key.methods, 2)),
        _agreement(kept, key),
        {s.name: sum(r.scene == code for a in kept for r in a.scenes)
         for code, s in key.scenes.items()},
        seed,
    )  # fmt: skip


def _resample(raters: int, seed: int) -> Int[np.ndarray, "b r"]:
    """Return how often each rater occurs in each bootstrap sample."""
    rng = np.random.default_rng(seed)
    picked = np.empty((RESAMPLES, raters), np.int16)
    for row in picked:
        row[:] = np.bincount(rng.integers(raters, size=raters), minlength=raters)
    return picked


def _mean(
    sums: Sequence[float], counts: Sequence[float], drawn: Int[np.ndarray, "b r"]
) -> CountedMean:
    """Return the mean of all values and its interval, given raters' ``sums`` and ``counts``."""
    total, count = np.array(sums, float), np.array(counts, float)
    mean = float(total.sum() / count.sum())
    if len(sums) < 2:
        return CountedMean(mean, None)
    both = np.stack([total, count], axis=1)
    parts = [part.astype(float) @ both for part in np.array_split(drawn, 20)]
    sampled = np.concatenate(parts)
    low, high = np.quantile(sampled[:, 0] / sampled[:, 1], [0.025, 0.975])
    return CountedMean(mean, (float(low), float(high)))


def _method(
    method: str, kept: Sequence[RaterAnswers], drawn: Int[np.ndarray, "b r"]
) -> MethodFigures:
    counts = [len(a.scenes) for a in kept]
    sums = [[sum(s.ratings[method][k] for s in a.scenes) for a in kept]
            for k in range(len(CRITERIA))]  # fmt: skip
    means = {name: _mean(sums[k], counts, drawn) for k, name in enumerate(CRITERIA)}
    thirds = [sum(three) / 3 for three in zip(*sums[:3], strict=True)]
    chosen = sum(s.choice == method for a in kept for s in a.scenes)
    choices = sum(counts)
    return MethodFigures(method, means, _mean(thirds, counts, drawn), chosen, chosen / choices,
                         wilson(chosen, choices))  # fmt: skip


def _pair(
    method: str, other: str, kept: Sequence[RaterAnswers], drawn: Int[np.ndarray, "b r"]
) -> PairFigures:
    overall = CRITERIA.index("overall")
    apart = [[s.ratings[method][overall] - s.ratings[other][overall] for s in a.scenes]
             for a in kept]  # fmt: skip
    flat = [d for each in apart for d in each]
    points = [sum(0.5 + 0.5 * ((d > 0) - (d < 0)) for d in each) for each in apart]
    chosen, others = (sum(s.choice == m for a in kept for s in a.scenes) for m in (method, other))
    both = chosen + others
    return PairFigures(
        method, other,
        sum(d > 0 for d in flat), sum(d == 0 for d in flat), sum(d < 0 for d in flat),
        _mean(points, [len(each) for each in apart], drawn),
        chosen, others, chosen / both if both else None, wilson(chosen, both) if both else None,
    )  # fmt: skip


def _agreement(kept: Sequence[RaterAnswers], key: StudyKey) -> dict[str, float | None]:
    """Return Krippendorff's alpha of each criterion (ordinal) and of the choice (nominal)."""
    marks: dict[tuple[str, str], list[tuple[int, ...]]] = defaultdict(list)
    chosen: dict[str, list[int]] = defaultdict(list)
    for scene in (s for a in kept for s in a.scenes):
        chosen[scene.scene].append(key.methods.index(scene.choice))
        for method, ratings in scene.ratings.items():
            marks[scene.scene, method].append(ratings)
    found = {
        name: krippendorff([[r[k] for r in unit] for unit in marks.values()], "ordinal")
        for k, name in enumerate(CRITERIA)
    }
    return found | {"choice": krippendorff(chosen.values(), "nominal")}
