"""What the commands print for ``--help``, taken apart: usage, description, groups of options."""

from __future__ import annotations

import contextlib
import io
import os
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from generator.cli import run

_WIDE = "1000"  # columns: no line is broken but where its docstring ends one
_NESTED = re.compile(r"\{([\w,-]+)\}")


@dataclass(frozen=True)
class HelpOption:
    """One row of a command's help: ``head``, such as ``--seed INT``, and its description."""

    head: str
    text: str

    @property
    def flags(self) -> tuple[str, ...]:
        """The words that a command line may have for it; none of a positional argument."""
        return tuple(re.findall(r"(?<![\w-])--?[a-z][\w-]*", self.head))


@dataclass(frozen=True)
class HelpGroup:
    """A box of a command's help: its title, the remark below it, its rows."""

    title: str
    remark: str
    options: tuple[HelpOption, ...]


@dataclass(frozen=True)
class CommandHelp:
    """A command as its help shows it; ``name`` has the words before its arguments."""

    name: str
    usage: str
    text: str
    groups: tuple[HelpGroup, ...]

    @property
    def flags(self) -> frozenset[str]:
        """Every option that the command takes."""
        return frozenset(f for g in self.groups for o in g.options for f in o.flags)


def commands() -> Iterator[CommandHelp]:
    """Yield every command of ``tabletopgen``, nested ones with their group's name."""
    top = read_help(print_help([]))
    for name in subcommands(top):
        found = read_help(print_help([name]))
        if nested := subcommands(found):
            yield from (read_help(print_help([name, inner])) for inner in nested)
        else:
            yield found


def subcommands(command: CommandHelp) -> list[str]:
    """Return the names of a command's own commands, as its usage lists them."""
    if not any(group.title == "subcommands" for group in command.groups):
        return []
    return _NESTED.findall(command.usage)[-1].split(",")


def print_help(words: Sequence[str]) -> str:
    """Return what ``tabletopgen WORDS --help`` prints, in lines that are not wrapped."""
    out = io.TextIOWrapper(io.BytesIO(), encoding="utf-8")  # with a plain StringIO boxes are ASCII
    before = os.environ.get("COLUMNS")
    os.environ["COLUMNS"] = _WIDE
    try:
        with contextlib.redirect_stdout(out), contextlib.suppress(SystemExit):
            run([*words, "--help"])
    finally:
        del os.environ["COLUMNS"]
        if before is not None:
            os.environ["COLUMNS"] = before
    out.seek(0)
    return out.read()


def read_help(printed: str) -> CommandHelp:
    """Take apart what a command printed for ``--help``."""
    head, *boxes = re.split(r"^╭─ ", printed, flags=re.M)
    usage, _, text = head.removeprefix("usage: ").partition("\n")
    name = re.split(r" [\[{]| -h| [A-Z]", usage.strip(), maxsplit=1)[0]
    return CommandHelp(name, usage.strip(), text.strip(), tuple(map(_group, boxes)))


def _group(box: str) -> HelpGroup:
    """Read a box: rows that are not indented begin an option, or are the remark above a rule."""
    title, *lines = (line.rstrip() for line in box.splitlines())
    rows = [line[2:].removesuffix("│").rstrip() for line in lines if line.startswith("│")]
    ruled = next((k for k, row in enumerate(rows) if re.fullmatch(r"─+", row)), -1)
    options: list[list[str]] = []
    for row in rows[ruled + 1 :]:
        if row and not row.startswith(" "):
            first, _, rest = row.partition("  ")
            options.append([first, rest.strip()])
        elif options:
            options[-1].append(row.strip())
    remark = " ".join(rows[:ruled]) if ruled > 0 else ""
    made = (HelpOption(first, " ".join(filter(None, rest))) for first, *rest in options)
    return HelpGroup(title.strip(" ─╮"), remark, tuple(made))
