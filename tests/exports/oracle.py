"""Programs in a separate environment that read or write exports, and their results.

They need other versions than this package (mujoco-usd-converter 0.8.0: MuJoCo < 3.17) or much that
it does not (yourdfpy). To have them:

    python -m venv oracles
    oracles/bin/pip install mujoco-usd-converter==0.8.0 yourdfpy==0.0.60
    export TABLETOPGEN_ORACLES=$PWD/oracles/bin/python
    apt-get install ignition-tools libsdformat-dev    # ``ign sdf --check``
"""

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

VARIABLE = "TABLETOPGEN_ORACLES"

CONVERT = """
import json, sys
from pathlib import Path
import mujoco_usd_converter
from pxr import Usd, UsdGeom, UsdPhysics
made = mujoco_usd_converter.Converter(layer_structure=False).convert(sys.argv[1], sys.argv[2])
stage = Usd.Stage.Open(made.path)
found = {}
for prim in stage.Traverse():
    if not prim.HasAPI(UsdPhysics.RigidBodyAPI):
        continue
    matrix = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(0)
    below = [p for p in Usd.PrimRange(prim) if p.HasAPI(UsdPhysics.CollisionAPI)]
    hulls = [UsdPhysics.MeshCollisionAPI(p).GetApproximationAttr().Get() for p in below
             if p.HasAPI(UsdPhysics.MeshCollisionAPI)]
    box = UsdGeom.BBoxCache(0, [UsdGeom.Tokens.default_, UsdGeom.Tokens.render])
    found[prim.GetName()] = {
        "mass": UsdPhysics.MassAPI(prim).GetMassAttr().Get(),
        "position": [*matrix.ExtractTranslation()], "rotation": [[*row][:3] for row in matrix][:3],
        "parts": len(below), "hulls": sorted({*hulls}),
    }
print(json.dumps(found))
"""

LOAD_URDF = """
import json, sys
import yourdfpy
urdf = yourdfpy.URDF.load(
    sys.argv[1], load_collision_meshes=True, build_collision_scene_graph=True
)
assert urdf.validate()
found = {
    name: {
        "mass": link.inertial.mass if link.inertial else None, "parts": len(link.collisions),
        "matrix": urdf.get_transform(name, "world").tolist(),
    }
    for name, link in urdf.link_map.items()
}
found["bounds"] = urdf.scene.bounds.tolist()
print(json.dumps(found))
"""


def ask(script: str, *arguments: object, needs: str) -> Any:
    """Return the JSON printed by a script in the other environment; skip without one."""
    python = os.environ.get(VARIABLE, "")
    if not Path(python).is_file():
        pytest.skip(
            f"NOT CHECKED by {needs}: set {VARIABLE} to the python of an environment with it; "
            "tests/exports/oracle.py says how to make one"
        )
    plain = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "PYTHONHOME")}
    done = subprocess.run(
        [python, "-c", script, *map(str, arguments)], capture_output=True, text=True, env=plain,
        timeout=200,
    )  # fmt: skip
    if f"No module named {needs!r}" in done.stderr:
        pytest.skip(f"NOT CHECKED by {needs}: {python} does not have it")
    assert done.returncode == 0, done.stderr[-3000:]
    return json.loads(done.stdout.strip().splitlines()[-1])


def check_sdf(path: Path) -> str:
    """Return the output of Debian's or Gazebo's checker for an SDF file; skip without one."""
    program = next((p for p in ("gz", "ign") if shutil.which(p)), None)
    if program is None:
        pytest.skip(
            "NOT CHECKED by libsdformat: neither gz nor ign is installed "
            "(apt-get install ignition-tools libsdformat-dev)"
        )
    done = subprocess.run(
        [program, "sdf", "--check", str(path)], capture_output=True, text=True, timeout=100
    )
    if "Valid" not in done.stdout and "sdf" not in done.stderr + done.stdout:
        pytest.skip(f"NOT CHECKED by libsdformat: {program} has no command sdf")
    errors = [line for line in done.stderr.splitlines() if "backward" not in line]
    return "\n".join([done.stdout.strip(), *errors]).strip()
