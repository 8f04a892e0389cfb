"""The imager's pictures over HTTP, in both server formats, and their processing."""

import io
import json
import struct
import zlib
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import cv2
import numpy as np
import pytest
from desk import SIZES, VIEW, detections, instances, reference
from openai_server import KEY, Request, Running
from PIL import Image
from toy import cube_mesh

from generator.backends.cloud.drawing.pictures import pad
from generator.backends.cloud.imager import REDRAWS, CloudImager
from generator.backends.cloud.server.typed_question import data_uri
from generator.calls.session import Session
from generator.calls.store import CallStore, Used
from generator.errors import BackendError, UnusableError
from generator.geometry import mask_box
from generator.io.pictures import encode_png
from generator.render.crop import in_reference, tight_box
from generator.scene import (
    Detection,
    Instance,
    Model,
    PlannedObject,
    PlannedTable,
    Relation,
    ScenePlan,
    TopView,
)

Make = Callable[..., CloudImager]
PLAN = ScenePlan(
    "x",
    PlannedTable("round", "walnut", size=(1.0, 0.9, 0.74)),
    (
        PlannedObject("mug_1", "mug", "mug", {"color": "red"}, (Relation("on", "book_1"),)),
        PlannedObject("book_1", "book", "book", size=(0.2, 0.15, 0.03)),
        PlannedObject("mug_2", "mug", "mug", {}, (Relation("left_of", "book_1"),)),
    ),
    "cosy",
)


def plain(width: int = 300, height: int = 200) -> np.ndarray:
    return np.full((height, width, 3), (10, 200, 30), np.uint8)


@pytest.fixture(autouse=True)
def painted(server: Running) -> None:
    """The server draws a plain picture by default."""
    server.script.paint = lambda request: plain()


def bomb() -> bytes:
    """A PNG of a few bytes that claims 60000 x 60000 pixels."""
    head = b"IHDR" + struct.pack(">IIBBBBB", 60000, 60000, 8, 2, 0, 0, 0)
    chunk = struct.pack(">I", 13) + head + struct.pack(">I", zlib.crc32(head))
    data = b"IDAT" + zlib.compress(b"\0" * 100)
    body = struct.pack(">I", len(data) - 4) + data + struct.pack(">I", zlib.crc32(data))
    return b"\x89PNG\r\n\x1a\n" + chunk + body


# ------------------------------------------------------------------------------------------- draw
def test_openai_s_form_draws(server: Running, make_imager: Make) -> None:
    drawn = make_imager().draw(PLAN, 0)
    np.testing.assert_array_equal(drawn, plain())
    (request,) = server.script.requests
    assert request.path == "/v1/images/generations"
    assert request.body["size"] == "1536x1024"
    assert "response_format" not in request.body
    for words in (
        "round walnut table, 100 cm long, 90 cm deep and 74 cm high, with straight legs",
        "exactly 3 things",
        "1. the red mug (number 1 of 2): on the book",
        "2. the book, 20 by 15 by 3 cm",
        "3. the mug (number 2 of 2): to the left of the book",
        "cosy",
    ):
        assert words in request.text


def test_seedream_s_form_draws(server: Running, make_imager: Make) -> None:
    server.script.form = "seedream"
    make_imager(form="seedream").draw(PLAN, 0)
    (request,) = server.script.requests
    assert request.body["size"] == "2048x1360"
    assert request.body["response_format"] == "b64_json"
    assert request.body["watermark"] is False
    assert request.body["sequential_image_generation"] == "disabled"


def test_another_seed_is_another_drawing(server: Running, make_imager: Make) -> None:
    imager = make_imager()
    for seed in (0, 1, 2):
        imager.draw(PLAN, seed)
    assert len({r.text for r in server.script.requests}) == 3


def test_clear_pictures_lie_on_white_and_large_ones_are_shrunk(
    server: Running, make_imager: Make
) -> None:
    server.script.paint = lambda request: np.zeros((1000, 2000, 4), np.uint8)
    drawn = make_imager().draw(PLAN, 0)
    assert drawn.shape == (640, 1280, 3)
    assert (drawn == 255).all()


def test_options_that_a_server_does_not_know_are_left_out(
    server: Running, make_imager: Make
) -> None:
    server.script.unknown = {"size"}
    imager = make_imager()
    imager.draw(PLAN, 0)
    imager.draw(PLAN, 1)
    assert ["size" in r.body for r in server.script.requests] == [True, False, False]


