"""Extraction and repair of JSON (bare, fenced or embedded) in a chat model's text."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator
from typing import Any

from ....errors import UnusableError
from ....io.bounded import parse_json

# All patterns take linear time, even if the end of a match is missing.
_THOUGHT = re.compile(r"<think(?:ing)?>", re.IGNORECASE)
_THOUGHT_END = re.compile(r"</think(?:ing)?>", re.IGNORECASE)
_FENCE = re.compile(r"```[a-zA-Z0-9]*+\s*+(.*?)```", re.DOTALL)
_STRING = r'"[^"\\]*+(?:\\.[^"\\]*+)*+"?+'  # up to the end of the text if the string is not closed
_COMMENT = r"//[^\n]*|/\*.*?(?:\*/|\Z)"
_COMMA = r",(?=\s*+[}\]])"
_REFUSAL = re.compile(
    r"^\W*(i['’]?m (very )?sorry|sorry\b|i (can['’]?t|can ?not|am unable|am not able)|"
    r"as an ai\b|unfortunately,? i)",
    re.IGNORECASE,
)
_LONGEST_LITERAL = 2**17  # maximum characters of an answer in Python notation
_CURLY = str.maketrans({"“": '"', "”": '"', "„": '"', "‘": "'", "’": "'"})


class Wrong(ValueError):
    """An unusable answer; its message can be sent back to the model."""


def read_object(text: str) -> dict[str, Any]:
    """Return the JSON object in an answer.

    The candidates are, in order: the whole text, fenced blocks (last first), and parts in braces
    (last first). Each is parsed verbatim, then repaired: comments and trailing commas removed,
    quotes straightened, Python literals converted, open brackets closed. NaN and infinite numbers
    are rejected.

    Raises:
        Wrong: there is no such object.
    """
    text = _without_thoughts(text).strip().lstrip("\ufeff")
    for piece in _pieces(text):
        for attempt in (piece, _repair(piece)):
            found = _object(attempt)
            if found is not None:
                return found
    raise Wrong("the answer contains no valid JSON object.")


def is_refusal(text: str) -> bool:
    """Return whether an answer contains no JSON and begins like a refusal."""
    return "{" not in text and bool(_REFUSAL.match(text.strip()))


def _pieces(text: str) -> Iterator[str]:
    yield text
    yield from reversed([found.strip() for found in _FENCE.findall(text)])
    stretches, end = [], 0
    for start in (m.start() for m in re.finditer(r"\{", text)):
        if start >= end:
            end = _end(text, start)
            stretches.append(text[start:end])
    yield from reversed(stretches)


def _end(text: str, start: int) -> int:
    """Return the end of the JSON object at ``start``, or of the text if the object is unclosed.

    An apostrophe does not open a string, because JSON strings use double quotes.
    """
    depth, inside, skip = 0, False, False
    for at in range(start, len(text)):
        letter = text[at]
        if skip or letter == "\\":
            skip = not skip
        elif letter == '"':
            inside = not inside
        elif not inside and letter in "{}":
            depth += 1 if letter == "{" else -1
            if not depth:
                return at + 1
    return len(text)


def _object(text: str) -> dict[str, Any] | None:
    try:
        found = parse_json(text, "The answer", UnusableError)
    except UnusableError:
        found = _literal(text)
    return found if isinstance(found, dict) else None


def _without_thoughts(text: str) -> str:
    """Remove marked reasoning, which extends from each start mark to the next end mark."""
    kept, at = [], 0
    while (begin := _THOUGHT.search(text, at)) and (end := _THOUGHT_END.search(text, begin.end())):
        kept.append(text[at : begin.start()])
        at = end.end()
    return "".join([*kept, text[at:]])


def _literal(text: str) -> Any:
    """Parse an answer in Python notation, which some models use; return None if that fails."""
    if not text.startswith("{") or len(text) > _LONGEST_LITERAL:
        return None
    words = {"true": "True", "false": "False", "null": "None"}
    text = re.sub(r"\b(true|false|null)\b", lambda m: words[m[0]], text)
    try:
        found = ast.literal_eval(text)
        return parse_json(json.dumps(found, allow_nan=False), "The answer", UnusableError)
    except (ValueError, SyntaxError, TypeError, MemoryError, RecursionError, UnusableError):
        return None


def _repair(text: str) -> str:
    text = text.translate(_CURLY)
    text = _outside_strings(text, _COMMENT, "")
    text += _closing(text)
    return _outside_strings(text, _COMMA, "")


def _outside_strings(text: str, pattern: str, by: str) -> str:
    """Replace ``pattern`` everywhere except in double-quoted strings."""
    either = re.compile(rf"({_STRING})|(?:{pattern})", re.DOTALL)
    return either.sub(lambda m: m[1] if m[1] is not None else by, text)


def _closing(text: str) -> str:
    """Return the quote and brackets missing at the end of a truncated JSON text."""
    strings = re.compile(_STRING, re.DOTALL)
    missing = '"' * any(_is_open(found) for found in strings.findall(text))
    bare = strings.sub("", text)
    open_ = []
    for letter in bare:
        if letter in "{[":
            open_.append("}" if letter == "{" else "]")
        elif letter in "}]" and open_:
            open_.pop()
    return missing + "".join(reversed(open_))


def _is_open(string: str) -> bool:
    """Return whether a string is not closed: its final quote is missing or escaped."""
    if len(string) < 2 or not string.endswith('"'):
        return True
    body = string[1:-1]
    return (len(body) - len(body.rstrip("\\"))) % 2 == 1
