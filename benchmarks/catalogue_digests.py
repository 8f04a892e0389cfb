"""Digests of every category of the catalogue, which a refactoring must not change.

    python benchmarks/catalogue_digests.py record before.json
    python benchmarks/catalogue_digests.py compare before.json after.json

A digest covers five looks of a category (two plain, a colour, two styles): meshes, textures, convex
parts, slots, size and physics; and the facts of the category. Categories are recorded in their
order, which draws of random tables depend on.
"""

from __future__ import annotations

import argparse
import dataclasses
import enum
import hashlib
import json
import sys
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np

from tabletop_objects import CATEGORIES, Category, build

LOOKS: tuple[tuple[int, dict[str, str]], ...] = (
    (0, {}), (1, {}), (2, {"color": "red", "material": "wood"}),
    (3, {"style": "cartoon", "size": "large"}), (4, {"style": "low-poly", "color": "blue"}),
)  # fmt: skip
"""Seeds and attributes of the looks."""


def words(value: object) -> Iterator[bytes]:
    """Yield the content of a value as bytes, arrays with their types and shapes."""
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        for field in dataclasses.fields(value):
            yield field.name.encode()
            yield from words(getattr(value, field.name))
    elif isinstance(value, np.ndarray):
        yield f"{value.dtype.str}{value.shape}".encode()
        yield np.ascontiguousarray(value).tobytes()
    elif isinstance(value, Mapping):
        for key in sorted(value):
            yield str(key).encode()
            yield from words(value[key])
    elif isinstance(value, list | tuple):
        yield f"{len(value)}".encode()
        for item in value:
            yield from words(item)
    elif isinstance(value, set | frozenset):
        yield from words(sorted(value))
    elif isinstance(value, enum.Enum):
        yield value.name.encode()
    elif value is None or isinstance(value, bool | int | float | str | np.generic):
        yield repr(value.item() if isinstance(value, np.generic) else value).encode()
    else:
        raise TypeError(f"values of type {type(value).__name__} have no digest")


def digest(value: object) -> str:
    """Return the digest of a value."""
    found = hashlib.sha256()
    for word in words(value):
        found.update(len(word).to_bytes(8, "little") + word)
    return found.hexdigest()[:20]


def record_category(key: str) -> tuple[str, dict[str, str]]:
    """Return the digests of one category: of its facts and of each look."""
    looks = {
        f"look {number}": digest(build(key, seed, attributes=attributes))
        for number, (seed, attributes) in enumerate(LOOKS)
    }
    return key, {"facts": digest(facts(CATEGORIES[key])), **looks}


def facts(category: Category) -> dict[str, object]:
    """Return the facts of a category, except its builder."""
    names = ("key", "size", "mass", "aliases", "themes", "roles", "colors", "friction", "state",
             "holder", "noun", "container", "ball", "density")  # fmt: skip
    return {name: getattr(category, name) for name in names}


def record(path: Path, workers: int, only: Sequence[str] = ()) -> None:
    """Write the digests of all categories, or of selected ones, in their order."""
    keys = [key for key in CATEGORIES if not only or key in only]
    with ProcessPoolExecutor(workers) as pool:
        found = dict(pool.map(record_category, keys, chunksize=16))
    path.write_text(json.dumps(found, indent=0) + "\n")
    print(f"{len(found)} categories, {len(LOOKS)} looks each")


def compare(one: Path, other: Path) -> int:
    """Print the differences between two records; return their number."""
    before, after = (json.loads(path.read_text()) for path in (one, other))
    differing = [key for key in before | after if before.get(key) != after.get(key)]
    for key in differing:
        old, new = before.get(key, {}), after.get(key, {})
        print(f"{key}: {', '.join(part for part in old | new if old.get(part) != new.get(part))}")
    moved = list(before) != list(after)
    order = "differs" if moved else "is the same"
    print(f"{len(before)} categories, {len(differing)} differ, order {order}")
    return len(differing) + moved


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    commands = parser.add_subparsers(dest="command", required=True)
    recording = commands.add_parser("record")
    recording.add_argument("out", type=Path)
    recording.add_argument("--workers", type=int, default=2)
    recording.add_argument("--only", nargs="+", default=(), metavar="KEY", help="default: all")
    comparing = commands.add_parser("compare")
    comparing.add_argument("one", type=Path)
    comparing.add_argument("other", type=Path)
    args = parser.parse_args()
    if args.command == "compare":
        return int(compare(args.one, args.other) > 0)
    record(args.out, args.workers, args.only)
    return 0


if __name__ == "__main__":
    sys.exit(main())
