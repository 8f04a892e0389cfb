"""Search for secrets reachable from an error, as a log or a debugger may show them."""

import traceback
from collections.abc import Iterator
from types import TracebackType
from typing import Any

OURS = ("generator.", "tabletop_objects.")


def chain(error: BaseException) -> Iterator[BaseException]:
    """Return the error with all of its causes and contexts."""
    left, seen = [error], set()
    while left:
        link = left.pop()
        if id(link) not in seen:
            seen.add(id(link))
            yield link
            left += [e for e in (link.__cause__, link.__context__) if e is not None]


def everything(error: BaseException, *, frames: bool = True) -> str:
    """Return texts, attributes, requests with headers, and local variables of package frames.

    Without ``frames`` not the last: where a server writes a key back, they hold its answer.
    """
    texts = ["".join(traceback.format_exception(error))]
    for link in chain(error):
        texts += [repr(link), str(link.args), *map(shown, vars(link).values())]
        texts += [shown(getattr(link, name, None)) for name in ("body", "request", "response")]
        texts += held(link.__traceback__) if frames else ()
    return "\n".join(texts)


def held(trace: TracebackType | None) -> Iterator[str]:
    while trace is not None:
        if trace.tb_frame.f_globals.get("__name__", "").startswith(OURS):
            yield from map(shown, trace.tb_frame.f_locals.values())
        trace = trace.tb_next


def shown(value: Any) -> str:
    """Return a value, and its content if its text hides that."""
    try:
        parts = [repr(value)]
        for part in (value, getattr(value, "request", None)):
            raw = getattr(getattr(part, "headers", None), "raw", ())
            parts += [str(raw), str(getattr(part, "text", ""))]
    except Exception as error:  # such as a request that was never set
        return repr(error)
    return "\n".join(parts)
