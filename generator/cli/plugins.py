"""Commands by name: this package's, and entry points of the group ``tabletopgen.commands``.

A command is imported when it runs, not when it is listed: its one-line summary is read from its
module's source. This package imports no other package's command; ``tabletopgen_env`` declares its
own in ``pyproject.toml``. The declarations of a source checkout take precedence, because the
installed metadata may be older or missing.

Entry points of the group ``tabletopgen.verifiers`` check, by replaying episodes, parts of a bundle
that this package does not know. They are functions that take the bundle's path, the number of
episodes and a seed, and return the number of replayed episodes and a list of problems.
"""

from __future__ import annotations

import ast
import importlib.util
import sys
import tomllib
from collections.abc import Mapping
from importlib.abc import InspectLoader
from importlib.machinery import PathFinder
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from types import MappingProxyType
from typing import Any

from ..errors import InputError, escape

GROUP, VERIFIERS = "tabletopgen.commands", "tabletopgen.verifiers"

CHECKOUT = Path(__file__).parents[2]
"""The folder that contains this package; in a source checkout it has a ``pyproject.toml``."""

OWN: Mapping[str, EntryPoint] = MappingProxyType({
    name: EntryPoint(name, f"{__package__}.{value}", GROUP)
    for name, value in {
        "generate": "generate:generate",
        "compose": "generate:compose",
        "import": "generate:import_",
        "batch": "batch:batch",
        "edit": "edit:edit",
        "explain": "inspection:explain",
        "inspect": "inspection:inspect",
        "verify": "inspection:verify",
        "view": "inspection:view",
        "compare": "inspection:compare",
        "export": "inspection:export",
        "evaluate": "evaluate:evaluate",
        "doctor": "doctor:doctor",
        "cache": "cache:app",
        "models": "models:app",
        "objects": "objects:app",
    }.items()
})  # fmt: skip
"""The commands of this package, in the order of ``--help``."""


def find_commands(group: str = GROUP) -> Mapping[str, EntryPoint]:
    """Return other packages' commands (or another group's entry points) by name, not imported."""
    installed = {entry.name: entry for entry in entry_points(group=group)}
    declared = project().get("entry-points", {}).get(group, {})
    own = {name: EntryPoint(name, value, group) for name, value in declared.items()}
    return dict(sorted((installed | own).items()))


def load(entry: EntryPoint) -> Any:
    """Import a command: a function, or a ``tyro.extras.SubcommandApp`` with its own subcommands.

    Raises:
        InputError: it cannot be imported.
    """
    try:
        return entry.load()
    except Exception as error:  # the code belongs to another package
        raise InputError(
            f"The command {entry.name} cannot be loaded from {entry.value} "
            f"({type(error).__name__}: {error}). Reinstall the package that provides it."
        ) from error


def summary_of(entry: EntryPoint) -> str | None:
    """Return the summary of a command: the first paragraph of its docstring.

    For a group of commands this is its module's docstring. The source is read, not run; a command
    without readable source is imported. If that fails, the reason is printed on standard error and
    None is returned.
    """
    try:
        tree = ast.parse(_source_of(entry.module))
    except (ImportError, SyntaxError, ValueError):
        return _summary_of_loaded(entry)
    function = next(
        (n for n in tree.body if isinstance(n, ast.FunctionDef) and n.name == entry.attr), tree
    )
    return _first_paragraph(ast.get_docstring(function))


def _source_of(module: str) -> str:
    """Return the source of a module without importing it or its parent packages.

    Raises:
        ImportError: the module does not exist, or its source is not available.
    """
    top, *inner = module.split(".")
    spec = importlib.util.find_spec(top)
    name = top
    for part in inner:
        name = f"{name}.{part}"
        spec = spec and PathFinder.find_spec(name, spec.submodule_search_locations)
    loader = spec.loader if spec is not None else None
    source = loader.get_source(name) if isinstance(loader, InspectLoader) else None
    if source is None:
        raise ImportError(f"no source of {module}")
    return source


def _summary_of_loaded(entry: EntryPoint) -> str | None:
    try:
        command = load(entry)
    except InputError as error:
        print(escape(f"{error}"), file=sys.stderr)
        return None
    described = command if callable(command) else sys.modules[entry.module]
    return _first_paragraph(described.__doc__)


def _first_paragraph(docstring: str | None) -> str:
    return " ".join((docstring or "").strip().partition("\n\n")[0].split())


def project() -> Mapping[str, Any]:
    """Return the ``project`` table of the source checkout, or {} outside of one."""
    try:
        text = (CHECKOUT / "pyproject.toml").read_text(encoding="utf-8")
        found = tomllib.loads(text).get("project", {})
    except (OSError, ValueError):
        return {}
    ours = isinstance(found, dict) and found.get("name") == "tabletopgen"
    return found if ours else {}
