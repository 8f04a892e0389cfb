"""What goes wrong in the browser is said in one clear message on the page."""

import json
import shutil
from collections.abc import Iterator
from pathlib import Path
from statistics import median

import pytest
from browser import opened, wait_for_scenes
from browsing.chromium import ENGINE, serve
from pages import SEARCH
from playwright.sync_api import Browser

from assets_cache.store import find
from generator import save
from generator.imports import import_scene
from tabletopgen_web.page.options import FolderOptions
from tabletopgen_web.page.site import GALLERY, write_site

pytestmark = [pytest.mark.slow, pytest.mark.timeout(900)]

SCENE = "coffee-oval"
QUICK = FolderOptions(formats=(), episodes=0, robot=False)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A site of one scene, for tests that damage it."""
    return write_site(find(SCENE), tmp_path / "site", options=QUICK).path


@pytest.fixture
def address(folder: Path) -> Iterator[str]:
    with serve(folder) as found:
        yield found


def said(browser: Browser, address: str, scene: str = SCENE, script: str = "") -> str:
    """Return the page's error message."""
    page = opened(browser).page
    if script:
        page.add_init_script(script)
    page.goto(f"{address}#/scene/{scene}")
    return page.get_by_role("alert").inner_text(timeout=30_000)


def test_no_webgl(browser: Browser, address: str) -> None:
    script = "HTMLCanvasElement.prototype.getContext = () => null"
    assert "WebGL" in said(browser, address, script=script)


def test_no_webassembly(browser: Browser, address: str) -> None:
    assert "WebAssembly" in said(browser, address, script="delete globalThis.WebAssembly")


def test_a_page_of_a_newer_version(browser: Browser, folder: Path, address: str) -> None:
    (view,) = folder.glob("scenes/*/view.json")
    view.write_text(json.dumps({**json.loads(view.read_text()), "schema": 2}))
    assert "newer version of tabletopgen" in said(browser, address)


@pytest.mark.parametrize("content", ["", "{", "[]", '"text"', "{}"])
def test_a_damaged_list(browser: Browser, folder: Path, address: str, content: str) -> None:
    (folder / GALLERY).write_text(content)
    assert "damaged" in said(browser, address)


def test_a_missing_mesh(browser: Browser, folder: Path, address: str) -> None:
    next(folder.glob("scenes/*/bundle/meshes/*")).unlink()
    assert "missing (404)" in said(browser, address)


def test_a_damaged_document(browser: Browser, folder: Path, address: str) -> None:
    (document,) = folder.glob("scenes/*/bundle/scene.xml")
    document.write_text("<mujoco><nonsense/></mujoco>")
    assert "cannot be shown" in said(browser, address)


def test_a_bundle_that_could_not_be_read(browser: Browser, tmp_path: Path) -> None:
    bundle = tmp_path / "bad-0123456789ab"
    bundle.mkdir()
    (bundle / "scene.json").write_text("{}")
    site = write_site([bundle], tmp_path / "site", options=QUICK)
    with serve(site.path) as address:
        assert "schema" in said(browser, address, "bad-0123456789ab")


def test_sixty_objects(browser: Browser, tmp_path: Path) -> None:
    boxes = "".join(
        f'<body name="die_{k}" pos="{0.1 * (k % 10) - 0.45} {0.1 * (k // 10) - 0.25} 0.52">'
        '<freejoint/><geom type="box" size=".02 .02 .02" mass=".05" rgba=".8 .2 .2 1"/></body>'
        for k in range(60)
    )
    top = '<body name="table" pos="0 0 0.25"><geom type="box" size=".6 .4 .25"/></body>'
    (tmp_path / "many.xml").write_text(
        f"<mujoco><worldbody>{top}{boxes}</worldbody></mujoco>", encoding="utf-8"
    )
    bundle = save(import_scene(tmp_path / "many.xml"), tmp_path)
    site = write_site([bundle], tmp_path / "site", options=QUICK)
    with serve(site.path) as address:
        watched = opened(browser)
        watched.page.goto(f"{address}#/scene/{bundle.name}")
        wait_for_scenes(watched.page)
        assert watched.page.evaluate(f"{ENGINE}.error.value") is None
        assert len(watched.page.evaluate(f"{ENGINE}.bodies()")) >= 62
        assert watched.faults == []


def test_two_hundred_scenes_stay_fluid(browser: Browser, folder: Path, address: str) -> None:
    """A search among 200 takes at most a few times as long as one among 20."""
    few, many = (median(search(browser, folder, address, count)) for count in (20, 200))
    assert many <= 20 * few


def search(browser: Browser, folder: Path, address: str, count: int) -> list[float]:
    """Return the durations of searches in a gallery with so many entries, including drawing."""
    gallery = json.loads((folder / GALLERY).read_text())
    row = gallery["scenes"][0]
    rows = [{**row, "id": f"{row['id']}-{k}", "name": f"table {k}"} for k in range(count)]
    (folder / GALLERY).write_text(json.dumps({**gallery, "scenes": rows}))
    watched = opened(browser)
    page = watched.page
    page.goto(address)
    page.locator("a.card").first.wait_for()
    assert page.locator("a.card").count() == count
    times = page.evaluate(SEARCH)
    assert watched.faults == []
    return times


def test_a_moved_page_still_opens(browser: Browser, folder: Path, tmp_path: Path) -> None:
    """All of its addresses are relative, so it can be at any URL."""
    deeper = tmp_path / "root" / "some" / "place"
    deeper.parent.mkdir(parents=True)
    shutil.move(folder, deeper)
    with serve(tmp_path / "root") as address:
        page = opened(browser).page
        page.goto(f"{address}some/place/#/scene/{SCENE}")
        wait_for_scenes(page)
        assert page.evaluate(f"{ENGINE}.error.value") is None
