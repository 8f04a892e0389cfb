"""The viewer's finer points: who drives what, what is let go, what goes on unseen."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from bounded import until as wait_until
from browser import opened, place_on_page, until, wait_for_scenes
from browsing.chromium import ENGINE, serve
from playwright.sync_api import Browser, CDPSession, Page

from assets_cache.store import find
from tabletopgen_web.page.options import FolderOptions
from tabletopgen_web.page.site import write_site

pytestmark = [pytest.mark.slow, pytest.mark.timeout(900)]

SCENE = "kitchen-cutting"
THING = "bowl_1"


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A site of one scene with an episode."""
    options = FolderOptions(formats=(), episodes=1)
    return write_site(find(SCENE), tmp_path_factory.mktemp("one") / "site", options=options).path


@pytest.fixture(scope="module")
def address(place: Path) -> Iterator[str]:
    with serve(place) as found:
        yield found


def show(page: Page, address: str) -> None:
    page.goto(f"{address}#/scene/{SCENE}")
    wait_for_scenes(page)
    assert page.evaluate(f"{ENGINE}.error.value") is None


def drive(page: Page) -> None:
    """Put the arm at the table."""
    page.get_by_role("button", name="Drive the Panda").click()
    until(page, f"{ENGINE}.mode.value === 'arm'")


def joints(page: Page) -> np.ndarray:
    return np.array(page.evaluate(f"{ENGINE}.state()")["qpos"][-9:-2])


def wait_for_rest(page: Page) -> None:
    """Wait until the arm stops moving, without held keys."""
    for _ in range(60):
        before = joints(page)
        page.wait_for_timeout(500)
        if np.abs(joints(page) - before).max() < 0.01:
            return
    raise AssertionError("the arm goes on moving")


def place_of(page: Page, name: str) -> np.ndarray:
    """Return the position of a free object, metres."""
    bodies = {b["name"]: b["qpos"] for b in page.evaluate(f"{ENGINE}.bodies()")}
    at = bodies[name]
    return np.array(page.evaluate(f"{ENGINE}.state()")["qpos"][at : at + 3])


def touch(session: CDPSession, kind: str, *points: tuple[float, float]) -> None:
    fingers = [{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(points)]
    session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": fingers})


def swipe(session: CDPSession, start: tuple[float, float], right: float, down: float) -> None:
    touch(session, "touchStart", start)
    for k in range(1, 9):
        touch(session, "touchMove", (start[0] + right * k / 8, start[1] + down * k / 8))


def test_an_arm_that_is_held_where_it_is_stays_there(browser: Browser, address: str) -> None:
    """Its servos hold it: the pull is not doubled."""
    page = opened(browser).page
    show(page, address)
    drive(page)
    page.wait_for_timeout(300)
    before = joints(page)
    x, y = place_on_page(page, "panda/link5")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y + 0.2)
    page.wait_for_timeout(1200)
    assert np.abs(joints(page) - before).max() < 0.006  # radians
    page.mouse.up()


def test_a_finger_drags_a_thing_and_beside_things_turns_the_view(
    browser: Browser, address: str
) -> None:
    page = opened(browser, viewport={"width": 390, "height": 844}, has_touch=True).page
    show(page, address)
    session = page.context.new_cdp_session(page)
    before, view = place_of(page, THING), page.evaluate(f"{ENGINE}.stage.view")
    swipe(session, place_on_page(page, THING), 10, -70)
    wait_until(lambda: place_of(page, THING)[2] > before[2] + 0.03)
    touch(session, "touchEnd")
    assert page.evaluate(f"{ENGINE}.stage.view") == pytest.approx(view)
    box = page.locator("canvas").bounding_box()
    assert box is not None
    swipe(session, (box["x"] + 8, box["y"] + 8), 60, 0)
    touch(session, "touchEnd")
    until(page, f"Math.abs({ENGINE}.stage.view[0] - {view[0]}) > 0.05")


def test_buttons_of_the_arm_are_held_by_keys_and_let_go(browser: Browser, address: str) -> None:
    page = opened(browser).page
    show(page, address)
    drive(page)
    page.get_by_role("button", name="up", exact=True).focus()
    before = joints(page)
    page.keyboard.down("Space")
    until(page, f"Math.abs((await {ENGINE}.state()).qpos.at(-8) - {before[1]}) > 0.05")
    page.keyboard.up("Space")
    wait_for_rest(page)


def test_a_key_that_is_let_go_under_another_no_longer_drives(
    browser: Browser, address: str
) -> None:
    page = opened(browser).page
    show(page, address)
    drive(page)
    page.locator("canvas").focus()
    before = joints(page)
    page.keyboard.down("r")
    until(page, f"Math.abs((await {ENGINE}.state()).qpos.at(-8) - {before[1]}) > 0.03")
    page.keyboard.down("Control")
    page.keyboard.up("r")
    page.keyboard.up("Control")
    wait_for_rest(page)


