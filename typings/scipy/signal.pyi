"""SciPy has no types of its own: every name may be there."""

from typing import Any

def __getattr__(name: str) -> Any: ...
