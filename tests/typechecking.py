"""Runtime checks of the product's array annotations: dtypes and shapes of every call.

``install`` puts jaxtyping's import hook with beartype on the packages. Names that are imported for
the type checker alone are imported for real, which no circle of imports prevents (see
``test_import_rules.py``).
"""

import functools
import importlib.abc
import importlib.machinery
import re
import sys
from collections.abc import Callable, Sequence
from types import ModuleType
from typing import Any

import beartype
from jaxtyping import install_import_hook

PACKAGES = ("tabletop_objects", "generator", "tabletopgen_env", "assets_cache")
CONF = beartype.BeartypeConf(is_pep484_tower=True)  # an int is a float, as for type checkers
ARRAYS = re.compile(r"\b(?:Float|Int|UInt|UInt8|UInt16|Int32|Int64|Bool|Shaped|Num|Real)\d*\[")


def check(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function that checks its array arguments and results.

    Other types are the type checker's; tests give wrong ones on purpose, to see them refused. So
    they do with arrays to constructors, which check what they are given.
    """
    if function.__name__ == "__init__":
        return function
    hints = function.__annotations__
    arrays = {
        name: hint
        for name, hint in hints.items()
        if ARRAYS.search(hint if isinstance(hint, str) else repr(hint))
    }
    if not arrays:
        return function
    function.__annotations__ = {**dict.fromkeys(hints, object), **arrays}
    try:
        return beartype.beartype(conf=CONF)(function)
    finally:
        function.__annotations__ = hints


class _Finder(importlib.abc.MetaPathFinder):
    """Finds the modules of the packages and executes their type-checking imports."""

    def find_spec(
        self, name: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> importlib.machinery.ModuleSpec | None:
        if name.partition(".")[0] not in PACKAGES:
            return None
        others = (finder for finder in sys.meta_path if finder is not self)
        found = (finder.find_spec(name, path, target) for finder in others)
        spec = next((spec for spec in found if spec is not None), None)
        if spec is not None and isinstance(spec.loader, importlib.machinery.SourceFileLoader):
            spec.loader.source_to_code = functools.partial(  # type: ignore[method-assign]
                _compile, spec.loader.source_to_code
            )
        return spec


def _compile(compiling: Callable[..., Any], data: bytes, path: str, **options: Any) -> Any:
    return compiling(data.replace(b"\nif TYPE_CHECKING:", b"\nif True:"), path, **options)


def install() -> None:
    """Check every call of the packages, which must not have been imported yet."""
    install_import_hook(list(PACKAGES), "typechecking.check")
    sys.meta_path.insert(0, _Finder())
