"""The studio's page where things go otherwise than usual; the server's part is partly played."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from browser import opened, until, wait_for_scenes
from playwright.sync_api import Browser, Page, Route
from studio_pages import TEXT, Studio, drag, enter, jobs, make, place, running

from assets_cache.store import find

pytestmark = [pytest.mark.slow, pytest.mark.timeout(900)]

JOB: dict[str, Any] = {
    "id": "0123456789ab", "kind": "compose", "state": "interrupted", "title": "a thrice-met table",
    "request": {"kind": "compose", "text": TEXT}, "created": 1.0, "started": 2.0, "finished": 3.0,
    "runs": 3, "stage": None, "figures": [], "error": "The studio stopped 3 times.",
    "result": None, "log": "",
}  # fmt: skip


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    folder = tmp_path_factory.mktemp("pages")
    (folder / "store").mkdir()
    with running(folder / "studio", folder / "store") as found:
        yield found


@pytest.fixture
def own(tmp_path: Path) -> Iterator[Studio]:
    """A separate studio for one test."""
    (tmp_path / "store").mkdir()
    with running(tmp_path / "studio", tmp_path / "store") as found:
        yield found


def play(page: Page, path: str, value: Any, status: int = 200) -> None:
    """Answer a request instead of the server."""
    page.context.route(path, lambda route: route.fulfill(status=status, json=value))


def test_a_job_that_stays_interrupted_can_be_resumed_or_removed_and_has_its_log(
    browser: Browser, studio: Studio
) -> None:
    page = opened(browser).page
    play(page, "**/api/jobs", {"jobs": [JOB]})
    play(page, f"**/api/jobs/{JOB['id']}", {**JOB, "log": "what it said\n"})
    page.goto(studio.address)
    page.get_by_role("button", name="Start again").wait_for()
    assert page.get_by_role("button", name="Cancel").count() == 0
    assert page.get_by_role("button", name="Remove the job").count() == 1
    page.get_by_role("link", name=JOB["title"]).click()
    page.get_by_text("Log").click()
    assert page.locator("pre").inner_text() == "what it said\n"
    assert page.title() == f"{JOB['title']} – TabletopGen studio"
    page.get_by_role("link", name="Make", exact=True).click()
    page.get_by_role("heading", name="Make a table").wait_for()
    assert page.title() == "TabletopGen studio"


def make_picture(folder: Path) -> Path:
    """Write a picture that can be uploaded."""
    from PIL import Image

    path = folder / "photo.png"
    Image.linear_gradient("L").convert("RGB").save(path)
    return path


def test_what_is_understood_is_said_while_it_is_typed(
    browser: Browser, studio: Studio, tmp_path: Path
) -> None:
    page = opened(browser, viewport={"width": 390, "height": 844}).page
    page.goto(studio.address)
    page.get_by_label("Describe the table").fill("a round table with two red mugs and happiness")
    page.get_by_text("2 × red mug").wait_for()
    page.get_by_text("Not understood: “happiness”").wait_for()
    page.get_by_label("Describe the table").fill("gemütlicher Tisch mit Kaffee und Kuchen")
    page.get_by_text("not English").wait_for()
    assert page.get_by_text("2 × red mug").count() == 0
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    page.locator("input[type=file]").set_input_files(make_picture(tmp_path))
    page.get_by_role("button", name="Use a text instead").wait_for()
    assert page.get_by_text("not English").count() == 0, "the text is not used"
    page.get_by_role("button", name="Use a text instead").click()
    page.get_by_text("not English").wait_for()


def test_a_scene_that_cannot_be_removed_is_not_said_to_be(browser: Browser, studio: Studio) -> None:
    page = opened(browser).page
    (bundle,) = find("coffee-oval")
    row = {
        "id": bundle.name, "name": "coffee-oval", "kind": "compose", "prompt": "", "asked": [],
        "theme": "", "seed": 0, "saved": False, "edits": 0, "last_edit": "",
        "table": {"label": "table", "size": [1, 1, 1]}, "things": [], "difficulty": None,
        "gate": None, "certificate": None, "warnings": [], "thumbnail": None, "error": None,
        "in": "workspace", "digest": "0", "editable": True, "parent": None,
    }  # fmt: skip
    play(page, "**/api/scenes", {"scenes": [row]})
    play(page, f"**/api/scenes/{bundle.name}", {"error": "Disk error."}, 507)
    page.on("dialog", lambda dialog: dialog.accept())
    page.goto(studio.address)
    page.get_by_role("button", name="Remove coffee-oval").click()
    assert "Disk error." in page.get_by_role("alert").inner_text()


def test_redo_goes_to_the_newest_and_keeps_the_focus(browser: Browser, studio: Studio) -> None:
    page = opened(browser).page
    first, newest, older = (find(n)[0].name for n in ("coffee-oval", "office-desk", "tidy-task-2"))
    steps = [{"id": first, "digest": "0", "kind": "made", "asked": "", "names": [], "exists": True}]
    for scene, later in ((first, [newest, older]), (newest, [older])):
        history = {"scene": scene, "steps": steps, "later": later}
        play(page, f"**/api/scenes/{scene}/history", history)
    page.goto(studio.address)
    page.get_by_role("heading", name="Make a table").wait_for()
    page.goto(f"{studio.root}#/scene/{first}")
    wait_for_scenes(page)
    page.get_by_role("button", name="Redo").focus()
    page.keyboard.press("Enter")
    page.wait_for_url(f"**/{newest}")
    page.get_by_role("heading", name="office-desk").wait_for()
    until(page, "document.activeElement.textContent === 'Redo'", 5)


def test_redo_brings_back_what_was_undone(browser: Browser, studio: Studio) -> None:
    page = enter(browser, studio).page
    first, newest, older = (find(n)[0].name for n in ("coffee-oval", "office-desk", "tidy-task-2"))
    for scene, before, later in (
        (first, [], [newest, older]), (older, [first], []), (newest, [first], []),
    ):  # fmt: skip
        steps = [
            {"id": n, "digest": "0", "kind": "made", "asked": "", "names": [], "exists": True}
            for n in (*before, scene)
        ]
        play(page, f"**/api/scenes/{scene}/history", {"scene": scene, "steps": steps,
                                                      "later": later})  # fmt: skip
    page.goto(f"{studio.root}#/scene/{older}")
    wait_for_scenes(page)
    page.get_by_role("button", name="Undo").click()
    page.wait_for_url(f"**/{first}")
    page.get_by_role("button", name="Redo").click()
    page.wait_for_url(f"**/{older}")


def test_an_edit_is_followed_after_a_reload_and_from_another_tab(
    browser: Browser, own: Studio
) -> None:
    page = enter(browser, own).page
    place(page, own)
    where = page.url
    other = page.context.new_page()
    other.goto(where)
    wait_for_scenes(other)
    page.get_by_placeholder("a red mug left of the laptop").fill("a spoon")
    page.get_by_role("button", name="Add", exact=True).click()
    page.locator(".working").wait_for()
    page.reload()
    for each in (page, other):
        each.get_by_text("done; the table has settled").wait_for(timeout=120_000)
        assert each.url != where
    assert page.url == other.url
    wait_for_scenes(page)
    page.get_by_role("option", name="spoon_1").wait_for(state="attached")
    assert sum(job["kind"] == "edit" for job in jobs(page)) == 1


def test_a_studio_with_a_new_token_is_found_again(browser: Browser, studio: Studio) -> None:
    page = opened(browser).page
    refused: list[Route] = []

    def refuse(route: Route) -> None:
        refused.append(route)
        if len(refused) < 3:
            route.fulfill(status=403, json={"error": "Open the address printed by the studio."})
        else:
            route.continue_()

    page.context.route("**/api/events?*", refuse)
    page.goto(studio.address)
    page.get_by_text("The studio is not responding").wait_for()
    page.get_by_text("The studio is not responding").wait_for(state="hidden", timeout=20_000)


def test_a_page_that_nobody_sees_holds_no_connection(browser: Browser, studio: Studio) -> None:
    page = opened(browser).page
    page.add_init_script(
        "window.sources = []; const Real = EventSource;"
        "window.EventSource = class extends Real {"
        " constructor(url) { super(url); window.sources.push(this); } };"
    )
    page.goto(studio.address)
    until(page, "window.sources.length === 1 && window.sources[0].readyState === 1")
    hide = (
        "value => { Object.defineProperty(document, 'hidden', { value, configurable: true });"
        " document.dispatchEvent(new Event('visibilitychange')); }"
    )
    page.evaluate(hide, True)
    assert page.evaluate("window.sources.map((s) => s.readyState)") == [2]
    page.get_by_label("Describe the table").fill(TEXT)
    page.evaluate(
        "text => fetch('/api/jobs', { method: 'POST',"
        " body: JSON.stringify({ kind: 'compose', text }),"
        "headers: { 'content-type': 'application/json' } })",
        TEXT,
    )
    page.evaluate(hide, False)
    page.get_by_role("link", name=TEXT).wait_for()  # what happened meanwhile is heard


def test_a_picture_that_is_too_large_is_not_sent(browser: Browser, studio: Studio) -> None:
    page = enter(browser, studio).page
    sent: list[str] = []
    page.on("request", lambda request: sent.append(request.url))
    page.evaluate(
        """() => {
          const files = new DataTransfer();
          files.items.add(new File([new Uint8Array(21 * 2 ** 20)], 'large.png'));
          const field = document.querySelector('input[type=file]');
          field.files = files.files;
          field.dispatchEvent(new Event('change', { bubbles: true }));
        }"""
    )
    assert "limit of 20 MiB" in page.get_by_role("alert").inner_text()
    assert not [url for url in sent if "pictures" in url]


def test_a_picture_dropped_beside_its_place_opens_nothing(browser: Browser, studio: Studio) -> None:
    page = enter(browser, studio).page
    kept = page.evaluate(
        """() => ['dragover', 'drop'].map((kind) => {
          const event = new DragEvent(kind, { bubbles: true, cancelable: true });
          document.body.dispatchEvent(event);
          return event.defaultPrevented;
        })"""
    )
    assert kept == [True, True]


def test_costs_come_before_spending_and_go_when_they_no_longer_hold(
    browser: Browser, studio: Studio
) -> None:
    page = opened(browser).page

    def charge(route: Route) -> None:
        answer = route.fetch()
        state = answer.json()
        for backend in state["backends"]:
            if backend["charges"] and "reasoner" in backend["roles"]:
                backend.update(available=True, lacks="")
        route.fulfill(response=answer, body=json.dumps(state))

    begun: list[Any] = []

    def begin(route: Route) -> None:
        if route.request.method != "POST":
            return route.continue_()
        begun.append(route.request.post_data_json)
        return route.fulfill(status=201, json={**JOB, "state": "queued", "error": None})

    page.context.route("**/api/state", charge)
    page.context.route("**/api/jobs", begin)
    estimate = {"roles": [], "calls": ["plan: at most 0.02"], "asks_servers": True}
    play(page, "**/api/estimate", estimate)
    page.goto(studio.address)
    page.get_by_label("Describe the table").fill(TEXT)
    page.get_by_label("Generate: the full method").check()
    page.locator("summary", has_text="Backends").click()
    page.get_by_text("Interpretation of each phrase").wait_for()
    chooser = page.get_by_label("reasoner")
    paid = page.evaluate(
        "async () => (await (await fetch('/api/state')).json()).backends"
        ".find((b) => b.charges && b.available && b.roles.includes('reasoner')).name"
    )
    chooser.select_option(paid)
    page.get_by_text("Interpretation of each phrase").wait_for(state="detached")
    make_it = page.get_by_role("button", name="Make the table")
    make_it.click()
    page.get_by_text("plan: at most 0.02").wait_for()
    assert begun == []
    page.get_by_label("Seed").fill("7")
    assert page.get_by_text("plan: at most 0.02").count() == 0
    make_it.click()
    page.get_by_text("plan: at most 0.02").wait_for()
    assert begun == []
    make_it.click()
    page.wait_for_url("**/#/job/*")
    assert [(job["seed"], job["reasoner"]) for job in begun] == [(7, paid)]


def test_a_turn_sends_no_place_and_who_has_left_is_not_fetched_back(
    browser: Browser, own: Studio
) -> None:
    page = enter(browser, own).page
    make(page)
    page.get_by_role("button", name="Above").click()
    page.wait_for_timeout(500)
    drag(page, "mug_1", 12, 10, shift=True)
    asked = next(job["request"] for job in jobs(page) if job["kind"] == "edit")
    assert "to" not in asked and abs(asked["turn"]) >= 1
    page.get_by_placeholder("a red mug left of the laptop").fill("a spoon")
    page.get_by_role("button", name="Add", exact=True).click()
    page.get_by_role("link", name="Scenes", exact=True).click()
    page.get_by_role("button", name="Open it").wait_for(timeout=120_000)
    assert page.url.endswith("#/scenes")
    page.get_by_role("button", name="Open it").click()
    wait_for_scenes(page)
    assert "/scene/" in page.url
