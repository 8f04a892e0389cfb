"""MJCF with every mesh in a file: ``scene.xml``, for importers that read no vertices in the XML.

It is a bundle's ``scene.xml`` otherwise, cameras and the keyframe "settled" included.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Mapping

import numpy as np

from ..physics.mjcf import document
from ..scene import ConvexPart, Scene
from .bodies import piece_of
from .files import plain_obj


def mjcf_files(scene: Scene) -> Mapping[str, bytes]:
    """Return a scene's MJCF and the files it refers to, by path."""
    written = document(scene)
    root = ET.fromstring(written.xml)
    files = dict(written.files)
    for mesh in root.iter("mesh"):
        if (numbers := mesh.attrib.pop("vertex", None)) is not None:
            corners = np.array(numbers.split(), np.float64).reshape(-1, 3)
            hull = piece_of(ConvexPart(corners))
            path = f"meshes/{mesh.attrib['name']}.obj"
            files[path] = plain_obj(hull.vertices, hull.faces)
            mesh.set("file", path)
    return {"scene.xml": ET.tostring(root) + b"\n", **files}
