"""MJCF export with each mesh in its own file: ``scene.xml``, for importers that require mesh files.

It equals a bundle's ``scene.xml``, including cameras and the keyframe "settled", except that the
table has an inertia, too, and bodies that are added without one get theirs from their geoms.
``load_mujoco.py`` loads it.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Mapping

import numpy as np

from ..scene import ConvexPart
from .bodies import ExportBody, ExportWorld, piece_of
from .files import INERTIA, number_text, plain_obj
from .loaders import loader_scripts


def mjcf_files(world: ExportWorld) -> Mapping[str, bytes]:
    """Return the MJCF file, the files that it refers to and a loader script, keyed by path."""
    written = world.mjcf()
    root = ET.fromstring(written.xml)
    files = dict(written.files)
    for mesh in root.iter("mesh"):
        if (numbers := mesh.attrib.pop("vertex", None)) is not None:
            corners = np.array(numbers.split(), np.float64).reshape(-1, 3)
            hull = piece_of(ConvexPart(corners))
            path = f"meshes/{mesh.attrib['name']}.obj"
            files[path] = plain_obj(hull.vertices, hull.faces)
            mesh.set("file", path)
    for compiler in root.iter("compiler"):
        compiler.attrib.pop("inertiafromgeom")  # by default it applies to geoms
    fixed = {body.name: body for body in world.bodies if body.fixed}
    for element in root.iter("body"):
        if element.attrib["name"] in fixed:
            element.insert(0, _inertial(fixed[element.attrib["name"]]))
    ET.indent(root)
    return {"scene.xml": ET.tostring(root) + b"\n", **files, **loader_scripts("mujoco")}


def _inertial(body: ExportBody) -> ET.Element:
    entries = (body.inertia[INERTIA[name]] for name in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz"))
    return ET.Element(
        "inertial", pos=number_text(body.com), mass=number_text([body.mass]),
        fullinertia=number_text(entries),
    )  # fmt: skip
