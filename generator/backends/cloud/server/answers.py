"""Pydantic models of the answers to the questions; field names include units."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BaseModel, ConfigDict, Field

from ....scene import GroupKind, OutlineKind, RelationKind

Id = Annotated[int, Field(ge=0, le=999)]
MOST_ANSWERED = 1000
"""Maximum number of objects in an answer to a question about given objects."""

MOST_PLANNED = 40
"""Maximum number of objects in a plan, as in the embedded planner."""

MOST_SEATS = 12
"""Maximum number of place settings on a table."""


def _check_printable(word: str) -> str:
    if not word.isprintable():
        raise ValueError("contains characters that cannot be printed")
    return word


Word = Annotated[str, Field(min_length=1, max_length=60), AfterValidator(_check_printable)]
Centimetres = Annotated[float, Field(gt=0.05, le=600)]
Degrees = Annotated[float, Field(ge=-360, le=360)]
GridBox = Annotated[list[Annotated[float, Field(ge=0, le=1000)]], Field(min_length=4, max_length=4)]
Axis = Literal["+x", "-x", "+y", "-y", "+z", "-z"]


class ModelAnswer(BaseModel):
    """A model's answer: immutable, with finite numbers only; unexpected keys are ignored."""

    model_config = ConfigDict(extra="ignore", frozen=True, allow_inf_nan=False)


class RelationAnswer(ModelAnswer):
    """A relation to a ``target``, which is the number of an object, or 0 for the table."""

    kind: RelationKind
    target: Id


PlannedId = Annotated[int, Field(ge=1, le=200)]


class ThingAnswer(ModelAnswer):
    """One planned object. ``contents`` is a filling or a motif that is not a separate object."""

    id: PlannedId
    noun: Word
    color: Word | None
    accent: Word | None = None
    material: Word | None
    size_word: Literal["small", "medium", "large"] | None
    state: Word | None
    posture: Literal["upright", "lying", "upside down"] | None = None
    contents: Word | None = None
    size_cm: Annotated[list[Centimetres], Field(min_length=3, max_length=3)] | None
    relations: Annotated[list[RelationAnswer], Field(max_length=6)]


class SeatAnswer(ModelAnswer):
    """The seat of a place setting, counted from 1, and the total number of seats."""

    number: Annotated[int, Field(ge=1, le=MOST_SEATS)]
    count: Annotated[int, Field(ge=1, le=MOST_SEATS)]


class GroupAnswer(ModelAnswer):
    """An ordered group; only "setting" has a ``seat``, and only "circle" may have ``around``."""

    kind: GroupKind
    things: Annotated[list[PlannedId], Field(min_length=1, max_length=MOST_PLANNED)]
    around: PlannedId | None = None
    seat: SeatAnswer | None = None


class TableAnswer(ModelAnswer):
    """The planned table."""

    outline: OutlineKind
    material: Word
    color: Word | None
    legs: Literal["straight", "tapered", "splayed", "trestle", "pedestal", "hairpin", "metal"]
    length_cm: Annotated[float, Field(ge=30, le=400)]
    width_cm: Annotated[float, Field(ge=30, le=400)]
    height_cm: Annotated[float, Field(ge=20, le=130)]


class PlanAnswer(ModelAnswer):
    """The answer to ``plan_scene``."""

    table: TableAnswer
    style: Word
    things: Annotated[list[ThingAnswer], Field(min_length=1, max_length=MOST_PLANNED)]
    groups: Annotated[list[GroupAnswer], Field(max_length=20)] = []


class KindAnswer(ModelAnswer):
    """One kind of object."""

    noun: Word
    count: Annotated[int, Field(ge=1, le=60)]


class KindsAnswer(ModelAnswer):
    """The answer to ``list_objects``."""

    kinds: Annotated[list[KindAnswer], Field(min_length=1, max_length=60)]


