"""Explanation of a text, phrase by phrase."""

from __future__ import annotations

import json

import pytest

from generator.cli import run
from generator.language.explanation import Explained, explain, summarize


def test_every_role_is_told() -> None:
    rows = explain(
        "A round table with three red mugs in a row, happiness and a clavichord on the left, "
        "but no plates."
    )
    assert {row.role for row in rows} >= {
        "table", "thing", "count", "attribute", "arrangement", "place", "absent", "not understood",
    }  # fmt: skip
    assert Explained("attribute", "red", "color of mug") in rows
    assert Explained("thing", "a clavichord", "a stand-in (keyed)") in rows
    assert rows[-1] == Explained("not understood", "happiness")


def test_the_command_prints_lines_or_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["explain", "a mug on a book", "--json"]) == 0
    assert {"role": "relation", "phrase": "on book", "meaning": "of mug"} in json.loads(
        capsys.readouterr().out
    )
    assert run(["explain", "a mug on a book"]) == 0
    assert "relation        on book" in capsys.readouterr().out


def test_a_text_is_summarized_in_a_sentence(capsys: pytest.CaptureFixture[str]) -> None:
    said = summarize("a round oak table with a laptop, two red mugs and a zorble")
    assert said == ("A round table of oak: laptop, 2 × red mug, zorble (a plain stand-in).")
    assert run(["explain", "an oval table with a mug"]) == 0
    assert capsys.readouterr().out.startswith("An oval table of ")


def test_ignored_words_are_told() -> None:
    rows = explain("a telescopic red mug and two books")
    assert Explained("not understood", "telescopic", "of mug") in rows
    assert not any(row.role == "not understood" and row.phrase == "red" for row in rows)


def test_what_the_plan_warns_of_is_told_too() -> None:
    rows = explain("a phone leaning on a cactus")
    assert any(row.role == "note" and "cannot lean" in row.meaning for row in rows)


def test_what_was_not_understood_is_told_once() -> None:
    rows = explain("a mug 5 cm behind a plate and happiness")
    told = [row for row in rows if "not understood" in (row.role, row.meaning.lower()[:14])]
    assert [row.phrase for row in told] == ["happiness", "5 cm"]
    assert not any(row.role == "note" for row in rows)


def test_a_denied_place_is_told() -> None:
    rows = explain("the mug is not on the tray")
    assert Explained("absent", "on tray", "of mug") in rows
