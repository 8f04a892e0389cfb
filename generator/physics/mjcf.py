"""Conversion of a scene to MJCF: one XML document and its files, which plain MuJoCo can load.

The body and the free joint of an object have the object's name; the table's body is named "table"
and the floor's geom "floor". The cameras are "reference" (the scene's view) and "top"; the keyframe
"settled" has every object's resting pose. Visual geoms are in group 2, collision geoms in group 3.
Meshes, textures and hulls are named by the digest of their content.
"""

from __future__ import annotations

import hashlib
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, Literal

import numpy as np
from jaxtyping import Float, Real

from ..geometry import framing_camera, quaternion_matrix
from ..io.pictures import encode_png
from ..scene import TABLE, ConvexPart, Mesh, Object, Scene, View

FLOOR = "floor"
"""Name of the floor's geom."""

FRICTION_STIFFNESS = 10
"""Ratio of frictional to normal contact impedance (MuJoCo's impratio). At 1, objects that lean in a
mug or lie in a heap creep by half a millimetre per second. Larger ratios reduce the creep; up to
ten, they hardly slow the simulation down. The environments use the same value."""

FLAT_SPOT = 0.1
"""Rolling resistance of round objects, as a fraction of the radius. It is the tangent of the angle
at which they start to roll, almost 6 degrees; on a table tilted by 2 degrees they rest, as fruit
does. Small objects, such as marbles, would still roll, so their rolling resistance is at least
``_LEAST_FLAT`` metres."""

_LEAST_FLAT = 0.002
_FIRM = {"solimp": "0.98 0.99 0.001", "solmix": "100"}
"""Contacts with rolling resistance are stiffer than MuJoCo's default (0.9 0.95), since softer ones
let objects creep, in proportion to the inverse square of FLAT_SPOT: on a table tilted by 2 degrees,
an orange turns by 1 degree in 5 s with these values, and by 5 degrees with the defaults."""

_SLENDER, _THIN = 0.35, 0.04  # maximum thickness of slender objects: fraction of length; metres
_ROUND = 0.02  # maximum relative difference between two diameters of a round cross-section
VERTEX_DIGITS, UV_DIGITS = 6, 5
"""Numbers of decimals in stored meshes: of vertices in the unit box, and of uv coordinates."""

_TINY = 1e-200  # MuJoCo treats smaller numbers as zero
_TOP_VIEW = View(azimuth=0.0, elevation=np.pi / 2, fov=np.deg2rad(30.0))
_HALF = np.sqrt(0.5)
_AXIS_QUATERNION = ((_HALF, 0.0, _HALF, 0.0), (_HALF, -_HALF, 0.0, 0.0))  # rotations of z to x, y


GeomKind = Literal["mesh", "box", "cylinder", "sphere", "ellipsoid"]
"""The MuJoCo geom type of each kind of convex part."""


@dataclass(frozen=True)
class Document:
    """The document ``scene.xml`` and the files to which it refers, by relative path."""

    xml: str
    files: Mapping[str, bytes]


def document(
    scene: Scene,
    *,
    visuals: bool = True,
    paths: Mapping[Mesh, tuple[str, str]] = MappingProxyType({}),
    fixed: Sequence[Object] = (),
) -> Document:
    """Return the MJCF of a scene; without ``visuals``, it contains only the physics.

    ``paths`` are the paths of existing meshes and textures, to which the document only refers.
    ``fixed`` objects are added before the scene's own, without joints.
    """
    root = ET.Element("mujoco", model=scene.name)
    _settings(root)
    assets = _Assets(ET.SubElement(root, "asset"), visuals, paths)
    world = ET.SubElement(root, "worldbody")
    _floor(world)
    if visuals:
        _light(world, scene.table.height)
        _cameras(world, scene)
    table = ET.SubElement(world, "body", name=TABLE, pos=_text([0, 0, scene.table.height / 2]))
    assets.draw(table, scene.table.model.mesh, scene.table.scale)
    for part in scene.table.parts:
        assets.collide(table, part, scene.table.friction)
    for thing in fixed:
        _body(world, thing, assets, free=False)
    for thing in scene.objects:
        _body(world, thing, assets)
    if scene.objects:
        keyframe = ET.SubElement(root, "keyframe")
        poses = np.concatenate([_pose(thing) for thing in scene.objects])
        ET.SubElement(keyframe, "key", name="settled", qpos=_text(poses))
    ET.indent(root)
    return Document(ET.tostring(root, encoding="unicode") + "\n", dict(assets.files))


