"""Probes that may crash or hang; each runs in its own process."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import dataclass

_LIMIT = 60.0  # time limit of a probe in seconds

GL_BACKENDS = ("egl", "osmesa", "glfw")
"""The possible values of ``MUJOCO_GL``."""

_LONGEST = 200  # maximum length of a probe's output in characters

_DRAW = """
import mujoco
from OpenGL import GL
model = mujoco.MjModel.from_xml_string('<mujoco><worldbody><geom size="1"/></worldbody></mujoco>')
data = mujoco.MjData(model)
mujoco.mj_forward(model, data)
with mujoco.Renderer(model, 32, 32) as renderer:
    renderer.update_scene(data)
    if not renderer.render().any():
        raise SystemExit("the picture is black")
    print(GL.glGetString(GL.GL_RENDERER).decode())
"""

_CUDA = """
import torch
if torch.version.cuda is None:
    raise SystemExit(f"torch {torch.__version__} is built without CUDA")
if not torch.cuda.is_available():
    raise SystemExit("torch finds no usable device")
print(torch.cuda.get_device_name(0))
"""


@dataclass(frozen=True)
class Probe:
    """Whether a feature works, with the device's name or the reason of the failure."""

    works: bool
    said: str


def draw(backend: str) -> Probe:
    """Check whether MuJoCo can render with one of ``GL_BACKENDS``."""
    return run(_DRAW, _LIMIT, MUJOCO_GL=backend)


def cuda() -> Probe:
    """Check whether torch can use a CUDA device."""
    return run(_CUDA, _LIMIT)


def run(code: str, limit: float, **environment: str) -> Probe:
    """Run Python code in its own process, which is killed after ``limit`` seconds.

    The last line of standard output is the result, and that of standard error the reason of a
    failure.
    """
    try:
        done = subprocess.run(
            [sys.executable, "-P", "-c", code], stdin=subprocess.DEVNULL, capture_output=True,
            text=True, errors="replace", timeout=limit, env={**os.environ, **environment},
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return Probe(False, f"no result within {limit:g} s")
    except OSError as error:
        return Probe(False, f"no process could be started: {error.strerror}")
    if done.returncode < 0:
        return Probe(False, f"the process crashed with signal {-done.returncode}")
    lines = (done.stderr if done.returncode else done.stdout).strip().splitlines()
    return Probe(not done.returncode, lines[-1][:_LONGEST] if lines else "")
