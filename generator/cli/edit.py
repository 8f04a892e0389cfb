"""The ``edit`` command, which changes finished scenes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated

from tyro import conf
from tyro.conf import OmitArgPrefixes, Positional

from ..backends.paid_run import save_ledger, scene_key
from ..errors import DryRunError, InputError, require_seed
from ..scene import EditKind
from . import paid_options
from .output import one, print_scene, progress, store
from .paid_options import NO_CALLS, NOBODY, Calls, Chosen

if TYPE_CHECKING:
    from ..editing.edits import WordedEdit

FORMS: Mapping[EditKind, str] = MappingProxyType({
    "swap": 'swap NAME "a banjo"',
    "add": 'add "a red mug left of the laptop"',
    "remove": "remove NAME",
    "move": 'move NAME "left of the laptop", or move NAME --to X Y, or move NAME --turn DEGREES',
    "restyle": "restyle STYLE [NAME ...]",
})  # fmt: skip
"""The syntax of each action."""


@dataclass(frozen=True)
class MoveOptions:
    """Where to move an object.

    Attributes:
        to: With move: new x and y of the object's centre in metres from the table's centre, +x
            right, +y away from the viewer.
        turn: With move: rotation in degrees, counter-clockwise seen from above.
    """

    to: tuple[float, float] | None = None
    turn: float | None = None


_MOVE = MoveOptions()


def edit(
    bundle: Annotated[Positional[str], conf.arg(metavar="BUNDLE")],
    action: Positional[EditKind],
    words: Annotated[Positional[tuple[str, ...]], conf.arg(metavar="[NAME] [WORDS]")],
    /,
    *,
    target: OmitArgPrefixes[MoveOptions] = _MOVE,
    out: Path | None = None,
    replace: bool = False,
    seed: int = 0,
    mix: Chosen = NOBODY,
    calls: Calls = NO_CALLS,
    json: bool = False,
) -> int:
    """Change one object of a finished scene; unaffected objects stay identical to the byte.

    swap mug_1 "a teapot" · add "a red mug left of the laptop" · remove mug_1 · move mug_1 "behind
    the laptop" · move mug_1 --to 0.2 -0.1 --turn 90 · restyle cartoon mug_1

    The scene is settled and checked again; a scene that fails its gate is not published. The
    original bundle is kept. Removing a container also removes its contents.

    Args:
        bundle: A bundle's name, digest, glob pattern or path; `tabletopgen inspect` lists its
            objects.
        action: The change to make.
        words: An object's name, a description, or both. restyle takes plain, cartoon or low-poly,
            then the names of objects; all objects if none are given.
        target: Where to move an object.
        out: Folder for the new bundle; defaults to the user cache.
        replace: Replace the edited bundle, which is removed.
        seed: The same bundle, edit and seed give the same scene.
        mix: Backends that draw and model new objects; the catalogue if none are given. Roles that
            are not set are then embedded, unless --backend is given.
        calls: Cost limit of server requests, and the cache of their responses.
        json: Print a JSON object instead of text.
    """
    import assets_cache

    from ..editing.edits import WordedEdit

    require_seed(seed)
    path, folder = one(bundle), store(out)
    asked = WordedEdit(action, words, target.to, target.turn, seed)
    _check_form(asked)
    if replace:
        if out is not None:
            raise InputError(
                "--replace puts the new bundle in the place of the old one; remove --out."
            )
        assets_cache.check_removable(path, path.parent)
    session = calls.session()
    chosen = mix.select(session) if mix.given else None
    who = None if chosen is None else chosen.identity()
    scene = scene_key("edit", path.name, action, words, target.to, target.turn, seed, who)
    try:
        with paid_options.answering(session, scene), progress(quiet=json) as shown:
            if shown is not None:
                shown(action, 1, 1)
            edited = asked.apply(path, chosen)
            if calls.dry_run:  # no call was needed
                raise DryRunError("")
            made = edited.save(path.parent if replace else folder)
    except DryRunError as error:
        return paid_options.print_dry_run(error, json, mix, chosen)
    save_ledger(session, made)
    if replace and made.resolve() != path.resolve():
        assets_cache.remove(path, path.parent)
    return print_scene(made, edited.scene, json, session=session)


def _check_form(asked: WordedEdit) -> None:
    if asked.action != "move" and not (asked.to is None and asked.turn is None):
        raise InputError(f"--to and --turn require the action move, not {asked.action}.")
    if not asked.is_complete:
        form = FORMS[asked.action]
        raise InputError(f"Use tabletopgen edit BUNDLE {form}; got {' '.join(asked.words)!r}.")
