"""The five edits of a finished scene; each takes a bundle and returns the edited scene."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from ..backends import Backends
from ..errors import InputError, SceneError, require_seed
from ..generation import Config
from ..language.planner import plan_scene
from ..method.assembly import body
from ..method.publish import without
from ..scene import (
    TABLE,
    Edit,
    EditKind,
    Model,
    Object,
    Placement,
    PlannedObject,
    Relation,
    Scene,
    held_relations,
)
from ..scene.provenance import plain, versions
from . import plans
from .attempts import settle_again, try_places
from .edited import Edited, Opened
from .models import check_known, check_style, make, remodel
from .placement import beneath, loads, moved_by, moved_to, place_by_relations, pose, set_down
from .request import Planner, as_planned, understand, whereabouts

ATTEMPTS = 4
"""Number of positions to try."""

ASIDE = 0.02
"""Displacement, in metres, above which a warning says that the exact position was not free."""

LONG = 1.3
"""Ratio of length to width above which an object has a visible lengthwise direction."""


def swap(
    bundle: str | Path,
    name: str,
    text: str,
    seed: int = 0,
    backends: Backends | None = None,
    config: Config | None = None,
) -> Edited:
    """Replace an object with another one (Fig. 7): ``swap(bundle, "ukulele_1", "a banjo")``.

    The new object has its usual size, and the old object's yaw if both are long. If there is no
    room for it in the same place, it is put at the nearest free position, with a warning. Objects
    on or in the old object are set down on or in the new one. ``backends`` draw and model the new
    object; if None, it comes from the catalogue. The same bundle, edit and seed give the same
    scene.

    Raises:
        InputError: The scene has no such object, or the text does not name a known object.
        BackendError: A backend failed.
        SceneError: There is no room, an object loses its support, or the gate fails.
        BundleError: The bundle is damaged.
    """
    require_seed(seed)
    opened, config = Opened.read(bundle), config or Config()
    scene, old = opened.scene, opened.thing(name)
    asked = understand(scene, text, _planner(backends), seed)
    if asked.planned.relations:
        raise InputError(
            f"{text!r} contains a position, but the new object takes the position of {name}. "
            "Describe the object only, and move it afterwards."
        )
    support = old.placement.on
    kind = "in" if old.placement.inside else "on"
    relations = (Relation(kind, support),) if support != TABLE else ()
    planned = replace(asked.planned, relations=relations)
    made = make(planned, asked.style, beneath(scene, planned, (name,)), backends, config, seed)
    inside = [o.name for o in scene.objects if o.placement.on == name and o.placement.inside]
    if inside and not made.model.container:
        raise SceneError(
            f"{name} contains {', '.join(inside)}, but {asked.planned.noun} cannot hold objects. "
            "Move or remove the contents first, or choose a container."
        )
    yaw = _facing(old, made.model.size, made.yaw)
    new = _body(planned.name, made.model, old, yaw)
    wanted = _exchange(scene, name, new)
    arranged = set_down(wanted, [new.name])
    done = settle_again(scene, wanted, arranged, [new.name], config)
    took = replace(asked.planned, relations=held_relations(scene, name))
    done = plans.swap_in_plan(done, name, took)
    edit = _edit(opened, "swap", (name, new.name), text, seed, backends, config)
    messages = (f"{new.name} replaces {name}.", *_aside(wanted, done, new.name))
    return Edited.of(opened, done, edit, asked.warnings + messages)


def add(
    bundle: str | Path,
    text: str,
    seed: int = 0,
    backends: Backends | None = None,
    config: Config | None = None,
) -> Edited:
    """Add an object to the table: ``add(bundle, "a red mug left of the laptop")``.

    The text may include a position. It must refer to the scene's objects by their nouns, or by
    their names if several are alike. For the seed and the backends see ``swap``.

    Raises:
        InputError: The text does not name a known object, or refers to one that is not in the
            scene.
        BackendError, SceneError, BundleError: As for ``swap``.
    """
    require_seed(seed)
    opened, config = Opened.read(bundle), config or Config()
    scene = opened.scene
    asked = understand(scene, text, _planner(backends), seed)
    planned = asked.planned
    made = make(planned, asked.style, beneath(scene, planned), backends, config, seed)

    def place(attempt: int) -> Scene:
        placement = place_by_relations(scene, planned, made.model, made.yaw, (), seed + attempt)
        new = body(made.model, placement)
        return scene.replace(objects=(*scene.objects, new))

    done = try_places(scene, place, planned.name, [planned.name], config, attempts=ATTEMPTS)
    done = plans.add_to_plan(done, planned)
    edit = _edit(opened, "add", (planned.name,), text, seed, backends, config)
    return Edited.of(opened, done, edit, asked.warnings)


def remove(bundle: str | Path, name: str, config: Config | None = None) -> Edited:
    """Remove an object with its contents; objects on it are set down on its support.

    Raises:
        InputError: The scene has no such object.
        SceneError: It is the last object, or the remaining scene fails the gate.
        BundleError: The bundle is damaged.
    """
    opened, config = Opened.read(bundle), config or Config()
    scene = opened.scene
    opened.thing(name)
    left = {p.name: p for p in without([o.placement for o in scene.objects], name)}
    if not left:
        raise SceneError(f"{name} is the last object on the table; a scene needs at least one.")
    gone = tuple(o.name for o in scene.objects if o.name not in left)
    loose = [o.name for o in scene.objects if o.name in left and o.placement.on in gone]
    kept = [replace(o, placement=left[o.name]) for o in scene.objects if o.name in left]
    wanted = scene.replace(objects=tuple(kept))
    done = settle_again(scene, wanted, set_down(wanted, loose), (), config, loose)
    done = plans.remove_from_plan(done, gone)
    messages = tuple(f"{n} was removed with {name}." for n in gone if n != name)
    messages += tuple(f"{n} was set down because {name} was removed." for n in loose)
    edit = _edit(opened, "remove", (name, *(n for n in gone if n != name)), name, 0, None, config)
    return Edited.of(opened, done, edit, messages)


def move(
    bundle: str | Path,
    name: str,
    where: str | tuple[float, float] | None = None,
    turn: float = 0.0,
    seed: int = 0,
    backends: Backends | None = None,
    config: Config | None = None,
) -> Edited:
    """Move an object, together with the objects on and in it.

    ``where`` is a description ("left of the laptop", "on book_2"), or x and y of the object's
    centre in metres relative to the table's centre, with +x right and +y away. If it is None, the
    object is turned in place. ``turn`` is in radians, counter-clockwise seen from above. The
    reasoner of ``backends``, or the embedded one, interprets the description; ``seed`` selects
    among possible positions.

    Raises:
        InputError: The scene has no such object, or there is no valid position.
        BackendError: A backend failed.
        SceneError: The position is occupied or off the table, or the gate fails.
        BundleError: The bundle is damaged.
    """
    require_seed(seed)
    opened, config = Opened.read(bundle), config or Config()
    scene, thing = opened.scene, opened.thing(name)
    _check_move(where, turn)
    messages: tuple[str, ...] = ()
    planned = PlannedObject(name, thing.label, thing.model.category)
    if isinstance(where, str):
        heard = whereabouts(scene, thing, where, _planner(backends), seed)
        planned, messages = heard.planned, heard.warnings
    above = loads(scene, name)
    under = sorted({r.target for r in planned.relations} & {name, *above})
    if under:
        raise InputError(f"{name} cannot be placed relative to {under[0]}, which moves with it.")

    def place(attempt: int) -> Scene:
        if not isinstance(where, str):
            return moved_to(scene, thing, where, turn)
        model = replace(thing.model, size=thing.scale)
        yaw = thing.placement.yaw + turn
        place = place_by_relations(scene, planned, model, yaw, (name, *above), seed + attempt)
        return moved_by(scene, thing, place)

    attempts = ATTEMPTS if isinstance(where, str) else 1
    done = try_places(scene, place, name, (), config, (name, *above), attempts)
    done = plans.move_in_plan(done, name, planned.relations)
    asked = where if isinstance(where, str) else _metres(where, turn)
    edit = _edit(opened, "move", (name, *above), asked, seed, backends, config)
    return Edited.of(opened, done, edit, messages)


def restyle(
    bundle: str | Path,
    style: str,
    names: Sequence[str] = (),
    seed: int = 0,
    backends: Backends | None = None,
    config: Config | None = None,
) -> Edited:
    """Rebuild some or all objects in another style, with the same sizes and positions.

    The style is "plain", "cartoon" or "low-poly" or, with backends, any word that they understand.
    The table is unchanged. For the seed and the backends see ``swap``.

    Raises:
        InputError: The style or an object does not exist, or the catalogue lacks an object.
        BackendError, SceneError, BundleError: As for ``swap``.
    """
    require_seed(seed)
    opened, config = Opened.read(bundle), config or Config()
    scene = opened.scene
    chosen = list(dict.fromkeys(opened.thing(n).name for n in names))
    chosen = chosen or [o.name for o in scene.objects]
    planned = {n: as_planned(scene, scene.object(n)) for n in chosen}
    if backends is None:
        check_style(style)
        for thing in planned.values():
            check_known(thing)
    models = {n: remodel(scene, p, style, backends, config, seed) for n, p in planned.items()}
    wanted = scene.replace(objects=tuple(
        _body(o.name, models[o.name], o, o.placement.yaw) if o.name in models else o
        for o in scene.objects
    ))  # fmt: skip
    done = settle_again(scene, wanted, set_down(wanted, chosen), chosen, config)
    edit = _edit(opened, "restyle", tuple(chosen), style, seed, backends, config)
    messages = tuple(w for n in chosen for w in _aside(wanted, done, n))
    return Edited.of(opened, plans.restyle_plan(done, chosen, style), edit, messages)


# ------------------------------------------------------------------------------------------ parts


def _planner(backends: Backends | None) -> Planner:
    return plan_scene if backends is None else backends.reasoner.plan_scene


def _edit(
    opened: Opened,
    kind: EditKind,
    names: tuple[str, ...],
    asked: str,
    seed: int,
    backends: Backends | None,
    config: Config,
) -> Edit:
    makers = {} if backends is None else backends.identity()
    return Edit(opened.sha256, kind, names, asked, seed, makers, plain(config), versions())


def _body(name: str, model: Model, old: Object, yaw: float) -> Object:
    """Return a model as an upright body with the position and support of ``old``."""
    x, y, z = old.pose.position
    bottom = z - old.scale[2] / 2
    center = np.array([x, y, bottom + model.size[2] / 2])
    below = old.placement
    return body(model, Placement(name, yaw, center, model.size, below.on, below.inside))


def _facing(old: Object, size: np.ndarray, natural: float) -> float:
    """Return a replacement's yaw: that of ``old`` if both are long, otherwise its natural yaw."""
    was, now = np.log(old.scale[0] / old.scale[1]), np.log(size[0] / size[1])
    if min(abs(was), abs(now)) < np.log(LONG):
        return natural
    yaw = old.placement.yaw + (np.pi / 2 if was * now < 0 else 0.0)
    return float(min((yaw, yaw + np.pi), key=lambda a: -np.cos(a - natural)))


