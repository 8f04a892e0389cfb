"""Foreign meshes: GLB and OBJ files of users, of servers, and of other methods."""

import base64
import functools
import json
import random
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from backends.modelers.foreign import glb as packed
from backends.modelers.foreign import instance, prior, striped_box

from generator.backends.modelers.folder import Folder
from generator.evaluation.external import load_external, read_glb
from generator.io.pictures import encode_png
from generator.meshes.canonical import normal_mesh
from generator.scene import USUAL_VIEW

from ..judging import accepts, accepts_any, command, reading
from ..streams import bomb, hostile_png, png, spoiled
from ..values import mutate, number, text, written
from . import Run

Header = dict[str, Any]

_APART = 0.1  # share of cases read in children
_PICTURE = encode_png(np.full((16, 16, 3), 120, np.uint8))


@functools.cache
def good_glb() -> bytes:
    """Return a valid GLB with a texture and two pieces."""
    return packed(striped_box(), trimesh.creation.icosphere(1))


def glb(rng: random.Random, folder: Path) -> Run:
    """GLB files in a folder of assets, and as responses."""
    raw = hostile_glb(rng)
    (folder / "mug_1.glb").write_bytes(raw)
    apart = rng.random() < _APART

    def run() -> bool:
        with reading(apart):
            return accepts_any(
                lambda: normal_mesh(raw, "the answer"),
                lambda: read_glb(raw, "the file"),
                lambda: Folder(str(folder)).model(instance("mug"), prior("mug"), USUAL_VIEW),
            )

    return run


def obj(rng: random.Random, folder: Path) -> Run:
    """OBJ files in a folder of assets, with materials and pictures."""
    raw = _obj(rng)
    (folder / "mug_1.obj").write_bytes(raw)
    (folder / "m.mtl").write_bytes(_materials(rng))
    picture = hostile_png(rng, _PICTURE) if rng.random() < 0.4 else _PICTURE
    (folder / "t.png").write_bytes(picture)
    if rng.random() < 0.05:
        (folder / "t.png").unlink()
        (folder / "t.png").symlink_to(rng.choice(("/dev/zero", "../../precious/file.txt", "t.png")))
    apart = rng.random() < _APART

    def run() -> bool:
        with reading(apart):
            return accepts(
                lambda: Folder(str(folder)).model(instance("mug"), prior("mug"), USUAL_VIEW),
                lambda: normal_mesh(raw, "the file", kind="obj"),
            )

    return run


def external(rng: random.Random, folder: Path) -> Run:
    """Results of other methods: transforms.json and its GLB files."""
    unit = [[0.1, 0, 0, 0.1], [0, 0.1, 0, 0.8], [0, 0, 0.1, 0], [0, 0, 0, 1]]
    told: Any = {
        "name": "scene-3", "method": "other", "up": "z",
        "table": {"size": [1.2, 0.7, 0.74], "top": [0, 0, 0.74]},
        "objects": [
            {"name": "mug_1", "label": "mug", "glb": "mug.glb", "matrix": unit, "on": "table",
             "inside": False},
            {"name": "cup_1", "glb": "mug.glb", "matrix": unit, "on": "mug_1"},
        ],
    }  # fmt: skip
    if rng.random() < 0.3:
        told["table"] = {"glb": "table.glb", "matrix": np.eye(4).tolist()}
    if rng.random() < 0.9:
        told = mutate(told, rng, ("mug.glb", "table", "cup_1", "y", "z", "../mug.glb"), raw=True)
    (folder / "transforms.json").write_bytes(written(told, rng))
    spoil = rng.random() < 0.2
    (folder / "mug.glb").write_bytes(hostile_glb(rng) if spoil else packed(striped_box()))
    board = trimesh.creation.box(extents=(1.2, 0.7, 0.74))
    (folder / "table.glb").write_bytes(packed(board))
    shown, apart = rng.random() < 0.1, rng.random() < _APART

    def run() -> bool:
        with reading(apart):
            good = accepts(lambda: load_external(folder, decompose=False))
            if good and shown:
                command("evaluate", str(folder))
            return good

    return run


# ----------------------------------------------------------------------------------------- GLB
def hostile_glb(rng: random.Random) -> bytes:
    """Return a GLB with false data, a mutated header, or damage."""
    header, data = _parts(good_glb())
    kind = rng.randrange(10)
    if kind < 4:
        header = mutate(header, rng, ("MASK", "BLEND", "SCALAR", "VEC3", "MAT4", "image/png"))
    elif kind < 8:
        change = rng.choice(_CHANGES)
        data = change(header, data, rng) or data
    elif kind == 8:
        return spoiled(good_glb(), rng)
    else:
        mutated = mutate(header, rng, raw=True)
        return _packed(written(mutated, rng), data)
    return _packed(_text(header), data, rng.choice((None, None, None, 0, 2**31, 2**32 - 1)))


def _parts(raw: bytes) -> tuple[Header, bytes]:
    size = struct.unpack("<I", raw[12:16])[0]
    return json.loads(raw[20 : 20 + size]), raw[28 + size :]


