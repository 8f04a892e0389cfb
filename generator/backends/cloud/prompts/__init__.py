"""The questions in words: one file each, filled in with exactly the variables it names."""

from __future__ import annotations

from importlib.resources import files
from string import Template

from ....errors import BackendError, choices


def prompt(name: str, **variables: str) -> str:
    """Return the prompt ``name``, its ``$variables`` filled in (BackendError: they do not fit)."""
    folder = files(__name__)
    stored = {f.name.removesuffix(".md"): f for f in folder.iterdir() if f.name.endswith(".md")}
    if name not in stored:
        raise BackendError(f"No prompt {name!r}.{choices(name, stored)}")
    template = Template(stored[name].read_text(encoding="utf-8"))
    wanted, given = set(template.get_identifiers()), set(variables)
    if wanted != given:
        missing, surplus = sorted(wanted - given), sorted(given - wanted)
        raise BackendError(f"Prompt {name!r}: missing {missing}, not asked for {surplus}.")
    return template.substitute(variables).strip()
