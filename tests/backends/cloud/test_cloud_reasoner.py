"""The reasoner's questions over HTTP: prompts, and the resulting values."""

import dataclasses
import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from desk import SIZES, THINGS, VIEW, instances, listed, reference
from openai_server import Request, Running
from toy import cube_mesh

from generator.backends.cloud.questions.checks import six_sides, turns
from generator.backends.cloud.questions.labelled import Labelled
from generator.backends.cloud.reasoner import CloudReasoner
from generator.backends.cloud.server.answers import OrientationAnswer
from generator.backends.cloud.server.json_text import Wrong
from generator.errors import BackendError, InputError
from generator.scene import (
    TABLE,
    Intrinsics,
    Mesh,
    PlannedObject,
    PlannedTable,
    Reference,
    Relation,
    ScenePlan,
    SizePrior,
)
from generator.scene.quarter_turns import quarter_turn

NUMBERS = {1: "book_1", 2: "mug_1", 3: "pen_1"}


def always(server: Running, answer: Any) -> None:
    server.script.chat = lambda request: json.dumps(answer)


def thing(id: int, noun: str, *relations: tuple[str, int], **more: Any) -> dict[str, Any]:
    told = [{"kind": kind, "target": target} for kind, target in relations]
    empty = dict.fromkeys(("color", "material", "size_word", "state", "size_cm"))
    return {"id": id, "noun": noun, "relations": told, **empty, **more}


def plan(*things: dict[str, Any]) -> dict[str, Any]:
    table = {"outline": "round", "material": "Walnut", "color": None, "legs": "hairpin",
             "length_cm": 100, "width_cm": 100, "height_cm": 74}  # fmt: skip
    return {"table": table, "style": "cosy", "things": list(things)}


# ------------------------------------------------------------------------------------------- plan
def test_a_plan_has_names_categories_metres_and_relations(
    server: Running, reasoner: CloudReasoner
) -> None:
    always(server, plan(
        thing(1, "coffee mug", ("on", 4), color="red", size_word="small"),
        thing(2, "Coffee Mug", ("left_of", 1), ("on", 0)),
        thing(3, "wibblet", ("center", 0), size_cm=[10, 5, 2.5]),
        thing(4, "book"),
    ))  # fmt: skip
    made = reasoner.plan_scene("two mugs and a wibblet", 0)
    assert made.prompt == "two mugs and a wibblet"
    assert made.table == PlannedTable("round", "walnut", "hairpin", (1.0, 1.0, 0.74))
    names = [(o.name, o.noun, o.category) for o in made.objects]
    assert names == [
        ("coffee_mug_1", "coffee mug", "mug"),
        ("coffee_mug_2", "coffee mug", "mug"),
        ("wibblet_1", "wibblet", "generic"),
        ("book_1", "book", "book"),
    ]
    first, second, third, _ = made.objects
    assert dict(first.attributes) == {"color": "red", "size": "small"}
    assert first.relations == (Relation("on", "book_1"),)
    assert second.relations == (Relation("left_of", "coffee_mug_1"), Relation("on", TABLE))
    assert third.size == (0.1, 0.05, 0.025)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("things", "told"),
    [
        ((thing(1, "mug"), thing(1, "book")), "must have its own number"),
        ((thing(1, "mug", ("on", 7)),), "related to 7, which is not an object"),
        ((thing(1, "mug", ("in", 0)),), "'in' the table"),
        ((thing(1, "mug", ("center", 2)), thing(2, "book")), "must be to the table"),
        ((thing(1, "mug", ("on", 2)), thing(2, "book", ("on", 1))), "contradict each other"),
        ((thing(1, "mug", ("on", 2), ("on", 3)), thing(2, "book"), thing(3, "tray")), "several"),
        ((thing(1, "mug", ("over", 0)),), "things.0.relations.0.kind"),
        ((thing(1, "mug", size_cm=[1, 2]),), "things.0.size_cm"),
        ((), "things"),
    ],
)
def test_a_plan_that_contradicts_itself_is_asked_again(
    server: Running, reasoner: CloudReasoner, things: tuple, told: str
) -> None:
    good = plan(thing(1, "mug"))

    def chat(request: Request) -> str:
        return json.dumps(plan(*things) if len(server.script.requests) == 1 else good)

    server.script.chat = chat
    assert [o.name for o in reasoner.plan_scene("a mug", 0).objects] == ["mug_1"]
    assert told in server.script.requests[1].text