def object_document(
    thing: Object, *, visuals: bool = False, floor: float | None = None
) -> Document:
    """Return the MJCF of a single object, as a free body at its pose.

    Args:
        thing: the object.
        visuals: whether to add its visual geom and a light; otherwise only the physics is written.
        floor: friction of a floor at z = 0; if None, no floor is added.
    """
    root = ET.Element("mujoco", model=thing.name)
    _settings(root)
    assets = _Assets(ET.SubElement(root, "asset"), visuals, {})
    world = ET.SubElement(root, "worldbody")
    if floor is not None:
        _floor(world).set("friction", _text([floor]))
    if visuals:
        _light(world, 0.0)
    _body(world, thing, assets)
    ET.indent(root)
    return Document(ET.tostring(root, encoding="unicode") + "\n", dict(assets.files))


def written_poses(things: Sequence[Object]) -> Float[np.ndarray, "n 7"]:
    """Return positions (metres) and quaternions as MuJoCo reads them from the document.

    They are rounded as in the document; MuJoCo normalises quaternions.
    """
    poses = np.array([_read(_text(_pose(thing))) for thing in things]).reshape(-1, 7)
    w, x, y, z = poses[:, 3:].T
    poses[:, 3:] /= np.sqrt(w * w + x * x + y * y + z * z)[:, None]
    return poses


# ------------------------------------------------------------------------------------- encoding


def encode_obj(mesh: Mesh) -> bytes:
    """Return a mesh as Wavefront OBJ, with vertices rounded to 1e-6 and uv coordinates to 1e-5."""
    corners = np.repeat(mesh.faces + 1, 2, axis=1)  # each corner with a vertex and its uv
    vertex, uv = f" %.{VERTEX_DIGITS}f", f" %.{UV_DIGITS}f"
    text = row_lines(f"v{3 * vertex}\n", mesh.vertices) + row_lines(f"vt{2 * uv}\n", mesh.uv)
    return (text + row_lines("f %d/%d %d/%d %d/%d\n", corners)).encode("ascii")


def row_lines(pattern: str, rows: Real[np.ndarray, "n k"]) -> str:
    """Return one line per row; all rows are formatted in a single operation, for speed."""
    return pattern * len(rows) % tuple(rows.ravel().tolist())


def mesh_path(encoded: bytes) -> str:
    """Return the path of an encoded mesh in a bundle."""
    return f"meshes/{_digest(encoded)}.obj"


def texture_path(encoded: bytes) -> str:
    """Return the path of an encoded texture in a bundle."""
    return f"textures/{_digest(encoded)}.png"


def mesh_files(mesh: Mesh) -> dict[str, bytes]:
    """Return the encoded files of a mesh and its texture by their paths in a bundle, mesh first."""
    obj, png = encode_obj(mesh), encode_png(mesh.texture)
    return {mesh_path(obj): obj, texture_path(png): png}


# --------------------------------------------------------------------------------------- pieces