def _text(header: Any) -> bytes:
    return json.dumps(header).encode("utf-8", "surrogatepass")


def _packed(content: bytes, data: bytes, length: int | None = None) -> bytes:
    content += b" " * (-len(content) % 4)
    data += bytes(-len(data) % 4)
    whole = 28 + len(content) + len(data) if length is None else length
    head = struct.pack("<4sIIII", b"glTF", 2, whole, len(content), 0x4E4F534A)
    return head + content + struct.pack("<II", len(data), 0x004E4942) + data


def _chain(header: Header, data: bytes, rng: random.Random) -> None:
    """Return a long chain of nodes, a comb, or a cycle."""
    count = rng.choice((10, 1000, 20_000, 100_000))
    nodes: list[Header] = [{"children": [k + 1]} for k in range(count - 1)] + [{"mesh": 0}]
    kind = rng.randrange(4)
    if kind == 0:
        nodes[-1]["children"] = [rng.randrange(count)]
    if kind == 1:
        nodes = [{"children": list(range(1, count))}] + [{"mesh": 0} for _ in range(count - 1)]
    if kind == 2:
        for node in nodes:
            node["matrix"] = [number(rng) for _ in range(16)]
    header["nodes"], header["scenes"] = nodes, [{"nodes": [0]}]


def _lattice(header: Header, data: bytes, rng: random.Random) -> None:
    """Return nodes shared by many parents, with exponentially many paths."""
    depth = rng.choice((5, 20, 40))
    header["nodes"] = [{"children": [k + 1, k + 1]} for k in range(depth)] + [{"mesh": 0}]
    header["scenes"] = [{"nodes": [0]}]


def _accessors(header: Header, data: bytes, rng: random.Random) -> None:
    accessor = rng.choice(header["accessors"])
    accessor[rng.choice(("count", "byteOffset", "componentType", "bufferView"))] = rng.choice((
        2**31, 2**40, -1, 10**9, 10**6, 0, 5121, 5126, 5125, 1.5, "1", None, True,
    ))  # fmt: skip
    if rng.random() < 0.3:
        accessor.pop("bufferView", None)
    if rng.random() < 0.3:
        count = rng.choice((1, 10**6, 10**9))
        accessor["sparse"] = {
            "count": count,
            "indices": {"bufferView": 0, "componentType": 5125},
            "values": {"bufferView": 0},
        }


def _views(header: Header, data: bytes, rng: random.Random) -> None:
    view = rng.choice(header["bufferViews"])
    view[rng.choice(("byteOffset", "byteLength", "byteStride", "buffer"))] = rng.choice((
        2**31, -1, 10**9, 0, 1, 3, 252, None, "4",
    ))  # fmt: skip


def _buffers(header: Header, data: bytes, rng: random.Random) -> None:
    uri = rng.choice((
        "../../precious/file.txt", "/dev/zero", "file:///etc/passwd", "http://[::1/x",
        "data:application/octet-stream;base64," + base64.b64encode(data).decode(),
        "data:;base64,!!!!", "data:", "a" * 5000, "\x00", "x.bin",
    ))  # fmt: skip
    header["buffers"] = [{**header["buffers"][0], "uri": uri}] * rng.choice((1, 1, 500))


_MOST_PICTURES = 2**25
"""Bytes of all pictures of a GLB: to write many more of them would be the work of the case."""


