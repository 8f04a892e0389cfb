"""Which categories tests build, and their models by seed: shared, so not to be changed."""

import os
import zlib

from generator.scene import Model
from tabletop_objects import CATEGORIES, build

SOME = [
    key
    for key in sorted(CATEGORIES)
    if os.environ.get("TABLETOPGEN_EVERY_CATEGORY") or zlib.crc32(key.encode()) % 4 == 0
]
"""A quarter of the catalogue, the same each time, for what takes long; all of it if asked."""


class Models:
    """The plain models of a category, each built when it is first asked for."""

    def __init__(self, key: str) -> None:
        self.key = key
        self._built: dict[int, Model] = {}

    def __getitem__(self, seed: int) -> Model:
        if seed not in self._built:
            self._built[seed] = build(self.key, seed)
        return self._built[seed]

    def first(self, count: int) -> list[Model]:
        return [self[seed] for seed in range(count)]