def _settings(root: ET.Element) -> None:
    ET.SubElement(root, "compiler", angle="radian", inertiafromgeom="false")
    option = ET.SubElement(
        root, "option", timestep="0.002", integrator="implicitfast", cone="elliptic",
        impratio=_text([FRICTION_STIFFNESS]),
    )  # fmt: skip
    ET.SubElement(option, "flag", sleep="enable")
    visual = ET.SubElement(root, "visual")
    ET.SubElement(visual, "global", offwidth="2048", offheight="2048")
    ET.SubElement(visual, "headlight", ambient=".45 .45 .45", diffuse=".3 .3 .3", specular="0 0 0")
    ET.SubElement(visual, "quality", shadowsize="4096")
    ET.SubElement(visual, "map", shadowclip="2")
    default = ET.SubElement(root, "default")
    drawn = ET.SubElement(default, "default", {"class": "visual"})
    ET.SubElement(drawn, "geom", type="mesh", group="2", contype="0", conaffinity="0", mass="0")
    solid = ET.SubElement(default, "default", {"class": "collision"})
    ET.SubElement(solid, "geom", group="3", condim="4", solref="0.01 1", rgba=".3 .6 .9 .4")


def _floor(world: ET.Element) -> ET.Element:
    return ET.SubElement(
        world, "geom", name=FLOOR, type="plane", size="4 4 0.05", rgba=".93 .93 .92 1",
        condim="4", solref="0.01 1",
    )  # fmt: skip


def _light(world: ET.Element, height: float) -> None:
    """Add a light two metres above the given height."""
    ET.SubElement(
        world, "light", type="directional", pos=_text([0, 0, height + 2]),
        dir="0.3 0.4 -1", diffuse=".5 .5 .5", specular=".1 .1 .1",
    )  # fmt: skip


def _cameras(world: ET.Element, scene: Scene) -> None:
    points = _points(scene)
    cameras = {
        "reference": framing_camera(points, scene.view, 960, 720),
        "top": framing_camera(points, _TOP_VIEW, 960, 720),
    }
    for name, camera in cameras.items():
        right, down, _ = camera.rotation
        ET.SubElement(
            world, "camera", name=name, pos=_text(camera.position),
            xyaxes=_text([*right, *-down]), fovy=_text([np.rad2deg(camera.fov)]),
        )  # fmt: skip


def _body(world: ET.Element, thing: Object, assets: _Assets, *, free: bool = True) -> None:
    body = ET.SubElement(
        world, "body", name=thing.name, pos=_text(thing.pose.position),
        quat=_text(thing.pose.quaternion),
    )  # fmt: skip
    if free:
        ET.SubElement(body, "freejoint", name=thing.name)
    i = thing.inertia
    ET.SubElement(
        body, "inertial", pos=_text(thing.com), mass=_text([thing.mass]),
        fullinertia=_text([i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2]]),
    )  # fmt: skip
    assets.draw(body, thing.model.mesh, thing.scale)
    across, along = np.sort(thing.scale)[1:]
    slender = bool(across < min(_SLENDER * along, _THIN))
    for part in thing.parts:
        assets.collide(body, part, thing.friction, slender)


