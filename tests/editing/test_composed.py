"""Edits of composed scenes: their rows, and the text's relations afterwards."""

from dataclasses import replace
from pathlib import Path

import pytest

from generator import bundle, editing
from generator.composition import compose
from generator.scene import RelationOutcome

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("small")]

TEXT = "three mugs in a row, a book and an apple to the left of the book"


@pytest.fixture(scope="module")
def composed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return bundle.save(compose(TEXT, 0), tmp_path_factory.mktemp("composed"))


def outcomes(done: editing.Edited) -> list[tuple[str, str, str, bool]]:
    report = done.scene.report
    assert report is not None
    return [(o.name, o.kind, o.target, o.holds) for o in report.relations]


def test_what_is_taken_from_a_row_leaves_a_shorter_one(composed: Path) -> None:
    done = editing.remove(composed, "mug_2")
    assert done.scene.plan is not None
    assert [g.members for g in done.scene.plan.groups] == [("mug_1", "mug_3")]
    assert ("apple_1", "left_of", "book_1", True) in outcomes(done)


def test_what_is_put_in_a_place_takes_over_its_relations(composed: Path) -> None:
    done = editing.swap(composed, "apple_1", "an orange")
    assert ("orange_1", "left_of", "book_1", True) in outcomes(done)


def test_what_takes_the_place_of_a_misplaced_thing_does_not(tmp_path: Path) -> None:
    scene = compose("a book and an apple to the left of the book", 0)
    plan, report = scene.plan, scene.report
    assert plan is not None and report is not None
    false = RelationOutcome("apple_1", "left_of", "book_1", False, -0.1)
    path = bundle.save(scene.replace(report=replace(report, relations=(false,))), tmp_path)
    done = editing.swap(path, "apple_1", "an orange")
    assert outcomes(done) == []


def test_an_added_thing_is_checked_like_the_text(composed: Path) -> None:
    done = editing.add(composed, "a pen to the right of the book")
    assert ("pen_1", "right_of", "book_1", True) in outcomes(done)