def test_a_form_that_is_none_is_refused(make_imager: Make) -> None:
    with pytest.raises(BackendError, match=r"form 'seadream' is unknown\. Did you mean 'seedream'"):
        make_imager(form="seadream")


@pytest.mark.parametrize(
    ("model", "url", "form"),
    [
        ("gpt-image-1", "https://api.openai.com/v1", "openai"),
        ("doubao-seedream-4-0-250828", "https://proxy.example/v1", "seedream"),
        ("ep-2025", "https://ark.cn-beijing.volces.com/api/v3", "seedream"),
    ],
)
def test_the_form_is_told_by_names(make_imager: Make, model: str, url: str, form: str) -> None:
    assert make_imager(model=model, base_url=url).form == form


# --------------------------------------------------------------------------------- bad pictures
@pytest.mark.parametrize(
    ("data", "told"),
    [
        (b"<html>busy</html>", "the picture is HTML"),
        (b"GIF89a....", "use PNG, JPEG or WebP"),
        (bomb(), "at most 40,000,000 are allowed"),
        (b"", "contains no picture"),
    ],
    ids=("html", "gif", "bomb", "nothing"),
)
def test_what_is_no_picture_is_refused(
    server: Running, make_imager: Make, data: bytes, told: str
) -> None:
    server.script.paint = lambda request: data
    with pytest.raises(BackendError, match=rf"cloud .*: draw failed: .*{told}"):
        make_imager().draw(PLAN, 0)


def test_half_a_picture_and_a_tiny_one_are_refused(server: Running, make_imager: Make) -> None:
    file = io.BytesIO()
    noise = np.random.default_rng(0).integers(0, 255, (200, 200, 3), dtype=np.uint8)
    Image.fromarray(noise).save(file, "PNG")
    server.script.paint = lambda request: file.getvalue()[:5000]
    with pytest.raises(BackendError, match="damaged"):
        make_imager().draw(PLAN, 0)
    server.script.paint = lambda request: plain(20, 20)
    with pytest.raises(BackendError, match="20x20"):
        make_imager().draw(PLAN, 1)


def test_a_picture_that_the_model_will_not_draw(server: Running, make_imager: Make) -> None:
    server.script.failures.append("moderation")
    with pytest.raises(BackendError, match=r"draw failed: the model refuses: .*safety system"):
        make_imager().draw(PLAN, 0)
    assert len(server.script.requests) == 1


def test_a_server_that_speaks_of_case_does_not_refuse(server: Running, make_imager: Make) -> None:
    server.script.failures.append("case")
    np.testing.assert_array_equal(make_imager().draw(PLAN, 0), plain())
    assert len(server.script.requests) == 2


def test_a_kept_answer_that_is_of_no_use_is_asked_for_anew(
    server: Running, make_imager: Make, tmp_path
) -> None:
    server.script.paint = lambda request: b"<html>busy</html>"
    with pytest.raises(BackendError, match="HTML"):
        make_imager(session=Session(store=CallStore(tmp_path))).draw(PLAN, 0)
    server.script.paint = lambda request: plain()
    for _ in range(2):
        drawn = make_imager(session=Session(store=CallStore(tmp_path))).draw(PLAN, 0)
        np.testing.assert_array_equal(drawn, plain())
    assert len(server.script.requests) == 3


# ------------------------------------------------------------------------------------- addresses
def test_a_picture_is_fetched_without_the_key(server: Running, make_imager: Make) -> None:
    server.script.urls = True
    np.testing.assert_array_equal(make_imager().draw(PLAN, 0), plain())
    _, fetched = server.script.requests
    assert fetched.path.startswith("/files/")
    assert fetched.body == {"key": False}
    assert KEY not in str(fetched.headers)


def test_an_expired_address_is_asked_for_anew(server: Running, make_imager: Make, tmp_path) -> None:
    server.script.urls = True
    server.script.lost = {"/files/1.png"}
    np.testing.assert_array_equal(
        make_imager(session=Session(store=CallStore(tmp_path))).draw(PLAN, 0), plain()
    )
    assert len(server.script.asked("generations")) == 2


