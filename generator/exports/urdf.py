"""URDF export: ``scene.urdf`` with the world, the table and the objects, and a file for each body.

In ``scene.urdf`` the table is attached to the link "world" by a fixed joint and each object by a
floating joint, at its resting pose, for readers that support floating joints (MuJoCo). Others load
``objects/NAME.urdf``, one body each, including the table and the floor, at the poses of
``poses.json``, as ``load_pybullet.py`` and ``load_drake.py`` do. URDF itself has no friction; it is
given in elements for PyBullet, Drake and Gazebo, see ``engines``. Ellipsoids are exported as hulls.

In addition to its texture, a body has a colour. In ``scene.urdf`` it is the mean of the texture,
for readers without textures (MuJoCo), which would otherwise draw white objects; in an object's own
file it is white, since PyBullet multiplies the texture by it.
"""

from __future__ import annotations

import json
import xml.etree.ElementTree as ET
from collections.abc import Mapping

import numpy as np

from ..render.shading import sample_texture
from ..scene.triangles import areas
from .bodies import ExportBody, ExportPiece, ExportWorld, floor_body
from .engines import DRAKE, EngineFriction, drake_properties, engine_friction
from .files import INERTIA, ExportFiles, along, document_text, number_text, roll_pitch_yaw
from .loaders import loader_scripts

_COMPILER = {"strippath": "false", "fusestatic": "false", "discardvisual": "false"}


def urdf_files(world: ExportWorld) -> Mapping[str, bytes]:
    """Return the URDF files and the files that they refer to, keyed by path."""
    files, bodies = ExportFiles(), world.bodies
    rubbing = engine_friction(bodies, world.ground)
    root = _robot(world.name)
    ET.SubElement(root, "link", name="world")
    for body in bodies:
        _link(root, body, rubbing[body.name], files, "")
        joint = ET.SubElement(
            root, "joint", name=f"{body.name}_joint", type="fixed" if body.fixed else "floating"
        )
        turn = roll_pitch_yaw(body.quaternion)
        ET.SubElement(joint, "origin", xyz=number_text(body.position), rpy=number_text(turn))
        ET.SubElement(joint, "parent", link="world")
        ET.SubElement(joint, "child", link=body.name)
    written = {"scene.urdf": document_text(root)}
    poses = {}
    for body in (floor_body(world.ground), *bodies):
        alone = _robot(body.name)
        _link(alone, body, rubbing[body.name], files, "../")
        written[f"objects/{body.name}.urdf"] = document_text(alone)
        poses[body.name] = {
            "fixed": body.fixed,
            "position": body.position.tolist(),
            "quaternion_wxyz": body.quaternion.tolist(),
        }
    written["poses.json"] = json.dumps(poses, indent=1).encode() + b"\n"
    return written | files.content | loader_scripts("pybullet", "drake")


def _robot(name: str) -> ET.Element:
    root = ET.Element("robot", {"name": name, **DRAKE})
    ET.SubElement(ET.SubElement(root, "mujoco"), "compiler", _COMPILER)
    return root


def _link(
    root: ET.Element, body: ExportBody, rubbing: EngineFriction, files: ExportFiles, above: str
) -> None:
    """Add a body as a link; ``above`` is the path from the document to the export's folder."""
    link = ET.SubElement(root, "link", name=body.name)
    inertial = ET.SubElement(link, "inertial")
    ET.SubElement(inertial, "origin", xyz=number_text(body.com), rpy="0 0 0")
    ET.SubElement(inertial, "mass", value=number_text([body.mass]))
    entries = {name: number_text([body.inertia[at]]) for name, at in INERTIA.items()}
    ET.SubElement(inertial, "inertia", entries)
    visual = ET.SubElement(link, "visual")
    shape = ET.SubElement(visual, "geometry")
    ET.SubElement(shape, "mesh", filename=above + files.visual(body))
    material = ET.SubElement(visual, "material", name=f"{body.name}_material")
    color = [1.0, 1.0, 1.0] if above else mean_color(body)
    ET.SubElement(material, "color", rgba=number_text([*color, body.mesh.opacity]))
    ET.SubElement(material, "texture", filename=above + files.texture(body))
    for piece in body.pieces:
        collision = ET.SubElement(link, "collision")
        _collide(collision, piece, files, above)
        properties = ET.SubElement(collision, "drake:proximity_properties")
        for name, value in drake_properties(piece, rubbing.drake).items():
            ET.SubElement(properties, name, {} if value is None else {"value": value})
    contact = ET.SubElement(link, "contact")
    ET.SubElement(contact, "lateral_friction", value=number_text([rubbing.pybullet]))
    gazebo = ET.SubElement(root, "gazebo", reference=body.name)
    for name in ("mu1", "mu2"):
        ET.SubElement(gazebo, name).text = number_text([rubbing.gazebo])


def mean_color(body: ExportBody) -> list[float]:
    """Return the mean colour, from 0 to 1, of the visible part of a body's texture."""
    mesh = body.mesh
    area = areas(body.vertices, mesh.faces.astype(np.int64))
    shown = sample_texture(mesh.texture, mesh.uv[mesh.faces].astype(np.float64).mean(1))
    return np.average(shown, axis=0, weights=np.maximum(area, 1e-12)).round(4).tolist()


def _collide(collision: ET.Element, piece: ExportPiece, files: ExportFiles, above: str) -> None:
    if piece.kind in ("box", "cylinder", "sphere"):
        turn = along(piece.axis) if piece.kind == "cylinder" else (0, 0, 0)
        ET.SubElement(collision, "origin", xyz=number_text(piece.center), rpy=number_text(turn))
    shape = ET.SubElement(collision, "geometry")
    if piece.kind == "box":
        ET.SubElement(shape, "box", size=number_text(2 * piece.half))
    elif piece.kind == "cylinder":
        length = number_text([2 * piece.half[piece.axis]])
        ET.SubElement(shape, "cylinder", radius=number_text([piece.radius]), length=length)
    elif piece.kind == "sphere":
        ET.SubElement(shape, "sphere", radius=number_text([piece.half.mean()]))
    else:
        mesh = ET.SubElement(shape, "mesh", filename=above + files.collision(piece))
        ET.SubElement(mesh, "drake:declare_convex")
