"""What can be selected by name: the contract suites go through all of it."""

import importlib

from generator.backends.select import TABLE


def names(role: str) -> tuple[str, ...]:
    """Return the names of the backends that have a role."""
    return tuple(name for name, roles in TABLE.items() if role in roles)


def kind(name: str, role: str) -> type:
    """Return the class that answers for a role under a name."""
    module, _, attribute = TABLE[name][role].partition(":")
    return getattr(importlib.import_module(module), attribute)
