"""One object as a free body that stands on the floor."""

from __future__ import annotations

import numpy as np

from ..geometry import yaw_quaternion
from ..physics.inertia import body_mass
from ..physics.parts import body_parts
from ..scene import Model, Object, Placement, Pose


def stand_on_floor(model: Model) -> Object:
    """Return a model as a body of its real size whose underside is at z = 0."""
    middle = np.array([0.0, 0.0, model.size[2] / 2])
    parts = body_parts(model, model.size)
    weight = body_mass(model.mesh, model.size, model.physics, parts)
    return Object(
        model.name, model, Placement(model.name, 0.0, middle, model.size), parts,
        weight.mass, weight.com, weight.inertia, model.physics.friction,
        Pose(middle, yaw_quaternion(0.0)),
    )  # fmt: skip
