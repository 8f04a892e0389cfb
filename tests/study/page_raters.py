"""A rater who controls the page in Chromium, and a server that accepts answers."""

from __future__ import annotations

import functools
import http.server
import json
import re
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import tiny_studies as tiny

from tabletopgen_web.study.design import CRITERIA
from tabletopgen_web.study.key import StudyKey

if TYPE_CHECKING:
    from playwright.sync_api import Browser, BrowserContext, Page

LONG = 60_000
"""Milliseconds after which a step is taken to hang."""


@contextmanager
def opened(browser: Browser, url: str, **settings: Any) -> Iterator[tuple[BrowserContext, Page]]:
    """Open a rater's browser without stored state; its console must stay empty."""
    context = browser.new_context(locale="en-US", **settings)
    context.set_default_timeout(LONG)
    page, said = context.new_page(), []
    page.on("console", lambda message: said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    try:
        page.goto(url)
        yield context, page
        assert said == []
    finally:
        context.close()


def focus_is_on(page: Page) -> str:
    """Return the focused question, or the text of the focused button; empty otherwise."""
    return page.evaluate(
        "() => { const here = document.activeElement;"
        "const step = here.closest('[data-question]');"
        "return step ? step.dataset.question : here.matches('button') ? here.textContent : ''; }"
    )


def answer_by_keyboard(page: Page, key: StudyKey, rater: int) -> str:
    """Answer the current scene with digit keys only; return its code."""
    for _ in range(12):
        page.keyboard.press("Tab")
        if "-" in focus_is_on(page):
            break
    methods = {r: m for scene in key.scenes.values() for r, m in scene.results.items()}
    names = {r: scene.name for scene in key.scenes.values() for r in scene.results}
    while (question := focus_is_on(page)) and "-" in question:
        code, _, kind = question.partition("-")
        if kind == "choice":
            wanted = tiny.preferred(rater, key.scenes[code].name)
            values = page.locator(f'[data-question="{question}"] input').evaluate_all(
                "all => all.map(one => one.value)"
            )
            page.keyboard.press(str([methods[v] for v in values].index(wanted) + 1))
            return code
        if kind == "check":
            text = page.locator(f'[data-question="{question}"] legend').inner_text()
            found = re.search(r"choose (\d) here", text)
            assert found
            page.keyboard.press(found[1])
        else:
            marks = tiny.marks(rater, methods[code], names[code])
            page.keyboard.press(str(marks[CRITERIA.index(kind)]))
    raise AssertionError(f"no question has the focus, but {question!r}")


def answer_all(page: Page, key: StudyKey, rater: int) -> list[str]:
    """Answer all scenes from the introduction to the final button; return the scenes."""
    page.keyboard.press("Tab")
    while focus_is_on(page) != "Begin":
        page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    scenes = []
    for number in range(1, key.scenes_each + 1):
        page.get_by_role("heading", name=f"Scene {number} of {key.scenes_each}").wait_for()
        scenes.append(answer_by_keyboard(page, key, rater))
        last = number == key.scenes_each
        assert focus_is_on(page) == ("Finish" if last else "Next")
        if not last:
            page.keyboard.press("Enter")
    return scenes


def save_download(page: Page, act: Callable[[], object], folder: Path) -> Path:
    with page.expect_download(timeout=LONG) as started:
        act()
    path = folder / started.value.suggested_filename
    started.value.save_as(path)
    return path


def answer_by_mouse(page: Page) -> None:
    for question in page.locator("fieldset").all():
        question.locator("label").nth(1).click()


class _Taker(http.server.SimpleHTTPRequestHandler):
    """Serves a folder and accepts answers, unless the folder contains a file ``broken``."""

    def do_POST(self) -> None:
        folder = Path(self.directory)
        body = self.rfile.read(int(self.headers["Content-Length"]))
        broken = (folder / "broken").exists()
        if not broken:
            (folder / "got.json").write_text(json.dumps([self.path, json.loads(body)]))
        self.send_response(503 if broken else 204)
        self.end_headers()

    def log_message(self, *_: object) -> None:
        pass


@contextmanager
def serving(folder: Path) -> Iterator[str]:
    handler = functools.partial(_Taker, directory=str(folder))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        thread = threading.Thread(target=server.serve_forever, daemon=True)
        thread.start()
        try:
            yield f"http://127.0.0.1:{server.server_address[1]}"
        finally:
            server.shutdown()
            thread.join(timeout=30)
