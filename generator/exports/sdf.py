"""SDFormat 1.9: ``scene.sdf``, a world of models, as Gazebo loads it.

The table is a static model. A convex piece is one collision: a primitive, or a mesh that is its
hull. Friction is Coulomb's, of both directions.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping

import numpy as np

from ..scene import Scene
from .bodies import ExportBody, ExportPiece, bodies_of
from .files import ExportFiles
from .xml import INERTIA, along, document_text, number_text, roll_pitch_yaw

VERSION = "1.9"
"""Of SDFormat; ellipsoids came with 1.8."""


def sdf_files(scene: Scene) -> Mapping[str, bytes]:
    """Return a scene's SDF and the files it refers to, by path."""
    files = ExportFiles()
    root = ET.Element("sdf", version=VERSION)
    world = ET.SubElement(root, "world", name="scene")
    light = ET.SubElement(world, "light", name="sun", type="directional")
    _put(light, "pose", [0, 0, 10, 0, 0, 0])
    _put(light, "direction", [0.3, 0.4, -1])
    _put(light, "diffuse", [0.8, 0.8, 0.8, 1])
    _put(light, "specular", [0.1, 0.1, 0.1, 1])
    _floor(world)
    for body in bodies_of(scene):
        _model(world, body, files)
    return {"scene.sdf": document_text(root), **files.content}


def _put(parent: ET.Element, name: str, values: Iterable[float]) -> ET.Element:
    element = ET.SubElement(parent, name)
    element.text = number_text(values)
    return element


def _floor(world: ET.Element) -> None:
    model = ET.SubElement(world, "model", name="floor")
    ET.SubElement(model, "static").text = "true"
    link = ET.SubElement(model, "link", name="link")
    for tag in ("collision", "visual"):
        part = ET.SubElement(link, tag, name=tag)
        plane = ET.SubElement(ET.SubElement(part, "geometry"), "plane")
        _put(plane, "normal", [0, 0, 1])
        _put(plane, "size", [8, 8])


def _model(world: ET.Element, body: ExportBody, files: ExportFiles) -> None:
    model = ET.SubElement(world, "model", name=body.name)
    _put(model, "pose", [*body.position, *roll_pitch_yaw(body.quaternion)])
    if body.fixed:
        ET.SubElement(model, "static").text = "true"
    link = ET.SubElement(model, "link", name="link")
    if not body.fixed:
        inertial = ET.SubElement(link, "inertial")
        _put(inertial, "pose", [*body.com, 0, 0, 0])
        _put(inertial, "mass", [body.mass])
        inertia = ET.SubElement(inertial, "inertia")
        for name, at in INERTIA.items():
            _put(inertia, name, [body.inertia[at]])
    _draw(link, body, files)
    for k, piece in enumerate(body.pieces):
        collision = ET.SubElement(link, "collision", name=f"part_{k}")
        _collide(collision, piece, files)
        surface = ET.SubElement(ET.SubElement(collision, "surface"), "friction")
        ode = ET.SubElement(surface, "ode")
        for name in ("mu", "mu2"):
            _put(ode, name, [body.friction])


def _draw(link: ET.Element, body: ExportBody, files: ExportFiles) -> None:
    visual = ET.SubElement(link, "visual", name="visual")
    if body.mesh.opacity < 1:
        _put(visual, "transparency", [1 - body.mesh.opacity])
    mesh = ET.SubElement(ET.SubElement(visual, "geometry"), "mesh")
    ET.SubElement(mesh, "uri").text = files.visual(body)
    material = ET.SubElement(visual, "material")
    for name in ("ambient", "diffuse"):
        _put(material, name, [1, 1, 1, 1])
    metal = ET.SubElement(ET.SubElement(material, "pbr"), "metal")
    ET.SubElement(metal, "albedo_map").text = files.texture(body)
    _put(metal, "metalness", [0])
    _put(metal, "roughness", [0.7])


def _collide(collision: ET.Element, piece: ExportPiece, files: ExportFiles) -> None:
    if piece.kind != "mesh":
        turn = along(piece.axis) if piece.kind == "cylinder" else np.zeros(3)
        _put(collision, "pose", [*piece.center, *turn])
    shape = ET.SubElement(collision, "geometry")
    if piece.kind == "mesh":
        ET.SubElement(ET.SubElement(shape, "mesh"), "uri").text = files.collision(piece)
        return
    form = ET.SubElement(shape, piece.kind)
    if piece.kind == "box":
        _put(form, "size", 2 * piece.half)
    elif piece.kind == "ellipsoid":
        _put(form, "radii", piece.half)
    elif piece.kind == "sphere":
        _put(form, "radius", [piece.half.mean()])
    else:
        _put(form, "radius", [piece.radius])
        _put(form, "length", [2 * piece.half[piece.axis]])
