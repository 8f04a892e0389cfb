"""The paper's reasoner: a multimodal chat model that answers typed questions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from string import ascii_uppercase

import numpy as np
from jaxtyping import UInt8

from ...calls.session import Session
from ...errors import InputError
from ...geometry import wrap
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
from ..protocols import Instances, Sizes
from .drawing.pictures import on_white
from .prompts import prompt as worded
from .questions import checks, plan_answer, plan_text, scene_answers
from .questions.labelled import Labelled
from .server import answers, configuration
from .server.client import Server
from .server.json_text import Wrong
from .server.typed_question import Chat, Manners

Picture = UInt8[np.ndarray, "_ _ 3"]


@dataclass(frozen=True)
class CloudReasoner:
    """A chat model that answers the questions of ``Reasoner``, ``Judge`` and ``PoseGuesser``.

    Attributes:
        base_url: an OpenAI-compatible server whose chat/completions endpoint accepts pictures.
        model: the model's id on that server.
        seed: sent with every question to servers that accept a seed.
        session: state that all calls of one generation share; not part of the identity.
    """

    base_url: str = field(default_factory=configuration.chat_base_url)
    model: str = field(default_factory=configuration.chat_model)
    seed: int = 0
    session: Session = field(default_factory=Session, repr=False, compare=False)
    manners: Manners = field(default_factory=Manners, repr=False, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "base_url", configuration.checked_url(self.base_url))

    def check(self) -> None:
        """Raise BudgetError if there is a budget and the model's price is unknown."""
        self.session.check_price(self.model, self.base_url, f"cloud, reasoner ({self.model})")

    @property
    def server(self) -> str:
        """The server's name: its provider's name, or the host and port."""
        return configuration.server_name(self.base_url)

    @property
    def chat(self) -> Chat:
        """The chat model with its server."""
        server = Server(self.base_url, self.model, "chat", self.session)
        return Chat(server, self.manners, self.seed)

    def plan_scene(self, prompt: str, seed: int) -> ScenePlan:
        """Expand a prompt into a plan; the seed varies what the prompt leaves open.

        Raises:
            InputError: the text is empty or too long.
            BackendError: the answer is not usable; the other questions raise this too.
        """
        text = worded("plan_scene", text=plan_answer.checked_text(prompt), seed=str(seed))

        def plan(answer: answers.PlanAnswer) -> ScenePlan:
            return plan_answer.to_plan(prompt, answer)

        return self.chat.ask("plan_scene", text, (), answers.PlanAnswer, plan)

    def list_objects(self, reference: Reference) -> tuple[str, ...]:
        """Return "table" and each visible kind's noun, repeated for each of its instances."""
        plan = ""
        if reference.plan is not None:
            nouns = ", ".join(thing.noun for thing in reference.plan.objects)
            plan = (
                f"\nThe picture was drawn to show: {nouns}. Where one of these words fits what you "
                "see, use it; list no kind that is not there, and also what is there beside these."
            )
        text = worded("list_objects", plan=plan)
        return self.chat.ask(
            "list_objects", text, (reference.image,), answers.KindsAnswer, scene_answers.kinds
        )

    def estimate_view(self, reference: Reference, table: Instance) -> View:
        """Return the model's estimate of the camera; known intrinsics fix the field of view."""
        shown = Labelled.of(reference.image, (table,))

        def view(answer: answers.ViewAnswer) -> View:
            fov = float(np.deg2rad(answer.vertical_fov))
            if reference.intrinsics is not None:
                half = reference.image.shape[0] / 2
                fov = 2 * float(np.arctan(half / reference.intrinsics.fy))
            azimuth, elevation = np.deg2rad([answer.azimuth, answer.elevation])
            return View(float(azimuth), float(elevation), fov)

        text = worded("estimate_view", listing=shown.listing())
        return self.chat.ask("estimate_view", text, (shown.picture(),), answers.ViewAnswer, view)

    def estimate_sizes(self, reference: Reference, instances: Instances, view: View) -> Sizes:
        """Return typical sizes, but keep those given in the prompt."""
        shown = Labelled.of(reference.image, instances)
        fixed = scene_answers.fixed_sizes(reference, instances)
        numbers = shown.numbers
        known = [f"Number {numbers[n]} measures {plan_text.in_cm(s)}." for n, s in fixed.items()]

        def sizes(answer: answers.SizesAnswer) -> Sizes:
            return {
                name: SizePrior(
                    name,
                    fixed.get(name, np.array([a.length, a.width, a.height]) / 100),
                    a.placement,
                    (a.length_is, a.width_is, a.height_is),
                )
                for name, a in shown.match(answer.sizes).items()
            }

        note = "\nThis is known: " + " ".join(known) if known else ""
        text = worded("estimate_sizes", listing=shown.listing(), known=note)
        return self.chat.ask("estimate_sizes", text, shown.pair(), answers.SizesAnswer, sizes)

    def review_orientation(
        self, mesh: Mesh, instance: Instance, size: SizePrior
    ) -> tuple[tuple[str, int], ...]:
        """Return the quarter turns that orient the model as the instance's picture shows it."""
        length, width, height = (f"{100 * v:.3g}" for v in size.extent)
        x, y, z = (f"{v:.2f}" for v in mesh.extent / mesh.extent.max())
        text = worded(
            "review_orientation",
            label=instance.label, placement=size.placement,
            length_axis=size.axes[0], width_axis=size.axes[1], height_axis=size.axes[2],
            length=length, width=width, height=height, x=x, y=y, z=z,
        )  # fmt: skip
        pictures = (on_white(instance.crop), checks.six_sides(mesh))
        return self.chat.ask(
            "review_orientation", text, pictures, answers.OrientationAnswer, checks.turns
        )

    def stacking_order(
        self, reference: Reference, instances: Instances, view: View
    ) -> Mapping[str, Stacking]:
        """Return each object's support and its layer, counted from the table up."""
        shown = Labelled.of(reference.image, instances)

        def stacking(answer: answers.RestsAnswer) -> Mapping[str, Stacking]:
            return scene_answers.stacking(answer, shown)

        text = worded("stacking_order", listing=shown.listing())
        return self.chat.ask("stacking_order", text, shown.pair(), answers.RestsAnswer, stacking)

    def rate(
        self, reference: Picture, pictures: tuple[Picture, ...], criteria: Mapping[str, str]
    ) -> Mapping[str, float]:
        """Return a chat model's rating of a scene for each criterion, from 1 to 7."""

        def marks(answer: answers.MarksAnswer) -> dict[str, float]:
            given = [m.criterion for m in answer.marks]
            if sorted(given) != sorted(criteria):
                raise Wrong(
                    f"each of {', '.join(criteria)} must have one mark, got marks for {given}."
                )
            return {m.criterion: m.mark for m in answer.marks}

        listed = "\n".join(f"- {key}: {meaning}" for key, meaning in criteria.items())
        text = worded("rate", count=str(len(pictures)), criteria=listed)
        return self.chat.ask("rate", text, (reference, *pictures), answers.MarksAnswer, marks)

    def rank(
        self, reference: Picture, methods: Mapping[str, tuple[Picture, ...]]
    ) -> tuple[str, ...]:
        """Return the methods from best to worst; the model sees letters instead of names.

        Raises:
            InputError: there are more methods than letters.
        """
        if len(methods) > len(ascii_uppercase):
            raise InputError(f"At most {len(ascii_uppercase)} methods can be ranked at once.")
        letters = dict(zip(ascii_uppercase, methods, strict=False))

        def order(answer: answers.OrderAnswer) -> tuple[str, ...]:
            given = [letter.strip().upper() for letter in answer.order]
            if sorted(given) != sorted(letters):
                raise Wrong(
                    f"the order must contain each of {', '.join(letters)} once, got {given}."
                )
            return tuple(letters[letter] for letter in given)

        lines = [f"{letter}: {len(methods[name])} pictures" for letter, name in letters.items()]
        pictures = [picture for shown in methods.values() for picture in shown]
        text = worded("rank", listing="\n".join(lines))
        return self.chat.ask("rank", text, (reference, *pictures), answers.OrderAnswer, order)

    def guess_rotations(
        self, reference: Reference, instances: Instances, sizes: Sizes, view: View
    ) -> Mapping[str, float]:
        """Return the model's estimate of each object's yaw."""
        shown = Labelled.of(reference.image, instances, table=False)
        if not shown.by_number:
            return {}

        def yaws(answer: answers.TurnsAnswer) -> dict[str, float]:
            by_name = shown.match(answer.turns, without=(0,))
            return {name: wrap(float(np.deg2rad(a.yaw))) for name, a in by_name.items()}

        known = scene_answers.pose_facts(shown, sizes, view)
        text = worded("guess_rotations", **known)
        return self.chat.ask("guess_rotations", text, shown.pair(), answers.TurnsAnswer, yaws)

    def guess_layout(
        self, reference: Reference, instances: Instances, sizes: Sizes, view: View
    ) -> Mapping[str, LayoutBox]:
        """Return the model's estimates of positions and sizes, all within the tabletop.

        Raises:
            BackendError: ``sizes`` has no table; see also ``plan_scene``.
        """
        if TABLE not in sizes:
            raise self.chat.server.failure("guess_layout", "the size of the table is missing.")
        shown = Labelled.of(reference.image, instances, table=False)
        if not shown.by_number:
            return {}
        length, width = 100 * sizes[TABLE].extent[:2]

        def layout(answer: answers.PlacesAnswer) -> dict[str, LayoutBox]:
            return scene_answers.layout(answer, shown, length, width)

        text = worded(
            "guess_layout",
            length=f"{length:.0f}", width=f"{width:.0f}",
            half_length=f"{length / 2:.0f}", half_width=f"{width / 2:.0f}",
            **scene_answers.pose_facts(shown, sizes, view),
        )  # fmt: skip
        return self.chat.ask("guess_layout", text, shown.pair(), answers.PlacesAnswer, layout)
