"""The ``tabletopgen`` command; what it prints for ``--help`` is written in this package."""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

import tyro

from ..errors import InputError, TabletopError, escape, exit_code
from ..io.terminal import run_piped
from . import batching, cache, editing, evaluating, interrupts, looking, making, models
from .machine.command import doctor
from .plugins import find_commands, load, purpose_of

DESCRIPTION = """Turn text or a photo of a tabletop into a MuJoCo scene and Gymnasium environments.

tabletopgen COMMAND --help tells more.

Exit codes: 0 done, 1 a check failed, 2 bad input or usage, 3 backend, 4 bundle, 5 storage, 6 scene,
130 interrupted.
"""

GROUPS: Mapping[str, tuple[tyro.extras.SubcommandApp, str]] = MappingProxyType({
    "cache": (cache.app, "List, check and remove bundles of the store."),
    "models": (models.app, "List and fetch the open models."),
})  # fmt: skip
"""Commands with commands of their own, and what they are for."""

COMMANDS: tuple[Callable[..., int], ...] = (
    making.generate, making.compose, making.import_, batching.batch, editing.edit,
    looking.explain, looking.inspect, looking.verify, looking.view, looking.compare,
    looking.export, evaluating.evaluate, doctor,
)  # fmt: skip


def app(name: str) -> tyro.extras.SubcommandApp:
    """Return the commands: this package's, and of the others the one called ``name``.

    If nothing is called so, as with ``--help``, they are all there, each with one line about it.

    Raises:
        InputError: the one called ``name`` cannot be loaded.
    """
    made = tyro.extras.SubcommandApp()
    own = {command.__name__: command for command in COMMANDS}
    others = {} if name in own else find_commands()
    found: dict[str, Callable[..., Any]] = dict(own)
    for entry in [others[name]] if name in others else others.values():
        if entry.name not in own.keys() | GROUPS.keys():
            command = load(entry, entry.name == name)
            if isinstance(command, tyro.extras.SubcommandApp):
                command = _entry(entry.name, purpose_of(entry))
            found |= {entry.name: command} if command else {}
    for known, command in found.items():
        made.command(name=known)(command if name in found else _brief(command))
    for group, (_, purpose) in GROUPS.items():
        made.command(name=group)(_entry(group, purpose))
    return made


def _brief(command: Callable[..., Any]) -> Callable[..., Any]:
    """Return a command of which a list of commands shows one line."""

    @functools.wraps(command)
    def brief(*args: Any, **settings: Any) -> Any:
        return command(*args, **settings)

    brief.__doc__ = (command.__doc__ or "").partition("\n\n")[0]
    return brief


def _entry(group: str, purpose: str) -> Callable[[], int]:
    """Return what a list of commands shows of a group; ``run`` has its commands run."""

    def entry() -> int:
        raise InputError(f"tabletopgen {group} needs one of its commands; see --help.")

    entry.__doc__ = purpose
    return entry


def _group(name: str) -> tyro.extras.SubcommandApp | None:
    """Return the commands of a group, this package's or another's; None if there is no such group.

    Raises:
        InputError: another package's cannot be loaded.
    """
    if name in GROUPS:
        return GROUPS[name][0]
    own = {command.__name__ for command in COMMANDS}
    others = {} if name in own else find_commands()
    found = load(others[name], True) if name in others else None
    return found if isinstance(found, tyro.extras.SubcommandApp) else None


def run(arguments: list[str]) -> int:
    """Run the command line; every expected error becomes one line, and an exit code is returned."""
    name = arguments[0] if arguments else ""
    try:
        if group := _group(name):
            return group.cli(prog=f"tabletopgen {name}", args=arguments[1:], use_underscores=False)
        code = app(name).cli(
            prog="tabletopgen", description=DESCRIPTION, args=arguments, use_underscores=False
        )
    except TabletopError as error:
        print(escape(f"error: {error}"), file=sys.stderr)
        return exit_code(error)
    except KeyboardInterrupt:
        ours = name in {command.__name__ for command in COMMANDS}
        print("interrupted" + ("; nothing was published" if ours else ""), file=sys.stderr)
        return 130
    return code or 0


def main() -> None:
    """Run the process's command line and end it with the exit code."""
    interrupts.heed()
    code = run_piped(lambda: run(sys.argv[1:]))
    interrupts.ignore()
    raise SystemExit(code)
