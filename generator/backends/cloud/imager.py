"""The paper's image model, which draws reference pictures and top views and completes objects."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from jaxtyping import UInt8

from ...calls.session import Session
from ...calls.store import Used
from ...errors import BackendError, UnusableError, choices
from ...scene import (
    TABLE,
    Detection,
    Instance,
    Model,
    Reference,
    Rotation,
    ScenePlan,
    TopView,
    View,
)
from ..protocols import Imager, Instances
from .drawing import cutouts
from .drawing.picture_request import RATIOS, Form, Painter, Tolerated
from .drawing.pictures import on_white, pad, shrink
from .prompts import prompt
from .questions import plan_text
from .questions.checks import faults
from .questions.labelled import Labelled
from .server import configuration
from .server.client import Server
from .server.json_text import Wrong
from .server.typed_question import Chat, Manners

REDRAWS = 2
"""Maximum number of redraws of an incorrect picture."""

_WORK = 1280  # longer side of pictures in pixels
_WIDE = 1.5  # aspect ratio (width over height) of reference images
_EARLIER = "\n\nAn earlier drawing was wrong: "


@dataclass(frozen=True)
class CloudImager:
    """An imager that draws with an image model, and checks top views with a chat model.

    Attributes:
        base_url: the image server; see ``drawing`` for the supported forms.
        model: the image model's id on that server.
        form: the form of requests; "" derives it from the names of the model and the server.
        chat_base_url: the chat server.
        chat_model: the chat model, which checks top views.
        seed: different seeds give different drawings.
        session: state that all calls of one generation share; not part of the identity.
        fallback: the imager for top views if the model draws no usable one; ``Backends.select``
            passes the embedded imager. None raises the error instead.
    """

    base_url: str = field(default_factory=configuration.image_base_url)
    model: str = field(default_factory=configuration.image_model)
    form: Form | str = ""
    chat_base_url: str = field(default_factory=configuration.chat_base_url)
    chat_model: str = field(default_factory=configuration.chat_model)
    seed: int = 0
    session: Session = field(default_factory=Session, repr=False, compare=False)
    fallback: Imager | None = field(default=None, repr=False, compare=False)
    manners: Manners = field(default_factory=Manners, repr=False, compare=False)
    tolerated: Tolerated = field(default_factory=Tolerated, repr=False, compare=False)

    def __post_init__(self) -> None:
        for name in ("base_url", "chat_base_url"):
            object.__setattr__(self, name, configuration.checked_url(getattr(self, name)))
        if not self.form:
            object.__setattr__(self, "form", _form(self.model, self.base_url))
        if self.form not in RATIOS:
            raise BackendError(
                f"Imager.form {self.form!r} is unknown." + choices(self.form, RATIOS)
            )

    def check(self) -> None:
        """Raise BudgetError if there is a budget and a model's price is unknown."""
        models = {self.model: self.base_url, self.chat_model: self.chat_base_url}
        for model, url in models.items():
            self.session.check_price(model, url, f"cloud, imager ({model})")

    @property
    def server(self) -> str:
        """The image server's name: its provider's name, or the host and port."""
        return configuration.server_name(self.base_url)

    @property
    def painter(self) -> Painter:
        """The image model with its server and request format."""
        form: Form = "seedream" if self.form == "seedream" else "openai"
        server = Server(self.base_url, self.model, "image", self.session)
        return Painter(server, form, self.tolerated)

    @property
    def chat(self) -> Chat:
        """The chat model with its server."""
        server = Server(self.chat_base_url, self.chat_model, "chat", self.session)
        return Chat(server, self.manners, self.seed)

    def draw(self, plan: ScenePlan, seed: int) -> UInt8[np.ndarray, "h w 3"]:
        """Draw the plan's reference image, at most 1280 pixels wide or high.

        Raises:
            BackendError: the server returned no usable picture; the other questions raise this too.
        """
        table, things = plan_text.in_words(plan)
        text = prompt(
            "draw", style=plan.style, table=table, things=things, count=str(len(plan.objects)),
            take=self._take(seed, 0),
        )  # fmt: skip
        return shrink(on_white(self.painter.paint("draw", text, _WIDE)), _WORK)

    def complete(
        self, reference: Reference, detection: Detection, others: tuple[Detection, ...]
    ) -> Instance:
        """Redraw one object completely, without occlusion, and register it to the picture.

        Raises:
            BackendError: even after ``REDRAWS`` redraws, no drawing shows it; see also ``draw``.
        """
        cutout = cutouts.cut(reference, detection, others)
        place = Labelled.of(
            reference.image, [_as_instance(detection)], table=detection.label == TABLE
        ).picture()
        where = pad(place, *RATIOS[self.painter.form])
        bare = " Nothing stands on it: draw its top bare." if detection.label == TABLE else ""
        used, complaint = Used(self.session.store), ""
        for take in range(1 + REDRAWS):
            text = prompt(
                "complete", label=detection.label, ground=cutout.ground, bare=bare,
                complaint=complaint, take=self._take(0, take),
            )  # fmt: skip
            try:
                drawn = self.painter.paint(
                    "complete", text, 1.0, (cutout.picture, where), cutout.keep, clear=True,
                    used=used,
                )  # fmt: skip
                return cutouts.put_back(drawn, cutout)
            except Wrong as fault:
                complaint = f"{_EARLIER}{fault}"
        used.drop()
        raise self.painter.server.unusable(
            "complete",
            f"{1 + REDRAWS} drawings of {detection.label!r} could not be used: "
            f"{_last(complaint)} Try another image model or seed, or imager='embedded'.",
        )

    def top_view(
        self,
        reference: Reference,
        instances: Instances,
        models: Mapping[str, Model],
        rotations: Mapping[str, Rotation],
        view: View,
    ) -> TopView:
        """Draw the table from above; the segmenter later detects the objects' boxes in the drawing.

        The chat model checks that the view shows each object exactly once and nothing else. If a
        model refuses, or ``REDRAWS`` more drawings fail, ``fallback`` renders the view from
        geometry, and ``warnings`` of the top view states the reason.

        Raises:
            BackendError: a server did not answer, or no drawing is usable and there is no fallback.
        """
        try:
            return self._drawn_top_view(reference, instances, models)
        except UnusableError as error:
            if self.fallback is None:
                raise
            made = self.fallback.top_view(reference, instances, models, rotations, view)
            warning = (
                "The top view was rendered from geometry, because no drawing of it was usable. "
                f"{error}"
            )
        return replace(made, repaired=tuple(made.boxes), warnings=(*made.warnings, warning))

    def _drawn_top_view(
        self, reference: Reference, instances: Instances, models: Mapping[str, Model]
    ) -> TopView:
        """Return a drawn top view that passes all checks, or raise UnusableError."""
        things = Labelled.of(reference.image, instances)
        pictures = [pad(p, *RATIOS[self.painter.form]) for p in things.pair()]
        extent = _table_size(reference, models)
        ratio, size, complaint = _WIDE, "", ""
        if extent is not None:
            ratio = extent[0] / extent[1]
            size = ", {:.0f} cm from left to right by {:.0f} cm".format(*(100 * v for v in extent))
        for take in range(1 + REDRAWS):
            text = prompt(
                "top_view", size=size, count=str(things.count), things=things.names(),
                complaint=complaint, take=self._take(0, take),
            )  # fmt: skip
            drawn = self.painter.paint("top_view", text, ratio, pictures)
            image = shrink(on_white(drawn), _WORK)
            found = faults(self.chat, things, image)
            if not found:
                height, across = image.shape[:2]
                return TopView(image, np.array([0, 0, across, height], float), {})
            complaint = f"{_EARLIER}{' '.join(found)}"
        raise UnusableError(
            f"{1 + REDRAWS} top views drawn by {self.model} could not be used. Problem with the "
            f"last top view: {_last(complaint)}"
        )

    def _take(self, seed: int, take: int) -> str:
        """Return a sentence that makes the prompts for different drawings differ."""
        number = 1 + take + (1 + REDRAWS) * (self.seed + seed)
        return f"Version {number}. Do not write this number."


def _form(model: str, base_url: str) -> Form:
    """Return a server's API format, based on the names of the model and the server."""
    known = any(word in model.lower() for word in ("seedream", "seededit"))
    return "seedream" if known or configuration.server_name(base_url) == "ark" else "openai"


def _last(complaint: str) -> str:
    return complaint.removeprefix(_EARLIER)


def _as_instance(detection: Detection) -> Instance:
    """Return a detection as an instance without a cut-out."""
    nothing = np.zeros((1, 1, 4), np.uint8)
    label, box = detection.label, detection.box
    return Instance(label, label, box, detection.mask, nothing, box)


def _table_size(reference: Reference, models: Mapping[str, Model]) -> tuple[float, float] | None:
    """Return the table's length and width in metres, or None if they are unknown."""
    if reference.plan is not None:
        return reference.plan.table.size[:2]
    if TABLE not in models:
        return None
    length, width, _ = models[TABLE].size.tolist()
    return length, width
