"""The bundles that the package ships, by name, and a part that stands for them."""

from pathlib import Path

from extent import part_of

import assets_cache

BUNDLES = {
    path.name.rpartition("-")[0]: path
    for store in ("starter", "tasks")
    for path in assets_cache.find(str(Path(assets_cache.__file__).parent / store))
}

PART = part_of(BUNDLES, "lab", "vanity", "workbench-toys", "tidy-task-3")
"""Rectangular with something transparent and all kinds of parts; round; of another outline and
with the most kinds of things; and a task's table, whose parts are boxes and hulls only."""
