"""A foreign GLB reduced to its visible content: meshes at their positions, and base colours.

Parsers receive no node trees, animations, cameras, lines or points, no other pictures, and no data
that does not belong to a visible mesh. None of these can therefore harm them.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

Header = Mapping[str, Any]

JSON_CHUNK = 0x4E4F534A
TRIANGLES, STRIP, FAN = 4, 5, 6

_GLOSS = "KHR_materials_pbrSpecularGlossiness"
_SHOWN = ("POSITION", "TEXCOORD_0", "COLOR_0")
_NOTHING = {"componentType": 5121, "count": 0, "type": "SCALAR"}


class Crooked(ValueError):
    """The node tree of a GLB is invalid; the message explains why."""


def flatten(raw: bytes, header: Header) -> bytes:
    """Return an inspected GLB, reduced to its visible content.

    Each visible mesh becomes a root node with its world transform. Materials keep only their base
    colour (or diffuse colour, if they are specular-glossiness materials); no other pictures are
    decoded.
    """
    places = list(mesh_places(header))
    meshes = [_plain_mesh(header, mesh) for mesh in header.get("meshes", ())]
    shown = sorted({mesh for mesh, _ in places})
    numbers = {mesh: k for k, mesh in enumerate(shown)}
    nodes = [
        {"mesh": numbers[mesh], "name": str(k), "matrix": matrix.T.ravel().tolist()}
        for k, (mesh, matrix) in enumerate(places)
        if meshes[mesh]["primitives"]
    ]
    small = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes,
        "meshes": [meshes[mesh] for mesh in shown],
        "materials": [
            {
                "pbrMetallicRoughness": base_color(material),
                "alphaMode": "BLEND" if material.get("alphaMode") == "BLEND" else "OPAQUE",
            }
            for material in header.get("materials", ())
        ],
        **_columns(header, [meshes[mesh] for mesh in shown]),
    }
    text = json.dumps(small).encode()
    text += b" " * (-len(text) % 4)
    rest = memoryview(raw)[20 + struct.unpack_from("<I", raw, 12)[0] :]
    start = struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), JSON_CHUNK)
    return b"".join([start, text, rest])


def mesh_places(header: Header) -> Iterator[tuple[int, Float[np.ndarray, "4 4"]]]:
    """Yield the index and transform of each visible mesh, once for each node that has it.

    Raises:
        Crooked: the nodes do not form a tree.
    """
    nodes = header.get("nodes", ())
    if not nodes:
        yield from ((mesh, np.eye(4)) for mesh in range(len(header.get("meshes", ()))))
        return
    roots = roots_of(header, header.get("scene", 0))
    waiting = [(root, np.eye(4)) for root in roots]
    seen: set[int] = set()
    while waiting:
        at, above = waiting.pop()
        if at in seen:
            raise Crooked("a node has two parents")
        seen.add(at)
        with np.errstate(all="ignore"):  # overflows result in vertices that are rejected later
            matrix = above @ local_matrix(nodes[at])
        if "mesh" in nodes[at]:
            yield int(nodes[at]["mesh"]), matrix
        waiting += [(child, matrix) for child in nodes[at].get("children", ())]


def roots_of(header: Header, scene: int) -> Sequence[int]:
    """Return the root nodes of a scene, or those of all trees if no scene has nodes."""
    scenes = header.get("scenes", ())
    if not any(entry.get("nodes") for entry in scenes):
        return _topmost(header.get("nodes", ()))
    return scenes[scene].get("nodes", ())


def shown_nodes(header: Header) -> Iterator[Header]:
    """Yield the nodes of all scenes; a node in several scenes is yielded once for each of them.

    A file without nodes shows all of its meshes; a file without root nodes shows all of its trees.

    Raises:
        Crooked: the nodes do not form a tree.
    """
    nodes, scenes = header.get("nodes", ()), header.get("scenes", ())
    if not nodes:
        yield from ({"mesh": mesh} for mesh in range(len(header.get("meshes", ()))))
        return
    roots = [scene["nodes"] for scene in scenes if scene.get("nodes")] or [_topmost(nodes)]
    for named in roots:
        waiting, seen = [*named], set()
        while waiting:
            at = waiting.pop()
            if at in seen:
                raise Crooked("a node has two parents")
            seen.add(at)
            yield nodes[at]
            waiting += nodes[at].get("children", ())


def _topmost(nodes: Sequence[Header]) -> Sequence[int]:
    """Return the nodes that have no parent."""
    below = {child for node in nodes for child in node.get("children", ())}
    return [k for k in range(len(nodes)) if k not in below]


def base_color(material: Header) -> Header:
    """Return a material's base colour: its factor and its texture, where present."""
    plain = material.get("pbrMetallicRoughness", {})
    found = {key: plain[key] for key in ("baseColorFactor", "baseColorTexture") if key in plain}
    gloss = material.get("extensions", {}).get(_GLOSS, {})
    old = {"baseColorFactor": "diffuseFactor", "baseColorTexture": "diffuseTexture"}
    return found or {key: gloss[name] for key, name in old.items() if name in gloss}


