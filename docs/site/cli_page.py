"""The page of the command line, made of what the commands print for ``--help``."""

from __future__ import annotations

import re
from collections.abc import Iterator

from help_text import CommandHelp, HelpGroup, HelpOption, commands, print_help

INTRO = """\
# Command line

Generated from the commands' own `--help`. `python -m tabletopgen_env COMMAND` is an alias of
`tabletopgen COMMAND`; `python -m generator COMMAND` runs a source checkout."""


def page() -> str:
    """Return the whole page as Markdown."""
    codes = re.search(r"Exit codes: .*?\.$", print_help([]), flags=re.M | re.S)
    assert codes is not None
    known = list(commands())
    names = ", ".join(f"[`{_last(c)}`](#{anchor(c)})" for c in known)
    parts = [INTRO, " ".join(codes[0].split()), f"Commands: {names}.", *map(section, known)]
    return "\n\n".join(parts) + "\n"


def section(command: CommandHelp) -> str:
    """Return a command's section: usage, description, tables of arguments."""
    parts = [f"## {command.name}", f"```text\n{usage(command)}\n```", command.text]
    plain = [g for g in command.groups if g.title in ("positional arguments", "options")]
    if rows := [row for group in plain for row in _rows(group)]:
        parts.append(_table(rows))
    for group in command.groups:
        if group not in plain:
            parts += [f"{group.remark}", _table(list(_rows(group)))]
    return "\n\n".join(parts)


def usage(command: CommandHelp) -> str:
    """Return a command's usage in short."""
    plain = [g for g in command.groups if g.title == "positional arguments"]
    words = [_head(option) for group in plain for option in group.options]
    return " ".join([command.name, *words, "[OPTIONS]"])


def anchor(command: CommandHelp) -> str:
    """Return the anchor of a command's section."""
    return command.name.replace(" ", "-").lower()


def _last(command: CommandHelp) -> str:
    return command.name.partition(" ")[2]


def _table(rows: list[str]) -> str:
    return "\n".join(["| argument | meaning |", "|---|---|", *rows])


def _rows(group: HelpGroup) -> Iterator[str]:
    for option in group.options:
        if "-h" not in option.flags:
            yield f"| `{_head(option)}` | {_cell(option.text)} |"


def _head(option: HelpOption) -> str:
    """Return an option as it is typed: ``{None}|PATH`` is ``PATH``, on-off pairs are one word."""
    if option.text.endswith("(default: True)"):
        return option.flags[-1]  # --no-...: the one that changes something
    head = re.sub(r", --no-[\w-]+", "", option.head)
    head = re.sub(r"\{None,(.*?)\}", r"{\1}", head.replace("{None}|", ""))
    head = re.sub(r"\[+([^\[\]]+) \[\1 \.\.\.\]+", r"\1 ...", head)
    return head.replace("|", "\\|")


def _cell(text: str) -> str:
    """Return a description in one cell; defaults that say nothing are left out."""
    if text.endswith("(default: True)"):
        text = "Do not: " + text[0].lower() + text[1:]
    text = re.sub(r" *\((required|default: (None|False|True)?)\)$", "", text)
    text = re.sub(r"(?<![`\w])(--[a-z][\w-]*)", r"`\1`", text)
    return text.replace("|", "\\|").replace("<", "&lt;").replace("*", "\\*")
