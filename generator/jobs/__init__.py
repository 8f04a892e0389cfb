"""Resumable batches: many scenes in one folder, made by several processes or on Ray.

The same text and seed give the same bytes, regardless of the maker and the degree of parallelism. A
scene is either done or absent: the process that holds its lock makes it in a private folder, writes
its record, and only then publishes it. Several batches may therefore share a folder.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..io.lazy import lazy_names

if TYPE_CHECKING:
    from .loop import run as run
    from .loop import try_out as try_out
    from .prompts import Job as Job
    from .prompts import Maker as Maker
    from .prompts import jobs_of as jobs_of
    from .prompts import read_prompts as read_prompts
    from .records import Outcome as Outcome
    from .summary import Summary as Summary
    from .work import Composing as Composing
    from .work import Generating as Generating
    from .work import shared_budget as shared_budget

_HOMES = {
    "Composing": "work",
    "Generating": "work",
    "Job": "prompts",
    "Maker": "prompts",
    "Outcome": "records",
    "Summary": "summary",
    "jobs_of": "prompts",
    "read_prompts": "prompts",
    "run": "loop",
    "shared_budget": "work",
    "try_out": "loop",
}

__getattr__, __dir__ = lazy_names(__name__, _HOMES)