def test_an_address_at_another_host_is_not_fetched(
    make_imager: Make, monkeypatch: pytest.MonkeyPatch
) -> None:
    imager = make_imager()
    for address in ("https://evil.example/a.png", "http://127.0.0.1:1/a.png"):
        with pytest.raises(
            BackendError, match=r"downloads are not allowed.*TABLETOPGEN_CLOUD_IMAGE_H"
        ):
            imager.painter._picture("draw", {"data": [{"url": address}]}, Used(None), "yes")


@pytest.mark.parametrize(
    "address",
    ["file:///etc/passwd", "http://[::1", "https://a\u2100b/x", "http://", "\x1b[2J",
     "https://user:pass@api.openai.com/x", "https://h:99999/", "https://" + "a" * 9000],
)  # fmt: skip
def test_what_is_no_address_is_told_once_and_stays_paid_for(
    server: Running, make_imager: Make, address: str
) -> None:
    server.script.urls, server.script.address = True, address
    imager = make_imager()
    with pytest.raises(UnusableError, match="the picture's address"):
        imager.painter.paint("draw", "a mug", 1.5)
    assert [entry.outcome for entry in imager.session.account.entries] == ["answered"]


@pytest.mark.parametrize("data", [[{"b64_json": 5}], [{"url": ["x"]}], [{"b64_json": {}}], [5], 7])
def test_values_of_other_types_are_no_picture(make_imager: Make, data: Any) -> None:
    with pytest.raises(Exception, match="contains no picture"):
        make_imager().painter._picture("draw", {"data": data}, Used(None), "yes")


def test_a_picture_in_a_data_address_is_taken(make_imager: Make) -> None:
    data = {"data": [{"url": data_uri(encode_png(plain()))}]}
    found = make_imager().painter._picture("draw", data, Used(None), "yes")
    np.testing.assert_array_equal(found[..., :3], plain())


# --------------------------------------------------------------------------------------- complete
def redrawn(
    shown: np.ndarray, *, clear: bool, scale: float = 1.0, shift: tuple[int, int] = (0, 0)
) -> np.ndarray:
    """Redraw the content of a cut-out: resized about the centre, moved, optionally on white."""
    side = shown.shape[0]
    ground = shown[0, 0]
    middle = (1 - scale) * side / 2
    warp = np.array([[scale, 0, middle + shift[0]], [0, scale, middle + shift[1]]])
    picture = cv2.warpAffine(
        shown, warp, (side, side), borderMode=cv2.BORDER_CONSTANT, borderValue=ground.tolist()
    )
    if not clear:
        return picture
    alpha = (np.abs(picture.astype(int) - ground).max(2) > 40).astype(np.uint8) * 255
    return np.dstack([picture, alpha])


@pytest.mark.slow
@pytest.mark.parametrize("form", ["openai", "seedream"])
@pytest.mark.parametrize(("scale", "shift"), [(1.0, (0, 0)), (0.9, (60, -40)), (1.12, (-30, 20))])
def test_a_thing_is_put_back_where_it_was(
    server: Running, make_imager: Make, form: str, scale: float, shift: tuple[int, int]
) -> None:
    server.script.form = form
    server.script.paint = lambda r: redrawn(
        r.body["images"][0], clear=form == "openai", scale=scale, shift=shift
    )
    made, pen = completed(make_imager(form=form), "pen_1")
    assert (made.name, made.label, made.occluded) == ("pen", "pen", False)
    np.testing.assert_array_equal(made.mask, pen.mask)
    there = in_reference(made, tight_box(made))
    np.testing.assert_allclose(there, pen.box, atol=3)  # of 84 pixels that the cut-out shows
    inner = made.crop[made.crop[..., 3] > 250][:, :3]
    np.testing.assert_allclose(np.median(inner, axis=0), (20, 20, 20), atol=6)
    assert (made.crop[[0, -1]][..., 3] == 0).all()  # a margin all around
    (request,) = server.script.requests
    assert len(request.body["images"]) == 2
    assert '"pen"' not in request.text
    assert "pen" in request.text


@pytest.mark.slow
def test_openai_s_form_is_told_what_to_keep(server: Running, make_imager: Make) -> None:
    server.script.paint = lambda r: redrawn(r.body["images"][0], clear=True)
    _, book = completed(make_imager(), "book_1")
    (request,) = server.script.requests
    assert request.path == "/v1/images/edits"
    assert (request.body["size"], request.body["background"]) == ("1024x1024", "transparent")
    assert request.body["input_fidelity"] == "high"
    shown, mask = request.body["images"][0], request.body["mask"]
    kept = mask[..., 3] > 0
    np.testing.assert_allclose(shown[kept].mean(0), (40, 60, 160), atol=8)
    np.testing.assert_allclose(kept.mean(), book.mask.sum() / (1.4 * 80) ** 2, rtol=0.1)


