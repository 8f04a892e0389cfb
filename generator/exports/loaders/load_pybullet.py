"""Load this scene into PyBullet, with free objects at their poses and a fixed table and floor.

python load_pybullet.py prints how far each object moves in two seconds, in millimetres;
python load_pybullet.py --gui shows the scene.
"""

import json
import math
import sys
from pathlib import Path

import pybullet


def load(client: int = 0) -> dict[str, int]:
    """Load every body into a connected client; return their ids by name."""
    folder = Path(__file__).parent
    # Exact contacts between faces; otherwise hulls get a margin of 1 mm.
    pybullet.setPhysicsEngineParameter(enableSAT=1, physicsClientId=client)
    flags = pybullet.URDF_USE_INERTIA_FROM_FILE | pybullet.URDF_INITIALIZE_SAT_FEATURES
    bodies = {}
    for name, pose in json.loads((folder / "poses.json").read_text()).items():
        w, *xyz = pose["quaternion_wxyz"]
        bodies[name] = pybullet.loadURDF(
            str(folder / "objects" / f"{name}.urdf"), pose["position"], [*xyz, w],
            useFixedBase=pose["fixed"], flags=flags, physicsClientId=client,
        )  # fmt: skip
    pybullet.setGravity(0, 0, -9.81, physicsClientId=client)
    return bodies


if __name__ == "__main__":
    shown = "--gui" in sys.argv
    pybullet.connect(pybullet.GUI if shown else pybullet.DIRECT)
    loaded = load()
    first = {k: pybullet.getBasePositionAndOrientation(i)[0] for k, i in loaded.items()}
    for _ in range(480):  # of 1/240 s
        pybullet.stepSimulation()
    for key, number in loaded.items():
        last = pybullet.getBasePositionAndOrientation(number)[0]
        print(f"{key} {1000 * math.dist(first[key], last):.3f}")
    if shown:
        input("Press Enter to close.")
