"""Debian's Chromium for page tests, and common queries of pages."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from browsing.chromium import CHROMIUM, ENGINE, launch
from playwright.sync_api import Browser, Page, sync_playwright

_MODEST = "Object.defineProperty(navigator, 'deviceMemory', { get: () => 2 })"
"""A machine with little memory, for which the viewer draws less: here all is drawn by software."""

AXE = Path(__file__).parents[1] / "web" / "node_modules" / "axe-core" / "axe.min.js"

READY = (
    "n => [...(window.tabletopgen?.values() ?? [])]"
    ".filter(e => e.ready.value || e.error.value).length >= n"
)


@contextmanager
def chromium() -> Iterator[Browser]:
    """Yield a browser; without one, skip the test with a visible message."""
    if CHROMIUM is None:
        words = "Chromium is not installed (apt-get install chromium): the pages are NOT TESTED."
        warnings.warn(words, stacklevel=2)
        pytest.skip(words)
    with sync_playwright() as play:
        browser = launch(play)
        yield browser
        browser.close()


class Watched:
    """A page of the browser that records errors."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.faults: list[str] = []
        page.on("console", self._heed)
        page.on("pageerror", lambda error: self.faults.append(str(error)))

    def _heed(self, message: Any) -> None:
        if message.type in ("error", "warning") and "GPU stall" not in message.text:
            self.faults.append(message.text)


def opened(browser: Browser, **options: Any) -> Watched:
    """Open a new page without stored state."""
    context = browser.new_context(**{"viewport": {"width": 1000, "height": 700}, **options})
    context.set_default_timeout(90_000)
    context.add_init_script(_MODEST)
    return Watched(context.new_page())


def wait_for_scenes(page: Page, count: int = 1) -> None:
    """Wait until the given number of scenes on the page are live or have failed."""
    page.wait_for_function(READY, arg=count, timeout=60_000)


def until(page: Page, condition: str, seconds: float = 120) -> None:
    """Wait until a JavaScript condition, which may await, holds."""
    for _ in range(int(20 * seconds)):
        if page.evaluate(f"async () => Boolean({condition})"):
            return
        page.wait_for_timeout(50)
    raise AssertionError(f"never: {condition}")


def wait_for_scene(page: Page, scene: str) -> None:
    """Wait until the scene with ``scene`` in its folder's name is live or has failed."""
    page.wait_for_function(
        "name => [...window.tabletopgen?.keys() ?? []].some(k => k.includes(name))", arg=scene
    )
    wait_for_scenes(page)


def place_on_page(page: Page, name: str) -> tuple[float, float]:
    """Return the position of a body's origin on the page, pixels."""
    at = page.evaluate(f"{ENGINE}.locate({name!r})")
    box = page.locator("canvas").bounding_box()
    assert box is not None
    return box["x"] + at["x"], box["y"] + at["y"]


def axe_results(page: Page) -> tuple[list[str], float]:
    """Return axe's serious and critical violations, and the weighted share of rules that hold."""
    page.add_script_tag(content=AXE.read_text(encoding="utf-8"))
    done = page.evaluate("() => axe.run()")
    faults = [
        f"{f['id']}: {f['help']} at {[n['target'] for n in f['nodes']][:3]}"
        for f in done["violations"]
        if f["impact"] in ("serious", "critical")
    ]
    weight = {"minor": 1, "moderate": 3, "serious": 7, "critical": 10}
    passed = sum(weight.get(rule["impact"] or "", 3) for rule in done["passes"])
    failed = sum(weight[rule["impact"]] for rule in done["violations"])
    return faults, passed / (passed + failed)
