"""The page in Chromium: answered by keyboard, resumed, sent, and looked at by axe-core."""

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

import pytest
import tiny_studies as tiny
from command import Shell

from tabletopgen_web.study.design import CRITERIA
from tabletopgen_web.study.key import StudyKey
from tabletopgen_web.study.page import StudyFiles, write_study

if TYPE_CHECKING:
    from playwright.sync_api import Browser, BrowserContext, Page

pytestmark = pytest.mark.slow

LONG = 20_000
"""Milliseconds after which a step is taken to hang."""


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory, template: str) -> StudyFiles:
    return tiny.small_study(tmp_path_factory.mktemp("pictures"), template=template)


@pytest.fixture(scope="module")
def study(files: StudyFiles, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_study(files, tmp_path_factory.mktemp("study") / "study.html")[0]


@contextmanager
def opened(browser: Browser, url: str, **settings: Any) -> Iterator[tuple[BrowserContext, Page]]:
    """A rater's own browser, without what others left; it may say nothing on the console."""
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
    """The question in focus, or the text of the button; empty if neither has the focus."""
    return page.evaluate(
        "() => { const here = document.activeElement;"
        "const step = here.closest('[data-question]');"
        "return step ? step.dataset.question : here.matches('button') ? here.textContent : ''; }"
    )


def answer_by_keyboard(page: Page, key: StudyKey, rater: int) -> str:
    """Answer the scene shown with digits alone; return its code. The last button has the focus."""
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
    """Answer from the introduction on, to where Enter hands the answers in; return the scenes."""
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


def test_three_raters_give_the_table_worked_out_by_hand(
    browser: Browser, study: Path, files: StudyFiles, tmp_path: Path, shell: Shell
) -> None:
    """By keyboard alone, from the page to the report; orders differ and are balanced."""
    answers, orders = [], []
    for rater in range(3):
        with opened(browser, study.as_uri()) as (_, page):
            scenes = answer_all(page, files.key, rater)
            path = save_download(page, lambda page=page: page.keyboard.press("Enter"), tmp_path)
            page.get_by_role("heading", name="Thank you").wait_for()
            facts = json.loads(path.read_text())
            assert path.name == f"answers-{files.key.study}-{facts['rater']}.json"
            assert [one["scene"] for one in facts["scenes"]] == scenes
            answers.append(facts)
            orders.append(tuple(tuple(one["order"]) for one in facts["scenes"]))
            again = page.get_by_role("button", name="Download the answers")
            assert save_download(page, again.click, tmp_path).read_bytes() == path.read_bytes()
    shown = shell("study", "report", str(tmp_path), "--key", f"{study.parent}/study.key.json",
                  "--json")  # fmt: skip
    tiny.check_table(shown.facts)
    assert (shown.facts["raters"], shown.err) == (3, "")
    assert len({tuple(one["scene"] for one in facts["scenes"]) for facts in answers}) > 1
    assert len(set(orders)) > 1
    for facts in answers:
        first = [files.key.scenes[one["scene"]].results[one["order"][0]] for one in facts["scenes"]]
        assert first.count("ours") == 3  # of six scenes


def test_a_reload_resumes_and_starting_over_forgets(
    browser: Browser, study: Path, files: StudyFiles
) -> None:
    kept = f"study-{files.key.study}"
    with opened(browser, study.as_uri()) as (context, page):
        page.get_by_role("button", name="Begin").click()
        answer_by_keyboard(page, files.key, 0)
        page.keyboard.press("Enter")
        page.get_by_role("heading", name="Scene 2 of 6").wait_for()
        page.locator("fieldset input").nth(4).check(force=True)
        before = json.loads(page.evaluate("key => localStorage[key]", kept))
        page.reload()
        page.get_by_role("heading", name="Scene 2 of 6").wait_for()
        assert page.locator("fieldset input").nth(4).is_checked()
        page.get_by_role("button", name="Back").click()
        assert page.locator('[data-step="open"]').count() == 0
        after = json.loads(page.evaluate("key => localStorage[key]", kept))
        assert (after["rater"], after["marks"]) == (before["rater"], before["marks"])
        page.get_by_role("button", name="Start over").click()
        page.get_by_role("button", name="Cancel").click()
        page.get_by_role("heading", name="Scene 1 of 6").wait_for()
        page.get_by_role("button", name="Start over").click()
        page.get_by_role("button", name="Delete and start over").click()
        page.get_by_role("button", name="Begin").click()
        assert page.locator('[data-step="done"]').count() == 0
        new = json.loads(page.evaluate("key => localStorage[key]", kept))
        assert new["rater"] != before["rater"]
        for broken in ("{", '{"place": 99}', json.dumps({**new, "marks": {"x": {"overall": 9}}})):
            page.evaluate("([key, text]) => { localStorage[key] = text; }", [kept, broken])
            other = context.new_page()
            other.goto(study.as_uri())
            other.get_by_role("button", name="Begin").wait_for()
            other.close()


def test_what_is_missing_is_named_and_focused(
    browser: Browser, study: Path, files: StudyFiles
) -> None:
    with opened(browser, study.as_uri()) as (_, page):
        page.get_by_role("button", name="Begin").click()
        page.get_by_role("button", name="Next").click()
        assert focus_is_on(page) == page.locator("fieldset").first.get_attribute("data-question")
        page.locator("fieldset").first.get_by_text("not answered yet").wait_for()
        count = page.locator("fieldset").count()
        page.get_by_text(f"{count} questions are not answered yet.").wait_for()
        page.keyboard.press("9")  # no level
        page.keyboard.press("Control+3")
        assert page.locator('[data-step="done"]').count() == 0
        page.keyboard.press("2")
        page.keyboard.press("ArrowRight")  # of the next question, as radio buttons do
        levels = page.locator("fieldset input:checked").evaluate_all("a => a.map(b => b.value)")
        assert levels == ["2", "2"]


def test_pictures_are_enlarged_and_leafed_through(browser: Browser, study: Path) -> None:
    with opened(browser, study.as_uri()) as (_, page):
        page.get_by_role("button", name="Begin").click()
        page.get_by_role("button", name="Enlarge: Result 1").focus()
        page.keyboard.press("Enter")
        dialog = page.get_by_role("dialog", name="Result 1")
        dialog.wait_for()
        narrow = dialog.locator("img").bounding_box()
        page.keyboard.press("+")
        wide = dialog.locator("img").bounding_box()
        assert narrow and wide and wide["width"] == pytest.approx(1.5 * narrow["width"], rel=0.01)
        page.keyboard.press("ArrowLeft")
        page.get_by_role("dialog", name="Input picture").wait_for()
        page.keyboard.press("Escape")
        page.get_by_role("dialog").wait_for(state="detached")
        assert page.evaluate("document.activeElement.ariaLabel") == "Enlarge: Result 1"


def test_it_speaks_chinese(browser: Browser, study: Path, files: StudyFiles) -> None:
    with opened(browser, study.as_uri()) as (_, page):
        page.get_by_role("button", name="中文").click()
        page.get_by_role("button", name="开始").click()
        page.get_by_role("heading", name="场景 1 / 6").wait_for()
        assert page.evaluate("document.documentElement.lang") == "zh"
        page.reload()
        page.get_by_role("button", name="下一页").wait_for()


# ---------------------------------------------------------------------------------------- sending
class _Taker(http.server.SimpleHTTPRequestHandler):
    """A server of a folder that takes answers, unless its folder holds a file ``broken``."""

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


def test_answers_are_posted_and_a_failure_keeps_them(
    browser: Browser, template: str, tmp_path: Path
) -> None:
    files = tiny.small_study(
        tmp_path / "pictures", names=tiny.SCENES[:2], template=template,
        post="/api/studies/{study}/answers",
    )  # fmt: skip
    served = tmp_path / "served"
    page_file, _ = write_study(files, served / "study.html")
    (served / "broken").touch()
    with serving(served) as address:
        context = browser.new_context(locale="en-US")
        context.set_default_timeout(LONG)
        page = context.new_page()
        page.goto(f"{address}/study.html")
        answer_all(page, files.key, 0)
        page.keyboard.press("Enter")
        page.get_by_role("alert").filter(has_text="could not be sent").wait_for()
        button = page.get_by_role("button", name="Download the answers")
        kept = json.loads(save_download(page, button.click, tmp_path).read_text())
        (served / "broken").unlink()
        page.get_by_role("button", name="Try again").click()
        page.get_by_text("Your answers were sent").wait_for()
        path, sent = json.loads((served / "got.json").read_text())
        assert (path, sent) == (f"/api/studies/{files.key.study}/answers", kept)
        (served / "got.json").unlink()
        page.reload()
        page.get_by_text("Your answers were sent").wait_for()
        assert not (served / "got.json").exists()
        context.close()
    with opened(browser, page_file.as_uri()) as (_, page):  # a file has no server
        answer_all(page, files.key, 0)
        save_download(page, lambda: page.keyboard.press("Enter"), tmp_path)
        page.get_by_text("saved as the file").wait_for()


# ---------------------------------------------------------------------------------- accessibility
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", [(1280, 800), (390, 844)], ids=["desk", "phone"])
def test_axe_finds_no_fault(
    browser: Browser, study: Path, files: StudyFiles, axe: str, scheme: str, size: tuple[int, int]
) -> None:
    settings = {"color_scheme": scheme, "viewport": {"width": size[0], "height": size[1]}}
    with opened(browser, study.as_uri(), **settings) as (_, page):

        def check(where: str) -> None:
            page.evaluate(axe)
            faults = page.evaluate("axe.run()")["violations"]
            grave = [(f["id"], f["nodes"][0]["html"][:200]) for f in faults
                     if f["impact"] in ("serious", "critical")]  # fmt: skip
            assert (where, grave) == (where, [])
            wide = page.evaluate("document.documentElement.scrollWidth - innerWidth")
            assert (where, wide) == (where, 0)

        check("introduction")
        page.get_by_role("button", name="Begin").click()
        check("scene")
        page.get_by_role("button", name="Next").click()
        check("unanswered")
        page.get_by_role("button", name="Enlarge: Result 1").click()
        check("enlarged")
        page.keyboard.press("Escape")
        page.get_by_role("button", name="Start over").click()
        check("starting over")
        page.keyboard.press("Escape")
        for number in range(files.key.scenes_each):
            answer_by_mouse(page)
            last = number + 1 == files.key.scenes_each
            page.get_by_role("button", name="Finish" if last else "Next").click()
        check("end")


def answer_by_mouse(page: Page) -> None:
    for question in page.locator("fieldset").all():
        question.locator("label").nth(1).click()


def test_axe_can_find_faults(browser: Browser, axe: str) -> None:
    with opened(browser, "about:blank") as (_, page):
        page.set_content(
            '<img src="data:,"><input><p style="color:#aaa;background:#fff">some text</p>'
        )
        page.evaluate(axe)
        found = {fault["id"] for fault in page.evaluate("axe.run()")["violations"]}
        assert {"image-alt", "label", "color-contrast"} <= found
