"""The page of tasks, observations and actions, made of what the code says.

Descriptions and tables are the docstrings of the modules, turned into Markdown; weights, time
limits and tables to play at are those of the tasks themselves.
"""

from __future__ import annotations

import importlib
import re
from collections.abc import Iterator

import gymnasium

from tabletopgen_env.actions import CONTROL_HZ
from tabletopgen_env.tasks.names import NAMES
from tabletopgen_env.tasks.registry import task_named
from tabletopgen_env.tasks.sequence import PRESETS
from tabletopgen_env.tasks.task import Task

FILES = {"PickPlace": "pick_place"}
"""The modules and pictures whose names are not their task's in small letters."""

INTRO = """\
# Tasks, observations and actions

Eight kinds of task at any table. Each is a Gymnasium id, and each has a scripted expert
(`tabletopgen_env.expert.run.TaskExpert`); the strips show its episodes, at shipped tables with
fixed seeds.

```python
import gymnasium as gym

env = gym.make("tabletopgen_env:TabletopGen/PickPlace-v0", scenes="starter")
observation, info = env.reset(seed=0)
print(info["instruction"])
```

Text and tables of this page are generated from the code; `python docs/make_task_pictures.py`
draws its pictures."""

TABLES = """\
Tables: where scenes come from unless `scenes` says otherwise. An episode never terminates; the
time limit truncates it. "Left" and "right" in instructions are the robot's, wherever it
stands: its left is the side of +y in the base frame. The camera "top" shows them so; "front", what
`render` shows and the pictures here look from across the table, where they are swapped. Episodes of
the same scene, target and goal start alike unless `randomization` is set ([below](#randomisation)):
with `"starts"` the arm and the objects are a little off, differently each time."""

SECTIONS = (
    ("Goals and success", "tabletopgen_env.goals.goal"),
    ("Reward", "tabletopgen_env.tasks.task"),
    ("Observations", "tabletopgen_env.observations.modes"),
    ("The grasp hint", "tabletopgen_env.observations.grasp_hint"),
    ("Height maps", "tabletopgen_env.observations.height_map"),
    ("Pictures", "tabletopgen_env.rendering.views"),
    ("Point clouds", "tabletopgen_env.rendering.point_cloud"),
    ("Actions", "tabletopgen_env.actions"),
    ("Randomisation", "tabletopgen_env.randomization"),
)
"""Headings, and the modules whose docstrings stand below them."""

Span = tuple[int, int]


def file_of(name: str) -> str:
    """Return what the module and the picture of a task are called."""
    return FILES.get(name, name.lower())


def limit(name: str) -> int:
    """Return the time limit of a task's id, steps."""
    steps = gymnasium.spec(f"TabletopGen/{name}-v0").max_episode_steps
    assert steps is not None
    return steps


def docstring(module: str) -> str:
    """Return the docstring of a module."""
    return importlib.import_module(module).__doc__ or ""


# ---------------------------------------------------------------------- docstrings to Markdown


def markdown(text: str) -> str:
    """Return a docstring as Markdown: its tables, headings and literals."""
    lines = text.strip().splitlines()
    made: list[str] = []
    while lines:
        line = lines.pop(0)
        if re.fullmatch(r"=+( +=+)+", line):
            made += table(line, lines)
        elif lines and re.fullmatch(r"-{3,}", lines[0]):
            lines.pop(0)
            made += [f"### {line}", ""]
        else:
            made.append(line)
    return re.sub(r"``(.+?)``", r"`\1`", "\n".join(made))


def table(ruler: str, lines: list[str]) -> list[str]:
    """Take a table from the front of ``lines``, below its first ruler; return it as Markdown."""
    spans = [match.span() for match in re.finditer("=+", ruler)]
    blocks: list[list[list[str]]] = [[]]
    while lines:
        line = lines.pop(0)
        if line != ruler:
            add_row(blocks[-1], line, spans)
            continue
        blocks.append([])
        if not lines or not lines[0].strip():
            break
    head, body = (blocks[0], blocks[1]) if blocks[1] else ([[""] * len(spans)], blocks[0])
    rows = [head[0], ["---"] * len(spans), *body]
    return ["| " + " | ".join(row) + " |" for row in rows]


def add_row(rows: list[list[str]], line: str, spans: list[Span]) -> None:
    """Add a line to the rows of a table; one that begins with blanks continues the last row."""
    found = cells(line, spans)
    if found[0] or not rows:
        rows.append(found)
    else:
        rows[-1] = [f"{a} {b}".strip() for a, b in zip(rows[-1], found, strict=True)]


def cells(line: str, spans: list[Span]) -> list[str]:
    """Return the cells of a table's line; what runs over a column's end is all one cell."""
    ends = [start for start, _ in spans[1:]]
    found, begin = [], 0
    for end in ends:
        if line[end - 1 : end].strip():
            break
        found.append(line[begin:end].strip())
        begin = end
    found.append(line[begin:].strip())
    return found + [""] * (len(spans) - len(found))


# ---------------------------------------------------------------------------------------- page


def overview() -> Iterator[str]:
    """Yield the lines of the table of all tasks."""
    yield "| id | most goals | time limit | tables |"
    yield "|---|---|---|---|"
    for name in NAMES:
        time = f"{limit(name)} steps, {limit(name) / CONTROL_HZ:g} s"
        for preset in (None, *PRESETS) if name == "Sequence" else (None,):
            task = task_named(name, preset)
            shown = f"[`TabletopGen/{name}-v0`](#{name.lower()})"
            shown += f', `preset="{preset}"`' if preset else ""
            yield f"| {shown} | {task.most} | {time} | `{task.scenes}` |"


def weights() -> Iterator[str]:
    """Yield the lines of the table of weights."""
    tasks: dict[str, Task] = {name: task_named(name) for name in NAMES}
    terms = ("reach", "grasp", "lift", "place", "met", "success")
    yield f"| task | {' | '.join(terms)} |"
    yield "|---" * (len(terms) + 1) + "|"
    for name, task in tasks.items():
        assert set(task.weights) <= set(terms), name
        shown = (f"{task.weights[t]:.2f}" if t in task.weights else "" for t in terms)
        yield f"| {name} | {' | '.join(shown)} |"


def task_section(name: str) -> str:
    """Return the section of a task."""
    file = file_of(name)
    text = markdown(docstring(f"tabletopgen_env.tasks.{file}")).removeprefix(f"{name}: ")
    strips = [file, *(f"{file}_{preset}" for preset in PRESETS if name == "Sequence")]
    pictures = "\n\n".join(f"![{strip}](../images/tasks/{strip}.png)" for strip in strips)
    table = "tidy-task-1" if name == "Tidy" else "kitchen-cutting"
    live = f"<!-- live: {table} {name} -->"
    return f"### {name}\n\n{pictures}\n\n{live}\n\n{text[0].upper()}{text[1:]}"


def page() -> str:
    """Return the whole page."""
    parts = [INTRO, "\n".join(overview()), TABLES, "## The tasks", *map(task_section, NAMES)]
    for title, module in SECTIONS:
        parts += [f"## {title}", markdown(docstring(module))]
        if title == "Reward":
            parts += ["Weights of the dense reward:", "\n".join(weights())]
    return "\n\n".join(parts) + "\n"