@pytest.mark.slow
def test_a_server_without_masks_is_asked_without(server: Running, make_imager: Make) -> None:
    server.script.unknown = {"mask", "background"}
    server.script.paint = lambda r: redrawn(r.body["images"][0], clear=False)
    found = detections()
    imager = make_imager()
    for _ in range(2):
        imager.complete(reference(), found["pen_1"], (found["book_1"],))
        imager = replace(imager, seed=imager.seed + 1)
    sent = [("mask" in r.body, "background" in r.body) for r in server.script.requests]
    assert sent[0] == (True, True)
    assert sent[-1] == (False, False)
    assert len(sent) <= 4


@pytest.mark.slow
def test_hidden_parts_are_drawn_and_told(server: Running, make_imager: Make) -> None:
    """The mug hides a corner of the book's outline; the model draws the whole book."""

    def paint(request: Request) -> np.ndarray:
        shown = request.body["images"][0]
        book = np.abs(shown.astype(int) - (40, 60, 160)).max(2) < 30
        x0, y0, x1, y1 = mask_box(book).astype(int)
        picture = np.zeros((*shown.shape[:2], 4), np.uint8)
        picture[y0:y1, x0:x1] = (40, 60, 160, 255)
        return picture

    server.script.paint = paint
    made, book = completed(make_imager(), "book_1")
    assert made.occluded
    scale = made.crop.shape[1] / np.ptp(made.crop_box[[0, 2]])
    assert (made.crop[..., 3] > 127).sum() > 1.1 * book.mask.sum() * scale**2
    np.testing.assert_allclose(in_reference(made, tight_box(made)), [60, 90, 140, 150], atol=2.5)


@pytest.mark.slow
def test_what_touches_others_is_not_hidden_by_them(server: Running, make_imager: Make) -> None:
    server.script.paint = lambda r: redrawn(r.body["images"][0], clear=True, scale=0.95)
    assert not completed(make_imager(), "mug_1")[0].occluded


@pytest.mark.slow
def test_another_thing_is_drawn_again_with_what_was_wrong(
    server: Running, make_imager: Make
) -> None:
    def paint(request: Request) -> np.ndarray:
        if len(server.script.requests) > 1:
            return redrawn(request.body["images"][0], clear=True)
        wrong = np.zeros((512, 512, 4), np.uint8)
        cv2.circle(wrong, (256, 256), 200, (255, 0, 0, 255), -1)
        return wrong

    server.script.paint = paint
    made = make_imager().complete(reference(), detections()["pen_1"], ())
    assert made.label == "pen"
    first, second = server.script.requests
    assert "differs in shape from the cut-out" not in first.text
    assert "differs in shape from the cut-out" in second.text


@pytest.mark.slow
@pytest.mark.parametrize(
    ("paint", "told"),
    [
        (lambda side: np.random.default_rng(1).integers(0, 255, (side, side, 3), dtype=np.uint8),
         "must be one flat colour"),
        (lambda side: np.full((side, side, 3), 255, np.uint8), "fills 0.0%"),
        (lambda side: np.full((side, side, 4), 255, np.uint8), "fills 0.0%"),
    ],
)  # fmt: skip
def test_a_thing_that_is_never_drawn_is_an_error(
    server: Running, make_imager: Make, paint: Callable[[int], np.ndarray], told: str
) -> None:
    server.script.paint = lambda request: paint(256)
    with pytest.raises(BackendError, match=f"complete failed: 3 drawings of 'pen'.*{told}"):
        make_imager().complete(reference(), detections()["pen_1"], ())
    assert len(server.script.requests) == 1 + REDRAWS


# --------------------------------------------------------------------------------------- top view
def test_pictures_have_a_shape_that_the_model_takes() -> None:
    wide, high = np.zeros((50, 400, 3), np.uint8), np.zeros((300, 100, 3), np.uint8)
    assert pad(wide, 0.4, 2.5).shape == (160, 400, 3)
    assert pad(high, 0.5, 2.0).shape == (300, 150, 3)
    assert (pad(wide, 0.4, 2.5)[[0, -1]] == 255).all()
    np.testing.assert_array_equal(pad(wide, 0.4, 2.5)[55:105], wide)
    np.testing.assert_array_equal(pad(wide, 0.1, 10), wide)


