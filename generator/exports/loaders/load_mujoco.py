"""Load this scene into MuJoCo, at rest.

python load_mujoco.py prints how far each object moves in two seconds, in millimetres.
"""

from pathlib import Path

import mujoco
import numpy as np


def load() -> tuple[mujoco.MjModel, mujoco.MjData]:
    """Return the model, and data with every object at its pose."""
    model = mujoco.MjModel.from_xml_path(str(Path(__file__).parent / "scene.xml"))
    data = mujoco.MjData(model)
    if model.nkey:  # a table without objects has none
        mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    mujoco.mj_forward(model, data)
    return model, data


if __name__ == "__main__":
    model, data = load()
    first = data.xpos.copy()
    while data.time < 2.0:
        mujoco.mj_step(model, data)
    for number in model.jnt_bodyid:
        moved = 1000 * np.linalg.norm(data.xpos[number] - first[number])
        print(f"{model.body(number).name} {moved:.3f}")
