"""Marks and ranks of finished scenes (Sec. 4.1)."""

from __future__ import annotations

from collections.abc import Mapping
from string import ascii_uppercase

import numpy as np
from jaxtyping import UInt8

from ....errors import InputError
from ..prompts import prompt
from ..server.answers import MarksAnswer, OrderAnswer
from ..server.reading import Wrong
from ..server.typed_question import Chat

Picture = UInt8[np.ndarray, "_ _ 3"]


def rate(
    chat: Chat, reference: Picture, pictures: tuple[Picture, ...], criteria: Mapping[str, str]
) -> Mapping[str, float]:
    """Return a mark from 1 to 7 for each criterion."""

    def marks(answer: MarksAnswer) -> dict[str, float]:
        given = [m.criterion for m in answer.marks]
        if sorted(given) != sorted(criteria):
            raise Wrong(f"marks are needed for {', '.join(criteria)}, each once; got {given}.")
        return {m.criterion: m.mark for m in answer.marks}

    listed = "\n".join(f"- {key}: {meaning}" for key, meaning in criteria.items())
    text = prompt("rate", count=str(len(pictures)), criteria=listed)
    return chat.ask("rate", text, (reference, *pictures), MarksAnswer, marks)


def rank(
    chat: Chat, reference: Picture, methods: Mapping[str, tuple[Picture, ...]]
) -> tuple[str, ...]:
    """Return the methods' names, best first.

    Raises:
        InputError: more methods than letters.
    """
    if len(methods) > len(ascii_uppercase):
        raise InputError(f"At most {len(ascii_uppercase)} methods can be ranked at once.")
    letters = dict(zip(ascii_uppercase, methods, strict=False))

    def order(answer: OrderAnswer) -> tuple[str, ...]:
        given = [letter.strip().upper() for letter in answer.order]
        if sorted(given) != sorted(letters):
            raise Wrong(f"the order must hold {', '.join(letters)}, each once; got {given}.")
        return tuple(letters[letter] for letter in given)

    lines = [f"{letter}: {len(methods[name])} pictures" for letter, name in letters.items()]
    pictures = [picture for shown in methods.values() for picture in shown]
    text = prompt("rank", listing="\n".join(lines))
    return chat.ask("rank", text, (reference, *pictures), OrderAnswer, order)
