"""Names that can be selected: the contract suites cover all of them."""

import importlib

from generator.backends.select import TABLE


def names(role: str) -> tuple[str, ...]:
    """Return the names of the backends with a role."""
    return tuple(name for name, roles in TABLE.items() if role in roles)


def kind(name: str, role: str) -> type:
    """Return the class of a role's backend."""
    module, _, attribute = TABLE[name][role].partition(":")
    return getattr(importlib.import_module(module), attribute)
