"""Scripts that load an export into a physics engine, written next to it.

Each is copied unchanged and needs only the engine, not this package.
"""

from __future__ import annotations

from importlib import resources


def loader_scripts(*engines: str) -> dict[str, bytes]:
    """Return the loader scripts for the given engines, keyed by file name."""
    names = [f"load_{engine}.py" for engine in engines]
    return {name: resources.files(__name__).joinpath(name).read_bytes() for name in names}
