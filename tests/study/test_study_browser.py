"""The page in Chromium: answered by keyboard, resumed, sent, and looked at by axe-core."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
import tiny_studies as tiny
from command import Shell
from extent import part_of
from page_raters import (
    LONG,
    answer_all,
    answer_by_keyboard,
    answer_by_mouse,
    focus_is_on,
    opened,
    save_download,
    serving,
)

from tabletopgen_web.study.page import StudyFiles, write_study

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Route

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory, template: str) -> StudyFiles:
    return tiny.small_study(tmp_path_factory.mktemp("pictures"), template=template)


@pytest.fixture(scope="module")
def study(files: StudyFiles, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_study(files, tmp_path_factory.mktemp("study") / "study.html")[0]


def test_the_command_makes_a_page_that_names_no_method(
    template: str, tmp_path: Path, shell: Shell
) -> None:
    folders = tiny.write_pictures(tmp_path, ("TabletopGen", "MIDI"))
    out = tmp_path / "made" / "study.html"
    new = shell.of("study", "new", *(f"{name}={folder}" for name, folder in folders.items()),
                   "--inputs", str(tmp_path / "inputs"), "--out", str(out))  # fmt: skip
    facts = new("--json").facts
    assert (facts["methods"], facts["scenes_each"]) == (["TabletopGen", "MIDI"], 6)
    assert (facts["min_seconds"], facts["bytes"]) == (150.0, out.stat().st_size)
    text = re.sub(r"base64,[A-Za-z0-9+/=]+", "", out.read_text()).casefold()
    assert [word for word in ("tabletopgen", "midi", "scene-", str(tmp_path)) if word in text] == []
    assert "permission is hereby granted" in text  # the licences of its code
    before = out.read_bytes()
    new()
    assert out.read_bytes() == before
    assert sorted(p.name for p in out.parent.iterdir()) == ["study.html", "study.key.json"]


def test_three_raters_give_the_table_worked_out_by_hand(
    browser: Browser, study: Path, files: StudyFiles, tmp_path: Path, shell: Shell
) -> None:
    """By keyboard only, from the page to the report; orders differ and are balanced."""
    answers, orders = [], []
    for rater in range(3):
        with opened(browser, study.as_uri()) as (_, page):
            scenes = answer_all(page, files.key, rater)
            path = save_download(page, lambda page=page: page.keyboard.press("Enter"), tmp_path)
            page.get_by_role("heading", name="Thank you").wait_for()
            facts = json.loads(path.read_text())
            assert path.name == f"answers-{files.key.study}-{facts['rater']}.json"
            assert [one["scene"] for one in facts["scenes"]] == scenes
            times = [one["seconds"] for one in facts["scenes"]]
            assert 0 < facts["seconds"] == pytest.approx(sum(times), abs=0.4)
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


def test_who_begins_while_answers_are_sent_has_not_sent_any(
    browser: Browser, template: str, tmp_path: Path
) -> None:
    files = tiny.small_study(
        tmp_path / "pictures", names=tiny.SCENES[:2], template=template, post=tiny.POST
    )
    write_study(files, tmp_path / "served" / "study.html")
    with serving(tmp_path / "served") as address, opened(browser, f"{address}/study.html") as (
        _, page,
    ):  # fmt: skip
        held: list[Route] = []
        page.route("**/answers", lambda route: held.append(route))
        answer_all(page, files.key, 0)
        with page.expect_request("**/answers"):
            page.keyboard.press("Enter")
        page.get_by_role("button", name="Start over").click()
        page.get_by_role("button", name="Delete and start over").click()
        with page.expect_response("**/answers"):
            held[0].continue_()
        page.wait_for_timeout(200)  # in which a page that is wrong would take them for these
        kept = page.evaluate("key => localStorage[key]", f"study-{files.key.study}")
        assert json.loads(kept)["sent"] is False
        answer_all(page, files.key, 1)
        page.unroute("**/answers")
        page.keyboard.press("Enter")
        page.get_by_text("Your answers were sent").wait_for()


# ---------------------------------------------------------------------------------- accessibility
LOOKS = {
    f"{size}-{scheme}": {"color_scheme": scheme, "viewport": {"width": width, "height": height}}
    for size, width, height in (("desk", 1280, 800), ("phone", 390, 844))
    for scheme in ("light", "dark")
}


@pytest.mark.parametrize("look", part_of(LOOKS, "desk-light", "phone-dark"))  # each value once
def test_axe_finds_no_fault(
    browser: Browser, study: Path, files: StudyFiles, axe: str, look: str
) -> None:
    settings = LOOKS[look]
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


def test_axe_can_find_faults(browser: Browser, axe: str) -> None:
    with opened(browser, "about:blank") as (_, page):
        page.set_content(
            '<img src="data:,"><input><p style="color:#aaa;background:#fff">some text</p>'
        )
        page.evaluate(axe)
        found = {fault["id"] for fault in page.evaluate("axe.run()")["violations"]}
        assert {"image-alt", "label", "color-contrast"} <= found
