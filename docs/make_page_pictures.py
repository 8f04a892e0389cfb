"""Make the pictures of the web pages: ``python docs/make_page_pictures.py [NAME ...]``.

Chromium opens a page of the shipped tables (``--scenes``) and a studio of an empty folder, and
takes screenshots.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

from PIL import Image

import assets_cache
from tabletopgen_web.page.site import write_site

sys.path.append(str(Path(__file__).parents[1] / "benchmarks"))  # which has the browser

from browsing.chromium import CHROMIUM, launch, serve

if TYPE_CHECKING:
    from playwright.sync_api import Page

FOLDER = Path(__file__).parent / "images"

SIZE = (1280, 860)
"""Width and height of the browser's window, pixels."""

SCENE = "dining-family"

MOST_BYTES = 350_000
"""No picture is larger."""

_READY = "() => [...(window.tabletopgen?.values() ?? [])].some(e => e.ready.value)"
_TEXT = "a wooden desk with a laptop, two red mugs right of the laptop and a zorble"


def shoot_gallery(page: Page, site: str, _studio: str) -> None:
    """Show the gallery."""
    page.goto(site)
    page.locator("a.card img").first.wait_for()
    page.wait_for_timeout(1500)


def shoot_scene(page: Page, site: str, _studio: str) -> None:
    """Show a scene while the expert puts something into a bowl."""
    page.goto(f"{site}#/scene/{SCENE}")
    page.wait_for_function(_READY, timeout=60_000)
    page.get_by_role("button", name=re.compile("Watch: put")).first.click()
    page.wait_for_timeout(6000)
    page.get_by_role("button", name="Pause").click()
    page.evaluate("scrollTo(0, 0)")
    page.wait_for_timeout(1500)


def shoot_make(page: Page, _site: str, studio: str) -> None:
    """Show the studio's form with a text half understood."""
    page.goto(studio)
    page.get_by_label("Describe the table").fill(_TEXT)
    page.get_by_text("Interpretation of each phrase").wait_for()
    page.wait_for_timeout(1500)


def shoot_edit(page: Page, _site: str, studio: str) -> None:
    """Show the studio's scene with one thing chosen."""
    shoot_make(page, _site, studio)
    page.get_by_role("button", name="Make the table").click()
    page.get_by_role("link", name="Open the table").click(timeout=120_000)
    page.wait_for_function(_READY, timeout=60_000)
    page.get_by_label(re.compile("^Thing")).select_option("mug_1")
    page.wait_for_timeout(2000)


PICTURES: Mapping[str, Callable[[Page, str, str], None]] = MappingProxyType(
    {
        "page_gallery": shoot_gallery,
        "page_scene": shoot_scene,
        "studio_make": shoot_make,
        "studio_edit": shoot_edit,
    }
)
"""What is shown in each picture."""


@contextmanager
def start_studio(folder: Path) -> Iterator[str]:
    """Start a studio of an empty folder; yield its address with the token."""
    command = [sys.executable, "-m", "generator", "studio", "--no-browser", "--folder", str(folder)]
    environment = {**os.environ, "TABLETOPGEN_CACHE": str(folder / "store")}
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)
    assert process.stdout is not None
    try:
        yield next(found[0] for line in process.stdout if (found := re.search(r"http\S+", line)))
    finally:
        process.terminate()
        process.wait(30)


def main() -> None:
    """Make the pictures that are named, or all."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(PICTURES)}")
    parser.add_argument("--scenes", default=assets_cache.STARTER, help="tables on the page")
    parser.add_argument("--out", type=Path, default=FOLDER, help="folder of the pictures")
    options = parser.parse_args()
    unknown = {*options.names} - {*PICTURES}
    if unknown or CHROMIUM is None:
        parser.error(f"no picture is called {unknown}" if unknown else "Chromium is not installed")
    from playwright.sync_api import sync_playwright

    options.out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch, sync_playwright() as play:
        folder = Path(scratch)
        write_site(assets_cache.find(options.scenes), folder / "site")
        with serve(folder / "site") as site, start_studio(folder / "studio") as studio:
            browser = launch(play)
            for name in options.names or PICTURES:
                width, height = SIZE
                page = browser.new_page(viewport={"width": width, "height": height})
                PICTURES[name](page, site, studio)
                raw = folder / f"{name}.png"
                page.screenshot(path=raw)
                page.close()
                print(save(raw, options.out / raw.name))
            browser.close()


def save(raw: Path, target: Path) -> Path:
    """Save a screenshot in few colours, at most ``MOST_BYTES``."""
    with Image.open(raw) as picture:
        picture.convert("RGB").quantize(256, dither=Image.Dither.NONE).save(target, optimize=True)
    assert target.stat().st_size <= MOST_BYTES, target
    return target


if __name__ == "__main__":
    main()
