"""Scenes made by the command, as by a new user, and stored with its output."""

from __future__ import annotations

import json
import os
import re
import resource
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
LONGEST = 900.0
"""Timeout of a command in seconds."""


@dataclass(frozen=True)
class Made:
    """Results of a command: its exit code, ``--json``, errors, and processor seconds.

    ``bundle`` is the name of the bundle's folder; empty if there is none.
    """

    code: int
    said: Mapping[str, Any]
    errors: str
    seconds: float
    bundle: str

    @property
    def foreign(self) -> bool:
        """Whether it ended with an exception that is not the package's own."""
        return re.search(r'^ +File ".*", line \d+', self.errors, re.MULTILINE) is not None

    @property
    def warnings(self) -> list[str]:
        """Its warnings."""
        return [str(w) for w in self.said.get("warnings", ())]


def make(text: str, name: str, route: str, seed: int, folder: Path) -> Made:
    """Run the route's command on a text; an existing result is read from ``folder``."""
    kept = folder / f"{name}-{seed}.json"
    if kept.exists():
        return Made(**json.loads(kept.read_text(encoding="utf-8")))
    command = [sys.executable, "-m", "generator", route, text, "--seed", str(seed), "--json"]
    command += ["--out", str(folder), "--name", f"{name}-{seed}"]
    paths = os.pathsep.join(p for p in (str(ROOT), os.environ.get("PYTHONPATH", "")) if p)
    environment = os.environ | {"PYTHONPATH": paths, "OMP_NUM_THREADS": "1"}
    before = _processor_seconds()
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=LONGEST, env=environment, check=False
        )
        code, out, errors = done.returncode, done.stdout, done.stderr
    except subprocess.TimeoutExpired:
        code, out, errors = 124, "", f"no answer in {LONGEST:.0f} s"
    said = _read(out)
    bundle = Path(said["bundle"]).name if "bundle" in said else ""
    errors = errors.replace(f"{ROOT}{os.sep}", "")  # results contain no absolute paths
    made = Made(code, said, errors[-2000:], round(_processor_seconds() - before, 2), bundle)
    kept.write_text(json.dumps(asdict(made)), encoding="utf-8")
    return made


def _processor_seconds() -> float:
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _read(out: str) -> dict[str, Any]:
    try:
        said = json.loads(out)
    except json.JSONDecodeError:
        return {}
    return said if isinstance(said, dict) else {}
