"""Every code block of README.md and of the docs runs, or is checked and gives a reason."""

import os
import shutil
import subprocess
import sys
import warnings
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

import blocks
import pytest
from blocks import ROOT, Block
from extent import EXHAUSTIVE

from generator.threads import torch_threads

BLOCKS = blocks.blocks()
RUN = {
    page: [b for b in BLOCKS if b.page == page and b.language in blocks.RUN and b.reason is None]
    for page in sorted({b.page for b in BLOCKS})
}
"""The blocks that are run, by page."""

PICTURE = "examples/pictures/coffee_table.png"
GIVEN: Mapping[str, Mapping[str, str]] = MappingProxyType({
    "docs/guides/benchmark.md": {"straight_reach.py": "examples/policies/straight_reach.py"},
    "docs/guides/photo.md": {"desk.png": PICTURE},
})  # fmt: skip
"""Files that a page takes for granted, and where they come from."""

INSTEAD: Mapping[str, Mapping[str, str]] = MappingProxyType({
    "README.md": {
        "an office desk with a laptop, a mug and a stapler": "a die",
        "a kitchen table with a kettle and two mugs": "a die",
    },
    "docs/concepts/pipeline.md": {"a die and a bowl": "a die"},
    "docs/guides/page.md": {"page starter": "page coffee-square", '"kitchen-*"': "coffee-oval"},
    "docs/quickstart.md": {"a desk with a mug and a stapler": "a die"},
})  # fmt: skip
"""Smaller inputs that stand for a page's own, which are those of an exhaustive run."""

COPIED: Mapping[str, str] = MappingProxyType({
    "docs/guides/add-an-object.md": "tabletop_objects",
})  # fmt: skip
"""Packages of the checkout that a page changes; its blocks run beside a copy."""

MODULES: Mapping[str, str] = MappingProxyType({
    "docs/guides/add-an-object.md": "tabletop_objects/objects/music/forks.py",
})  # fmt: skip
"""Where the first Python block of a page goes, which is a module."""

LATER = () if EXHAUSTIVE else (
    "docs/guides/benchmark.md", "docs/guides/photo.md", "docs/guides/user-study.md",
)  # fmt: skip
"""Pages of long blocks, whose commands other tests run, too; only an exhaustive run has them."""

CHEAP = ("docs/concepts/frames.md", "docs/reference/api/index.md")
"""Pages whose blocks run in about a second together."""


def code_of(block: Block) -> str:
    """Return the code to run: the block's, with smaller inputs unless the run is exhaustive."""
    code = block.code
    for shown, run in {} if EXHAUSTIVE else INSTEAD.get(block.page, {}).items():
        code = code.replace(shown, run)
    return code


def slow(page: str) -> Any:
    return pytest.param(page, marks=() if page in CHEAP else pytest.mark.slow)


def test_every_block_is_of_a_language_that_is_known() -> None:
    unknown = [str(b) for b in BLOCKS if b.language not in (*blocks.RUN, *blocks.SHOWN)]
    assert not unknown, f"Name the language: {blocks.RUN} are run, {blocks.SHOWN} shown."


@pytest.mark.parametrize("block", [b for b in BLOCKS if b.language in blocks.RUN], ids=str)
def test_a_block_is_sound(block: Block) -> None:
    assert blocks.faults(block) == []


@pytest.mark.slow
@pytest.mark.parametrize(("language", "code"), [
    ("bash", "tabletopgen generat x"),
    ("bash", "tabletopgen compose x --bugdet 3"),
    ("bash", "for seed in 0 1; do tabletopgen verify x --jsn; done"),
    ("bash", "A=b tabletopgen cache lst"),
    ("bash", "make tset"),
    ("bash", "pip install -e '.[trian]'"),
    ("bash", "python benchmarks/sped.py"),
    ("bash", "rm -rf x"),
    ("bash", "echo 'x"),
])  # fmt: skip
def test_faults_are_found(language: str, code: str) -> None:
    try:
        assert blocks.faults(Block("page", 1, language, code, None))
    except ValueError as error:
        assert "quotation" in str(error)


def test_smaller_inputs_stand_for_some_that_are_shown() -> None:
    for page, pairs in INSTEAD.items():
        shown = "".join(block.code for block in RUN[page])
        assert [text for text in pairs if text not in shown] == [], page


def run_shell(block: Block, folder: Path) -> None:
    found = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", code_of(block)], cwd=folder, timeout=240,
        env={**os.environ, "PATH": found, "PYTHONPATH": str(ROOT)}, stdin=subprocess.DEVNULL,
        capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, f"{block}: {done.stdout[-2000:]}{done.stderr[-2000:]}"


def run_python(block: Block, names: dict[str, Any]) -> None:
    padded = "\n" * block.line + code_of(block)  # for the line in a traceback
    exec(compile(padded, str(ROOT / block.page), "exec"), names)


@pytest.mark.parametrize("page", [slow(p) for p, found in RUN.items() if found and p not in LATER])
def test_the_blocks_of_a_page_run(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "work"
    folder.mkdir()
    monkeypatch.chdir(folder)
    for name in ("HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME", "TABLETOPGEN_CALLS"):
        monkeypatch.setenv(name, str(tmp_path / name.lower()))
    monkeypatch.delenv("TABLETOPGEN_CACHE", raising=False)
    for name, origin in GIVEN.get(page, {}).items():
        shutil.copy(ROOT / origin, folder / name)
    if page in COPIED:
        shutil.copytree(ROOT / COPIED[page], folder / COPIED[page])
    if page in MODULES:
        module = next(b for b in BLOCKS if b.page == page and b.language == "python")
        (folder / MODULES[page]).write_text(module.code)
    names: dict[str, Any] = {"__name__": "__main__"}
    with torch_threads(1), warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        for block in RUN[page]:
            if block.language == "bash":
                run_shell(block, folder)
            else:
                run_python(block, names)