def picture_of(header: Header, material: Header) -> int | None:
    """Return the image index of a material's base colour texture, or None if it has none."""
    base = base_color(material)
    if "baseColorTexture" not in base:
        return None
    texture = header["textures"][base["baseColorTexture"]["index"]]
    other = texture.get("extensions", {}).get("EXT_texture_webp", {})
    return other.get("source", texture.get("source"))


def local_matrix(node: Header) -> Float[np.ndarray, "4 4"]:
    """Return the matrix of a node's transform in its parent, given as a matrix or in components."""
    matrix = np.array(node.get("matrix", np.eye(4).ravel()), np.float64).reshape(4, 4).T
    if not {"translation", "rotation", "scale"} & node.keys():
        return matrix
    own = np.eye(4)
    turn = np.array(node.get("rotation", (0, 0, 0, 1)), np.float64).reshape(4)
    if (turn != 0).any() and np.isfinite(turn).all():
        own[:3, :3] = Rotation.from_quat(turn).as_matrix()
    own[:3, :3] *= np.array(node.get("scale", (1, 1, 1)), np.float64).reshape(3)
    own[:3, 3] = np.array(node.get("translation", (0, 0, 0)), np.float64).reshape(3)
    return matrix @ own


def _plain_mesh(header: Header, mesh: Header) -> dict[str, Any]:
    """Return the triangle primitives of a mesh, with only the attributes that are used."""
    pieces = []
    for primitive in mesh["primitives"]:
        given = primitive["attributes"]
        mode = primitive.get("mode", TRIANGLES)
        if mode not in (TRIANGLES, STRIP) or "POSITION" not in given:
            continue
        plain = {"mode": mode, "attributes": {key: given[key] for key in _SHOWN if key in given}}
        plain |= {key: primitive[key] for key in ("indices", "material") if key in primitive}
        pieces.append(plain)
    return {"primitives": pieces, "name": "mesh"}


def _columns(header: Header, meshes: Sequence[Header]) -> dict[str, Any]:
    """Return accessors, buffer views, buffers, textures and images, with unused ones emptied."""
    primitives = [primitive for mesh in meshes for primitive in mesh["primitives"]]
    used = {index for primitive in primitives for index in primitive["attributes"].values()}
    used |= {primitive["indices"] for primitive in primitives if "indices" in primitive}
    seen = {picture_of(header, material) for material in header.get("materials", ())}
    images, accessors = header.get("images", ()), header.get("accessors", ())
    read = {accessors[k].get("bufferView") for k in used}
    read |= {images[k].get("bufferView") for k in seen if k is not None}
    none = {"buffer": 0, "byteLength": 0}
    views = header.get("bufferViews", ())
    return {
        "accessors": [a if k in used else _NOTHING for k, a in enumerate(accessors)],
        "bufferViews": [v if k in read else none for k, v in enumerate(views)],
        "images": [image if k in seen else {} for k, image in enumerate(images)],
        **{key: header[key] for key in ("buffers", "textures") if key in header},
    }
