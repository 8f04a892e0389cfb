"""Everything between a question and a paid call: sending, waiting, keeping, counting.

``Session`` is what the calls of one generation share. Backends that ask a server hold one.
"""

from .session import Session

__all__ = ["Session"]