def _exchange(scene: Scene, name: str, new: Object) -> Scene:
    """Return the scene with one object replaced, and those on or in it moved to the new one."""

    def exchange(thing: Object) -> Object:
        if thing.name == name:
            return new
        if thing.placement.on != name:
            return thing
        there = replace(thing.placement, on=new.name)
        if not there.inside:
            return replace(thing, placement=there)
        middle = np.array([*new.pose.position[:2], thing.pose.position[2]])  # starts upright
        return pose(thing, replace(there, translation=middle))

    return scene.replace(objects=tuple(map(exchange, scene.objects)))


def _check_move(where: object, turn: float) -> None:
    place = () if where is None or isinstance(where, str) else np.asarray(where, float)
    if len(place) not in (0, 2) or not np.isfinite([*place, turn]).all():
        raise InputError(
            "A position must be two finite numbers x and y in metres, or a description in words, "
            f"and a turn must be finite; got {where!r} and {turn!r}."
        )
    if where is None and turn == 0:
        raise InputError(
            "Specify a position, as a description or in metres, or an angle to turn by."
        )


def _aside(wanted: Scene, done: Scene, name: str) -> tuple[str, ...]:
    """Return a warning if an object could not be placed where it was requested."""
    places = [s.object(name).pose.position[:2] for s in (wanted, done)]
    aside = float(np.linalg.norm(places[1] - places[0]))
    message = (
        f"{name} was placed {100 * aside:.0f} cm away, at the nearest position with room for it."
    )
    return (message,) if aside >= ASIDE else ()


def _metres(where: tuple[float, float] | None, turn: float) -> str:
    place = "" if where is None else f"to {where[0]:g} {where[1]:g} m"
    yaw = f"turned by {np.rad2deg(turn):g} deg" if turn else ""
    return " ".join(word for word in (place, yaw) if word)
