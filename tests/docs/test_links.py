"""Internal links of README.md, CONTRIBUTING.md and the docs are valid."""

import re
import tomllib
from functools import cache
from pathlib import Path

import blocks
import cli_page
import pytest
import tasks_page
from blocks import ROOT

PAGES = blocks.pages()
GENERATED = {"docs/reference/cli.md": cli_page.page, "docs/reference/tasks.md": tasks_page.page}
_FENCED = re.compile(r"^```.*?^```$", re.M | re.S)
_LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")


@cache
def text_of(page: Path) -> str:
    """Return a page without its fenced blocks; for a generated page, the site's text."""
    name = page.relative_to(ROOT).as_posix()
    made = GENERATED.get(name)
    return _FENCED.sub("", made() if made else page.read_text(encoding="utf-8"))


def anchors(page: Path) -> set[str]:
    """Return the anchors of a page's headings, as GitHub and the site make them."""
    headings = re.findall(r"^#+ (.+)$", text_of(page), flags=re.M)
    plain = (re.sub(r"[^\w\- ]", "", heading.lower()) for heading in headings)
    return {heading.strip().replace(" ", "-") for heading in plain}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_links_lead_somewhere(page: Path) -> None:
    wrong = []
    for link in _LINK.findall(text_of(page)):
        if re.match(r"[a-z]+:", link):
            continue
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        if not target.exists() or (anchor and anchor not in anchors(target)):
            wrong.append(link)
    assert wrong == []


def test_the_stub_of_the_tasks_has_the_sections_of_the_site() -> None:
    stub, made = ROOT / "docs/reference/tasks.md", tasks_page.page()
    sections = re.findall(r"^## .+$", _FENCED.sub("", made), flags=re.M)
    text = stub.read_text(encoding="utf-8")
    assert re.findall(r"^## .+$", text, flags=re.M) == sections
    for title, module in tasks_page.SECTIONS:
        body = text.partition(f"## {title}\n")[2].partition("## ")[0]
        assert module.replace(".", "/") in body, title
        assert all((stub.parent / link).exists() for link in _LINK.findall(body)), title


def test_every_page_is_in_a_table_of_contents() -> None:
    index = ROOT / "docs/index.md"
    listed, waiting = {index}, [index]
    while waiting:
        page = waiting.pop()
        trees = re.findall(r"```\{toctree\}\n(.*?)```", page.read_text(encoding="utf-8"), re.S)
        names = [line for tree in trees for line in tree.split() if not line.startswith(":")]
        for name in names:
            child = page.parent / f"{name}.md"
            if child not in listed and child.is_file():
                listed.add(child)
                waiting.append(child)
    assert listed == {p for p in PAGES if p.is_relative_to(ROOT / "docs")}


def test_every_table_of_results_is_shown() -> None:
    shown = "".join(p.read_text(encoding="utf-8") for p in (ROOT / "docs/results").glob("*.md"))
    for path in (ROOT / "benchmarks/results").glob("*.md"):
        assert f"benchmarks/results/{path.name}\n" in shown, path


def test_the_readme_is_short_and_shows_the_test_command() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert text.count("\n") <= 150
    assert "make test" in text
    ci = (ROOT / ".ci/run").read_text(encoding="utf-8")
    assert "make test" in ci


def test_the_quickstart_names_every_extra() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    text = (ROOT / "docs/quickstart.md").read_text(encoding="utf-8")
    (line,) = (line for line in text.splitlines() if "following extras:" in line)
    named = set(re.findall(r"`([a-z]+)`", line.partition("following extras:")[2]))
    assert named >= {*project["optional-dependencies"]} - {"dev"}
