"""A gathered model compiled by MuJoCo: first in a child with limits, which may fail, then here."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import InputError
from .mjcf_files import GatheredModel

if TYPE_CHECKING:
    import mujoco

_SECONDS, _MEMORY = 120, 6 * 2**30  # what compiling may take: of time, and bytes

_CHILD = """
import resource, sys
seconds, memory = int(sys.argv[2]), int(sys.argv[3])
resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
import mujoco
try:
    mujoco.MjModel.from_xml_path(sys.argv[1])
except ValueError as error:
    print(" ".join(str(error).split())[:500], file=sys.stderr)
    sys.exit(3)
"""


def compile_foreign(gathered: GatheredModel, what: str) -> mujoco.MjModel:
    """Return the compiled model; ``what`` names it in messages.

    Raises:
        InputError: MuJoCo refuses it, or takes too long or too much memory.
    """
    import mujoco

    with tempfile.TemporaryDirectory() as folder:
        for name, content in gathered.files.items():
            Path(folder, name).write_bytes(content)
        scene = Path(folder, "scene.xml")
        scene.write_text(gathered.xml, encoding="utf-8")
        command = [sys.executable, "-c", _CHILD, str(scene), str(_SECONDS), str(_MEMORY)]
        try:
            done = subprocess.run(
                command, cwd=folder, capture_output=True, timeout=2 * _SECONDS, check=False
            )
        except subprocess.TimeoutExpired as error:
            raise InputError(f"{what} takes MuJoCo longer than {2 * _SECONDS} s.") from error
    if done.returncode == 3:
        said = done.stderr.decode(errors="replace").strip().splitlines()[-1:]
        raise InputError(f"MuJoCo refuses {what}: {' '.join(said)!r}. Mend it there.")
    if done.returncode:
        raise InputError(
            f"MuJoCo breaks down over {what}, or takes more than {_SECONDS} s or "
            f"{_MEMORY // 2**30} GiB (exit code {done.returncode}). Use a simpler model."
        )
    try:
        return mujoco.MjModel.from_xml_string(gathered.xml, gathered.files)
    except ValueError as error:  # it has just been fine
        raise InputError(f"MuJoCo refuses {what}: {' '.join(str(error).split())!r}.") from error