def test_a_reset_opens_the_gripper_in_word_and_deed(browser: Browser, address: str) -> None:
    page = opened(browser).page
    show(page, address)
    drive(page)
    page.get_by_role("button", name="Close the gripper").click()
    page.get_by_role("button", name="Open the gripper").wait_for()
    page.get_by_role("button", name="Reset").click()
    page.get_by_role("button", name="Close the gripper").wait_for()
    page.locator("canvas").focus()
    page.keyboard.press("r")
    until(page, f"Math.abs((await {ENGINE}.state()).ctrl[7] - 255) < 1e-9")
    wait_for_rest(page)
    assert page.evaluate(f"{ENGINE}.state()")["ctrl"][7] == 255


@pytest.mark.parametrize(
    ("button", "mark"), [("Centres of mass", "centres"), ("Contacts", "spots")]
)
def test_marks_go_when_they_are_switched_off(
    browser: Browser, address: str, button: str, mark: str
) -> None:
    page = opened(browser).page
    show(page, address)
    page.get_by_role("button", name="Pause").click()  # nothing moves any more
    shown = f"{ENGINE}.marks.{mark}.visible"
    for wanted in ("true", "false"):
        page.get_by_role("button", name=button).click()
        until(page, f"{shown} === {wanted}", 20)


def test_what_nobody_sees_does_not_run(browser: Browser, address: str) -> None:
    page = opened(browser).page
    show(page, address)
    hide = (
        "value => { Object.defineProperty(document, 'hidden', { value, configurable: true });"
        " document.dispatchEvent(new Event('visibilitychange')); }"
    )
    page.evaluate(hide, True)
    page.wait_for_timeout(100)
    time = page.evaluate(f"{ENGINE}.state()")["time"]
    page.wait_for_timeout(300)
    assert page.evaluate(f"{ENGINE}.state()")["time"] == time
    page.evaluate(hide, False)
    until(page, f"(await {ENGINE}.state()).time > {time + 0.1}")


def test_modes_that_are_asked_for_at_once_come_one_after_the_other(
    browser: Browser, address: str
) -> None:
    watched = opened(browser)
    page = watched.page
    show(page, address)
    page.evaluate(
        f"""async () => {{
          const engine = {ENGINE};
          const [episode] = engine.files.episodes;
          await Promise.all([engine.setMode('arm'), engine.play(episode), engine.setMode('scene')]);
        }}"""
    )
    state = page.evaluate(f"{ENGINE}.state()")
    assert page.evaluate(f"{ENGINE}.mode.value") == "scene"
    assert page.evaluate(f"{ENGINE}.player.playback.value") is None
    assert len(state["ctrl"]) == 0 and not np.isnan(state["qpos"]).any()
    assert watched.faults == []


def test_a_damaged_episode_leaves_the_scene(browser: Browser, place: Path, tmp_path: Path) -> None:
    spoilt = tmp_path / "site"
    shutil.copytree(place, spoilt)
    (episode,) = spoilt.glob("scenes/*/episodes/*.bin")
    episode.write_bytes(episode.read_bytes()[:-5])
    with serve(spoilt) as address:
        page = opened(browser).page
        show(page, address)
        page.get_by_role("button", name="Watch: ").click()
        assert "damaged" in page.get_by_role("alert").inner_text()
        page.get_by_role("button", name="Back to the scene").click()
        until(page, f"{ENGINE}.trouble.value === null && (await {ENGINE}.state()).time > 0.2")
        assert page.get_by_role("alert").count() == 0


def test_no_memory_for_the_physics_is_said(browser: Browser, address: str) -> None:
    """The worker's WebAssembly cannot start: an error appears instead of endless waiting."""
    page = opened(browser).page
    script = "WebAssembly.instantiate = () => Promise.reject(new RangeError('Out of memory'));\n"

    def spoil(route: object) -> None:
        answer = route.fetch()  # type: ignore[attr-defined]
        route.fulfill(response=answer, body=script + answer.text())  # type: ignore[attr-defined]

    page.context.route("**/assets/worker-*.js", spoil)
    page.goto(f"{address}#/scene/{SCENE}")
    assert "Out of memory" in page.get_by_role("alert").inner_text(timeout=30_000)


def test_scenes_that_are_passed_over_leave_no_workers(browser: Browser, address: str) -> None:
    page = opened(browser).page
    page.goto(f"{address}#/")
    page.locator("a.card").first.wait_for()
    page.evaluate(
        f"""async () => {{
          for (let k = 0; k < 12; k++) {{
            location.hash = k % 2 ? '#/' : '#/scene/{SCENE}';
            await new Promise((done) => setTimeout(done));
          }}
          location.hash = '#/scene/{SCENE}';
        }}"""
    )
    wait_for_scenes(page)
    page.wait_for_timeout(300)
    assert len(page.workers) == 1
