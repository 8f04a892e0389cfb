"""A static page in a real browser: scenes load, simulate, can be looked at, dragged and driven."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browser import axe_results, opened, place_on_page, until, wait_for_scene, wait_for_scenes
from browsing.chromium import ENGINE
from extent import count
from pages import STEPS, apart, simulate
from playwright.sync_api import Browser, Page

pytestmark = [pytest.mark.slow, pytest.mark.timeout(900)]

CUTTING = "kitchen-cutting"


def state(page: Page) -> dict[str, Any]:
    return page.evaluate(f"{ENGINE}.state()")


def rows_of(page: Page) -> dict[str, int]:
    """Return the first qpos index of each free body."""
    return {b["name"]: b["qpos"] for b in page.evaluate(f"{ENGINE}.bodies()") if b["qpos"] >= 0}


def show(page: Page, site: str, scene: str) -> None:
    page.goto(f"{site}#/scene/{scene}")
    wait_for_scene(page, f"/{scene}")
    assert page.evaluate(f"{ENGINE}.error.value") is None


def test_every_shipped_scene_stays_where_mujoco_in_python_says(
    browser: Browser, site: str, shipped: list[Path]
) -> None:
    """Poses after 2 s agree within 1 mm and 0.5 degrees."""
    watched = opened(browser)
    worst = {}
    for bundle in shipped:
        show(watched.page, site, bundle.name)
        page = watched.page
        page.evaluate(f"{ENGINE}.run(false)")
        page.evaluate(f"{ENGINE}.reset()")
        here = np.array(page.evaluate(f"{ENGINE}.advance({STEPS})")["qpos"])
        worst[bundle.name] = apart(here, simulate(bundle))
    assert len(worst) == len(shipped) >= count(23, 8)
    assert {n: w for n, w in worst.items() if w[0] > 1e3 or w[1] > 0.5} == {}
    assert watched.faults == []


def test_a_thing_is_dragged_and_thrown(browser: Browser, site: str) -> None:
    watched = opened(browser)
    page = watched.page
    show(page, site, CUTTING)
    row = rows_of(page)["bowl_1"]
    before = state(page)["qpos"][row : row + 3]
    x, y = place_on_page(page, "bowl_1")
    page.mouse.move(x, y)
    until(page, f"{ENGINE}.hover.value?.name === 'bowl_1'")
    page.mouse.down()
    page.mouse.move(x, y - 80, steps=8)
    until(page, f"(await {ENGINE}.state()).qpos[{row + 2}] > {before[2] + 0.03}")
    page.mouse.up()
    until(page, f"Math.hypot(...(await {ENGINE}.state()).qvel) < 0.01")
    after = state(page)["qpos"][row : row + 3]
    assert np.linalg.norm(np.subtract(after, before)) > 0.02
    page.get_by_role("button", name="Reset").click()
    until(page, f"(await {ENGINE}.state()).time < 1")
    assert state(page)["qpos"][row : row + 3] == pytest.approx(before, abs=1e-3)
    assert watched.faults == []


def test_play_pause_and_step(browser: Browser, site: str) -> None:
    page = opened(browser).page
    show(page, site, CUTTING)
    page.get_by_role("button", name="Pause").click()
    first = state(page)["time"]
    page.get_by_role("button", name="Step").click()
    until(page, f"(await {ENGINE}.state()).time > {first}")
    assert state(page)["time"] == pytest.approx(first + 0.02)
    page.locator("canvas").focus()
    page.keyboard.press("Space")
    until(page, f"(await {ENGINE}.state()).time > {first + 0.1}")


def test_a_recorded_episode_plays_to_its_end(browser: Browser, site: str) -> None:
    watched = opened(browser)
    page = watched.page
    show(page, site, CUTTING)
    page.get_by_role("button", name="Watch: put the tomato into the bowl").click()
    until(page, f"{ENGINE}.player.playback.value !== null")
    until(page, f"{ENGINE}.player.playback.value.time >= {ENGINE}.player.playback.value.duration")
    rows, qpos = rows_of(page), state(page)["qpos"]
    tomato, bowl = (np.array(qpos[rows[n] : rows[n] + 3]) for n in ("tomato_1", "bowl_1"))
    assert np.linalg.norm((tomato - bowl)[:2]) < 0.06
    page.get_by_role("button", name="Back to the scene").click()
    until(page, f"{ENGINE}.mode.value === 'scene'")
    assert watched.faults == []


def test_the_arm_is_driven_as_the_environment_drives_it(
    browser: Browser, site: str, shipped: list[Path]
) -> None:
    import gymnasium as gym

    bundle = next(path for path in shipped if path.name.startswith(CUTTING))
    env = gym.make("tabletopgen_env:TabletopGen/Lift-v0", scenes=str(bundle), action="ee_delta")
    env.reset(seed=0)
    world = env.get_wrapper_attr("world")
    world.reset()
    controller = env.get_wrapper_attr("controller")
    controller.reset(world)
    actions = [[1, 0, 0, 0, 1]] * 8 + [[0, 0.6, -0.5, 0.5, 1]] * 8 + [[0, 0, -1, 0, -1]] * 8
    for action in actions:
        controller.apply(world, np.array(action, float))
        world.step(25)
    expected = world.data.qpos.copy()
    env.close()
    page = opened(browser).page
    show(page, site, CUTTING)
    page.get_by_role("button", name="Drive the Panda").click()
    until(page, f"{ENGINE}.mode.value === 'arm'")
    found = page.evaluate(f"{ENGINE}.act({actions})")["qpos"]
    assert len(found) == len(expected)
    assert np.abs(np.array(found)[-9:] - expected[-9:]).max() < 1e-3  # radians, metres


def test_the_gallery_is_searched(browser: Browser, site: str, shipped: list[Path]) -> None:
    watched = opened(browser)
    page = watched.page
    page.goto(site)
    cards = page.locator("a.card")
    cards.first.wait_for()
    assert cards.count() == len(shipped)
    page.get_by_role("searchbox").fill("tomato knife")
    until(page, f"document.querySelectorAll('a.card').length < {len(shipped)}")
    assert {"kitchen-cutting"} <= {*page.locator("a.card h2").all_text_contents()}
    page.get_by_role("searchbox").fill("")
    page.get_by_label("Theme").select_option("office")
    found = {*page.locator("a.card h2").all_text_contents()}
    assert found == {"office-desk", "office-round", "tidy-task-2"}
    page.get_by_text("office-desk").click()
    wait_for_scenes(page)
    assert watched.faults == []


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_accessibility(browser: Browser, site: str, scheme: Any) -> None:
    page = opened(browser, color_scheme=scheme, bypass_csp=True).page
    page.goto(site)
    page.locator("a.card").first.wait_for()
    faults, share = axe_results(page)
    assert faults == [] and share >= 0.95
    page.goto(f"{site}#/scene/{CUTTING}")
    wait_for_scenes(page)
    page.get_by_role("button", name="Drive the Panda").click()
    until(page, f"{ENGINE}.mode.value === 'arm'")
    faults, share = axe_results(page)
    assert faults == [] and share >= 0.95


def test_two_scenes_beside_each_other_on_a_phone(browser: Browser, site: str) -> None:
    watched = opened(browser, viewport={"width": 390, "height": 844}, has_touch=True)
    page = watched.page
    page.goto(f"{site}#/beside/{CUTTING}/coffee-oval")
    wait_for_scenes(page, 2)
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    assert page.evaluate("[...window.tabletopgen.values()].map(e => e.error.value)") == [None] * 2
    assert watched.faults == []


def test_a_scene_that_is_not_there_is_said(browser: Browser, site: str) -> None:
    page = opened(browser).page
    page.goto(f"{site}#/scene/no-such-table")
    assert "There is no scene no-such-table" in page.get_by_role("alert").inner_text()
