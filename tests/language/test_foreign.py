"""Texts in other languages are rejected in one line; English with foreign words is not."""

from __future__ import annotations

import ast
import json
from pathlib import Path

import pytest
from foreign_texts import ENGLISH_TEXTS, FOREIGN_TEXTS, SHORT_TEXTS

from generator.cli import run
from generator.errors import InputError
from generator.language.explanation import explain
from generator.language.planner import plan_scene
from generator.language.reader import OTHER_LANGUAGE, check_text
from generator.language.words.foreign import is_foreign

ROOT = Path(__file__).parents[2]
LINE = "let a cloud reasoner plan it: 'tabletopgen generate TEXT --reasoner cloud'"


def benchmark_texts() -> list[str]:
    names = ("texts", "table78")
    return [
        e["text"] for n in names for e in json.loads((ROOT / f"benchmarks/{n}.json").read_text())
    ]


def sentences_of_tests() -> list[str]:
    """Return every string with words in the sentence tests."""
    found = []
    for name in ("test_sentences", "test_settled", "test_explaining"):
        tree = ast.parse((ROOT / f"tests/language/{name}.py").read_text())
        strings = (node.value for node in ast.walk(tree) if isinstance(node, ast.Constant))
        found += [s for s in strings if isinstance(s, str) and " " in s]
    return found


@pytest.mark.parametrize("language", FOREIGN_TEXTS)
def test_texts_in_other_languages_are_told(language: str) -> None:
    assert [text for text in FOREIGN_TEXTS[language] if not is_foreign(text)] == []


def test_nearly_all_short_foreign_texts_are_refused() -> None:
    missed = []
    for text in SHORT_TEXTS:
        try:
            check_text(text)
            missed.append(text)
        except InputError as error:
            assert str(error) == OTHER_LANGUAGE
    assert len(missed) <= 2, missed


def test_no_english_text_is_refused() -> None:
    texts = [*benchmark_texts(), *sentences_of_tests(), *ENGLISH_TEXTS]
    assert len(texts) > 250
    assert [text for text in texts if is_foreign(text)] == []
    for text in (*benchmark_texts(), *ENGLISH_TEXTS):
        check_text(text)


@pytest.mark.parametrize("text", ["ein Tisch mit einer Tasse", "一张桌子上有两个杯子"])
def test_one_line_names_the_cloud_reasoner(text: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert LINE in OTHER_LANGUAGE and "\n" not in OTHER_LANGUAGE
    for ask in (plan_scene, explain):
        with pytest.raises(InputError) as caught:
            ask(text, 0)
        assert str(caught.value) == OTHER_LANGUAGE
    for command in ("explain", "compose"):
        assert run([command, text]) != 0
        told = " ".join(capsys.readouterr().err.split())
        assert LINE in told