class ViewAnswer(ModelAnswer):
    """The answer to ``estimate_view``, in degrees."""

    elevation: Annotated[float, Field(ge=5, le=90)]
    azimuth: Annotated[float, Field(ge=-45, le=45)]
    vertical_fov: Annotated[float, Field(ge=10, le=100)]


class SizeAnswer(ModelAnswer):
    """The size of one object in centimetres."""

    id: Id
    placement: Word
    length: Centimetres
    width: Centimetres
    height: Centimetres
    length_is: Word
    width_is: Word
    height_is: Word


class SizesAnswer(ModelAnswer):
    """The answer to ``estimate_sizes``."""

    sizes: Annotated[list[SizeAnswer], Field(max_length=MOST_ANSWERED)]


class OrientationAnswer(ModelAnswer):
    """The answer to ``review_orientation``: the model's vertical axis and lengthwise axis."""

    up: Axis
    along: Axis


class RestAnswer(ModelAnswer):
    """The support of one object."""

    id: Id
    how: Literal["on", "in"]
    support: Id
    leans_at: Id | None


class RestsAnswer(ModelAnswer):
    """The answer to ``stacking_order``."""

    things: Annotated[list[RestAnswer], Field(max_length=MOST_ANSWERED)]


class MarkAnswer(ModelAnswer):
    """The rating for one criterion."""

    criterion: Word
    why: Annotated[str, Field(max_length=4000)]
    mark: Annotated[float, Field(ge=1, le=7)]


class MarksAnswer(ModelAnswer):
    """The answer to ``rate``."""

    marks: Annotated[list[MarkAnswer], Field(max_length=MOST_ANSWERED)]


class OrderAnswer(ModelAnswer):
    """The answer to ``rank``: the letters of the methods, from best to worst."""

    order: Annotated[list[Word], Field(max_length=MOST_ANSWERED)]


class TurnAnswer(ModelAnswer):
    """The yaw of one object in degrees."""

    id: Id
    yaw: Degrees


class TurnsAnswer(ModelAnswer):
    """The answer to ``guess_rotations``."""

    turns: Annotated[list[TurnAnswer], Field(max_length=MOST_ANSWERED)]


class PlaceAnswer(ModelAnswer):
    """The position and size of one object in centimetres."""

    id: Id
    x: Annotated[float, Field(ge=-400, le=400)]
    y: Annotated[float, Field(ge=-400, le=400)]
    length: Centimetres
    width: Centimetres
    height: Centimetres


class PlacesAnswer(ModelAnswer):
    """The answer to ``guess_layout``."""

    places: Annotated[list[PlaceAnswer], Field(max_length=MOST_ANSWERED)]


class SightAnswer(ModelAnswer):
    """The positions of an object in a drawn top view, as boxes (x0, y0, x1, y1) on the grid."""

    id: Id
    boxes: Annotated[list[GridBox], Field(max_length=20)]
    covered: bool


class TopViewAnswer(ModelAnswer):
    """The answer to ``check_top_view``."""

    from_above: bool
    things: Annotated[list[SightAnswer], Field(max_length=MOST_ANSWERED)]
    extra: Annotated[list[Word], Field(max_length=40)]


_LIMITS = {"minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum", "minLength", "maxLength",
           "minItems", "maxItems", "title", "description", "default"}  # fmt: skip


def strict_schema(answer: type[ModelAnswer]) -> dict[str, Any]:
    """Return the JSON schema of an answer in the form that strict servers accept.

    All keys are required and no others are allowed. Limits on numbers and lengths are omitted,
    because not all servers support them: the prompts state them, and the answer is validated
    against them.
    """
    return _strict(answer.model_json_schema(), properties=False)


def _strict(part: Any, properties: bool) -> Any:
    if isinstance(part, list):
        return [_strict(p, False) for p in part]
    if not isinstance(part, dict):
        return part
    kept = {
        k: _strict(v, k in ("properties", "$defs"))
        for k, v in part.items()
        if properties or k not in _LIMITS
    }
    if not properties and kept.get("type") == "object":
        kept |= {"additionalProperties": False, "required": list(kept.get("properties", {}))}
    return kept
