"""A running studio, and user actions on its page."""

import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from browser import Watched, opened, place_on_page, wait_for_scene, wait_for_scenes
from browsing.chromium import ENGINE
from playwright.sync_api import Browser, Page

from generator.bundle import save
from generator.composition import compose
from generator.scene import Scene

TEXT = "a wooden desk with a mug and a plate"


@dataclass
class Studio:
    """A running studio: its address with the token, its folder, the user's store, its process."""

    address: str
    folder: Path
    store: Path
    process: subprocess.Popen[str]

    @property
    def root(self) -> str:
        return self.address.partition("?")[0]


@contextmanager
def running(folder: Path, store: Path) -> Iterator[Studio]:
    command = [sys.executable, "-m", "generator", "studio", "--no-browser", "--folder", str(folder)]
    environment = {**os.environ, "TABLETOPGEN_CACHE": str(store), "OMP_NUM_THREADS": "1"}
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=environment
    )
    try:
        assert process.stdout is not None
        for line in process.stdout:
            if found := re.search(r"http://\S+token=\S+", line):
                break
        else:
            raise AssertionError("the studio printed no address")
        yield Studio(found[0], folder, store, process)
    finally:
        process.send_signal(signal.SIGINT)
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            process.kill()


def enter(browser: Browser, studio: Studio, **options: Any) -> Watched:
    watched = opened(browser, **options)
    watched.page.goto(studio.address)
    watched.page.get_by_role("heading", name="Make a table").wait_for()
    return watched


def make(page: Page, text: str = TEXT) -> None:
    """Create a table from a text and open it."""
    page.get_by_label("Describe the table").fill(text)
    page.get_by_role("button", name="Make the table").click()
    page.get_by_role("link", name="Open the table").click(timeout=120_000)
    wait_for_scenes(page)
    assert page.evaluate(f"{ENGINE}.error.value") is None


@cache
def composed(text: str) -> Scene:
    """Return the table of a text."""
    return compose(text)


def place(page: Page, studio: Studio, text: str = TEXT) -> str:
    """Put a table into the studio's workspace, as its job would, and open it; return its id."""
    scene = save(composed(text), studio.folder / "scenes").name
    page.goto(f"{studio.root}#/scene/{scene}")
    page.reload()  # no job of the studio made the table, so the open page does not know it
    wait_for_scenes(page)
    assert page.evaluate(f"{ENGINE}.error.value") is None
    return scene


def drag(page: Page, name: str, right: float, down: float, *, shift: bool = False) -> None:
    """Drag an object by its centre, pixels, and wait for the resulting scene."""
    (x, y), before = place_on_page(page, name), page.url
    page.mouse.move(x, y)
    if shift:
        page.keyboard.down("Shift")
    page.mouse.down()
    page.mouse.move(x + right, y + down, steps=6)
    page.mouse.up()
    if shift:
        page.keyboard.up("Shift")
    remedy = page.get_by_role("button", name="Place it there")  # the place is occupied
    for _ in range(600):
        if page.url != before:
            break
        if remedy.is_visible():
            remedy.click()
        page.wait_for_timeout(100)
    assert page.url != before, page.get_by_role("alert").all_text_contents()
    scene = page.url.rpartition("/")[2]
    wait_for_scene(page, scene)


def jobs(page: Page) -> list[dict[str, Any]]:
    return page.evaluate("async () => (await (await fetch('/api/jobs')).json()).jobs")
