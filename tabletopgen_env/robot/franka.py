"""Constants of the Panda: values published by Franka, and experimentally identified masses.

Sources: *Franka Control Interface documentation, robot and interface specifications* (modified
Denavit-Hartenberg parameters after Craig, joint position, velocity and torque limits, hand and
finger dimensions, grasp force); *franka_description* (the capsules of its self-collision model); C.
Gaz, M. Cognetti, A. Oliva, P. Robuffo Giordano, A. De Luca, "Dynamic Identification of the Franka
Emika Panda Robot With Retrieval of Feasible Parameters Using Penalty-Based Optimization", IEEE RA-L
4(4), 2019 (link masses, centres of mass and inertia tensors). Gains, home pose and the gripper's
0-255 command are those of the MuJoCo Menagerie model, so policies transfer between the two.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

HALF_PI = float(np.pi / 2)


@dataclass(frozen=True)
class Joint:
    """One arm joint, with the modified DH frame that precedes it.

    ``a`` and ``d`` are in metres, ``alpha`` in radians; the link's frame in its parent's is
    ``Rot_x(alpha) Trans_x(a) Rot_z(q) Trans_z(d)``. ``low`` and ``high`` bound q (radians),
    ``velocity`` is in rad/s, ``torque`` in N m, ``stiffness`` and ``damping`` are the position
    servo's gains (N m/rad, N m s/rad).
    """

    a: float
    d: float
    alpha: float
    low: float
    high: float
    velocity: float
    torque: float
    stiffness: float
    damping: float

    @property
    def place(self) -> tuple[float, float, float]:
        """The position (m) of the link's frame in its parent frame."""
        return self.a, float(-self.d * np.sin(self.alpha)), float(self.d * np.cos(self.alpha))

    @property
    def turn(self) -> tuple[float, float, float, float]:
        """The wxyz quaternion of the link's frame in its parent frame at q = 0."""
        return float(np.cos(self.alpha / 2)), float(np.sin(self.alpha / 2)), 0.0, 0.0


JOINTS: tuple[Joint, ...] = (
    Joint(0.0, 0.333, 0.0, -2.8973, 2.8973, 2.175, 87.0, 4500.0, 450.0),
    Joint(0.0, 0.0, -HALF_PI, -1.7628, 1.7628, 2.175, 87.0, 4500.0, 450.0),
    Joint(0.0, 0.316, HALF_PI, -2.8973, 2.8973, 2.175, 87.0, 3500.0, 350.0),
    Joint(0.0825, 0.0, HALF_PI, -3.0718, -0.0698, 2.175, 87.0, 3500.0, 350.0),
    Joint(-0.0825, 0.384, -HALF_PI, -2.8973, 2.8973, 2.61, 12.0, 2000.0, 200.0),
    Joint(0.0, 0.0, HALF_PI, -0.0175, 3.7525, 2.61, 12.0, 2000.0, 200.0),
    Joint(0.088, 0.0, HALF_PI, -2.8973, 2.8973, 2.61, 12.0, 2000.0, 200.0),
)
"""The seven joints, base to wrist."""

HOME: tuple[float, ...] = (0.0, 0.0, 0.0, -HALF_PI, 0.0, HALF_PI, -HALF_PI / 2)
"""Home pose, in radians: the hand points straight down, 0.55 m in front of the base."""

FLANGE = 0.107
"""Distance from the frame of joint 7 to the flange, where the hand is mounted, in metres."""

HAND_YAW = -np.pi / 4
"""Rotation of the hand about the flange's axis, in radians."""

FINGER_MOUNT = 0.0584
"""Distance from the flange to the fingers' slides, in metres."""

TCP = 0.1034
"""Distance from the flange to the tool centre point between the fingertips, in metres."""

FINGER_STROKE = 0.04
"""Travel of each finger, in metres; the gripper opens by twice as much."""

GRIPPER_CTRL = 255.0
"""Gripper command when fully open; 0 closes."""


@dataclass(frozen=True)
class Inertial:
    """Mass (kg), centre of mass (m) and inertia (xx, yy, zz, xy, xz, yz; kg m^2) of one body."""

    mass: float
    com: tuple[float, float, float]
    inertia: tuple[float, float, float, float, float, float]


INERTIALS: dict[str, Inertial] = {
    "link0": Inertial(0.629769, (-0.041018, -0.00014, 0.049974),
        (0.00315, 0.00388, 0.004285, 8.2904e-7, 0.00015, 8.2299e-6)),
    "link1": Inertial(4.970684, (0.003875, 0.002081, -0.04762),
        (0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169)),
    "link2": Inertial(0.646926, (-0.003141, -0.02872, 0.003495),
        (0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704)),
    "link3": Inertial(3.228604, (0.027518, 0.039252, -0.066502),
        (0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805)),
    "link4": Inertial(3.587895, (-0.05317, 0.104419, 0.027454),
        (0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641)),
    "link5": Inertial(1.225946, (-0.011953, 0.041065, -0.038437),
        (0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229)),
    "link6": Inertial(1.666555, (0.060149, -0.014117, -0.010517),
        (0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341)),
    "link7": Inertial(0.735522, (0.010517, -0.004252, 0.061597),
        (0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741)),
    "hand": Inertial(0.73, (-0.01, 0.0, 0.03), (0.001, 0.0025, 0.0017, 0.0, 0.0, 0.0)),
    "left_finger": Inertial(0.015, (0.0, 0.0, 0.0), (2.375e-6, 2.375e-6, 7.5e-7, 0.0, 0.0, 0.0)),
    "right_finger": Inertial(0.015, (0.0, 0.0, 0.0), (2.375e-6, 2.375e-6, 7.5e-7, 0.0, 0.0, 0.0)),
}  # fmt: skip
"""Inertial parameters of the links, identified by Gaz et al. (2019), and of the hand, by Franka."""


@dataclass(frozen=True)
class Capsule:
    """A collision capsule: two end points and a radius in its body's frame, in metres."""

    start: tuple[float, float, float]
    end: tuple[float, float, float]
    radius: float


CAPSULES: dict[str, tuple[Capsule, ...]] = {
    "link0": (Capsule((-0.09, 0.0, 0.06), (-0.06, 0.0, 0.06), 0.06),),
    "link1": (Capsule((0.0, 0.0, -0.25), (0.0, 0.0, -0.05), 0.06),),
    "link2": (Capsule((0.0, 0.0, -0.06), (0.0, 0.0, 0.06), 0.06),),
    "link3": (Capsule((0.0, 0.0, -0.22), (0.0, 0.0, -0.07), 0.06),),
    "link4": (Capsule((0.0, 0.0, -0.06), (0.0, 0.0, 0.06), 0.06),),
    "link5": (
        Capsule((0.0, 0.0, -0.31), (0.0, 0.0, -0.21), 0.06),
        Capsule((0.0, 0.08, -0.2), (0.0, 0.08, -0.06), 0.025),
    ),
    "link6": (Capsule((0.0, 0.0, -0.07), (0.0, 0.0, 0.01), 0.05),),
    "link7": (
        Capsule((0.0, 0.0, -0.06), (0.0, 0.0, 0.08), 0.04),
        Capsule((0.055, 0.0, 0.082), (0.065, 0.0, 0.082), 0.03),
    ),
}
"""Franka's published self-collision capsules (franka_description), cylindrical parts only."""
