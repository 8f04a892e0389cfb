"""Questions about what a picture shows: kinds, camera, sizes, supports, and poses by eye."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ....geometry import wrap
from ....scene import TABLE, Instance, LayoutBox, Reference, SizePrior, Stacking, View
from ..prompts import prompt
from ..server.answers import (
    KindsAnswer,
    PlacesAnswer,
    RestAnswer,
    RestsAnswer,
    SizesAnswer,
    TurnsAnswer,
    ViewAnswer,
)
from ..server.reading import Wrong
from ..server.typed_question import Chat
from .labelled import Labelled

Instances = tuple[Instance, ...]


def list_objects(chat: Chat, reference: Reference) -> tuple[str, ...]:
    """Return "table" and the noun of each kind seen, as often as it is there."""
    plan = ""
    if reference.plan is not None:
        nouns = ", ".join(thing.noun for thing in reference.plan.objects)
        plan = (
            f"\nThe picture was drawn to show: {nouns}. Where one of these words fits what you "
            "see, use it; list no kind that is not there, and also what is there beside these."
        )
    return chat.ask(
        "list_objects", prompt("list_objects", plan=plan), (reference.image,), KindsAnswer, _kinds
    )


def _kinds(answer: KindsAnswer) -> tuple[str, ...]:
    nouns = [" ".join(kind.noun.lower().split()) for kind in answer.kinds]
    twice = sorted({n for n in nouns if nouns.count(n) > 1})
    if twice:
        raise Wrong(f"these kinds are listed twice: {', '.join(twice)}. Give each once.")
    counts = {n: k.count for n, k in zip(nouns, answer.kinds, strict=True) if n != TABLE}
    if not counts:
        raise Wrong("no kind of thing on the table is listed.")
    return (TABLE, *(noun for noun, count in counts.items() for _ in range(count)))


def estimate_view(chat: Chat, reference: Reference, table: Instance) -> View:
    """Return the camera; the field of view is the intrinsics' where they are known."""
    shown = Labelled.of(reference.image, (table,))
    intrinsics = reference.intrinsics
    height = reference.image.shape[0]

    def view(answer: ViewAnswer) -> View:
        fov = float(np.deg2rad(answer.vertical_fov))
        if intrinsics is not None:
            fov = 2 * float(np.arctan(height / 2 / intrinsics.fy))
        azimuth, elevation = np.deg2rad([answer.azimuth, answer.elevation])
        return View(float(azimuth), float(elevation), fov)

    text = prompt("estimate_view", listing=shown.listing())
    return chat.ask("estimate_view", text, (shown.picture(),), ViewAnswer, view)


def estimate_sizes(
    chat: Chat, reference: Reference, instances: Instances
) -> Mapping[str, SizePrior]:
    """Return each instance's size prior; sizes that a text fixed replace the model's."""
    shown = Labelled.of(reference.image, instances)
    fixed = {i.name: size for i in instances if (size := _fixed_size(reference, i)) is not None}
    numbers = shown.numbers
    sentences = [f"Number {numbers[n]} measures {_by(size)} cm." for n, size in fixed.items()]
    known = "\nThis is known: " + " ".join(sentences) if sentences else ""

    def sizes(answer: SizesAnswer) -> dict[str, SizePrior]:
        by_name = shown.match(answer.sizes)
        return {
            name: SizePrior(
                name,
                fixed.get(name, np.array([a.length, a.width, a.height]) / 100),
                a.placement,
                (a.length_is, a.width_is, a.height_is),
            )
            for name, a in by_name.items()
        }

    text = prompt("estimate_sizes", listing=shown.listing(), known=known)
    pictures = (np.asarray(reference.image), shown.picture())
    return chat.ask("estimate_sizes", text, pictures, SizesAnswer, sizes)


def _fixed_size(reference: Reference, instance: Instance) -> np.ndarray | None:
    """Return the size that a text fixed, metres."""
    if reference.plan is None:
        return None
    if instance.name == TABLE:
        return np.array(reference.plan.table.size)
    sizes = {t.size for t in reference.plan.objects if t.noun == instance.label}
    only = sizes.pop() if len(sizes) == 1 else None  # alike things of different sizes: look
    return None if only is None else np.array(only)


