"""A Sphinx extension: pages made of the code, in place of the stubs that the repository holds."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

import cli_page
import docstrings
import tasks_page

CHANGELOG = Path(__file__).parents[2] / "CHANGELOG.md"


def changelog() -> str:
    """Return the changelog; pages that its old entries link to may have moved."""
    return re.sub(r"\[([^]]+)\]\((?!http)[^)]+\)", r"\1", CHANGELOG.read_text(encoding="utf-8"))


PAGES: Mapping[str, Callable[[], str]] = MappingProxyType({
    "changelog": changelog,
    "reference/cli": cli_page.page,
    "reference/tasks": tasks_page.page,
})  # fmt: skip
"""What makes a page, by the page's name. Nothing is written: the text is replaced as it is read."""


def replace_stub(app: Any, name: str, source: list[str]) -> None:
    """Put the generated text in place of a stub's."""
    if name in PAGES:
        source[0] = PAGES[name]()


def setup(app: Any) -> Mapping[str, bool]:
    """Connect to Sphinx."""
    app.connect("source-read", replace_stub)
    app.connect("autodoc-process-docstring", docstrings.process_docstring, priority=400)
    app.connect("autodoc-process-docstring", docstrings.restore_colons, priority=600)
    app.connect("doctree-read", docstrings.drop_paths)
    app.connect("autodoc-process-signature", docstrings.process_signature)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
