"""The command that changes finished scenes: ``edit``."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import numpy as np
from tyro import conf
from tyro.conf import OmitArgPrefixes, Positional

from ..errors import DryRunError, InputError, require_seed
from . import paying
from .paying import NO_CALLS, NOBODY, Calls, Chosen
from .printing import print_scene, progress
from .store import one, store

if TYPE_CHECKING:
    from ..backends import Backends
    from ..editing import Edited

Action = Literal["swap", "add", "remove", "move", "restyle"]

_MOVES = 'move NAME "left of the laptop", or move NAME --to X Y, or move NAME --turn DEGREES'
FORMS: dict[Action, tuple[int, int, str]] = {
    "swap": (2, 2, 'swap NAME "a banjo"'),
    "add": (1, 1, 'add "a red mug left of the laptop"'),
    "remove": (1, 1, "remove NAME"),
    "move": (1, 2, _MOVES),
    "restyle": (1, 99, "restyle STYLE [NAME ...]"),
}
"""The fewest and the most words that each action is given, and what they are."""


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
    action: Positional[Action],
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
    """Change one thing of a finished scene; everything else stays as it is, to the byte.

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

    require_seed(seed)
    path, folder = one(bundle), store(out)
    _check_form(action, words, target)
    if replace:
        if out is not None:
            raise InputError("--replace puts the bundle where the old one is; leave out --out.")
        assets_cache.check_removable(path, path.parent)
    session = calls.session()
    chosen = mix.select(session) if mix.given else None
    who = None if chosen is None else chosen.identity()
    scene = paying.scene_key("edit", path.name, action, words, target.to, target.turn, seed, who)
    try:
        with paying.answering(session, scene), progress(quiet=json) as shown:
            if shown is not None:
                shown(action, 1, 1)
            edited = _edit(path, action, words, target, seed, chosen)
            if calls.dry_run:  # it came to no call
                raise DryRunError("")
            made = edited.save(path.parent if replace else folder)
    except DryRunError as error:
        return paying.print_dry_run(error, json, mix, chosen)
    paying.save_ledger(session, made)
    if replace and made.resolve() != path.resolve():
        assets_cache.remove(path, path.parent)
    return print_scene(made, edited.scene, json, session=session)


def _check_form(action: Action, words: tuple[str, ...], target: MoveOptions) -> None:
    fewest, most, form = FORMS[action]
    fits = fewest <= len(words) <= most
    if action == "move":
        ways = (len(words) == 2) + (target.to is not None)
        fits = fits and (ways == 1 or (ways == 0 and target.turn is not None))
    elif target != _MOVE:
        raise InputError(f"--to and --turn go with move, not with {action}.")
    if not fits:
        raise InputError(f"Say tabletopgen edit BUNDLE {form}; got {' '.join(words)!r}.")


def _edit(
    path: Path,
    action: Action,
    words: tuple[str, ...],
    target: MoveOptions,
    seed: int,
    backends: Backends | None,
) -> Edited:
    from .. import editing

    if action == "swap":
        return editing.swap(path, words[0], words[1], seed, backends)
    if action == "add":
        return editing.add(path, words[0], seed, backends)
    if action == "remove":
        return editing.remove(path, words[0])
    if action == "move":
        where = words[1] if len(words) == 2 else target.to
        yaw = 0.0 if target.turn is None else float(np.deg2rad(target.turn))
        return editing.move(path, words[0], where, yaw, seed, backends)
    return editing.restyle(path, words[0], words[1:], seed, backends)
