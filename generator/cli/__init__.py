"""The ``tabletopgen`` command; what it prints for ``--help`` is written in this package."""

from __future__ import annotations

import sys

import tyro

from ..errors import TabletopError, escaped, exit_code
from ..io.terminal import piped
from . import batching, cache, editing, evaluating, interrupts, looking, making, models

DESCRIPTION = """Turn a text, or one picture of a tabletop, into a simulated table.

The store of finished tables and the open models have commands of their own:
tabletopgen cache --help, tabletopgen models --help.

Exit codes: 0 done, 1 a check failed, 2 bad input or usage, 3 backend, 4 bundle, 5 storage, 6 scene,
130 interrupted.
"""

GROUPS = {"cache": cache.app, "models": models.app}
"""Commands with commands of their own."""

app = tyro.extras.SubcommandApp()
for command in (
    making.generate,
    making.compose,
    batching.batch,
    editing.edit,
    looking.inspect,
    looking.verify,
    looking.view,
    looking.compare,
    evaluating.evaluate,
):
    app.command(command)


def run(arguments: list[str]) -> int:
    """Run the command line; every expected error becomes one line, and an exit code is returned."""
    try:
        if arguments and (group := GROUPS.get(arguments[0])):
            return group.cli(
                prog=f"tabletopgen {arguments[0]}", args=arguments[1:], use_underscores=False
            )
        return app.cli(
            prog="tabletopgen", description=DESCRIPTION, args=arguments, use_underscores=False
        )
    except TabletopError as error:
        print(escaped(f"error: {error}"), file=sys.stderr)
        return exit_code(error)
    except KeyboardInterrupt:
        print("interrupted; nothing was published", file=sys.stderr)
        return 130


def main() -> None:
    """Run the process's command line and end it with the exit code."""
    interrupts.heed()
    code = piped(lambda: run(sys.argv[1:]))
    interrupts.ignore()
    raise SystemExit(code)