def models() -> dict[str, Model]:
    return {
        name: Model(name, name.removesuffix("_1"), cube_mesh(), prior.extent)
        for name, prior in SIZES.items()
    }


def completed(imager: CloudImager, name: str) -> tuple[Instance, Detection]:
    """Complete one object of the desk; return the result and the findings."""
    found = detections()
    thing = found.pop(name)
    return imager.complete(reference(), thing, tuple(found.values())), thing


def sight(id: int, *boxes: list[int], covered: bool = False) -> dict:
    return {"id": id, "boxes": list(boxes), "covered": covered}


GOOD = [sight(1, [100, 100, 300, 300]), sight(2, [150, 150, 250, 250]), sight(3, [600, 1, 700, 9])]


def check(things: list, extra: list = [], from_above: bool = True) -> str:  # noqa: B006
    return json.dumps({"from_above": from_above, "things": things, "extra": extra})


def seen(imager: CloudImager) -> TopView:
    return imager.top_view(reference(), instances(), models(), {}, VIEW)


def test_a_right_top_view_is_taken_and_left_to_the_segmenter(
    server: Running, make_imager: Make
) -> None:
    server.script.paint = lambda request: plain(512, 300)
    server.script.chat = lambda request: check(GOOD)
    top = seen(make_imager())
    np.testing.assert_array_equal(top.image, plain(512, 300))
    assert dict(top.boxes) == {}
    assert top.warnings == ()
    drawn, checked = server.script.requests
    assert "120 cm from left to right by 70 cm" in drawn.text
    assert "exactly these 3 things" in drawn.text.lower()
    assert drawn.body["size"] == "1536x1024"
    assert "1: book\n2: mug\n3: pen" in checked.text


def seen_at_last(server: Running, make_imager: Make, first: str) -> None:
    """Return the result for a top view whose first check gets this answer, and the next a good
    one."""
    asked = server.script.asked
    server.script.chat = lambda r: first if len(asked("completions")) == 1 else check(GOOD)
    assert seen(make_imager()).warnings == ()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("answer", "told"),
    [
        (check([*GOOD[:2], sight(3)]), "The pen (number 3) was missing."),
        (check([*GOOD[:2], sight(3, [1, 1, 9, 9], [50, 1, 90, 9])]), "appeared 2 times."),
        (check(GOOD, ["spoon"]), "There was a spoon, which does not belong in the picture."),
        (check(GOOD, from_above=False), "was not from straight above."),
    ],
)
def test_a_wrong_top_view_is_drawn_again(
    server: Running, make_imager: Make, answer: str, told: str
) -> None:
    seen_at_last(server, make_imager, answer)
    first, second = server.script.asked("edits")
    assert told not in first.text
    assert told in second.text


@pytest.mark.parametrize(
    ("things", "told"),
    [
        ([*GOOD[:2], sight(3, [100, 100, 300, 301])], "numbers 1 and 3 must not have the same box"),
        ([*GOOD[:2], sight(3, [9, 9, 1, 1])], "a box of number 3 is invalid"),
        (GOOD[:2], "no answer for number 3"),
    ],
)
def test_a_check_that_cannot_be_is_asked_again(
    server: Running, make_imager: Make, things: list, told: str
) -> None:
    seen_at_last(server, make_imager, check(things))
    assert told in server.script.asked("completions")[1].text
    assert len(server.script.asked("edits")) == 1


def test_what_lies_below_another_need_not_be_seen(server: Running, make_imager: Make) -> None:
    server.script.chat = lambda request: check([*GOOD[:2], sight(3, covered=True)])
    assert seen(make_imager()).warnings == ()


@pytest.mark.slow
def test_geometry_stands_in_with_a_warning(server: Running, make_imager: Make) -> None:
    server.script.chat = lambda request: check([*GOOD[:2], sight(3)])
    top = seen(make_imager())
    assert len(server.script.asked("edits")) == 1 + REDRAWS
    assert set(top.boxes) == {"book_1", "mug_1", "pen_1"}
    assert set(top.repaired) == set(top.boxes)
    (warning,) = top.warnings
    assert (
        "rendered from geometry" in warning
        and "3 top views drawn by brush-1 could not be used." in warning
    )
    assert "The pen (number 3) was missing." in warning
