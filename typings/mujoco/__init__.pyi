"""MuJoCo's Python module is compiled, without types: every name may be there."""

from typing import Any

def __getattr__(name: str) -> Any: ...
