"""Scores from 1 to 7: one request for all criteria, with validation of the answer."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from spoiling import shot, sound

from generator.backends.embedded.reasoner import EmbeddedReasoner
from generator.backends.protocols import Judge
from generator.errors import BackendError, InputError
from generator.evaluation import evaluate
from generator.evaluation.judged import (
    CRITERIA,
    MEASURED,
    judge_scene,
    marks_from_figures,
    rank_methods,
)

WHITE = np.full((8, 8, 3), 255, np.uint8)


class Friendly:
    """A judge with the given answers."""

    def __init__(self, marks: Mapping[str, Any], order: tuple[str, ...] = ()) -> None:
        self.marks, self.order, self.seen = marks, order, []

    def rate(self, reference: Any, pictures: Any, criteria: Mapping[str, str]) -> Mapping[str, Any]:
        self.seen.append((reference, pictures, criteria))
        return self.marks

    def rank(self, reference: Any, methods: Mapping[str, Any]) -> tuple[str, ...]:
        self.seen.append((reference, methods))
        return self.order


GOOD = {"VF": 6, "IA": 5.5, "PP": 7}


def test_a_judge_marks_all_criteria_of_one_scene() -> None:
    judge = Friendly(GOOD)
    marks = judge_scene(judge, WHITE, [WHITE, WHITE])
    assert isinstance(judge, Judge)
    assert marks.marks == GOOD
    assert marks.average == pytest.approx(18.5 / 3)
    assert marks.judge == "Friendly"
    (asked,) = judge.seen
    assert len(asked[1]) == 2
    assert set(asked[2]) == {"VF", "IA", "PP"}
    assert all(len(text) > 40 for text in CRITERIA.values())


@pytest.mark.parametrize(
    "marks",
    [
        {"VF": 6, "IA": 5},
        GOOD | {"PP": 8},
        GOOD | {"PP": 0},
        GOOD | {"PP": True},
        GOOD | {"VF": float("nan")},
        GOOD | {"IA": "good"},
    ],
)
def test_an_answer_off_the_scale_is_refused(marks: Mapping[str, Any]) -> None:
    with pytest.raises(BackendError, match="1 to 7"):
        judge_scene(Friendly(marks), WHITE, [WHITE])


def test_a_ranking_names_each_method_once() -> None:
    methods = {"ours": [WHITE], "other": [WHITE]}
    assert rank_methods(Friendly({}, ("ours", "other")), WHITE, methods) == ("ours", "other")
    for order in (("ours",), ("ours", "ours"), ("ours", "third")):
        with pytest.raises(BackendError, match="once"):
            rank_methods(Friendly({}, order), WHITE, methods)


def test_the_embedded_reasoner_is_no_judge_and_says_so() -> None:
    with pytest.raises(BackendError, match="cannot judge"):
        judge_scene(EmbeddedReasoner(), WHITE, [WHITE])


def test_a_judge_needs_a_picture_of_the_scene() -> None:
    with pytest.raises(InputError, match="at least one picture"):
        judge_scene(Friendly(GOOD), WHITE, [])


def test_measured_marks_say_what_they_are_and_give_none_for_looks() -> None:
    best = marks_from_figures(iou=1.0, built=1.0, pair_collisions=0.0, unsound=0.0)
    assert best.judge == MEASURED
    assert best.marks == {"VF": None, "IA": 7, "PP": 7}
    assert best.average is None
    assert best.facts()["average"] is None
    assert "not marked" in best.notes["VF"]
    worst = marks_from_figures(iou=0.0, built=0.0, pair_collisions=0.2, unsound=1.0)
    assert worst.marks == {"VF": None, "IA": 1, "PP": 1}
    blind = marks_from_figures(
        iou=None, built=None, pair_collisions=0.0, unsound=0.5, simulated=False
    )
    assert blind.marks == {"VF": None, "IA": None, "PP": 4}
    assert "not simulated" in blind.notes["PP"]


@pytest.mark.slow
def test_an_evaluation_takes_the_judges_marks() -> None:
    taken, judge = shot(sound()), Friendly(GOOD)
    found = evaluate(
        taken.scene, picture=taken.picture, segments=taken.segments, judge=judge, simulate=False
    )
    assert found.marks.marks == GOOD
    (asked,) = judge.seen
    shown = np.asarray(asked[1][0], int)
    assert shown.shape == taken.picture.shape
    assert np.abs(shown - taken.picture).mean() < 8  # drawn from the picture's own camera
