"""The docs state which MuJoCo the page runs and which the package runs."""

import json
import re
from pathlib import Path

import mujoco

ROOT = Path(__file__).parents[2]


def test_the_docs_report_the_gap_between_the_engines() -> None:
    package = json.loads((ROOT / "web/package.json").read_text(encoding="utf-8"))
    page = package["dependencies"]["@mujoco/mujoco"]
    pinned = re.search(
        r"^mujoco==(\S+)$", (ROOT / "constraints.txt").read_text(encoding="utf-8"), re.MULTILINE
    )
    assert pinned is not None and pinned[1] == mujoco.__version__
    guide = (ROOT / "docs/guides/page.md").read_text(encoding="utf-8")
    assert f"runs MuJoCo {page}," in guide
    assert f"while the Python package uses {pinned[1]}." in guide
    assert [int(part) for part in page.split(".")] <= [int(part) for part in pinned[1].split(".")]
