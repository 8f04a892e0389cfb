"""A study of two methods and six scenes, and three raters with a table computed by hand.

Marks of ``ours`` and ``other``, by rater:

=======  ==============================================  ========================================
rater    ours: VF, IA, PP, overall                       other: VF, IA, PP, overall
=======  ==============================================  ========================================
first    6, 5, 7, 6                                      3, 3 (scene-0: 2), 4, 3
second   5, 5, 6, 6                                      4, 3, 4, 4 (scene-0 and scene-1: 6)
third    7 (scene-3 to scene-5: 4), 5, 5, 4              5, 4, 4, 5
=======  ==============================================  ========================================

The first always prefers ours; the second other in scene-0 and scene-1; the third ours in scene-5.
"""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
from jaxtyping import UInt8

from generator.io.pictures import write_picture
from tabletopgen_web.study.collection import collect
from tabletopgen_web.study.design import CRITERIA, Drawing, StudyOptions
from tabletopgen_web.study.key import StudyKey
from tabletopgen_web.study.page import StudyFiles, make_study, write_study
from tabletopgen_web.study.page_data import MARK, StudyPage, read_page

METHODS = ("ours", "other")
SCENES = tuple(f"scene-{k}" for k in range(6))

TEMPLATE = f"""<!doctype html>
<html><head><meta charset="utf-8" /><title>Study</title>
<script type="module">let a = 1;</script><style>p {{ color: red }}</style></head>
<body>{MARK}</body></html>
"""
"""In place of the built page."""

POST = "/api/studies/{study}/answers"
"""Where a studio takes answers."""

Marks = tuple[int, int, int, int]


def marks(rater: int, method: str, scene: str) -> Marks:
    """Return the ratings of the table above."""
    number = int(scene[-1])
    if method == "ours":
        third = (7 if number < 3 else 4, 5, 5, 4)
        return ((6, 5, 7, 6), (5, 5, 6, 6), third)[rater]
    first = (3, 2 if number == 0 else 3, 4, 3)
    return (first, (4, 3, 4, 6 if number < 2 else 4), (5, 4, 4, 5))[rater]


def preferred(rater: int, scene: str) -> str:
    """Return the choices of the table above."""
    number = int(scene[-1])
    return METHODS[(False, number < 2, number < 5)[rater]]


def check_table(facts: Mapping[str, Any]) -> None:
    """Check the results of the three raters' answers, computed by hand.

    VF of ours: (6 * 6 + 6 * 5 + 3 * 7 + 3 * 4) / 18 = 99 / 18. IA of other: (2 + 5 * 3 + 6 * 3 +
    6 * 4) / 18 = 59 / 18. Of three raters all are the same one in 1 of 27 bootstrap samples, which
    is more than 2.5 %: an interval reaches from the lowest to the highest rater's own mean.
    """
    ours, other = facts["methods"]
    means = {name: round(one["mean"], 4) for name, one in ours["means"].items()}
    assert means == dict(zip(CRITERIA, (5.5, 5.0, 6.0, 5.3333), strict=True))
    means = {name: round(one["mean"], 4) for name, one in other["means"].items()}
    assert means == dict(zip(CRITERIA, (4.0, 3.2778, 4.0, 4.2222), strict=True))
    assert [round(m["average"]["mean"], 4) for m in (ours, other)] == [5.5, 3.7593]
    assert [round(x, 4) for x in ours["means"]["visual_fidelity"]["interval"]] == [5.0, 6.0]
    assert [round(x, 4) for x in ours["means"]["image_alignment"]["interval"]] == [5.0, 5.0]
    assert (ours["chosen"], other["chosen"]) == (11, 7)
    assert round(ours["share"], 4) == 0.6111
    assert [round(x, 4) for x in ours["share_interval"]] == [0.3862, 0.7969]
    (pair,) = facts["pairs"]
    assert (pair["wins"], pair["ties"], pair["losses"]) == (10, 2, 6)
    assert round(pair["rate"]["mean"], 4) == round(11 / 18, 4)
    # Coincidences of the two choices: 1 in each of scene-0 to scene-4, so 1 - 17 * 5 / (11 * 7).
    assert round(facts["agreement"]["choice"], 6) == round(1 - 85 / 77, 6)


def picture(seed: int) -> UInt8[np.ndarray, "96 128 3"]:
    """Return patches of random colours."""
    small = np.random.default_rng(seed).integers(0, 256, (6, 8, 3), dtype=np.uint8)
    return np.kron(small, np.ones((16, 16, 1), np.uint8))


def write_pictures(
    folder: Path, methods: Sequence[str] = METHODS, scenes: Sequence[str] = SCENES
) -> dict[str, Path]:
    """Write input pictures into ``inputs`` and methods' results into their folders."""
    for j, name in enumerate(("inputs", *methods)):
        for k, scene in enumerate(scenes):
            write_picture(picture(100 * j + k), folder / name / f"{scene}.png")
    return {method: folder / method for method in methods}


def small_study(
    folder: Path,
    methods: Sequence[str] = METHODS,
    names: Sequence[str] = SCENES,
    template: str = TEMPLATE,
    **options: Any,
) -> StudyFiles:
    """Return a study of plain pictures; by default each rater sees all scenes.

    The pictures are decoded in this process: a child per picture takes most of a test's time.
    """
    results = write_pictures(folder, methods, names)
    with mock.patch("generator.sandbox.runner.is_inside", return_value=True):
        found, ignored = collect(results, folder / "inputs", Drawing())
    assert ignored == []
    chosen = StudyOptions(**{"scenes": len(names), "min_seconds": 0, **options})
    return make_study(found, methods, chosen, template)


def served_study(folder: Path, **options: Any) -> tuple[StudyFiles, StudyPage]:
    """Return a study that a studio serves, and its page, read back."""
    files = small_study(folder / "pictures", post=POST, **options)
    page, _ = write_study(files, folder / "study.html")
    return files, read_page(page, options.get("template", TEMPLATE), POST)


def answers_of(key: StudyKey, number: int, **changes: Any) -> dict[str, Any]:
    """Return the answers of one of the three raters in the page's format."""
    scenes = []
    for code, scene in key.scenes.items():
        codes = {method: result for result, method in scene.results.items()}
        ratings = {codes[m]: dict(zip(CRITERIA, marks(number, m, scene.name), strict=True))
                   for m in METHODS}  # fmt: skip
        scenes.append({
            "scene": code, "seconds": 30.0, "order": [*scene.results], "ratings": ratings,
            "choice": codes[preferred(number, scene.name)],
        })  # fmt: skip
    checks = [{"scene": code, "asked": 3, "given": 3} for code in [*key.scenes][: key.attention]]
    return {
        "schema": 1, "study": key.study, "rater": f"{number:016x}", "language": "en",
        "seconds": 30.0 * len(scenes), "scenes": scenes, "checks": checks, **changes,
    }  # fmt: skip


def write_answers(folder: Path, facts: Mapping[str, Any], name: str | None = None) -> Path:
    """Write answers under the page's file names."""
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / (name or f"answers-{facts['study']}-{facts['rater']}.json")
    path.write_text(json.dumps(facts))
    return path