def test_another_seed_is_another_question(server: Running, reasoner: CloudReasoner) -> None:
    always(server, plan(thing(1, "mug")))
    for seed in (0, 1):
        reasoner.plan_scene("a mug", seed)
    first, second = (r.text for r in server.script.requests)
    assert first != second
    assert "a mug" in first


def test_legs_that_do_not_fit_the_top_are_refused(server: Running, reasoner: CloudReasoner) -> None:
    told = plan(thing(1, "mug"))
    always(server, {**told, "table": {**told["table"], "legs": "trestle"}})
    with pytest.raises(BackendError, match="a round table cannot have trestle legs"):
        reasoner.plan_scene("a mug", 0)


@pytest.mark.parametrize("text", ["", "  \n", "123 ?!", "a mug " * 1000, None])
def test_a_text_of_no_use_is_refused_before_it_costs(
    server: Running, reasoner: CloudReasoner, text: Any
) -> None:
    with pytest.raises(InputError):
        reasoner.plan_scene(text, 0)
    assert not server.script.requests


# --------------------------------------------------------------------------------------- pictures
def test_kinds_are_words_as_often_as_they_are_seen(
    server: Running, reasoner: CloudReasoner
) -> None:
    always(server, {"kinds": [{"noun": "Toy  car", "count": 2}, {"noun": "book", "count": 1}]})
    assert reasoner.list_objects(reference()) == ("table", "toy car", "toy car", "book")


def test_planned_words_are_told(server: Running, reasoner: CloudReasoner) -> None:
    always(server, {"kinds": [{"noun": "goblet", "count": 1}]})
    planned = ScenePlan("x", PlannedTable(), (PlannedObject("goblet_1", "goblet", "generic"),))
    reasoner.list_objects(reference(planned))
    assert "drawn to show: goblet" in server.script.requests[0].text


def test_the_view_is_in_radians(server: Running, reasoner: CloudReasoner) -> None:
    always(server, {"elevation": 60, "azimuth": -10, "vertical_fov": 30})
    view = reasoner.estimate_view(reference(), instances()[0])
    assert np.rad2deg([view.elevation, view.azimuth, view.fov]) == pytest.approx([60, -10, 30])
    # the table's box, (20, 60, 300, 220) of 320 x 240, on the grid
    assert "0: table; box 62 250 938 917" in server.script.requests[0].text


def test_known_intrinsics_tell_the_field_of_view(server: Running, reasoner: CloudReasoner) -> None:
    always(server, {"elevation": 60, "azimuth": 0, "vertical_fov": 30})
    known = Intrinsics(240, 240, 159.5, 119.5)
    rgbd = Reference(reference().image, depth=np.ones((240, 320)), intrinsics=known)
    assert reasoner.estimate_view(rgbd, instances()[0]).fov == pytest.approx(2 * np.arctan(0.5))


def size(id: int, *extent: float) -> dict[str, Any]:
    length, width, height = extent
    return {"id": id, "placement": "lying flat", "length": length, "width": width,
            "height": height, "length_is": "spine", "width_is": "page", "height_is": "thickness",
            }  # fmt: skip


ALL = [size(0, 120, 70, 74), size(1, 25, 18, 3), size(2, 9, 8, 10), size(3, 14, 1, 1)]


def test_sizes_are_metres_by_name(server: Running, reasoner: CloudReasoner) -> None:
    always(server, {"sizes": ALL[::-1]})
    sizes = reasoner.estimate_sizes(reference(), instances(), VIEW)
    assert set(sizes) == set(THINGS)
    np.testing.assert_allclose(sizes["book_1"].extent, [0.25, 0.18, 0.03])
    assert sizes["book_1"].placement == "lying flat"
    assert sizes["book_1"].axes == ("spine", "page", "thickness")
    assert not sizes["book_1"].measured
    text = server.script.requests[0].text
    assert listed(text) == {0: "table", 1: "book", 2: "mug", 3: "pen"}
    content = server.script.requests[0].body["messages"][0]["content"]
    assert [part["type"] for part in content] == ["text", "image_url", "image_url"]


