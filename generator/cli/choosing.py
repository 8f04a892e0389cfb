"""How every command lets its user say who answers: --backend, and an option for each role."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any

from tyro.conf import OmitArgPrefixes, arg

from ..backends import Mix

if TYPE_CHECKING:
    from ..backends import Backends

Chosen = OmitArgPrefixes[Annotated[Mix, arg(name="backend")]]
"""The type of a command's argument that makes these options."""

Roles = Mapping[str, Mapping[str, Any]]
"""Who each role is: its name, and its settings."""

USUAL = Mix()
"""What generating commands use unless told otherwise."""

NOBODY = Mix(backend=None)
"""What commands use that can do without backends."""


def roles_of(mix: Mix, backends: Backends) -> Roles:
    """Return for each role who it is by name, and the settings that decide its answers."""
    names, settings = mix.roles(), backends.identity()
    return {
        role: {"name": names[role], **{k: v for k, v in settings[role].items() if k != "class"}}
        for role in names
    }


def lines_of(roles: Roles) -> list[str]:
    """Return ``roles_of`` as a line for each role."""
    lines = []
    for role, facts in roles.items():
        settings = ", ".join(f"{k}={v}" for k, v in facts.items() if k != "name" and v != "")
        lines.append(f"{role:<10} {facts['name']}" + (f" ({settings})" if settings else ""))
    return lines
