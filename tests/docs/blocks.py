"""The fenced blocks of README.md and of the pages below ``docs/``, their checks and execution.

A Python or shell block is run by a test unless the line above its fence is a comment of the form
``<!-- not-run: needs a key -->``. Blocks of a page share one folder; Python blocks also share
variables.
"""

import ast
import re
import shlex
import subprocess
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import help_text

ROOT = Path(__file__).parents[2]

RUN = ("bash", "python")
"""Languages of blocks that are checked and run."""

SHOWN = ("html", "json", "text", "toml")
"""Languages of blocks that are only shown."""

_FENCE = re.compile(
    r"(?:^<!-- not-run: (?P<reason>[^\n]+) -->\n)?^```(?P<language>[^\n]*)\n(?P<code>.*?)^```$",
    re.M | re.S,
)
_KEYWORDS = frozenset({"do", "done", "then", "fi"})
_SEPARATORS = frozenset({";", "&&", "||", "|", "&", ";;"})
_ALIAS = ["python", "-m", "tabletopgen_env"]


@dataclass(frozen=True)
class Block:
    """One fenced block; ``reason`` is the reason not to run it, else None."""

    page: str
    line: int
    language: str
    code: str
    reason: str | None

    def __str__(self) -> str:
        return f"{self.page}:{self.line}"


def pages() -> list[Path]:
    """Return README.md, CONTRIBUTING.md and every page of the site."""
    return [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]


def read(page: Path) -> Iterator[Block]:
    """Yield the blocks of a page in order, without directives of the site."""
    text = page.read_text(encoding="utf-8")
    for found in _FENCE.finditer(text):
        if not found["language"].startswith("{"):
            line = text.count("\n", 0, found.start("language")) + 1
            name = page.relative_to(ROOT).as_posix()
            yield Block(name, line, found["language"], found["code"], found["reason"])


def blocks() -> list[Block]:
    return [block for page in pages() for block in read(page)]


# ------------------------------------------------------------------------------------- shell
def faults(block: Block) -> list[str]:
    """Return the faults of a block without running it."""
    if block.language == "python":
        ast.parse(block.code, str(block))
        return []
    done = subprocess.run(
        ["bash", "-n", "-c", block.code], capture_output=True, text=True, timeout=60
    )
    found = [done.stderr] if done.returncode else []
    return found + [fault for words in simple_commands(block.code) for fault in _faults(words)]


def simple_commands(code: str) -> Iterator[list[str]]:
    """Yield the words of each simple command of a shell script, without its variables."""
    for line in code.replace("\\\n", " ").splitlines():
        words: list[str] = []
        for word in [*_words(line), ";"]:
            if word in _SEPARATORS:
                if words:
                    yield words
                words = []
            elif word not in _KEYWORDS and (words or not re.match(r"\w+=", word)):
                words.append(word)


def _words(line: str) -> list[str]:
    lexer = shlex.shlex(line, posix=True, punctuation_chars=";&|")
    lexer.whitespace_split = True
    return list(lexer)


def _faults(words: list[str]) -> list[str]:
    """Return the faults of a simple command: unknown command, option, target or extra."""
    if words[:3] == _ALIAS:
        words = ["tabletopgen", *words[3:]]
    program, *rest = words
    if program == "tabletopgen":
        return _cli_faults(rest)
    if program == "make":
        return [f"no target {w!r} in the Makefile" for w in rest if w not in _targets()]
    if program == "pip" or words[:3] == ["python", "-m", "pip"]:
        extras = {e for w in rest for found in re.findall(r"\[(.*)\]", w) for e in found.split(",")}
        return [f"no extra {extra!r}" for extra in sorted(extras - _extras())]
    if program == "python":
        return _python_faults(rest)
    known = ("for", "export", "printf", "cd", "python3", ".", "tensorboard", "pytest", ".ci/run")
    return [] if program in known else [f"{program!r} is no command that is known here"]


def _python_faults(rest: list[str]) -> list[str]:
    where = rest[1].replace(".", "/") if rest[0] == "-m" else rest[0]
    there = [ROOT / where, ROOT / f"{where}.py", ROOT / where / "__main__.py"]
    return [] if any(path.is_file() for path in there) else [f"no script {' '.join(rest[:2])}"]


def _cli_faults(rest: list[str]) -> list[str]:
    name = next((n for n in (" ".join(rest[:2]), rest[0]) if n in cli_flags()), None)
    if name is None:
        return [f"no command tabletopgen {rest[0]}"]
    given = [w.partition("=")[0] for w in rest if re.match(r"--?[a-z]", w)]
    return [f"tabletopgen {name} has no {w}" for w in given if w not in cli_flags()[name]]


@cache
def cli_flags() -> Mapping[str, frozenset[str]]:
    """Return the options of each ``tabletopgen`` command from its help."""
    return {c.name.partition(" ")[2]: c.flags for c in help_text.commands()}


@cache
def _targets() -> frozenset[str]:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    return frozenset(re.findall(r"^([a-z-]+):", makefile, flags=re.M))


@cache
def _extras() -> frozenset[str]:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    return frozenset(project["optional-dependencies"])