ASKED: dict[str, Callable[[CloudReasoner], object]] = {
    "list_objects": lambda reasoner: reasoner.list_objects(reference()),
    "estimate_view": lambda reasoner: reasoner.estimate_view(reference(), instances()[0]),
    "estimate_sizes": lambda reasoner: reasoner.estimate_sizes(reference(), instances(), VIEW),
}
SEEN = {"elevation": 60, "azimuth": 0, "vertical_fov": 30}


def kinds(*nouns: str) -> dict[str, Any]:
    return {"kinds": [{"noun": noun, "count": 1} for noun in nouns]}


@pytest.mark.parametrize(
    ("question", "answer", "told"),
    [
        ("list_objects", kinds("mug", "Mug"), "listed twice: mug"),
        ("list_objects", kinds("table"), "no kind of object"),
        ("estimate_view", {**SEEN, "elevation": 95}, "elevation"),
        ("estimate_view", {**SEEN, "elevation": "high"}, "elevation"),
        ("estimate_view", {**SEEN, "azimuth": 170}, "azimuth"),
        ("estimate_sizes", {"sizes": ALL[:3]}, "no answer for number 3"),
        ("estimate_sizes", {"sizes": [*ALL, ALL[2]]}, "more than one answer for number 2"),
        ("estimate_sizes", {"sizes": [*ALL, size(9, 1, 1, 1)]}, "does not contain number 9"),
        ("estimate_sizes", {"sizes": [*ALL[:3], size(3, 0, 1, 1)]}, "sizes.3.length"),
        ("estimate_sizes", {"sizes": [*ALL[:3], size(3, 5000, 1, 1)]}, "sizes.3.length"),
    ],
)
def test_an_impossible_answer_is_refused(
    server: Running, reasoner: CloudReasoner, question: str, answer: dict[str, Any], told: str
) -> None:
    always(server, answer)
    with pytest.raises(BackendError, match=f"{question}.*{told}"):
        ASKED[question](reasoner)


def test_sizes_that_a_text_fixed_are_kept(server: Running, reasoner: CloudReasoner) -> None:
    always(server, {"sizes": ALL})
    planned = ScenePlan("x", PlannedTable(size=(1.5, 0.8, 0.7)), (
        PlannedObject("mug_1", "mug", "mug", size=(0.2, 0.2, 0.3)),
        PlannedObject("pen_1", "pen", "pen", size=(0.2, 0.02, 0.02)),
        PlannedObject("pen_2", "pen", "pen"),
    ))  # fmt: skip
    sizes = reasoner.estimate_sizes(reference(planned), instances(), VIEW)
    np.testing.assert_allclose(sizes["table"].extent, [1.5, 0.8, 0.7])
    np.testing.assert_allclose(sizes["mug_1"].extent, [0.2, 0.2, 0.3])
    np.testing.assert_allclose(sizes["pen_1"].extent, [0.14, 0.01, 0.01])  # which pen it is?
    assert "Number 2 measures 20 by 20 by 30 cm." in server.script.requests[0].text


# ------------------------------------------------------------------------------------ orientation
AXES = {
    sign + name: (1 if sign == "+" else -1) * np.eye(3)[k]
    for k, name in enumerate("xyz")
    for sign in "+-"
}


@pytest.mark.parametrize("up", AXES)
@pytest.mark.parametrize("along", AXES)
def test_turns_bring_up_upward_and_along_to_x(up: str, along: str) -> None:
    answer = OrientationAnswer.model_validate({"up": up, "along": along})
    if up[1] == along[1]:
        with pytest.raises(Wrong, match="must be different axes"):
            turns(answer)
        return
    turn = quarter_turn(turns(answer))
    np.testing.assert_array_equal(turn @ AXES[up], [0, 0, 1])
    np.testing.assert_array_equal(np.abs(turn @ AXES[along]), [1, 0, 0])


