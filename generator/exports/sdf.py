"""SDFormat 1.9 export: ``scene.sdf``, a world of models that Gazebo can load.

Table and floor are static models. A convex piece is one collision: a primitive, or a mesh that is
its hull. Friction is isotropic Coulomb friction, given separately for Gazebo and for Drake; see
``engines``. ``load_drake.py`` loads the scene into Drake.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping

import numpy as np

from .bodies import ExportBody, ExportPiece, ExportWorld, floor_body
from .engines import DRAKE, EngineFriction, drake_properties, engine_friction
from .files import INERTIA, ExportFiles, along, document_text, number_text, roll_pitch_yaw
from .loaders import loader_scripts

VERSION = "1.9"
"""Version of SDFormat; ellipsoids need at least 1.8."""


def sdf_files(content: ExportWorld) -> Mapping[str, bytes]:
    """Return the SDF file, the files that it refers to and a loader script, keyed by path."""
    files = ExportFiles()
    root = ET.Element("sdf", {"version": VERSION, **DRAKE})
    world = ET.SubElement(root, "world", name="scene")
    light = ET.SubElement(world, "light", name="sun", type="directional")
    _put(light, "pose", [0, 0, 10, 0, 0, 0])
    _put(light, "direction", [0.3, 0.4, -1])
    _put(light, "diffuse", [0.8, 0.8, 0.8, 1])
    _put(light, "specular", [0.1, 0.1, 0.1, 1])
    rubbing = engine_friction(content.bodies, content.ground)
    for body in (floor_body(content.ground), *content.bodies):
        _model(world, body, rubbing[body.name], files)
    return {"scene.sdf": document_text(root), **files.content, **loader_scripts("drake")}


def _put(parent: ET.Element, name: str, values: Iterable[float]) -> ET.Element:
    element = ET.SubElement(parent, name)
    element.text = number_text(values)
    return element


def _model(
    world: ET.Element, body: ExportBody, rubbing: EngineFriction, files: ExportFiles
) -> None:
    model = ET.SubElement(world, "model", name=body.name)
    _put(model, "pose", [*body.position, *roll_pitch_yaw(body.quaternion)])
    if body.fixed:
        ET.SubElement(model, "static").text = "true"
    link = ET.SubElement(model, "link", name="link")
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
            _put(ode, name, [rubbing.gazebo])
        properties = ET.SubElement(collision, "drake:proximity_properties")
        for name, value in drake_properties(piece, rubbing.drake).items():
            ET.SubElement(properties, name).text = value


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
        mesh = ET.SubElement(shape, "mesh")
        ET.SubElement(mesh, "uri").text = files.collision(piece)
        ET.SubElement(mesh, "drake:declare_convex")
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
