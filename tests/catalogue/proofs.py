"""Categories that passed their checks: ``proven.json``.

A category is proven by a digest of its key and of the code that draws it: its module, and all
modules of ``tabletop_objects`` which that imports, the styles included. Comments, docstrings, error
messages and layout do not count. ``proven.json`` holds the digests of the categories that passed,
and of each module its bytes, code and imports, so that only modules changed since then are parsed.
"""

from __future__ import annotations

import ast
import hashlib
import json
import os
import zlib
from collections.abc import Collection, Mapping
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path

import tabletop_objects
from tabletop_objects import CATEGORIES
from tabletop_objects.catalogue import INDEX

PROOFS = Path(__file__).with_name("proven.json")
ROOT = Path(tabletop_objects.__file__).parent
ALWAYS = ("kit.styles",)
"""Modules that draw a category and that its own does not import."""

SAMPLE = 40
"""One category in so many is always checked."""


@dataclass(frozen=True)
class Source:
    """A module: digests of its bytes and of its code, and the modules that it imports."""

    bytes: str
    code: str
    imports: tuple[str, ...]


@dataclass(frozen=True)
class Proofs:
    """The content of ``proven.json``."""

    modules: Mapping[str, Source]
    categories: Mapping[str, str]


def load(path: Path = PROOFS) -> Proofs:
    """Read the committed proofs; a missing file proves nothing."""
    if not path.exists():
        return Proofs({}, {})
    content = json.loads(path.read_bytes())
    modules = {
        name: Source(row["bytes"], row["code"], tuple(row["imports"]))
        for name, row in content["modules"].items()
    }
    return Proofs(modules, content["categories"])


def save(proofs: Proofs, path: Path = PROOFS) -> None:
    """Write proofs, a line for each module and category."""

    def table(rows: Mapping[str, object]) -> str:
        return ",\n".join(f"{json.dumps(k)}: {json.dumps(v)}" for k, v in sorted(rows.items()))

    modules = table({name: asdict(source) for name, source in proofs.modules.items()})
    categories = table(proofs.categories)
    path.write_text(f'{{"modules": {{\n{modules}\n}},\n"categories": {{\n{categories}\n}}}}\n')


class Digests:
    """Digests of categories by their code, of a tree of modules below ``root``."""

    def __init__(self, known: Mapping[str, Source], root: Path = ROOT) -> None:
        self.root, self.known = root, known
        self.modules: dict[str, Source] = {}
        self._drawings: dict[str, str] = {}

    def of(self, key: str, module: str) -> str:
        """Return the digest of a category that ``module`` declares ("objects.office.cups")."""
        if module not in self._drawings:
            code = [f"{name} {self.source(name).code}" for name in sorted(self._reach(module))]
            self._drawings[module] = "\n".join(code)
        return _digest(f"{key}\n{self._drawings[module]}".encode())

    def source(self, module: str) -> Source:
        """Return a module's digests; its code is parsed if its bytes are not known."""
        if module not in self.modules:
            content = self._path(module).read_bytes()
            known = self.known.get(module)
            if known is None or known.bytes != _digest(content):
                tree = ast.parse(content)
                known = Source(
                    _digest(content), _digest(code_of(tree)), self._imports(module, tree)
                )
            self.modules[module] = known
        return self.modules[module]

    def _reach(self, module: str) -> set[str]:
        """Return a module and all that it imports, directly or not."""
        reached: set[str] = set()
        waiting = [module, *(name for name in ALWAYS if self._path(name).exists())]
        while waiting:
            name = waiting.pop()
            if name not in reached:
                reached.add(name)
                waiting.extend(self.source(name).imports)
        return reached

    def _path(self, module: str) -> Path:
        return self.root.joinpath(*module.split(".")).with_suffix(".py")

    def _imports(self, module: str, tree: ast.AST) -> tuple[str, ...]:
        """Return the modules below ``root`` that a module imports, anywhere in it."""
        folder, names = module.split(".")[:-1], set()
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.level:
                up = node.level - 1
                base = folder[: len(folder) - up] + (node.module or "").split(".")
                stem = ".".join(part for part in base if part)
                names |= {stem, *(f"{stem}.{a.name}".lstrip(".") for a in node.names)}
        return tuple(sorted(name for name in names if name and self._path(name).exists()))


def code_of(tree: ast.AST) -> bytes:
    """Return code without docstrings (also of constants), error messages, comments and layout."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
            node.exc = node.exc.func  # a category that passes its checks raises nothing
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            node.body = [each for each in node.body if not _is_docstring(each)]
    return ast.dump(tree).encode()


def _is_docstring(node: ast.stmt) -> bool:
    return (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    )


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:16]


@cache
def digests() -> Mapping[str, str]:
    """Return the digest of every category as its code is now."""
    return _now()[0]


def _now() -> tuple[dict[str, str], Mapping[str, Source]]:
    table = Digests(load().modules)
    rows = json.loads(INDEX.read_bytes())
    found = {key: table.of(key, f"objects.{rows[key]['module']}") for key in sorted(rows)}
    return found, table.modules


def unproven(proofs: Proofs, now: Mapping[str, str]) -> list[str]:
    """Return the categories whose code differs from the last proof."""
    return [key for key in now if proofs.categories.get(key) != now[key]]


def categories_to_check() -> list[str]:
    """Return the unproven categories and a fixed sample of the others, or all if ``wanted``."""
    if os.environ.get("TABLETOPGEN_EVERY_CATEGORY"):
        return sorted(CATEGORIES)
    sample = {key for key in CATEGORIES if zlib.crc32(key.encode()) % SAMPLE == 0}
    return sorted(sample | {*unproven(load(), digests())})


def record(passed: Mapping[str, str], failed: Collection[str], path: Path = PROOFS) -> None:
    """Rewrite the proofs: add the digests of passed categories, drop failed or missing ones."""
    now, modules = _now()
    kept = {k: v for k, v in load(path).categories.items() if k in now and k not in failed}
    save(Proofs(modules, kept | {k: v for k, v in passed.items() if k not in failed}), path)
