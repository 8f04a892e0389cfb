"""Ways through the gallery: names of pages, the focus, neighbours, and the way back."""

import json
from collections.abc import Iterator

import pytest
from browser import opened, wait_for_scenes
from browsing.chromium import serve
from playwright.sync_api import Browser, Page

from assets_cache.store import find
from tabletopgen_web.page.options import FolderOptions
from tabletopgen_web.page.site import GALLERY, write_site

pytestmark = [pytest.mark.slow, pytest.mark.timeout(900)]

QUICK = FolderOptions(formats=(), episodes=0, robot=False)
NAMES = ("coffee-oval", "kitchen-cutting", "office-desk")


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A site of three scenes; one that cannot be shown is listed before the last."""
    bundles = [path for name in NAMES for path in find(name)]
    folder = write_site(bundles, tmp_path_factory.mktemp("few") / "site", options=QUICK).path
    gallery = json.loads((folder / GALLERY).read_text())
    bad = {**gallery["scenes"][0], "id": "bad", "name": "bad", "error": "It is damaged."}
    gallery["scenes"].insert(1, bad)
    (folder / GALLERY).write_text(json.dumps(gallery))
    with serve(folder) as found:
        yield found


def enter(browser: Browser, address: str) -> Page:
    page = opened(browser, viewport={"width": 700, "height": 500}).page
    page.goto(address)
    page.locator("a.card").first.wait_for()
    return page


def wait_for_focus(page: Page, on: str) -> None:
    """Wait until the element with an id or a text has the focus."""
    script = (
        "on => document.activeElement.id === on || document.activeElement.innerText.includes(on)"
    )
    page.wait_for_function(
        f"on => document.activeElement !== document.body && ({script})(on)", arg=on
    )


def test_neighbours_pass_over_what_cannot_be_shown(browser: Browser, address: str) -> None:
    page = enter(browser, address)
    page.locator("a.card", has_text=NAMES[0]).click()
    for name in NAMES[1:]:
        page.get_by_role("link", name="Next").click()
        page.get_by_role("heading", name=name).wait_for()
    assert page.get_by_role("link", name="Next").count() == 0
    page.get_by_role("link", name="Previous").click()
    page.get_by_role("heading", name=NAMES[1]).wait_for()


def test_the_way_back_leads_to_what_was_found(browser: Browser, address: str) -> None:
    page = enter(browser, address)
    assert page.title() == "Tables"
    page.get_by_role("searchbox").fill("e")
    card = page.locator("a.card", has_text=NAMES[2])
    card.focus()
    page.keyboard.press("Enter")
    wait_for_scenes(page)
    assert page.title() == f"{NAMES[2]} – Tables"
    wait_for_focus(page, "main")
    page.go_back()
    card.wait_for()
    assert page.title() == "Tables"
    assert page.get_by_role("searchbox").input_value() == "e"
    wait_for_focus(page, NAMES[2])
    assert card.evaluate("c => c.getBoundingClientRect().top < innerHeight")


def test_tables_are_put_beside_each_other_by_a_button(browser: Browser, address: str) -> None:
    """Selection alone does not navigate: keyboard users pass other options on the way."""
    page = enter(browser, address)
    page.locator("a.card", has_text=NAMES[0]).click()
    chooser = page.get_by_label("Beside")
    chooser.select_option(label=NAMES[1])
    assert "beside" not in page.url
    page.get_by_role("button", name="Show", exact=True).click()
    page.wait_for_url("**/#/beside/**")
    title = f"{NAMES[0]} and {NAMES[1]} – Tables"
    page.wait_for_function("title => document.title === title", arg=title)
    page.goto(f"{address}#/scene/nowhere")
    page.get_by_role("alert").wait_for()
    assert page.title() == "Tables"


def test_plurals_and_certified_tables_are_found(browser: Browser, address: str) -> None:
    page = enter(browser, address)
    search = page.get_by_role("searchbox", name="Search")
    for words, found in (
        ("knives", NAMES[1:2]), ("tomatoes", NAMES[1:2]), ("notebooks laptops", NAMES[2:]),
        ("boats", ()), ("tees", ()),
    ):  # fmt: skip
        search.fill(words)
        page.wait_for_function(
            "names => [...document.querySelectorAll('a.card h2')].map(h => h.textContent).join()"
            " === names.join()", arg=[*found],
        )  # fmt: skip
    search.fill("")
    page.get_by_label("All tasks certified").check()
    page.get_by_text("0 of 4 tables").wait_for()
