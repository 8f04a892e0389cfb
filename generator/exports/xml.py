"""What exports in XML write alike."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterable

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

INERTIA = {"ixx": (0, 0), "ixy": (0, 1), "ixz": (0, 2), "iyy": (1, 1), "iyz": (1, 2), "izz": (2, 2)}
"""Names of an inertia's entries, of URDF and SDF, and where they are."""

_ALONG = np.array([[0, np.pi / 2, 0], [-np.pi / 2, 0, 0], [0, 0, 0]])


def number_text(numbers: Iterable[float]) -> str:
    """Return numbers as text: nine significant digits, no negative zero."""
    return " ".join(f"{float(x) + 0.0:.9g}" for x in numbers)


def roll_pitch_yaw(quaternion: Float[np.ndarray, "4"]) -> Float[np.ndarray, "3"]:
    """Return a unit wxyz quaternion as turns about the fixed x, y and z axes, in this order."""
    return Rotation.from_quat(quaternion, scalar_first=True).as_euler("xyz")


def along(axis: int) -> Float[np.ndarray, "3"]:
    """Return roll, pitch and yaw that turn the z axis to ``axis``."""
    return _ALONG[axis]


def document_text(root: ET.Element) -> bytes:
    """Return an indented document with its declaration."""
    ET.indent(root)
    return b'<?xml version="1.0" encoding="utf-8"?>\n' + ET.tostring(root, encoding="utf-8") + b"\n"
