"""Docstrings as Sphinx takes them: dataclasses' fields as lists, tables left to the tasks page.

The project's dataclasses describe their fields in lines of the form ``name, name: text``, which
reStructuredText would run together.
"""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterable, Set
from typing import Any

import tasks_page
from sphinx import addnodes

SHOWN_ELSEWHERE = frozenset(module for _, module in tasks_page.SECTIONS)
"""Modules whose docstrings are sections of the page of tasks."""

_COLON = "\ua789"
"""Stands for a colon while Napoleon reads: of a constant it takes what comes before for a type."""

_LITERAL = re.compile(r"(``[^`]*``)")
_FIELD = re.compile(r"(\w+(?:, \w+)*): (.*)")


def process_docstring(
    app: Any, what: str, name: str, obj: object, options: Any, lines: list[str]
) -> None:
    """Change the lines of a docstring in place; called by autodoc for each."""
    if what == "module" and name in SHOWN_ELSEWHERE:
        end = lines.index("") if "" in lines else len(lines)
        lines[end:] = ["", "The tables are in :doc:`/reference/tasks`.", ""]
    elif what == "class" and dataclasses.is_dataclass(obj):
        lines[:] = list_fields(lines, {field.name for field in dataclasses.fields(obj)})
    elif what in ("attribute", "data"):
        lines[:] = [line.replace(": ", f"{_COLON} ") for line in lines]
    lines[:] = [escape(line) for line in lines]


def restore_colons(
    app: Any, what: str, name: str, obj: object, options: Any, lines: list[str]
) -> None:
    """Put back the colons of a constant's docstring, after Napoleon has read it."""
    lines[:] = [line.replace(_COLON, ":") for line in lines]


def drop_paths(app: Any, doctree: Any) -> None:
    """Drop the values of constants that are paths: they are of the machine that builds."""
    for node in list(doctree.findall(addnodes.desc_annotation)):
        if "PosixPath(" in node.astext():
            node.parent.remove(node)


def process_signature(
    app: Any, what: str, name: str, obj: object, options: Any, signature: str, returned: str
) -> tuple[str, str] | None:
    """Return the signature of a dataclass with defaults that Sphinx can read."""
    if what == "class" and dataclasses.is_dataclass(obj) and signature:
        return re.sub(r"~(\w+\.)+", "", signature).replace("<factory>", "..."), returned
    return None


def escape(line: str) -> str:
    """Return a line with its bars and the stars of globs as text: ``|x|``, ``"mug-*"``."""
    parts = _LITERAL.split(line)
    parts[::2] = [re.sub(r"\||(?<=-)\*", r"\\\g<0>", part) for part in parts[::2]]
    return "".join(parts)


def list_fields(lines: Iterable[str], names: Set[str]) -> list[str]:
    """Return a docstring's lines with the descriptions of fields as items of a list."""
    result: list[str] = []
    inside = False
    for line in lines:
        found = _FIELD.fullmatch(line)
        starts = found is not None and names >= {*found[1].split(", ")}
        if starts and not inside:
            result.append("")
        if found is not None and starts:
            marked = ", ".join(f"``{name}``" for name in found[1].split(", "))
            result.append(f"* {marked}: {found[2]}")
        else:
            inside = inside and bool(line)
            result.append(f"  {line.strip()}" if inside else line)
        inside = inside or starts
    return result