class _Assets:
    """Writer of geoms, which adds each mesh, texture and hull to the document only once."""

    def __init__(
        self, element: ET.Element, visuals: bool, paths: Mapping[Mesh, tuple[str, str]]
    ) -> None:
        self.files: dict[str, bytes] = {}
        self._paths: dict[Mesh, tuple[str, ...]] = dict(paths)
        self._element = element
        self._visuals = visuals
        self._named: set[str] = set()

    def _add(self, tag: str, name: str, **attributes: str) -> str:
        if name not in self._named:
            self._named.add(name)
            ET.SubElement(self._element, tag, {"name": name, **attributes})
        return name

    def draw(self, body: ET.Element, mesh: Mesh, scale: Float[np.ndarray, "3"]) -> None:
        """Add the textured mesh as a visual geom, which makes no contacts."""
        if not self._visuals:
            return
        if mesh not in self._paths:
            files = mesh_files(mesh)
            self.files |= files
            self._paths[mesh] = tuple(files)
        shape, picture = self._paths[mesh]
        size = _text(scale)
        mesh_name = self._add(
            "mesh", f"mesh_{_digest((shape + size).encode())}", file=shape, scale=size,
            inertia="shell",
        )  # fmt: skip
        texture = self._add("texture", f"texture_{Path(picture).stem}", type="2d", file=picture)
        alpha = _text([mesh.opacity])
        material = self._add(
            "material", f"material_{_digest((texture + alpha).encode())}", texture=texture,
            rgba=f"1 1 1 {alpha}", specular="0.2", shininess="0.3",
        )  # fmt: skip
        ET.SubElement(body, "geom", {"class": "visual"}, mesh=mesh_name, material=material)

    def collide(
        self, body: ET.Element, part: ConvexPart, friction: float, slender: bool = False
    ) -> None:
        """Add a convex part as a collision geom, which is a primitive if possible.

        Round parts, and the parts of ``slender`` objects, resist rolling on a slightly tilted
        table, as fruit does with its soft spots and a pen with its clip.
        """
        kind, attributes = primitive(part)
        round_ = kind in ("sphere", "ellipsoid") or (kind == "cylinder" and part.axis != 2)
        resistance = 0.0001
        if round_ or slender:
            attributes |= {"condim": "6", **_FIRM}
            low, high = part.bounds
            resistance = max(_LEAST_FLAT, FLAT_SPOT * float((high - low).min()) / 2)
        if kind == "mesh":
            vertices = _text(part.vertices.round(6).ravel())
            attributes["mesh"] = self._add(
                "mesh", f"hull_{_digest(vertices.encode())}", vertex=vertices, inertia="convex"
            )
        slide = _text([friction, 0.003, resistance])
        always = {"class": "collision", "type": kind, "friction": slide}
        ET.SubElement(body, "geom", always | attributes)


def primitive(part: ConvexPart) -> tuple[str, dict[str, str]]:
    """Return a part's geom type and attributes, or "mesh" if no primitive fits."""
    kind = primitive_kind(part)
    if kind == "mesh":
        return kind, {}
    low, high = part.bounds
    half = (high - low) / 2
    attributes = {"pos": _text((low + high) / 2)}
    if kind == "sphere":
        return kind, attributes | {"size": _text([half.mean()])}
    if kind != "cylinder":
        return kind, attributes | {"size": _text(half)}
    if part.axis != 2:
        attributes["quat"] = _text(_AXIS_QUATERNION[part.axis])
    across = np.delete(half, part.axis)
    return kind, attributes | {"size": _text([across.mean(), half[part.axis]])}


def primitive_kind(part: ConvexPart) -> GeomKind:
    """Return a part's geom type, or "mesh" if no primitive fits."""
    if part.kind in ("hull", "box"):
        return "mesh" if part.kind == "hull" else "box"
    low, high = part.bounds
    half = (high - low) / 2
    if part.kind == "ellipsoid":
        return "sphere" if half.max() <= (1 + _ROUND) * half.min() else "ellipsoid"
    across = np.delete(half, part.axis)
    return "cylinder" if across.max() <= (1 + _ROUND) * across.min() else "mesh"


def _points(scene: Scene) -> Float[np.ndarray, "n 3"]:
    """Return all visual vertices of a scene in the world frame."""
    table = scene.table
    points = [table.model.mesh.vertices * table.scale + [0, 0, table.height / 2]]
    for thing in scene.objects:
        rotation = quaternion_matrix(thing.pose.quaternion)
        turned = (thing.model.mesh.vertices * thing.scale) @ rotation.T
        points.append(turned + thing.pose.position)
    return np.concatenate(points)


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:16]


def _pose(thing: Object) -> Float[np.ndarray, "7"]:
    return np.concatenate([thing.pose.position, thing.pose.quaternion])


def _read(text: str) -> list[float]:
    return [float(word) for word in text.split()]


def _text(numbers: Iterable[Any]) -> str:
    values = np.array(numbers if isinstance(numbers, np.ndarray) else [*numbers], np.float64) + 0.0
    values[np.abs(values) < _TINY] = 0.0
    return " ".join([f"{value:.7g}" for value in values.tolist()])
