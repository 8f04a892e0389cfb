"""Each relation of the understanding benchmark: true and false cases."""

from collections.abc import Sequence

import pytest
from made_things import seen, thing
from wording.relations import holds, ordered, row
from wording.seen import Seen, Thing

Places = Sequence[tuple[float, float]]


def blocks(places: Places) -> list[Thing]:
    return [thing(f"block_{k}", x, y) for k, (x, y) in enumerate(places)]


def true(kind: str, a: Sequence[Thing], b: Sequence[Thing] = (), table: Seen | None = None) -> bool:
    return holds(kind, [a], [b] if b else [], None, table or seen(*a, *b))


@pytest.mark.parametrize(
    ("kind", "right", "wrong"),
    [
        ("left", (-0.2, 0.05), (0.2, 0.0)),
        ("left", (-0.1, 0.0), (-0.03, 0.25)),
        ("right", (0.2, 0.05), (-0.2, 0.0)),
        ("behind", (0.05, 0.2), (0.05, -0.2)),
        ("front", (0.0, -0.15), (0.3, -0.05)),
        ("near", (0.15, 0.0), (0.4, 0.0)),
    ],
)
def test_directions_are_the_viewers(
    kind: str, right: tuple[float, float], wrong: tuple[float, float]
) -> None:
    mug = thing("mug_1")
    assert true(kind, [thing("pen_1", *right)], [mug])
    assert not true(kind, [thing("pen_1", *wrong)], [mug])


@pytest.mark.parametrize(
    ("kind", "right", "wrong"),
    [
        ("centre", (0.05, -0.05), (0.3, 0.0)),
        ("leftside", (-0.3, 0.1), (0.0, 0.0)),
        ("rightside", (0.3, 0.1), (-0.3, 0.1)),
        ("backside", (0.3, 0.2), (0.3, 0.0)),
        ("frontside", (0.0, -0.2), (0.0, 0.2)),
        ("backleftcorner", (-0.4, 0.2), (-0.4, 0.0)),
        ("frontrightcorner", (0.4, -0.2), (0.4, 0.2)),
    ],
)
def test_zones_are_parts_of_the_table(
    kind: str, right: tuple[float, float], wrong: tuple[float, float]
) -> None:
    assert true(kind, [thing("mug_1", *right)])
    assert not true(kind, [thing("mug_1", *wrong)])


@pytest.mark.parametrize(
    ("kind", "right", "wrong"),
    [
        ("row", [(-0.2, 0), (0, 0.01), (0.2, 0)], [(-0.2, 0), (0, 0.2), (0.2, 0)]),
        ("row", [(-0.05, 0), (0.05, 0)], [(-0.4, 0), (0.4, 0)]),
        ("column", [(0, -0.2), (0, 0), (0, 0.2)], [(-0.2, 0), (0, 0), (0.2, 0)]),
        ("circle", [(0.2, 0), (0, 0.2), (-0.2, 0), (0, -0.2)], [(0, 0), (0.1, 0), (0.2, 0)]),
        (
            "corners",
            [(-0.4, 0.2), (0.4, 0.2), (-0.4, -0.2), (0.4, -0.2)],
            [(-0.4, 0.2), (0.4, 0.2), (-0.4, -0.2), (0, 0)],
        ),
    ],
)
def test_patterns_of_several_things(kind: str, right: Places, wrong: Places) -> None:
    assert true(kind, blocks(right))
    assert not true(kind, blocks(wrong))


def test_things_in_one_place_are_no_row() -> None:
    assert not row(blocks([(0, 0), (0, 0)]))
    assert not row(blocks([(0, 0)]))


def test_order_is_by_height_or_by_bulk() -> None:
    small, large = thing("bowl_1", -0.2), thing("bowl_2", 0.2, size=(0.2, 0.2, 0.08))
    tall = thing("bowl_3", 0.4, size=(0.02, 0.02, 0.3))
    assert ordered([large, small], 1)
    assert not ordered([large, small], -1)
    assert ordered([small, large, tall], 1)
    assert not ordered([thing("a_1", -0.1), thing("a_2", 0.1)], 1)


