"""Texts, requirements on their plans, and a correct chat-model answer for each. Data only."""

from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Expected:
    """Requirements on the plan of ``text``.

    Attributes:
        counts: how many of each category; "generic" for stand-ins.
        relations: (category, kind, category or "table") to how many things have it.
        groups: (kind, members, seat counted from 0, category of what is in its middle).
        looks: category to attributes that each of its things has.
        order: categories from left to right in the settled scene.
        things, groups_answered, table: what a chat model answers.
        english: whether the embedded planner reads the text.
    """

    text: str
    counts: dict[str, int]
    things: list[dict[str, Any]]
    relations: dict[tuple[str, str, str], int] = field(default_factory=dict)
    groups: list[tuple[str, int, tuple[int, int] | None, str | None]] = field(default_factory=list)
    looks: dict[str, dict[str, str]] = field(default_factory=dict)
    order: tuple[str, ...] = ()
    groups_answered: list[dict[str, Any]] = field(default_factory=list)
    table: dict[str, Any] = field(default_factory=dict)
    english: bool = True

    def answer(self) -> dict[str, Any]:
        """Return the complete answer of a chat model."""
        table = {"outline": "rectangle", "material": "oak", "color": None, "legs": "tapered",
                 "length_cm": 120, "width_cm": 70, "height_cm": 74}  # fmt: skip
        return {
            "table": table | self.table, "style": "plain", "things": self.things,
            "groups": self.groups_answered,
        }  # fmt: skip


_LOOKS = ("color", "accent", "material", "size_word", "state", "contents", "size_cm")


def thing(id: int, noun: str, *relations: tuple[str, int], **looks: Any) -> dict[str, Any]:
    """Return an object of an answer."""
    told = [{"kind": kind, "target": target} for kind, target in relations]
    return {"id": id, "noun": noun, "relations": told, **dict.fromkeys(_LOOKS), **looks}


def group(kind: str, *things: int, around: int | None = None, seat: Any = None) -> dict[str, Any]:
    """Return a group of an answer; ``seat`` is its number, from 1, and the number of seats."""
    told = None if seat is None else {"number": seat[0], "count": seat[1]}
    return {"kind": kind, "things": list(things), "around": around, "seat": told}


def _setting(first: int) -> list[dict[str, Any]]:
    return [
        thing(first, "plate"), thing(first + 1, "fork", ("left_of", first)),
        thing(first + 2, "knife", ("right_of", first)),
        thing(first + 3, "glass", ("behind", first)),
    ]  # fmt: skip


