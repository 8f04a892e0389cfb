"""Program that writes ``index.json``; run it as ``python -m tabletop_objects.index``.

The index holds the properties of every category. Categories keep their ranks, because these affect
random choices and decide which category an ambiguous alias refers to. New categories are appended
in the alphabetical order of their keys.
"""

from __future__ import annotations

import dataclasses
import json
import sys
from pathlib import Path

from .catalogue import INDEX, OBJECTS, read_module
from .kit.shapes import Category

FACTS = tuple(f for f in dataclasses.fields(Category) if f.name not in ("key", "shape", "_"))


def write_index(path: Path = INDEX) -> int:
    """Write the index of all modules in ``objects`` and return the number of categories."""
    path.write_text(index_text(), encoding="utf-8")
    return len(declarations())


def declarations() -> dict[str, tuple[str, Category]]:
    """Return all declared categories by key, with their modules relative to ``objects``.

    Raises:
        ValueError: two modules declare the same key, or a category's first theme is not its folder.
    """
    root = Path(__file__).with_name("objects")
    found: dict[str, tuple[str, Category]] = {}
    for path in sorted(root.rglob("*.py")):
        if path.name == "__init__.py":
            continue
        module = ".".join(path.relative_to(root).with_suffix("").parts)
        for key, category in read_module(f"{OBJECTS}.{module}").items():
            if key in found:
                raise ValueError(
                    f"{key} is declared in both {found[key][0]} and {module}; rename one of them."
                )
            if category.themes[:1] != (path.parent.name,):
                raise ValueError(
                    f"{key} in {module} must have {path.parent.name!r} as its first theme, got "
                    f"{category.themes[:1]}."
                )
            found[key] = module, category
    return found


def index_text() -> str:
    """Return the content of the index for the current modules."""
    found = declarations()
    ranked = list(json.loads(INDEX.read_bytes())) if INDEX.exists() else []
    keys = [k for k in ranked if k in found] + sorted(found.keys() - set(ranked))
    rows = [f"{json.dumps(k)}: {json.dumps(row_of(*found[k]), ensure_ascii=False)}" for k in keys]
    return "{\n" + ",\n".join(rows) + "\n}\n"


def row_of(module: str, category: Category) -> dict[str, object]:
    """Return the properties of a category that differ from their defaults."""
    facts = {f.name: getattr(category, f.name) for f in FACTS}
    facts = {f.name: facts[f.name] for f in FACTS if facts[f.name] != f.default}
    if category.noun == category.key.replace("_", " "):
        facts.pop("noun", None)
    if category.holder is not None:
        facts["holder"] = category.holder.stance, category.holder.room
    return {"module": module, **facts}


if __name__ == "__main__":
    print(f"{write_index()} categories", file=sys.stderr)