def stacking_order(
    chat: Chat, reference: Reference, instances: Instances
) -> Mapping[str, Stacking]:
    """Return what each thing rests on or in; what it leans at carries nothing."""
    shown = Labelled.of(reference.image, instances)

    def stacking(answer: RestsAnswer) -> dict[str, Stacking]:
        by_name = shown.match(answer.things, without=(0,))
        supports = {}
        for name, rest in by_name.items():
            _check_rest(rest, shown)
            below = shown.by_number[rest.support].name if rest.support else TABLE
            supports[name] = below, rest.how == "in"
        found = {TABLE: Stacking(1)}
        for name, (below, inside) in supports.items():
            found[name] = Stacking(_layer(name, supports), below, inside)
        return found

    text = prompt("stacking_order", listing=shown.listing())
    pictures = (np.asarray(reference.image), shown.picture())
    return chat.ask("stacking_order", text, pictures, RestsAnswer, stacking)


def _check_rest(rest: RestAnswer, shown: Labelled) -> None:
    for other in (rest.support, rest.leans_at or 0):
        if other and other not in shown.by_number:
            raise Wrong(f"thing {rest.id} rests on or leans at {other}, which is not in the list.")
        if other == rest.id:
            raise Wrong(f"thing {rest.id} rests on or leans at itself.")
    if rest.how == "in" and not rest.support:
        raise Wrong(f"thing {rest.id} is in the table; a thing on the table is on it.")


def _layer(name: str, supports: Mapping[str, tuple[str, bool]]) -> int:
    layer, seen = 2, [name]
    while (below := supports[seen[-1]][0]) != TABLE:
        if below in seen:
            raise Wrong(f"these rest on one another in a circle: {', '.join(seen)}.")
        seen.append(below)
        layer += 1
    return layer


# ------------------------------------------------------------------------------- poses by eye


def guess_rotations(
    chat: Chat,
    reference: Reference,
    instances: Instances,
    sizes: Mapping[str, SizePrior],
    view: View,
) -> Mapping[str, float]:
    """Return each thing's yaw, radians."""
    shown = Labelled.of(reference.image, instances, table=False)
    if not shown.by_number:
        return {}

    def yaws(answer: TurnsAnswer) -> dict[str, float]:
        by_name = shown.match(answer.turns, without=(0,))
        return {name: wrap(float(np.deg2rad(a.yaw))) for name, a in by_name.items()}

    text = prompt("guess_rotations", listing=_size_listing(shown, sizes), **_camera(view))
    pictures = (np.asarray(reference.image), shown.picture())
    return chat.ask("guess_rotations", text, pictures, TurnsAnswer, yaws)


def guess_layout(
    chat: Chat,
    reference: Reference,
    instances: Instances,
    sizes: Mapping[str, SizePrior],
    view: View,
) -> Mapping[str, LayoutBox]:
    """Return each thing's place on the tabletop and its size, metres."""
    shown = Labelled.of(reference.image, instances, table=False)
    if not shown.by_number:
        return {}
    length, width = 100 * sizes[TABLE].extent[:2]

    def layout(answer: PlacesAnswer) -> dict[str, LayoutBox]:
        by_name = shown.match(answer.places, without=(0,))
        beyond = [a.id for a in by_name.values() if abs(a.x) > length / 2 or abs(a.y) > width / 2]
        if beyond:
            numbers = ", ".join(map(str, beyond))
            raise Wrong(f"these lie beyond the edge of the tabletop: {numbers}.")
        return {
            name: LayoutBox(
                np.array([a.x, a.y]) / 100, np.array([a.length, a.width, a.height]) / 100
            )
            for name, a in by_name.items()
        }

    text = prompt(
        "guess_layout",
        listing=_size_listing(shown, sizes),
        length=f"{length:.0f}", width=f"{width:.0f}",
        half_length=f"{length / 2:.0f}", half_width=f"{width / 2:.0f}",
        **_camera(view),
    )  # fmt: skip
    pictures = (np.asarray(reference.image), shown.picture())
    return chat.ask("guess_layout", text, pictures, PlacesAnswer, layout)


def _size_listing(shown: Labelled, sizes: Mapping[str, SizePrior]) -> str:
    return shown.listing(lambda i: f"{_by(sizes[i.name].extent)} cm")


def _by(size: np.ndarray) -> str:
    return " by ".join(f"{100 * v:.3g}" for v in size)


def _camera(view: View) -> dict[str, str]:
    return {
        "elevation": f"{np.rad2deg(view.elevation):.0f}",
        "azimuth": f"{np.rad2deg(view.azimuth):.0f}",
    }