EXPECTED: tuple[Expected, ...] = (
    Expected(
        "three bowls, each with two apples",
        {"bowl": 3, "apple": 6},
        [*(thing(n, "bowl") for n in (1, 2, 3)),
         *(thing(4 + n, "apple", ("in", 1 + n // 2)) for n in range(6))],
        {("apple", "in", "bowl"): 6},
    ),
    Expected(
        "a stack of three books with a mug on top",
        {"book": 3, "mug": 1},
        [thing(1, "book"), thing(2, "book", ("on", 1)), thing(3, "book", ("on", 2)),
         thing(4, "mug", ("on", 3))],
        {("book", "on", "book"): 2, ("mug", "on", "book"): 1},
    ),
    Expected(
        "a table set for two",
        {"plate": 2, "fork": 2, "knife": 2, "glass": 2, "candle": 1},
        [*_setting(1), *_setting(5), thing(9, "candle", ("center", 0))],
        {("fork", "left_of", "plate"): 2, ("knife", "right_of", "plate"): 2,
         ("glass", "behind", "plate"): 2, ("candle", "center", "table"): 1},
        [("setting", 4, (0, 2), None), ("setting", 4, (1, 2), None)],
        groups_answered=[group("setting", 1, 2, 3, 4, seat=(1, 2)),
                         group("setting", 5, 6, 7, 8, seat=(2, 2))],
    ),
    Expected(
        "five red cubes in a row, no mugs",
        {"cube": 5},
        [thing(n, "cube", color="red") for n in range(1, 6)],
        groups=[("row", 5, None, None)],
        looks={"cube": {"color": "red"}},
        groups_answered=[group("row", 1, 2, 3, 4, 5)],
    ),
    Expected(
        "four candles in a circle around a vase",
        {"candle": 4, "vase": 1},
        [*(thing(n, "candle", ("next_to", 5)) for n in range(1, 5)), thing(5, "vase")],
        {("candle", "next_to", "vase"): 4},
        [("circle", 4, None, "vase")],
        groups_answered=[group("circle", 1, 2, 3, 4, around=5)],
    ),
    Expected(
        "a dozen eggs in an egg carton",
        {"egg": 12, "egg_carton": 1},
        [*(thing(n, "egg", ("in", 13)) for n in range(1, 13)), thing(13, "egg carton")],
        {("egg", "in", "egg_carton"): 12},
        looks={"egg_carton": {"state": "empty", "places": "12"}},
    ),
    Expected(
        "a clavichord between a laptop and a large lamp",
        {"generic": 1, "laptop": 1, "desk_lamp": 1},
        [thing(1, "clavichord", ("right_of", 2), ("left_of", 3)), thing(2, "laptop"),
         thing(3, "lamp", size_word="large")],
        looks={"desk_lamp": {"size": "large"}},
        order=("laptop", "generic", "desk_lamp"),
    ),
    Expected(
        "a tray holding a teapot and two cups",
        {"tray": 1, "teapot": 1, "mug": 2},
        [thing(1, "tray"), thing(2, "teapot", ("on", 1)), thing(3, "cup", ("on", 1)),
         thing(4, "cup", ("on", 1))],
        {("teapot", "on", "tray"): 1, ("mug", "on", "tray"): 2},
    ),
    Expected(
        "two plates, each with a fork to its left and a folded napkin on it",
        {"plate": 2, "fork": 2, "napkins": 2},
        [thing(1, "plate"), thing(2, "plate"), thing(3, "fork", ("left_of", 1)),
         thing(4, "fork", ("left_of", 2)), thing(5, "folded napkin", ("on", 1)),
         thing(6, "folded napkin", ("on", 2))],
        {("fork", "left_of", "plate"): 2, ("napkins", "on", "plate"): 2},
    ),
    Expected(
        "a glass of orange juice and an empty bowl",
        {"glass": 1, "bowl": 1},
        [thing(1, "glass", contents="orange juice"), thing(2, "bowl", state="empty")],
        looks={"glass": {"state": "with orange juice"}, "bowl": {"state": "empty"}},
    ),
    Expected(
        "a round glass table with a yellow and white mug, a plate without a fork and a pen at the "
        "edge",
        {"mug": 1, "plate": 1, "pen": 1},
        [thing(1, "mug", color="yellow", accent="white"), thing(2, "plate"),
         thing(3, "pen", ("edge", 0))],
        {("pen", "edge", "table"): 1},
        looks={"mug": {"color": "yellow", "accent": "white"}},
        table={"outline": "round", "material": "glass", "length_cm": 90, "width_cm": 90},
    ),
    Expected(
        "a mug on the left, an apple in the middle and a book behind the apple",
        {"mug": 1, "apple": 1, "book": 1},
        [thing(1, "mug", ("left_of", 0)), thing(2, "apple", ("center", 0)),
         thing(3, "book", ("behind", 2))],
        {("mug", "left_of", "table"): 1, ("apple", "center", "table"): 1,
         ("book", "behind", "apple"): 1},
    ),
    Expected(
        "Ein Laptop, rechts davon zwei rote Tassen, aber keine Maus",
        {"laptop": 1, "mug": 2},
        [thing(1, "laptop"), thing(2, "mug", ("right_of", 1), color="red"),
         thing(3, "mug", ("right_of", 1), color="red")],
        {("mug", "right_of", "laptop"): 2},
        looks={"mug": {"color": "red"}},
        english=False,
    ),
)  # fmt: skip
