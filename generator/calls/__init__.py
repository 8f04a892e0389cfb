"""Paid calls to servers: transport, retries, cache, prices, budgets and the ledger.

A ``Session`` is shared by all calls of one generation. Each backend that calls a server holds one.
"""

from .session import Session

__all__ = ["Session"]
