"""The site builds offline without warnings, and its generated pages match the code."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import docstrings
import help_text
import pytest
from blocks import ROOT

from tabletopgen_env.tasks.names import NAMES

OFFLINE = """
import socket
def refuse(*args, **kwargs):
    raise OSError("the build may not use the network")
socket.socket.connect = socket.create_connection = socket.getaddrinfo = refuse
"""


def build(out: Path) -> Path:
    """Build the site without network access; return its folder."""
    (out / "offline").mkdir()
    (out / "offline" / "sitecustomize.py").write_text(OFFLINE, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-c", ROOT / "docs/site",
         "-d", out / "doctrees", ROOT / "docs", out / "html"],
        env={**os.environ, "PYTHONPATH": str(out / "offline"), "PYTHONDONTWRITEBYTECODE": "1"},
        cwd=out, capture_output=True, text=True, timeout=280,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr[-5000:]
    return out / "html"


@pytest.mark.slow
def test_the_site_builds_with_every_page_and_command(tmp_path: Path) -> None:
    site = build(tmp_path)
    pages = [p.relative_to(ROOT / "docs") for p in (ROOT / "docs").rglob("*.md")]
    assert pages and all((site / page.with_suffix(".html")).is_file() for page in pages)
    cli = (site / "reference/cli.html").read_text(encoding="utf-8")
    for command in help_text.commands():
        assert f'id="{command.name.replace(" ", "-")}"' in cli
    assert "Push-v0" in (site / "reference/tasks.html").read_text(encoding="utf-8")
    assert 'src="live/index.html#/embed/dining-family"' in (site / "index.html").read_text()
    tasks = (site / "reference/tasks.html").read_text(encoding="utf-8")
    shown = re.findall(r'src="\.\./live/index\.html#/embed/([\w-]+)/(\w+)"', tasks)
    assert [task for _, task in shown] == [*NAMES]
    gallery = json.loads((site / "live/gallery.json").read_text(encoding="utf-8"))
    for scene, task in shown:
        (row,) = (row for row in gallery["scenes"] if row["name"] == scene)
        view = json.loads((site / "live/scenes" / row["id"] / "view.json").read_text())
        assert task in {episode["task"] for episode in view["episodes"]}, (scene, task)
    assert "Unreleased" in (site / "changelog.html").read_text(encoding="utf-8")
    text = "".join(p.read_text(encoding="utf-8") for p in (site / "reference/api").glob("*.html"))
    for name in ("generator.pipeline.generate", "generator.bundle.load", "generator.bundle.save",
                 "generator.composition.compose", "tabletopgen_env.env.make_env"):  # fmt: skip
        assert f'id="{name}"' in text
    assert str(ROOT) not in text, "the reference shows a path of the machine that built it"


def test_help_is_taken_apart() -> None:
    printed = """usage: tabletopgen cut [-h] [--deep {None}|INT] STR

Cut a thing.

╭─ positional arguments ──╮
│ STR        What.        │
╰─────────────────────────╯
╭─ knife options ─────────╮
│ How it is cut.          │
│ ─────────────────────── │
│ --deep {None}|INT       │
│            How deep,    │
│            in mm.       │
│ --neat, --no-neat       │
│            Neatly.      │
╰─────────────────────────╯
"""
    found = help_text.read_help(printed)
    assert (found.name, found.text) == ("tabletopgen cut", "Cut a thing.")
    assert [(g.title, g.remark) for g in found.groups] == [
        ("positional arguments", ""), ("knife options", "How it is cut."),
    ]  # fmt: skip
    assert found.groups[1].options[0].text == "How deep, in mm."
    assert found.flags == {"--deep", "--neat", "--no-neat"}


def test_fields_become_a_list() -> None:
    lines = ["Limits.", "", "low, high: metres,", "    or more.", "other: text", "", "low: no"]
    found = docstrings.list_fields(lines, {"low", "high"})
    assert found == [
        "Limits.", "", "", "* ``low``, ``high``: metres,", "  or more.", "  other: text", "",
        "", "* ``low``: no",
    ]  # fmt: skip
