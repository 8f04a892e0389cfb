"""Entries of the ledger, and their totals."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

Outcome = Literal["answered", "cached", "failed"]


@dataclass(frozen=True)
class Entry:
    """One call in the ledger: a new answer, an answer from the store, or a failed attempt.

    ``money`` is None if the price is unknown. An attempt that broke off after it was sent counts at
    its maximum cost. ``earlier`` marks calls of earlier runs; ``at`` is the server's host and port.
    """

    server: str
    question: str
    model: str = ""
    outcome: Outcome = "answered"
    seconds: float = 0.0
    tokens_in: int = 0
    tokens_out: int = 0
    images: int = 0
    money: float | None = 0.0
    earlier: bool = False
    at: str = ""


@dataclass(frozen=True)
class LedgerRow:
    """The totals of all calls that put one question to one model.

    ``money`` covers the calls with a known price; ``unpriced`` counts the others.
    """

    server: str
    question: str
    model: str
    calls: int
    cached: int
    failed: int
    seconds: float
    tokens_in: int
    tokens_out: int
    images: int
    money: float
    unpriced: int


def rows_of(entries: Iterable[Entry]) -> tuple[LedgerRow, ...]:
    """Return one row per question, server and model, in the order of their first calls."""
    groups: dict[tuple[str, str, str], list[Entry]] = {}
    for entry in entries:
        groups.setdefault((entry.server, entry.question, entry.model), []).append(entry)
    return tuple(_row(*names, group) for names, group in groups.items())


def table(entries: Sequence[Entry], currency: str) -> str:
    """Return the rows and their total as a text table, or "" if there were no calls."""
    if not entries:
        return ""
    head = ("server", "question", "model", "calls", "cached", "failed", "seconds",
            "tokens in", "tokens out", "images", currency)  # fmt: skip
    total = _row("total", "", "", entries)
    lines = [head, *(_cells(row) for row in (*rows_of(entries), total))]
    widths = [max(len(line[k]) for line in lines) for k in range(len(head))]
    return "\n".join(
        "  ".join(
            cell.ljust(width) if k < 3 else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(line, widths, strict=True))
        ).rstrip()
        for line in lines
    )


def _row(server: str, question: str, model: str, entries: Iterable[Entry]) -> LedgerRow:
    entries = tuple(entries)
    outcomes = [entry.outcome for entry in entries]
    return LedgerRow(
        server, question, model,
        calls=outcomes.count("answered"),
        cached=outcomes.count("cached"),
        failed=outcomes.count("failed"),
        seconds=sum(entry.seconds for entry in entries),
        tokens_in=sum(entry.tokens_in for entry in entries),
        tokens_out=sum(entry.tokens_out for entry in entries),
        images=sum(entry.images for entry in entries),
        money=sum(entry.money or 0.0 for entry in entries),
        unpriced=sum(entry.money is None for entry in entries),
    )  # fmt: skip


def _cells(row: LedgerRow) -> tuple[str, ...]:
    money = f"{row.money:.4f}" if row.money or not row.unpriced else ""
    unknown = f"{row.unpriced} unknown" * bool(row.unpriced)
    return (
        row.server, row.question, row.model, str(row.calls), str(row.cached), str(row.failed),
        f"{row.seconds:.1f}", str(row.tokens_in), str(row.tokens_out), str(row.images),
        " + ".join(filter(None, (money, unknown))),
    )  # fmt: skip