@pytest.mark.slow
def test_a_review_ends_in_quarter_turns(server: Running, reasoner: CloudReasoner) -> None:
    always(server, {"up": "-y", "along": "+z"})
    steps = reasoner.review_orientation(cube_mesh(), instances()[1], SIZES["book_1"])
    assert steps == (("x", -90), ("z", 90))
    always(server, {"up": "up", "along": "+z"})
    with pytest.raises(BackendError, match=r"review_orientation failed.*up: Input should be"):
        reasoner.review_orientation(cube_mesh(), instances()[2], SIZES["book_1"])


@pytest.mark.slow
def test_a_model_is_shown_from_six_sides_with_its_proportions(
    server: Running, reasoner: CloudReasoner
) -> None:
    always(server, {"up": "+z", "along": "+x"})
    flat = dataclasses.replace(cube_mesh(), vertices=cube_mesh().vertices * [0.2, 0.1, 0.02])
    reasoner.review_orientation(flat, instances()[1], SIZES["book_1"])
    text = server.script.requests[0].text
    assert "1.00 by 0.50 by 0.10" in text
    assert "25 cm by 18 cm, and is 3 cm high" in text


@pytest.mark.slow
def test_six_sides_show_what_they_say() -> None:
    """A cube whose +x face is white: visible in "+x" alone, and at the right edge of "+z"."""
    corners, faces, uv = [], [], []
    for axis in range(3):
        for sign in (-0.5, 0.5):
            a, b = np.eye(3)[(axis + 1) % 3], np.eye(3)[(axis + 2) % 3]
            middle = np.eye(3)[axis] * sign
            square = [middle + (s * a + t * b) / 2 for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
            k = len(corners)
            corners += square
            turn = [[k, k + 1, k + 2], [k, k + 2, k + 3]]
            faces += turn if sign > 0 else [t[::-1] for t in turn]
            uv += [[0.25 if (axis, sign) == (0, 0.5) else 0.75, 0.5]] * 4
    texture = np.zeros((2, 2, 3), np.uint8)
    texture[:, 0] = (255, 0, 0)
    texture[:, 1] = (0, 0, 255)
    sheet = six_sides(Mesh(np.array(corners), np.array(faces), np.array(uv), texture))
    red = (sheet[..., 0] > 90) & (sheet[..., 2] < 60)
    rows, columns = np.nonzero(red)
    height, width = sheet.shape[0] // 2, sheet.shape[1] // 3
    cells = {(int(r) // height, int(c) // width) for r, c in zip(rows, columns, strict=True)}
    assert cells == {(0, 2)}  # "+z", "-z", "+x" in the first row


# --------------------------------------------------------------------------------------- stacking
def rest(id: int, support: int, how: str = "on", leans_at: int | None = None) -> dict[str, Any]:
    return {"id": id, "how": how, "support": support, "leans_at": leans_at}


def test_layers_are_counted_from_the_table(server: Running, reasoner: CloudReasoner) -> None:
    always(server, {"things": [rest(3, 2, "in"), rest(2, 1), rest(1, 0, leans_at=2)]})
    stacking = reasoner.stacking_order(reference(), instances(), VIEW)
    assert {n: (s.order, s.on, s.inside) for n, s in stacking.items()} == {
        "table": (1, "table", False),
        "book_1": (2, "table", False),
        "mug_1": (3, "book_1", False),
        "pen_1": (4, "mug_1", True),
    }


@pytest.mark.slow
@pytest.mark.parametrize(
    ("things", "told"),
    [
        ([rest(1, 2), rest(2, 1), rest(3, 0)], "in a circle"),
        ([rest(1, 1), rest(2, 0), rest(3, 0)], "against itself"),
        ([rest(1, 8), rest(2, 0), rest(3, 0)], "8, which is not in the list"),
        ([rest(1, 0, leans_at=8), rest(2, 0), rest(3, 0)], "8, which is not in the list"),
        ([rest(1, 0, "in"), rest(2, 0), rest(3, 0)], "'in' the table"),
        ([rest(1, 0), rest(2, 0)], "no answer for number 3"),
        ([rest(1, 0, "near"), rest(2, 0), rest(3, 0)], "things.0.how"),
    ],
)
def test_impossible_stacks_are_asked_again(
    server: Running, reasoner: CloudReasoner, things: list, told: str
) -> None:
    always(server, {"things": things})
    with pytest.raises(BackendError, match=f"stacking_order.*{told}"):
        reasoner.stacking_order(reference(), instances(), VIEW)


# ----------------------------------------------------------------------------------- marks, poses
def test_marks_are_given_for_each_criterion(server: Running, reasoner: CloudReasoner) -> None:
    marks = [{"criterion": c, "why": "so", "mark": m} for c, m in (("PP", 5.5), ("VF", 2))]
    always(server, {"marks": marks})
    image = reference().image
    criteria = {"VF": "how real", "PP": "whether it stands"}
    assert reasoner.rate(image, (image, image), criteria) == {"VF": 2.0, "PP": 5.5}
    assert "- VF: how real" in server.script.requests[0].text
    with pytest.raises(BackendError, match="each of VF, PP, IA must have one mark"):
        reasoner.rate(image, (image,), {**criteria, "IA": "alike"})


def test_methods_are_ranked_by_letters(server: Running, reasoner: CloudReasoner) -> None:
    always(server, {"order": ["b", "A"]})
    image = reference().image
    methods = {"ours": (image,), "theirs": (image, image)}
    assert reasoner.rank(image, methods) == ("theirs", "ours")
    assert "ours" not in server.script.requests[0].text
    always(server, {"order": ["B", "B"]})
    with pytest.raises(BackendError, match="each of A, B once"):
        reasoner.rank(image, methods)


def test_yaws_are_radians_without_the_table(server: Running, reasoner: CloudReasoner) -> None:
    turns = [{"id": 1, "yaw": 90}, {"id": 2, "yaw": 270}, {"id": 3, "yaw": -30}]
    always(server, {"turns": turns})
    yaws = reasoner.guess_rotations(reference(), instances(), SIZES, VIEW)
    assert set(yaws) == set(NUMBERS.values())
    assert [yaws[n] for n in NUMBERS.values()] == pytest.approx([np.pi / 2, -np.pi / 2, -np.pi / 6])
    assert listed(server.script.requests[0].text) == {1: "book", 2: "mug", 3: "pen"}
    assert reasoner.guess_rotations(reference(), instances()[:1], SIZES, VIEW) == {}


def test_places_are_metres_from_the_middle(server: Running, reasoner: CloudReasoner) -> None:
    sized = {"length": 20, "width": 10, "height": 5}
    places = [{"id": n, "x": 10 * n, "y": -5, **sized} for n in NUMBERS]
    always(server, {"places": places})
    boxes = reasoner.guess_layout(reference(), instances(), SIZES, VIEW)
    np.testing.assert_allclose(boxes["mug_1"].center, [0.2, -0.05])
    np.testing.assert_allclose(boxes["mug_1"].size, [0.2, 0.1, 0.05])
    places[2]["x"] = 61
    with pytest.raises(BackendError, match="beyond the edge of the tabletop: 3"):
        reasoner.guess_layout(reference(), instances(), SIZES, VIEW)
    with pytest.raises(BackendError, match="size of the table"):
        bare = {n: s for n, s in SIZES.items() if n != TABLE}
        reasoner.guess_layout(reference(), instances(), bare, VIEW)


@pytest.mark.parametrize(
    ("box", "tag"),
    [([60, 90, 140, 150], (60, 72)), ([5, 0, 100, 80], (5, 0)), ([310, 50, 320, 80], (300, 32))],
)
def test_numbers_are_on_the_picture_whole(box: list[int], tag: tuple[int, int]) -> None:
    image = np.full((240, 320, 3), 255, np.uint8)
    thing = dataclasses.replace(instances()[1], box=box)
    drawn = Labelled.of(image, (thing,)).picture()
    x, y = tag
    around = drawn[y : y + 24, x : x + 20]
    assert ((around == 0).all(2)).sum() > 80  # black
    assert ((around[1:-1] > 200).all(2)).sum() > 8  # the number on it


def test_a_size_prior_is_the_stage_s_own(server: Running, reasoner: CloudReasoner) -> None:
    always(server, {"sizes": ALL})
    sizes = reasoner.estimate_sizes(reference(), instances(), VIEW)
    assert all(isinstance(s, SizePrior) and s.name == n for n, s in sizes.items())
