"""The studio as a person uses it, in a real browser."""

import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from browser import axe_results, place_on_page, until, wait_for_scenes
from browsing.chromium import ENGINE
from playwright.sync_api import Browser
from studio_pages import TEXT, Studio, drag, enter, jobs, make, place, running

from generator.bundle import load, verify

pytestmark = [pytest.mark.slow, pytest.mark.timeout(900)]

MUG = "a wooden desk with a mug"
"""A text of one object, for the full method."""


@pytest.fixture(scope="module")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    """A studio for tests that do not count its tables and jobs."""
    folder = tmp_path_factory.mktemp("shared")
    (folder / "store").mkdir()
    with running(folder / "studio", folder / "store") as found:
        yield found


@pytest.fixture
def studio(tmp_path: Path) -> Iterator[Studio]:
    """A separate studio for one test."""
    (tmp_path / "store").mkdir()
    with running(tmp_path / "studio", tmp_path / "store") as found:
        yield found


def test_a_table_is_made_mended_by_mouse_saved_and_opened_in_the_environment(
    browser: Browser, studio: Studio
) -> None:
    import gymnasium as gym

    watched = enter(browser, studio)
    page = watched.page
    make(page)
    page.get_by_role("button", name="Above").click()
    page.wait_for_timeout(500)
    drag(page, "mug_1", 25, 12)
    page.get_by_role("button", name="Above").click()
    page.wait_for_timeout(500)
    drag(page, "plate_1", -20, -10)
    page.get_by_role("button", name="Save to the store").click()
    page.get_by_text("is now in your store").wait_for()
    page.get_by_role("button", name="Saved").wait_for()
    scene = page.url.rpartition("/")[2]
    assert verify(studio.store / scene) == []
    moved = load(studio.store / scene)
    assert [edit.kind for edit in moved.provenance.edits] == ["move", "move"]
    env = gym.make(
        "tabletopgen_env:TabletopGen/Lift-v0", scenes=str(studio.store / scene), certified=False
    )
    env.reset(seed=0)
    env.close()
    page.get_by_role("button", name="Watch the expert").click()
    until(page, f"{ENGINE}.player.playback.value !== null")
    assert watched.faults == []


def test_a_drag_is_the_command_and_undo_goes_back(
    browser: Browser, studio: Studio, tmp_path: Path
) -> None:
    page = enter(browser, studio).page
    make(page)
    first = page.url.rpartition("/")[2]
    page.get_by_role("button", name="Above").click()
    page.wait_for_timeout(500)
    drag(page, "mug_1", 30, -10)
    second = page.url.rpartition("/")[2]
    asked = next(job["request"] for job in jobs(page) if job["kind"] == "edit")
    x, y = asked["to"]
    command = [
        sys.executable, "-m", "generator", "edit", str(studio.folder / "scenes" / first), "move",
        "mug_1", "--to", str(x), str(y), "--out", str(tmp_path / "by-command"),
    ]  # fmt: skip
    subprocess.run(command, check=True, timeout=120, stdout=subprocess.DEVNULL)
    assert [p.name for p in (tmp_path / "by-command").iterdir()] == [second]
    page.get_by_role("button", name="Undo").click()
    page.wait_for_function("name => location.href.endsWith(name)", arg=first)
    page.get_by_role("button", name="Redo").click()
    page.wait_for_function("name => location.href.endsWith(name)", arg=second)
    page.get_by_role("link", name="Make", exact=True).click()
    page.get_by_text("1 edit: move mug_1").wait_for()
    assert page.locator("article.card").count() == 1, "what was edited further is not shown"
    page.get_by_label("Show earlier versions").check()
    assert page.locator("article.card").count() == 2


def test_what_stands_on_a_thing_goes_along(browser: Browser, shared: Studio) -> None:
    page = enter(browser, shared).page
    make(page, "a wooden desk with an apple on a plate")
    scene = page.url.rpartition("/")[2]
    page.get_by_role("button", name="Above").click()
    page.wait_for_timeout(500)
    locate = f"{ENGINE}.locate('apple_1')"
    before, (x, y) = page.evaluate(locate), place_on_page(page, "plate_1")
    page.mouse.move(x + 30, y)  # beside the apple
    page.mouse.down()
    page.mouse.move(x + 70, y + 20, steps=4)
    during = page.evaluate(locate)
    assert abs(during["x"] - before["x"] - 40) < 6 and abs(during["y"] - before["y"] - 20) < 6
    page.mouse.up()
    page.wait_for_function("name => !location.href.endsWith(name)", arg=page.url[-12:])
    wait_for_scenes(page)
    asked = next(job for job in jobs(page) if job["request"].get("scene") == scene)
    moved = load(shared.folder / "scenes" / asked["result"]["scene"])
    assert moved.provenance.edits[0].names == ("plate_1", "apple_1")


def test_a_thing_that_is_dragged_shows_where_it_cannot_stand(
    browser: Browser, shared: Studio
) -> None:
    watched = enter(browser, shared)
    page = watched.page
    make(page, "a wooden desk with an apple on a plate and a mug")
    page.get_by_role("button", name="Above").click()
    page.wait_for_timeout(500)
    blocked = f"{ENGINE}.blocked.value"
    x, y = place_on_page(page, "apple_1")  # it is let down from the plate
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(*place_on_page(page, "mug_1"), steps=6)
    page.get_by_text("apple_1: mug_1 in the way").wait_for()
    page.mouse.move(x, 1, steps=6)
    page.get_by_text("apple_1: off the table").wait_for()
    page.mouse.move(x, y, steps=6)
    page.wait_for_function(f"() => {blocked} === null")
    page.mouse.up()
    (x, y), (to_x, to_y) = place_on_page(page, "mug_1"), place_on_page(page, "plate_1")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(to_x + 25, to_y, steps=6)  # the apple or the plate, whichever comes first
    page.get_by_text(re.compile("mug_1: .*plate_1.* in the way")).wait_for()
    page.mouse.up()
    page.get_by_role("alert").get_by_text("in the way").wait_for(timeout=60_000)
    assert page.evaluate(blocked) is None and watched.faults == []


