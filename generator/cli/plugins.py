"""Commands that other packages add: entry points of the group ``tabletopgen.commands``.

Those of ``tabletopgen.verifiers`` check a part of a bundle that this package does not know of, by
playing it again: functions of the bundle's path, how many episodes to play, and a seed, that return
how many were played and a list of what is wrong.

This package imports none of them; ``tabletopgen_env`` declares its own in ``pyproject.toml``. A
source checkout is asked first, for what is installed of it may be older, or nothing at all.
"""

from __future__ import annotations

import sys
import tomllib
from collections.abc import Mapping
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import Any

from ..errors import InputError, escape

GROUP, VERIFIERS = "tabletopgen.commands", "tabletopgen.verifiers"

CHECKOUT = Path(__file__).parents[2]
"""The folder that holds this package: of a source checkout, with a ``pyproject.toml``."""


def find_commands(group: str = GROUP) -> Mapping[str, EntryPoint]:
    """Return the commands of other packages by name, or another group's; none is imported."""
    installed = {entry.name: entry for entry in entry_points(group=group)}
    declared = project().get("entry-points", {}).get(group, {})
    own = {name: EntryPoint(name, value, group) for name, value in declared.items()}
    return dict(sorted((installed | own).items()))


def load(entry: EntryPoint, needed: bool) -> Any:
    """Import a command; return None if it cannot be imported and is not needed, and say so.

    It is a function, or a ``tyro.extras.SubcommandApp`` with commands of its own, of which the
    first line of its module's docstring says what they are for.

    Raises:
        InputError: it is needed.
    """
    try:
        return entry.load()
    except Exception as error:  # it is not ours
        told = (
            f"The command {entry.name} cannot be loaded from {entry.value} "
            f"({type(error).__name__}: {error})."
        )
        if needed:
            raise InputError(f"{told} Install again what adds it.") from error
        print(escape(told), file=sys.stderr)
        return None


def purpose_of(entry: EntryPoint) -> str:
    """Return what a group of commands is for, once it is imported."""
    return (sys.modules[entry.module].__doc__ or "").partition("\n")[0]


def project() -> Mapping[str, Any]:
    """Return the ``project`` table of the source checkout; empty where this is none."""
    try:
        text = (CHECKOUT / "pyproject.toml").read_text(encoding="utf-8")
        found = tomllib.loads(text).get("project", {})
    except (OSError, ValueError):
        return {}
    ours = isinstance(found, dict) and found.get("name") == "tabletopgen"
    return found if ours else {}
