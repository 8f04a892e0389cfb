"""The embedded image model, which renders plans, completes crops and rectifies the tabletop."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from . import completion, painter, top_view


@dataclass(frozen=True)
class EmbeddedImager:
    """An imager that works by rendering and image processing, without a generative model.

    ``draws_catalogue`` is True because the drawing of a plan shows the catalogue's own objects.
    """

    draws_catalogue: ClassVar[bool] = True

    draw = staticmethod(painter.draw)
    complete = staticmethod(completion.complete)
    top_view = staticmethod(top_view.top_view)