def test_between_needs_both_ends() -> None:
    left, right = thing("jar_1", -0.3), thing("jar_2", 0.3)
    assert true("between", [thing("mug_1", 0.05, 0.02)], [left, right])
    assert not true("between", [thing("mug_1", 0.45)], [left, right])
    assert not true("between", [thing("mug_1", 0.0, 0.4)], [left, right])
    assert not true("between", [thing("mug_1")], [left])
    ends = [[left], [right]]
    assert holds("between", [[thing("mug_1")]], ends, None, seen(left, right))


def test_around_is_on_all_sides() -> None:
    pot = thing("pot_1")
    assert true("around", blocks([(0.2, 0), (-0.1, 0.17), (-0.1, -0.17)]), [pot])
    assert not true("around", blocks([(0.2, 0), (0.2, 0.1), (0.2, -0.1)]), [pot])
    assert not true("around", blocks([(0.45, 0), (-0.1, 0.17), (-0.1, -0.17)]), [pot])
    assert true("eachside", blocks([(0.2, 0), (-0.2, 0)]), [pot])
    assert not true("eachside", blocks([(0.2, 0), (0.3, 0)]), [pot])


def test_on_follows_what_carries() -> None:
    plate = thing("plate_1", size=(0.2, 0.2, 0.02))
    apple, pear = thing("apple_1", up=0.02), thing("apple_2", 0.3)
    table = seen(plate, apple, pear, on={"apple_1": "plate_1"})
    assert true("on", [apple], [plate], table)
    assert not true("on", [apple, pear], [plate], table)
    assert holds("on", [[apple, pear]], [[plate]], "some", table)
    assert holds("on", [[apple, pear]], [[plate]], 1, table)
    assert not holds("on", [[apple, pear]], [[plate]], 2, table)
    assert true("noton", [pear], [plate], table)
    assert not true("noton", [apple], [plate], table)
    assert true("oneach", [apple, pear], [plate], table)
    assert not true("oneach", [pear], [plate], table)
    assert not true("empty", [plate], (), table)
    assert true("empty", [apple], (), table)
    assert not true("near", [apple], [plate], table)


def test_what_leans_on_a_thing_from_the_table_is_not_on_it() -> None:
    book, shelf = thing("book_1", 0.05), thing("shelf_1")
    assert not true("on", [book], [shelf], seen(book, shelf, on={"book_1": "shelf_1"}))


def test_in_is_within_the_outline_and_below_the_rim() -> None:
    bowl = thing("bowl_1", size=(0.2, 0.2, 0.08))
    inside, across = thing("egg_1", 0.05, up=0.02), thing("egg_2", 0.2, up=0.02)
    above = thing("egg_3", up=0.12)
    over = dict.fromkeys(("egg_1", "egg_2", "egg_3"), "bowl_1")
    table = seen(bowl, inside, across, above, on=over)
    assert true("in", [inside], [bowl], table)
    assert not true("in", [across], [bowl], table)
    assert not true("in", [above], [bowl], table)
    assert not true("in", [inside], [bowl], seen(bowl, inside))


def test_on_a_tray_is_in_it() -> None:
    tray, pen = thing("tray_1", size=(0.2, 0.2, 0.03)), thing("pen_1", 0.2, up=0.045)
    assert true("in", [pen], [tray], seen(tray, pen, on={"pen_1": "tray_1"}))


def test_a_stack_is_one_pile() -> None:
    things = [thing(f"book_{k}", up=0.06 * k) for k in range(3)]
    piled = seen(*things, on={"book_1": "book_0", "book_2": "book_1"})
    assert true("stack", things, (), piled)
    loose = seen(*things, on={"book_1": "book_0"})
    assert not true("stack", things, (), loose)
    assert holds("stack", [things], [], "some", loose)
    assert not holds("stack", [things], [], "some", seen(*things))


def test_upright_is_not_flat() -> None:
    assert true("upright", [thing("bottle_1", size=(0.05, 0.05, 0.2))])
    assert not true("upright", [thing("bottle_1", size=(0.2, 0.05, 0.05))])
    assert true("lying", [thing("bottle_1", size=(0.2, 0.05, 0.05))])


def test_nothing_stands_in_no_relation() -> None:
    mug = thing("mug_1")
    assert not true("left", [], [mug])
    assert not holds("left", [[mug]], [[]], None, seen(mug))
