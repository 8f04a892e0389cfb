"""The ``tabletopgen`` command; the modules of this package contain its ``--help`` texts.

Only the command that runs is imported; listing the commands imports none.
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

DESCRIPTION = (
    "Turn text or a photo of a tabletop into a MuJoCo scene and Gymnasium environments.\n\nSee "
    "tabletopgen COMMAND --help for the options of a command.\n\nExit codes: 0 success, 1 a "
    "check failed, 2 bad input or usage, 3 backend, 4 bundle, 5 storage, 6 scene,\n130 "
    "interrupted.\n"
)

_COMPLETION = ("--tyro-print-completion", "--tyro-write-completion")


def commands() -> Mapping[str, EntryPoint]:
    """Return all commands by name; this package's come first and cannot be overridden."""
    others = find_commands()
    return {**OWN, **{name: entry for name, entry in others.items() if name not in OWN}}


def app(name: str) -> tyro.extras.SubcommandApp:
    """Return the command called ``name``; no other command is imported.

    If ``name`` is empty or an option (``--help``), return all commands with their one-line
    summaries, without importing any of them. A request for shell completions imports all of them.

    Raises:
        InputError: no command has this name, or it cannot be loaded.
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
    """Return the entry point of a command; other packages are searched only if necessary."""
    if name in OWN:
        return OWN[name]
    known = commands()
    require_known(name, known, "Unknown command")
    return known[name]


def _stub(summary: str) -> Callable[[], int]:
    """Return a placeholder for a command in a list of commands; it is never run."""

    def entry() -> int:
        raise InputError(
            "The first argument must be a command; `tabletopgen --help` lists the commands."
        )

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
    """Run the command line and return its exit code; expected errors print one line."""
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
    """Run the command line of this process and exit with its exit code."""
    interrupts.heed()
    code = run_piped(lambda: run(sys.argv[1:]))
    interrupts.ignore()
    raise SystemExit(code)
