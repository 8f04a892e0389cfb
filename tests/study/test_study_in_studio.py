"""Studies that a studio serves, in Chromium: from the printed link to the report."""

from __future__ import annotations

import json
import random
import re
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
import tiny_studies as tiny
from bounded import line_of, running
from command import Shell
from page_raters import LONG, answer_all, answer_by_mouse, opened, serving

from tabletopgen_web.study.page import StudyFiles, write_study

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory, template: str) -> StudyFiles:
    return tiny.small_study(tmp_path_factory.mktemp("pictures"), template=template, post=tiny.POST)


@pytest.fixture(scope="module")
def study(files: StudyFiles, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_study(files, tmp_path_factory.mktemp("study") / "study.html")[0]


@contextmanager
def running_studio(folder: Path, *studies: Path, port: int = 0) -> Iterator[tuple[str, str]]:
    """A studio that serves studies; yield its own link and that of the first study's raters."""
    command = (sys.executable, "-m", "generator", "studio", "--no-browser", "--folder", folder,
               "--port", port, "--study", *studies)  # fmt: skip
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL, "bufsize": 0}
    with running(*command, **pipes) as process:
        own = re.fullmatch(r"Open (http://\S+)\n", line_of(process).decode())
        raters = re.fullmatch(
            r"Address for raters of study \w+: (http://\S+)\n", line_of(process).decode()
        )
        assert own and raters
        yield own[1], raters[1]


def test_a_link_is_answered_and_the_report_counts_it(
    browser: Browser, study: Path, files: StudyFiles, tmp_path: Path, shell: Shell
) -> None:
    kept = tmp_path / "studio" / "answers" / files.key.study
    with running_studio(tmp_path / "studio", study) as (own, link):
        assert "/study/" in link and own.partition("token=")[2] not in link
        root = own.partition("?")[0]
        for rater in range(3):
            with opened(browser, link) as (_, page):
                assert page.url == f"{root}study/{files.key.study}", "without the token"
                answer_all(page, files.key, rater)
                page.keyboard.press("Enter")
                page.get_by_text("Your answers were sent").wait_for()
                page.reload()
                page.get_by_text("Your answers were sent").wait_for()
                send_again(page)
                assert len(list(kept.iterdir())) == rater + 1
                for path in ("", "api/state", "api/jobs", "api/scenes"):
                    refused = page.request.get(f"{root}{path}")
                    assert refused.status == 403, path
                assert page.evaluate("document.cookie") == ""
        with opened(browser, own) as (_, page):  # the studio's own page, and what raters see
            page.goto(f"{root}study/{files.key.study}")
            page.get_by_role("button", name="Begin").wait_for()
    assert [len(json.loads(path.read_text())) for path in kept.iterdir()] == [1, 1, 1]
    shown = shell("study", "report", str(kept), "--key", f"{study.parent}/study.key.json", "--json")
    tiny.check_table(shown.facts)
    assert (shown.facts["raters"], shown.facts["left_out"], shown.err) == (3, [], "")


def send_again(page: Page) -> None:
    """Make a page repeat its last submission, as after a lost response."""
    page.evaluate(
        "() => { const [key] = Object.keys(localStorage).filter(k => /^study-\\w+$/.test(k));"
        "localStorage[key] = localStorage[key].replace('\"sent\":true', '\"sent\":false'); }"
    )
    with page.expect_response(lambda answer: answer.request.method == "POST") as sent:
        page.reload()
    assert sent.value.status == 201
    page.get_by_text("Your answers were sent").wait_for()


def free_port() -> int:
    """Return a port below the ephemeral range, so that no connection takes it meanwhile."""
    for port in random.SystemRandom().sample(range(20_000, 32_000), 100):
        with suppress(OSError), socket.create_server(("127.0.0.1", port)):
            return port
    raise AssertionError("all ports are taken")


def test_a_link_in_a_mailbox_opens_and_outlives_the_studio(
    browser: Browser, study: Path, files: StudyFiles, tmp_path: Path
) -> None:
    port = free_port()
    with running_studio(tmp_path / "studio", study, port=port) as (_, link):
        context = browser.new_context(locale="en-US")
        context.set_default_timeout(LONG)
        page = context.new_page()
        page.route("http://mail.example/", lambda route: route.fulfill(
            content_type="text/html", body=f'<a href="{link}">Take part</a>'))  # fmt: skip
        page.goto("http://mail.example/")
        page.get_by_role("link").click()
        page.get_by_role("button", name="Begin").wait_for()
    with running_studio(tmp_path / "studio", study, port=port) as (_, again):
        assert again == link
        page.reload()
        page.get_by_role("button", name="Begin").wait_for()
        context.close()