def test_an_edit_that_is_refused_leaves_everything_in_its_place(
    browser: Browser, studio: Studio
) -> None:
    page = enter(browser, studio).page
    place(page, studio)
    where = page.url
    page.get_by_placeholder("a red mug left of the laptop").fill(
        "forty grand pianos inside the mug"
    )
    page.get_by_role("button", name="Add", exact=True).click()
    page.get_by_role("alert").wait_for(timeout=60_000)
    assert page.url == where
    assert page.evaluate(f"{ENGINE}.error.value") is None
    page.get_by_role("link", name="Make", exact=True).click()
    page.get_by_text("Edits, exports and episodes (1)").click()
    page.get_by_text("edit: failed").wait_for()
    assert page.get_by_role("button", name=re.compile("again|Resume")).count() == 0, (
        "it would be refused again"
    )


def test_a_generation_shows_its_stages_is_cancelled_and_resumed(
    browser: Browser, studio: Studio
) -> None:
    watched = enter(browser, studio)
    page = watched.page
    page.get_by_label("Describe the table").fill(MUG)
    page.get_by_label("Generate: the full method").check()
    page.get_by_role("button", name="Estimate the cost").click()
    page.get_by_text("No requests to servers").wait_for(timeout=60_000)
    page.get_by_role("button", name="Make the table").click()
    page.locator("figure").first.wait_for(timeout=120_000)
    page.get_by_role("button", name="Cancel").click()
    page.get_by_text("generate: cancelled").wait_for(timeout=60_000)
    assert list((studio.folder / "scenes").glob("*")) == []
    page.get_by_role("button", name="Start again").click()
    page.get_by_role("link", name="Open the table").wait_for(timeout=300_000)
    assert page.locator("figure").count() >= 7
    assert len(list((studio.folder / "scenes").glob("*"))) == 1
    assert watched.faults == []


def test_a_studio_that_is_killed_goes_on_where_it_was(browser: Browser, tmp_path: Path) -> None:
    (tmp_path / "store").mkdir()
    folder, store = tmp_path / "studio", tmp_path / "store"
    with running(folder, store) as first:
        page = enter(browser, first).page
        page.get_by_label("Describe the table").fill(MUG)
        page.get_by_label("Generate: the full method").check()
        page.get_by_role("button", name="Make the table").click()
        page.locator("figure").first.wait_for(timeout=120_000)
        first.process.kill()
        page.get_by_text("The studio is not responding").wait_for(timeout=60_000)
    with running(folder, store) as second:
        page = enter(browser, second).page
        begun = "const job = (await (await fetch('/api/jobs')).json()).jobs[0];"
        until(page, f"(await (async () => {{ {begun} return job.runs === 2 && job.stage; }})())")


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"<html><script>alert(1)</script></html>", "picture"),
        (b"", "picture"),
        (b"\x89PNG\r\n\x1a\n" + b"\0" * 100, "picture"),
    ],
)
def test_what_is_no_picture_is_said(
    browser: Browser, shared: Studio, tmp_path: Path, content: bytes, said: str
) -> None:
    page = enter(browser, shared).page
    path = tmp_path / "photo.png"
    path.write_bytes(content)
    page.locator("input[type=file]").set_input_files(path)
    assert said in page.get_by_role("alert").inner_text()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_studio_accessibility(browser: Browser, shared: Studio, scheme: Any) -> None:
    page = enter(browser, shared, color_scheme=scheme, bypass_csp=True).page
    page.get_by_label("Describe the table").fill(TEXT + " and a zorble")
    page.get_by_text("Interpretation of each phrase").wait_for()
    for name in ("first", "job", "scene", "scenes"):
        if name == "job":
            page.get_by_role("button", name="Make the table").click()
            page.get_by_role("link", name="Open the table").wait_for(timeout=60_000)
        if name == "scene":
            page.get_by_role("link", name="Open the table").click()
            wait_for_scenes(page)
        if name == "scenes":
            page.get_by_role("link", name="Scenes", exact=True).click()
            page.locator("article.card").first.wait_for()
        faults, share = axe_results(page)
        assert (name, faults) == (name, [])
        assert share >= 0.95, name


def test_variants_are_compared_and_two_tabs_see_the_same(browser: Browser, studio: Studio) -> None:
    watched = enter(browser, studio)
    page = watched.page
    other = page.context.new_page()
    other.goto(studio.root)
    other.get_by_role("heading", name="Make a table").wait_for()
    page.get_by_label("Describe the table").fill(TEXT)
    page.get_by_label("Variants").fill("2")
    page.get_by_role("button", name="Make 2 tables").click()
    for each in (page, other):
        each.wait_for_function(
            "() => document.querySelectorAll('article.card').length === 2", timeout=120_000
        )
    for box in page.get_by_role("checkbox").all():
        box.check()
    page.get_by_role("link", name="Compare 2 side by side").click()
    wait_for_scenes(page, 2)
    assert watched.faults == []
