"""The command that changes finished scenes: ``edit``."""

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
"""How each action is put."""


@dataclass(frozen=True)
class MoveOptions:
    """Where a moved thing goes.

    Attributes:
        to: With move: x and y of the thing's centre in metres from the table's, +x right, +y away.
        turn: With move: degrees it turns, counter-clockwise seen from above.
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
    """Change one thing of a finished scene; what that does not disturb stays, to the byte.

    swap mug_1 "a teapot" · add "a red mug left of the laptop" · remove mug_1 · move mug_1 "behind
    the laptop" · move mug_1 --to 0.2 -0.1 --turn 90 · restyle cartoon mug_1

    The scene is settled and judged again; one that fails its gate is not published. The bundle
    edited stays, too. What is in a removed thing goes with it.

    Args:
        bundle: A bundle's name, digest, glob or path; `tabletopgen inspect` names its things.
        action: What is done.
        words: Name of the thing, what is asked for, or both. restyle takes plain, cartoon or
            low-poly, then names of things; all if none is named.
        target: Where a moved thing goes.
        out: Folder the new bundle goes into; the user cache if left out.
        replace: Put the new bundle in the place of the one edited, which is removed.
        seed: The same bundle, edit and seed give the same scene.
        mix: Who draws and models what is new; the catalogue if nobody is named. The roles left
            open are then embedded, unless --backend says otherwise.
        calls: What requests to servers may cost, and where responses are cached.
        json: Print one JSON object instead of text.
    """
    import assets_cache

    from ..editing.edits import WordedEdit

    require_seed(seed)
    path, folder = one(bundle), store(out)
    asked = WordedEdit(action, words, target.to, target.turn, seed)
    _check_form(asked)
    if replace:
        if out is not None:
            raise InputError("--replace puts the bundle where the old one is; leave out --out.")
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
            if calls.dry_run:  # it came to no call
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
        raise InputError(f"--to and --turn go with move, not with {asked.action}.")
    if not asked.is_complete:
        form = FORMS[asked.action]
        raise InputError(f"Say tabletopgen edit BUNDLE {form}; got {' '.join(asked.words)!r}.")