def test_a_script_that_came_in_would_not_run(
    browser: Browser, study: Path, files: StudyFiles, tmp_path: Path
) -> None:
    """The header's policy applies, whatever the page's own policy."""
    evil = "document.documentElement.dataset.evil = 1"
    markup = f'<script>{evil}</script><img src="x" onerror="{evil}"><iframe srcdoc="a"></iframe>'
    with running_studio(tmp_path / "studio", study) as (_, link):
        context = browser.new_context(locale="en-US")
        page = context.new_page()
        policies = []

        def spoil(route) -> None:
            answer = route.fetch(max_redirects=0)
            policies.append(answer.headers.get("content-security-policy", ""))
            body = re.sub(r'<meta http-equiv="Content-Security[^>]*>', "", answer.text())
            headers = {k: v for k, v in answer.headers.items() if k != "content-length"}
            route.fulfill(status=200, headers=headers, body=body.replace("</body>", markup))

        page.goto(link)
        page.route("**/study/*", spoil)
        page.reload()
        page.get_by_role("button", name="Begin").wait_for()
        page.wait_for_timeout(300)
        assert page.evaluate("document.documentElement.dataset.evil") is None
        assert "frame-ancestors 'none'" in policies[0]
        page.unroute("**/study/*")
        page.route("**/study/*", lambda route: route.fulfill(
            content_type="text/html", body=f"<body>{markup}"))  # fmt: skip
        page.reload()
        page.wait_for_function("document.documentElement.dataset.evil === '1'", timeout=LONG)
        context.close()


# ------------------------------------------------------------------------------------- two tabs
def count_seconds(page: Page, study: str) -> float:
    kept = json.loads(page.evaluate("key => localStorage[key]", f"study-{study}"))
    return sum(kept["seconds"].values())


def test_two_tabs_count_time_once(
    browser: Browser, study: Path, files: StudyFiles, tmp_path: Path
) -> None:
    """Simulated time: one tab alone for 22 s, both for 58 s, the second for 20 s."""
    (tmp_path / "study.html").write_bytes(study.read_bytes())
    with serving(tmp_path) as address:
        context = browser.new_context(locale="en-US")
        context.set_default_timeout(LONG)
        context.clock.install(time=1_700_000_000)
        context.clock.pause_at(1_700_000_001)

        def run(seconds: int) -> None:
            for _ in range(seconds):
                context.clock.run_for(1000)

        first, second = context.new_page(), context.new_page()
        first.goto(f"{address}/study.html")
        first.get_by_role("button", name="Begin").click()
        run(22)  # the second tab counts at times between those of the first
        second.goto(f"{address}/study.html")
        second.get_by_role("button", name="Next").wait_for()
        run(58)
        assert count_seconds(second, files.key.study) == pytest.approx(80, abs=6)
        first.close()
        run(20)
        assert count_seconds(second, files.key.study) == pytest.approx(100, abs=6)
        context.close()


def test_a_tab_that_was_frozen_does_not_undo_what_another_kept(
    browser: Browser, study: Path, files: StudyFiles, tmp_path: Path
) -> None:
    """In a single tab: it receives no notice of its own updates, as if it had been suspended."""
    (tmp_path / "study.html").write_bytes(study.read_bytes())
    with serving(tmp_path) as address, opened(browser, f"{address}/study.html") as (_, page):
        page.get_by_role("button", name="Begin").click()
        page.get_by_role("button", name="Next").wait_for()
        for event in ("pageshow", "visibilitychange"):
            language = page.evaluate(
                "([key, event]) => { const kept = JSON.parse(localStorage[key]);"
                "kept.language = kept.language === 'en' ? 'zh' : 'en';"
                "localStorage[key] = JSON.stringify(kept); dispatchEvent(new Event(event));"
                "return kept.language; }", [f"study-{files.key.study}", event],
            )  # fmt: skip
            page.wait_for_function("known => document.documentElement.lang === known", arg=language)


def test_the_texts_say_one_where_there_is_one(
    browser: Browser, template: str, tmp_path: Path
) -> None:
    files = tiny.small_study(tmp_path / "pictures", names=tiny.SCENES[:1], template=template)
    page_file, _ = write_study(files, tmp_path / "study.html")
    with opened(browser, page_file.as_uri()) as (_, page):
        page.get_by_text("There is 1 page. It shows an input picture").wait_for()
        page.get_by_role("button", name="Begin").click()
        answer_by_mouse(page)
        page.get_by_role("button", name="Finish").click()
        page.get_by_text("You have answered everything.").wait_for()
