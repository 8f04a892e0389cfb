"""Banks of scenes for a batch: one model that fits all scenes, and one row of fields per scene."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float

from generator.errors import InputError, SceneError, require_known, require_number

from ...robot.panda import Panda
from ...world.world import World
from .union.content import SceneContent
from .union.look_union import LookUnion
from .union.shape import UnionShape
from .union.simplification import MOST_PARTS, cap_world
from .union.slot_union import MODEL_FIELDS, START_FIELDS, Row, SlotUnion

MOST_OBJECTS = 8
"""Default maximum number of objects per scene. Every world has room for the largest scene, at the
cost of time and memory.
"""


@dataclass(frozen=True)
class LeftOut:
    """A scene excluded from a bank: its index in the input, its name and the reason."""

    source: int
    name: str
    reason: str


@dataclass(frozen=True, eq=False)
class _Placed:
    """A scene of a bank, and the slot of each of its objects."""

    source: int
    content: SceneContent
    slots: tuple[int, ...]


class SceneBank:
    """Scenes that a ``BatchWorld`` can load, each in its robot's base frame.

    The first axis of every array is the scene (n); the second axis of per-object arrays is the slot
    (s). The worlds are only read, and no reference to them is kept.

    Attributes:
        union: the model that fits all scenes.
        scenes: names of the scenes.
        sources: index of each scene in ``worlds``.
        left_out: the excluded scenes, with reasons.
        objects: name of each slot's object, None for an empty slot.
        rows: the batched fields; see ``slot_union.Row``.
        filled: whether each slot holds an object.
        half_extent: half extents of the box of each slot's object, zeros for an empty slot, metres.
        table: height of the table top above the base, and half extents of its outline, the longer
            first, metres.
        yaw: yaw of the base in the scene's world frame, radians.
        looks: the model for rendering, None without pictures.

    Args:
        worlds: compiled scenes.
        max_objects: scenes with more objects are left out.
        max_parts: maximum number of convex parts per object. Parts of objects with more are merged,
            and the scene is checked again by the physical gate, which takes about a second; a scene
            that fails is left out. None keeps all parts.
        shape: shape of the union model, taken from the bank that this one will replace; scenes that
            do not fit it are left out. None selects a shape that fits all scenes.
        robot: the robot of the worlds; None for ``Panda()``.
        pictures: whether to prepare the scenes for rendering.

    Raises:
        InputError: no scene is left, a limit is out of range, or a world has a different robot.
    """

    def __init__(
        self,
        worlds: Iterable[World],
        *,
        max_objects: int = MOST_OBJECTS,
        max_parts: int | None = MOST_PARTS,
        shape: UnionShape | None = None,
        robot: Panda | None = None,
        pictures: bool = False,
    ) -> None:
        require_number("max_objects", max_objects, minimum=1, integer=True)
        if max_parts is not None:
            require_number("max_parts", max_parts, minimum=1, integer=True)
        robot = robot or Panda()
        contents, left_out = _read(worlds, max_objects, max_parts, robot, pictures)
        if shape is None and contents:
            shape = UnionShape.around([*contents.values()])
        placed = list(_place(contents, shape)) if shape else []
        left_out += _unfit(contents, placed)
        self.left_out = tuple(sorted(left_out, key=lambda scene: scene.source))
        if not placed or shape is None:
            raise InputError(_nothing_left(self.left_out))
        hulls = {name: hull for s in placed for name, hull in s.content.hulls.items()}
        self.union = SlotUnion(shape, hulls, robot)
        self.scenes = tuple(scene.content.name for scene in placed)
        self.sources = tuple(scene.source for scene in placed)
        self.objects = tuple(_names(scene, len(shape.slots)) for scene in placed)
        self.rows = _stack([self.union.row(scene.content, scene.slots) for scene in placed])
        self.filled: Bool[np.ndarray, "n s"] = np.array(
            [[name is not None for name in names] for names in self.objects]
        )
        self.half_extent: Float[np.ndarray, "n s 3"] = np.zeros((*self.filled.shape, 3))
        for k, scene in enumerate(placed):
            extents = [thing.half_extent for thing in scene.content.objects]
            self.half_extent[k, list(scene.slots)] = np.reshape(extents, (-1, 3))
        self.table: Float[np.ndarray, "n 3"] = np.stack([s.content.table for s in placed])
        self.yaw: Float[np.ndarray, "n"] = np.array([s.content.yaw for s in placed])
        looks = [s.content.look for s in placed if s.content.look is not None]
        slots = [s.slots for s in placed]
        self.looks = LookUnion(self.union, looks, slots) if pictures else None

    def __len__(self) -> int:
        return len(self.scenes)

    @property
    def slots(self) -> int:
        """The number of slots of every world."""
        return len(self.union.shape.slots)

    def slot(self, scene: int, name: str) -> int:
        """Return the slot of the object ``name`` in the scene with index ``scene``.

        Raises:
            InputError: the scene has no such object.
        """
        there = [o for o in self.objects[scene] if o is not None]
        require_known(name, there, f"Scene {self.scenes[scene]!r} has no object")
        return self.objects[scene].index(name)


def _read(
    worlds: Iterable[World], most_objects: int, most_parts: int | None, robot: Panda, looks: bool
) -> tuple[dict[int, SceneContent], list[LeftOut]]:
    """Return the scenes within the limits, by index in ``worlds``, and the excluded scenes."""
    contents: dict[int, SceneContent] = {}
    left_out: list[LeftOut] = []
    for k, world in enumerate(worlds):
        name, count = world.scene.name, len(world.names)
        if count > most_objects:
            reason = f"the scene has {count} objects, but max_objects is {most_objects}"
            left_out.append(LeftOut(k, name, reason))
            continue
        try:
            within = world if most_parts is None else cap_world(world, most_parts, robot)
        except SceneError as error:
            left_out.append(LeftOut(k, name, str(error)))
        else:
            contents[k] = SceneContent.of(within, looks)
    return contents, left_out


def _unfit(contents: dict[int, SceneContent], placed: list[_Placed]) -> list[LeftOut]:
    """Return the scenes that do not fit the given shape, each with the reason."""
    reason = "the scene has more objects or collision parts than the given shape has room for"
    unfit = contents.keys() - {scene.source for scene in placed}
    return [LeftOut(k, contents[k].name, reason) for k in unfit]


def _place(contents: dict[int, SceneContent], shape: UnionShape) -> Iterator[_Placed]:
    """Yield the scenes that fit ``shape``, with the slots of their objects."""
    for source, content in contents.items():
        if (slots := shape.assign(content)) is not None:
            yield _Placed(source, content, slots)


def _names(scene: _Placed, slots: int) -> tuple[str | None, ...]:
    names: list[str | None] = [None] * slots
    for thing, slot in zip(scene.content.objects, scene.slots, strict=True):
        names[slot] = thing.name
    return tuple(names)


def _stack(rows: list[Row]) -> Row:
    """Stack the rows into arrays with the scene as the first axis, in MuJoCo Warp's precision."""
    stacked = {}
    for field in (*MODEL_FIELDS, *START_FIELDS):
        array = np.stack([row[field] for row in rows])
        stacked[field] = array.astype(np.int32 if array.dtype.kind == "i" else np.float32)
    return stacked


def _nothing_left(left_out: tuple[LeftOut, ...]) -> str:
    if not left_out:
        return "A SceneBank must have at least one world, got none."
    some = "; ".join(f"{scene.name!r}: {scene.reason}" for scene in left_out[:3])
    more = f"; and {len(left_out) - 3} more" if len(left_out) > 3 else ""
    return (
        f"None of the {len(left_out)} scenes fits the bank ({some}{more}). Use scenes with "
        "fewer objects, or raise max_objects."
    )
