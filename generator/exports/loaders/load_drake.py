"""Load this scene into Drake: objects free at their poses, table and floor fixed.

python load_drake.py prints how far each object moves in two seconds, in millimetres.
"""

import json
import logging
from pathlib import Path

import numpy as np
from pydrake.common.eigen_geometry import Quaternion
from pydrake.math import RigidTransform
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlant, MultibodyPlant, MultibodyPlantConfig
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

CONFIG = MultibodyPlantConfig(
    time_step=0.002,
    contact_model="hydroelastic_with_fallback",
    discrete_contact_approximation="lagged",
)
"""Settings of the plant; with point contact, flat bodies rest on one point and tilt."""


def load(plant: MultibodyPlant) -> None:
    """Add the scene to a plant that is part of a scene graph and not finalized yet."""
    folder, parser = Path(__file__).parent, Parser(plant)
    if (folder / "scene.sdf").is_file():
        parser.AddModels(folder / "scene.sdf")
        return
    for name, pose in json.loads((folder / "poses.json").read_text()).items():
        (model,) = parser.AddModels(folder / "objects" / f"{name}.urdf")
        body = plant.GetBodyByName(name, model)
        place = RigidTransform(Quaternion(pose["quaternion_wxyz"]), pose["position"])
        if pose["fixed"]:
            plant.WeldFrames(plant.world_frame(), body.body_frame(), place)
        else:
            plant.SetDefaultFloatingBaseBodyPose(body, place)


if __name__ == "__main__":
    logging.getLogger("drake").setLevel(logging.ERROR)  # hide messages about textures and lights
    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlant(CONFIG, builder)
    load(plant)
    plant.Finalize()
    simulator = Simulator(builder.Build())
    context = plant.GetMyContextFromRoot(simulator.get_context())
    bodies = [plant.get_body(index) for index in sorted(plant.GetFloatingBaseBodies())]
    first = [plant.EvalBodyPoseInWorld(context, body).translation() for body in bodies]
    simulator.AdvanceTo(2.0)
    for body, start in zip(bodies, first, strict=True):
        moved = plant.EvalBodyPoseInWorld(context, body).translation() - start
        name = plant.GetModelInstanceName(body.model_instance())
        print(f"{name} {1000 * np.linalg.norm(moved):.3f}")
