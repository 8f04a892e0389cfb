"""The embedded image model: paints a plan, completes crops, rectifies the table from above."""

from __future__ import annotations

from dataclasses import dataclass

from .drawing import completion, painter, topview


@dataclass(frozen=True)
class EmbeddedImager:
    """Answers the three picture questions without any model."""

    draw = staticmethod(painter.draw)
    complete = staticmethod(completion.complete)
    top_view = staticmethod(topview.top_view)
