"""A reasoner and an imager for OpenAI-compatible servers, with the paper's closed models or others.

``configuration`` lists the environment variables that select the server, models and keys.
"""

from importlib.util import find_spec

from ...errors import BackendError

_MISSING = [name for name in ("openai", "pydantic") if find_spec(name) is None]
if _MISSING:
    raise BackendError(
        f"The cloud backend needs {' and '.join(_MISSING)}: pip install 'tabletopgen[cloud]'."
    )
