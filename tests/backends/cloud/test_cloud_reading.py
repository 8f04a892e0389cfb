"""Extraction of JSON from model output."""

import contextlib
import time

import pytest
from pydantic import ValidationError

from generator.backends.cloud.server.answers import KindAnswer
from generator.backends.cloud.server.json_text import Wrong, is_refusal, read_object

WANTED = {"a": [1, 2.5], "b": {"c": None, "d": True}, "e": "it's // no comment, }"}
PLAIN = '{"a": [1, 2.5], "b": {"c": null, "d": true}, "e": "it\'s // no comment, }"}'


@pytest.mark.parametrize(
    "text",
    [
        PLAIN,
        f"\ufeff  {PLAIN}\n",
        f"Here you are:\n```json\n{PLAIN}\n```\nI hope it helps.",
        f"```\n{{}}\n```\nNo, rather:\n```\n{PLAIN}\n```",
        f"Don't mind the {{braces}}. The answer is {PLAIN} as asked.",
        f"<think>{{'a': 1}} or perhaps not</think>{PLAIN}",
        PLAIN.replace("}}", "},}").replace("2.5]", "2.5,]").replace("true}", "true,}"),
        PLAIN.replace('"b"', '// the second\n"b"').replace("[1,", "[1, /* and */"),
        PLAIN.replace('"a"', "“a”"),
        "{'a': [1, 2.5], 'b': {'c': None, 'd': True}, 'e': \"it's // no comment, }\"}",
        "{'a': [1, 2.5], 'b': {'c': null, 'd': true}, 'e': \"it's // no comment, }\"}",
    ],
)
def test_an_object_is_read_however_it_is_wrapped(text: str) -> None:
    assert read_object(text) == WANTED


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ('{"a": [1, 2', {"a": [1, 2]}),
        ('{"a": {"b": "cut o', {"a": {"b": "cut o"}}),
        ('```json\n{"a": [{"b": 1}, {"b": 2', {"a": [{"b": 1}, {"b": 2}]}),
    ],
)
def test_what_was_cut_off_is_closed(text: str, wanted: dict) -> None:
    assert read_object(text) == wanted


@pytest.mark.parametrize(
    "text", ["", "no", "[1, 2]", '"text"', '{"a": NaN}', '{"a": Infinity}', "{" * 5000, '{"a" 1}']
)
def test_anything_else_is_refused(text: str) -> None:
    with pytest.raises(Wrong, match="no valid JSON object"):
        read_object(text)


def test_refusals_are_told_from_answers() -> None:
    assert is_refusal("I'm sorry, but I can't help with that.")
    assert is_refusal("I cannot assist with this request.")
    assert not is_refusal('I cannot be sure, but: {"a": 1}')
    assert not is_refusal("The canary is sorry.")


@pytest.mark.slow
@pytest.mark.parametrize(
    "text",
    [
        "<think>" * 150_000, "```" + "a" * 1_000_000, "```a" * 200_001, '"\\' * 400_000,
        '{"a' + '\\"' * 400_000, "/*" * 400_000, "{" * 400_000, "{" + "[" * 400_000,
        '{"a":' * 100_000 + "1" + "}" * 100_000, "{'a': " + "-" * 100_000 + "1}",
        "{'a': " + "1+" * 50_000 + "1}", "{'a': " + "1**" * 20_000 + "1}",
        "{'a': 9" + "9" * 100_000 + "}", ",  " * 300_000, "{}" * 200_000, "\ud800" * 1000,
    ],
    ids=lambda text: text[:12].encode("ascii", "backslashreplace").decode(),
)  # fmt: skip
def test_a_hostile_answer_is_read_or_refused_in_time(text: str) -> None:
    began = time.process_time()
    with contextlib.suppress(Wrong):
        assert read_object(text) is not None
    assert time.process_time() - began < 10


def test_what_a_terminal_would_obey_is_no_word() -> None:
    with pytest.raises(ValidationError, match="cannot be printed"):
        KindAnswer.model_validate({"noun": "mug\x1b[2J", "count": 1})
