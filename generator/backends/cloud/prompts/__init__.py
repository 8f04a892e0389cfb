"""Prompts, one per file, whose variables must match the given values exactly."""

from __future__ import annotations

from importlib.resources import files
from string import Template

from ....errors import BackendError, choices


def prompt(name: str, **variables: str) -> str:
    """Return the prompt ``name`` with its ``$variables`` replaced.

    Raises:
        BackendError: the variables and the given values differ.
    """
    folder = files(__name__)
    stored = {f.name.removesuffix(".md"): f for f in folder.iterdir() if f.name.endswith(".md")}
    if name not in stored:
        raise BackendError(f"No prompt {name!r}.{choices(name, stored)}")
    template = Template(stored[name].read_text(encoding="utf-8"))
    wanted, given = set(template.get_identifiers()), set(variables)
    if wanted != given:
        missing, surplus = sorted(wanted - given), sorted(given - wanted)
        raise BackendError(f"Prompt {name!r}: missing {missing}, unexpected {surplus}.")
    return template.substitute(variables).strip()
