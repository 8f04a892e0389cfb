"""The ``tabletopgen`` command; what it prints for ``--help`` is written in this package.

Only the command that runs is imported; a list of commands imports none.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from importlib.metadata import EntryPoint
from typing import Any

import tyro

from ..errors import InputError, TabletopError, escape, exit_code, require_known
from ..io.terminal import run_piped
from . import interrupts
from .plugins import OWN, find_commands, load, summary_of

DESCRIPTION = """Turn text or a photo of a tabletop into a MuJoCo scene and Gymnasium environments.

tabletopgen COMMAND --help tells more.

Exit codes: 0 done, 1 a check failed, 2 bad input or usage, 3 backend, 4 bundle, 5 storage, 6 scene,
130 interrupted.
"""

_COMPLETION = ("--tyro-print-completion", "--tyro-write-completion")


def commands() -> Mapping[str, EntryPoint]:
    """Return every command by name; this package's come first and cannot be shadowed."""
    others = find_commands()
    return {**OWN, **{name: entry for name, entry in others.items() if name not in OWN}}


def app(name: str) -> tyro.extras.SubcommandApp:
    """Return the command called ``name``, which is imported, and no other.

    An option in its place (``--help``), or nothing, gets all commands with one line about each,
    none of them imported; a request for shell completions gets them imported.

    Raises:
        InputError: no command is called so, or it cannot be loaded.
    """
    made = tyro.extras.SubcommandApp()
    if name and not name.startswith("-"):
        made.command(name=name)(load(_entry(name)))
        return made
    for known, entry in commands().items():
        summary = summary_of(entry)
        if summary is not None:
            listed: Any = load(entry) if name.startswith(_COMPLETION) else _stub(summary)
            made.command(listed, name=known, help=summary)
    return made


def _entry(name: str) -> EntryPoint:
    """Return where a command is defined; other packages' are looked up only if need be."""
    if name in OWN:
        return OWN[name]
    known = commands()
    require_known(name, known, "Unknown command")
    return known[name]


def _stub(summary: str) -> Callable[[], int]:
    """Return a command without arguments that a list of commands shows; it is never run."""

    def entry() -> int:
        raise InputError("The first word is a command; `tabletopgen --help` lists them.")

    entry.__doc__ = summary
    return entry


def _run(arguments: list[str]) -> Any:
    name = arguments[0] if arguments else ""
    if name and not name.startswith("-"):
        command = load(_entry(name))
        if isinstance(command, tyro.extras.SubcommandApp):
            return command.cli(
                prog=f"tabletopgen {name}", args=arguments[1:], use_underscores=False
            )
    return app(name).cli(
        prog="tabletopgen", description=DESCRIPTION, args=arguments, use_underscores=False
    )


def run(arguments: list[str]) -> int:
    """Run the command line; every expected error becomes one line, and an exit code is returned."""
    try:
        return _run(arguments) or 0
    except TabletopError as error:
        print(escape(f"error: {error}"), file=sys.stderr)
        return exit_code(error)
    except KeyboardInterrupt:
        ours = bool(arguments) and arguments[0] in OWN
        print("interrupted" + ("; nothing was published" if ours else ""), file=sys.stderr)
        return 130


def main() -> None:
    """Run the process's command line and end it with the exit code."""
    interrupts.heed()
    code = run_piped(lambda: run(sys.argv[1:]))
    interrupts.ignore()
    raise SystemExit(code)
