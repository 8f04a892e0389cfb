"""The bundles that the package ships, by name."""

from pathlib import Path

import assets_cache

BUNDLES = {
    path.name.rpartition("-")[0]: path
    for store in ("starter", "tasks")
    for path in assets_cache.find(str(Path(assets_cache.__file__).parent / store))
}