def _pictures(header: Header, data: bytes, rng: random.Random) -> None:
    picture = hostile_png(rng, _PICTURE)
    if rng.random() < 0.2:
        picture = png(4096, 4096, color=0, data=bomb(4096 * 4097))
    uri = "data:image/png;base64," + base64.b64encode(picture).decode()
    if rng.random() < 0.2:
        uri = rng.choice(("../../precious/file.txt", "/dev/zero", "http://a℀b/x", text(rng)))
    count = max(1, min(rng.choice((1, 1, 20, 200)), _MOST_PICTURES // len(uri)))
    header["images"] = [{"uri": uri}] * count
    header["textures"] = [{"source": k} for k in range(count)]
    if count > 1:
        base = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
        header["materials"] = [
            {"pbrMetallicRoughness": {"baseColorTexture": {"index": k}}} for k in range(count)
        ] or [base]
        first = header["meshes"][0]["primitives"][0]
        header["meshes"][0]["primitives"] = [{**first, "material": k} for k in range(count)]


def _many(header: Header, data: bytes, rng: random.Random) -> None:
    """Very many meshes, primitives, materials or instances of one mesh."""
    count = rng.choice((100, 5000, 50_000))
    what = rng.choice(("primitives", "meshes", "nodes", "materials"))
    if what == "primitives":
        header["meshes"][0]["primitives"] *= count
    else:
        if what == "nodes":
            header["nodes"] = [{"mesh": 0} for _ in range(count)]
            header["scenes"] = [{"nodes": list(range(count))}]
        else:
            header[what] = header.get(what, [{}])[:1] * count


def _numbers(header: Header, data: bytes, rng: random.Random) -> bytes:
    """Return vertices that are NaN, infinite, huge, equal or coplanar."""
    floats = np.frombuffer(data[: len(data) // 4 * 4], "<f4").copy()
    kind = rng.randrange(5)
    some = np.random.default_rng(rng.randrange(2**31)).random(len(floats)) < 0.1
    if kind < 3:
        floats[some] = (np.nan, np.inf, 3e38)[kind]
    elif kind == 3:
        floats[:] = 0
    else:
        floats *= np.float32(rng.choice((1e-30, 1e-12, 1e12)))
    return floats.tobytes()


_CHANGES: tuple[Callable[[Header, bytes, random.Random], bytes | None], ...] = (
    _chain, _lattice, _accessors, _accessors, _views, _buffers, _pictures, _many, _numbers,
)  # fmt: skip


# ----------------------------------------------------------------------------------------- OBJ
@functools.cache
def _good_obj() -> str:
    ball = trimesh.creation.icosphere(2)
    rows = [f"v {x:.5f} {y:.5f} {z:.5f}" for x, y, z in ball.vertices]
    rows += [f"vt {x:.4f} {y:.4f}" for x, y, _ in ball.vertices]
    rows += ["usemtl m"]
    rows += [f"f {a}/{a} {b}/{b} {c}/{c}" for a, b, c in ball.faces + 1]
    return "mtllib m.mtl\n" + "\n".join(rows) + "\n"


_LINES = (
    "f 1/1 2/2 999999999/1", "f -1/-1 -2/-2 -3/-3", "f 1 2", "f 1 2 3 4 5 6 7 8", "v nan 0 0",
    "v 1e308 0 0", "v inf 0 0", "v 1 2", "v 0 0 0 1 1 1", "vt", "vn 0 0 nan", "o x", "g a b c",
    "usemtl other", "mtllib ../../outside.xml", "mtllib /dev/zero", "mtllib m.mtl m.mtl", "s off",
    "l 1 2 3", "p 1", "f 0/0 0/0 0/0", "f 1//1 2//2 3//3", "f 99999999999999999999 1 2", "\x00",
    "curv 0 1 1 2", "call x.obj", "csh rm x", "f 1.5 2 3", "f a b c", "v " + "1" * 400 + " 0 0",
    "usemtl", "mtllib", "f", "v", "vt nan nan", "f 1/99999999 2/2 3/3", "\\",
    "mtllib " + "a" * 5000,
)  # fmt: skip


def _obj(rng: random.Random) -> bytes:
    good = _good_obj()
    kind = rng.randrange(10)
    if kind < 5:
        lines = good.splitlines()
        for _ in range(rng.choice((1, 2, 5))):
            lines.insert(rng.randrange(len(lines) + 1), rng.choice(_LINES))
        return rng.choice(("\n", "\n", "\r\n")).join(lines).encode()
    if kind == 5:
        return spoiled(good.encode(), rng)
    if kind == 6:
        return _long(good, rng)
    if kind == 7:
        count = rng.choice((100, 3000, 20_000))
        parts = [f"usemtl m{k}\nf 1/1 2/2 3/3\n" for k in range(count)]
        return (good + "".join(parts)).encode()
    if kind == 8:
        count = rng.choice((1000, 50_000))
        word = rng.choice(("o x{}\nf 1 2 3\n", "g y{}\nf 1 2 3\n", "mtllib m.mtl\n", "s {}\n"))
        return (good + "".join(word.format(k) for k in range(count))).encode()
    rows = good.splitlines()
    return "\n".join(rng.sample(rows, len(rows))).encode()


def _long(good: str, rng: random.Random) -> bytes:
    size = rng.choice((10_000, 1_000_000, 8_000_000))
    return (good + rng.choice((
        "v " + "0 " * (size // 2), "f " + "1/1 " * (size // 4), "#" * size, "o " + "x" * size,
        "v 0 0 0\n" * (size // 8), "f 1/1 2/2 3/3\n" * (size // 14), "\n" * size,
        "f 1 2 3 " + "\\\n" * (size // 2), " " * size, "usemtl " + "m" * size,
    ))).encode()  # fmt: skip


def _materials(rng: random.Random) -> bytes:
    lines = ["newmtl m", "Kd 0.5 0.4 0.3", "d 0.5", "map_Kd t.png"]
    for _ in range(rng.randrange(3)):
        lines.insert(rng.randrange(len(lines) + 1), rng.choice((
            "Kd nan inf 2", "Kd", "map_Kd ../../precious/file.txt", "map_Kd /dev/zero", "Ns x",
            "map_Kd -s 1 1 1 t.png", "map_Kd " + "a" * 5000, "map_Kd \x00", "newmtl m", "newmtl",
            "illum 99999999999999", "Kd 1e999 0 0", "map_Bump t.png", "map_Kd m.mtl", "Kd 1",
        )))  # fmt: skip
    content = "\n".join(lines).encode()
    if rng.random() < 0.1:
        content = spoiled(content, rng)
    if rng.random() < 0.03:
        content = b"".join(b"newmtl m%d\nmap_Kd t.png\n" % k for k in range(20_000))
    return content
