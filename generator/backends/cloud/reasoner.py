"""The reasoner of the paper: a multimodal chat model behind typed questions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from jaxtyping import UInt8

from ...calls.session import Session
from ...scene import (
    TABLE,
    Instance,
    LayoutBox,
    Mesh,
    Reference,
    ScenePlan,
    SizePrior,
    Stacking,
    View,
)
from .drawing.pictures import on_white
from .prompts import prompt as worded
from .questions import estimating, judging, orientation, planning
from .server import configuration
from .server.answers import OrientationAnswer, PlanAnswer
from .server.calling import Server
from .server.typed_question import Chat, Manners


@dataclass(frozen=True)
class CloudReasoner:
    """Answers the six questions, and the two of ``Judge`` and of ``PoseGuesser``, by a chat model.

    Attributes:
        base_url: an OpenAI-compatible server that knows chat/completions with pictures.
        model: the model's id there.
        seed: sent with every question to servers that take one.
        session: what the calls of one generation share; no identity.
    """

    base_url: str = field(default_factory=configuration.chat_base_url)
    model: str = field(default_factory=configuration.chat_model)
    seed: int = 0
    session: Session = field(default_factory=Session, repr=False, compare=False)
    manners: Manners = field(default_factory=Manners, repr=False, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "base_url", configuration.checked_url(self.base_url))

    @property
    def server(self) -> str:
        """The server's name: its provider's, or host and port."""
        return configuration.server_name(self.base_url)

    @property
    def chat(self) -> Chat:
        """The model, ready to be asked."""
        server = Server(self.base_url, self.model, "chat", self.session)
        return Chat(server, self.manners, self.seed)

    def plan_scene(self, prompt: str, seed: int) -> ScenePlan:
        """Expand a text into a plan; another seed plans otherwise what the text leaves open.

        Raises:
            InputError: the text is empty or too long.
            BackendError: no usable answer, as for every question.
        """
        text = planning.checked_text(prompt)
        return self.chat.ask(
            "plan_scene",
            worded("plan_scene", text=text, seed=str(seed)),
            (),
            PlanAnswer,
            lambda answer: planning.to_plan(prompt, answer),
        )

    def list_objects(self, reference: Reference) -> tuple[str, ...]:
        """Return "table" and the noun of each kind seen, as often as it is there."""
        return estimating.list_objects(self.chat, reference)

    def estimate_view(self, reference: Reference, table: Instance) -> View:
        """Return the camera as the model judges it; known intrinsics tell the field of view."""
        return estimating.estimate_view(self.chat, reference, table)

    def estimate_sizes(
        self, reference: Reference, instances: tuple[Instance, ...], view: View
    ) -> Mapping[str, SizePrior]:
        """Return usual sizes; those that a text fixed are kept."""
        return estimating.estimate_sizes(self.chat, reference, instances)

    def review_orientation(
        self, mesh: Mesh, instance: Instance, size: SizePrior
    ) -> tuple[tuple[str, int], ...]:
        """Return the quarter turns that make the model stand as the instance's picture shows it."""
        length, width, height = (f"{100 * v:.3g}" for v in size.extent)
        x, y, z = (f"{v:.2f}" for v in mesh.extent / mesh.extent.max())
        text = worded(
            "review_orientation",
            label=instance.label, placement=size.placement,
            length_axis=size.axes[0], width_axis=size.axes[1], height_axis=size.axes[2],
            length=length, width=width, height=height, x=x, y=y, z=z,
        )  # fmt: skip
        pictures = (on_white(instance.crop), orientation.six_sides(mesh))
        return self.chat.ask(
            "review_orientation", text, pictures, OrientationAnswer, orientation.turns
        )

    def stacking_order(
        self, reference: Reference, instances: tuple[Instance, ...], view: View
    ) -> Mapping[str, Stacking]:
        """Return what each thing rests on or in; layers are counted from the table up."""
        return estimating.stacking_order(self.chat, reference, instances)

    def rate(
        self,
        reference: UInt8[np.ndarray, "h w 3"],
        pictures: tuple[UInt8[np.ndarray, "a b 3"], ...],
        criteria: Mapping[str, str],
    ) -> Mapping[str, float]:
        """Return marks from 1 to 7."""
        return judging.rate(self.chat, reference, pictures, criteria)

    def rank(
        self,
        reference: UInt8[np.ndarray, "h w 3"],
        methods: Mapping[str, tuple[UInt8[np.ndarray, "a b 3"], ...]],
    ) -> tuple[str, ...]:
        """Return the methods, best first; the model is told letters, no names."""
        return judging.rank(self.chat, reference, methods)

    def guess_rotations(
        self,
        reference: Reference,
        instances: tuple[Instance, ...],
        sizes: Mapping[str, SizePrior],
        view: View,
    ) -> Mapping[str, float]:
        """Return yaws as the model sees them."""
        return estimating.guess_rotations(self.chat, reference, instances, sizes, view)

    def guess_layout(
        self,
        reference: Reference,
        instances: tuple[Instance, ...],
        sizes: Mapping[str, SizePrior],
        view: View,
    ) -> Mapping[str, LayoutBox]:
        """Return places and sizes as the model sees them, none beyond the tabletop.

        Raises:
            BackendError: ``sizes`` has no table, or see ``plan_scene``.
        """
        if TABLE not in sizes:
            raise self.chat.server.failure("guess_layout", "the size of the table is not given.")
        return estimating.guess_layout(self.chat, reference, instances, sizes, view)
