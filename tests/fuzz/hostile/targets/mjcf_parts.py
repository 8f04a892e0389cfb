"""MJCF with valid and hostile parts: sizes, sensors, textures, replicates, meshes."""

import random
import struct
import zlib
from collections.abc import Callable
from pathlib import Path

import numpy as np

from ..streams import bomb, hostile_png, png, spoiled

Parts = dict[str, list[str]]

_NUMBERS = (
    "nan", "inf", "-inf", "0", "-1", "1e-300", "1e300", "1e38", "1e9", ".5", "3", "1000",
    "2147483648", "4294967296", "99999999999999999999", "1.5", "0x7fffffff", " 7 ", "1 2 3 4", "x",
)  # fmt: skip
_COUNTS = (
    "0", "1", "2", "3", "8", "40", "150", "200", "201", "100000", "200000000", "2147483647", "-1",
    "1e9",
)  # fmt: skip
_PLACED = ("pos", "size", "quat", "euler", "mass", "friction", "rgba", "density", "margin")
_BUILTIN = ("sphere", "hemisphere", "cone", "supersphere", "supertorus", "wedge", "plate")

_MOST_TEXT = 2**26  # size of meshes, characters


def write_mjcf(rng: random.Random, folder: Path) -> Path:
    """Write MJCF with valid and hostile parts; return its path."""
    parts: dict[str, list[str]] = {"top": [], "asset": [], "world": []}
    for craft in rng.choices(_CRAFTS, k=rng.choice((1, 1, 2, 3))):
        craft(rng, parts, folder)
    cube = (
        '<body name="cube" pos="0 0 .75"><freejoint/><geom type="box" size=".03 .03 .03"/></body>'
    )
    table = '<body name="table" pos="0 0 .7"><geom type="box" size=".5 .4 .02"/></body>'
    top, asset, world = (_joined(parts[key]) for key in ("top", "asset", "world"))
    text = (
        f'<mujoco model="m">{top}<asset>{asset}</asset>'
        f"<worldbody>{table}{cube}{world}</worldbody></mujoco>"
    )
    raw = text.encode()
    if rng.random() < 0.1:
        raw = spoiled(raw, rng)
    path = folder / "scene.xml"
    path.write_bytes(raw)
    return path


def _joined(pieces: list[str]) -> str:
    return "".join(pieces)


def _sizes(rng: random.Random, parts: Parts, folder: Path) -> None:
    names = (
        "nuserdata", "nuser_body", "nuser_geom", "nuser_jnt", "nuser_site", "nuser_cam", "nkey",
        "nuser_tendon", "nuser_actuator", "nuser_sensor", "njmax", "nconmax", "nstack", "memory",
    )  # fmt: skip
    chosen = rng.sample(names, rng.choice((1, 2, 5)))
    values = (*_COUNTS, "100G", "1M", "-1")
    own = _joined([f' {name}="{rng.choice(values)}"' for name in chosen])
    parts["top"].append(f"<size{own}/>")
    if rng.random() < 0.3:
        user = "1 " * rng.choice((1, 1000, 200_000))
        parts["world"].append(f'<body user="{user}"><geom size=".1" user="{user}"/></body>')


def _sensors(rng: random.Random, parts: Parts, folder: Path) -> None:
    one = rng.choice((
        '<user name="u{k}" dim="{n}"/>', '<framepos objtype="body" objname="cube" user="{n}"/>',
        '<rangefinder site="none"/>', '<clock nsample="{n}" delay="1" interp="linear"/>',
        '<contact geom1="none" num="{n}"/>', '<plugin plugin="x"/>', "<user/>",
    ))  # fmt: skip
    many = rng.choice((1, 1, 100, 20_000))
    sensors = _joined([one.format(k=k, n=rng.choice(_COUNTS)) for k in range(many)])
    parts["top"].append(f"<sensor>{sensors}</sensor>")
    if rng.random() < 0.3:
        numeric = f'<numeric name="n" size="{rng.choice(_COUNTS)}" data="1"/>'
        parts["top"].append(f"<custom>{numeric}</custom>")


def _textures(rng: random.Random, parts: Parts, folder: Path) -> None:
    for k in range(rng.choice((1, 1, 3, 12))):
        kind = rng.choice(("2d", "cube", "skybox"))
        if rng.random() < 0.4:
            name = f"t{rng.randrange(2)}.png"
            (folder / name).write_bytes(_picture(rng))
            grid = rng.choice(("1 1", "3 4", "1000 1000"))
            own = f'file="{name}" gridsize="{grid}"'
        else:
            sides = [rng.choice(("8", "64", "1024", "8000", "26000", *_COUNTS)) for _ in range(2)]
            look = rng.choice(("flat", "checker", "gradient"))
            channels = rng.choice(("3", "3", "4", "1", "1000", "-1"))
            own = f'builtin="{look}" width="{sides[0]}" height="{sides[1]}" nchannel="{channels}"'
        parts["asset"].append(f'<texture name="t{k}" type="{kind}" {own}/>')
        parts["asset"].append(
            f'<material name="m{k}" texture="t{k}" texrepeat="{_number(rng)} 1"/>'
        )
        parts["world"].append(f'<geom size=".1" pos="0 0 -9" material="m{k}"/>')


def _picture(rng: random.Random) -> bytes:
    side = rng.choice((8, 24_000, 65_535, 2**31 - 1))
    if rng.random() < 0.3:
        return png(4096, 4096, color=0, data=bomb(4096 * 4097))
    if rng.random() < 0.5:
        return png(side, side, color=0, data=zlib.compress(bytes(1000)))
    return hostile_png(rng, png(8, 8, color=0, data=zlib.compress(bytes(72))))


def _replicates(rng: random.Random, parts: Parts, folder: Path) -> None:
    depth = rng.choice((1, 2, 3, 5, 40))
    inner = rng.choice((
        '<geom size=".001"/>', "<site/>", '<body><freejoint/><geom size=".01"/></body>',
        "<body/>", '<geom type="ellipsoid" size=".1 .2 .3"/><light/>', "<camera/>", "<frame/>",
        '<body><replicate count="9"><geom size=".1"/></replicate></body>', "",
    ))  # fmt: skip
    text = inner
    for _ in range(depth):
        count = rng.choice((*_COUNTS, "2", "2", "5"))
        own = f'count="{count}" offset="0 {_number(rng)} 1" euler="0 0 .1"'
        text = f"<replicate {own}>{text}</replicate>"
    parts["world"].append(rng.choice(('<body name="r" pos="0 0 -3">{}</body>', "{}")).format(text))


def _meshes(rng: random.Random, parts: Parts, folder: Path) -> None:
    kind = rng.randrange(5)
    count = rng.choice((4, 300, 20_000))
    shape = np.random.default_rng(rng.randrange(2**31)).normal(size=(count, 3))
    if kind == 0:  # unusual numbers among valid ones
        words = [f"{v:.4g}" for v in shape.ravel()]
        for _ in range(rng.choice((0, 1, 5))):
            words[rng.randrange(len(words))] = rng.choice(_NUMBERS)
        listed = " ".join(words)
        own = f'vertex="{listed}"'
    elif kind == 1:
        name = rng.choice(_BUILTIN)
        numbers = " ".join(rng.choice((*_COUNTS[:9], "0.5")) for _ in range(rng.randrange(1, 6)))
        own = f'builtin="{name}" params="{numbers}"'
    elif kind == 2:
        (folder / "m.obj").write_bytes(obj(rng, count))
        own = 'file="m.obj"'
    elif kind == 3:
        (folder / "m.stl").write_bytes(_stl(rng, count))
        own = 'file="m.stl"'
    else:
        (folder / "m.msh").write_bytes(_msh(rng, count))
        own = 'file="m.msh"'
    if rng.random() < 0.6:
        scale = rng.choice(("nan", "0", "-1", "1e200"))
        own += f' scale="{scale} 1 1"'
    own += rng.choice(("", ' inertia="exact"', ' inertia="shell"', ' maxhullvert="4"'))
    many = rng.choice((1, 1, 30, 2000))
    several = rng.random() < 0.3 and many * len(own) < _MOST_TEXT
    named = many if several else 1
    parts["asset"].append(_joined([f'<mesh name="g{k}" {own}/>' for k in range(named)]))
    free = rng.choice(("<freejoint/>", ""))
    parts["world"] += [
        f'<body pos="{k % 40} 0 9">{free}<geom type="mesh" mesh="g{k % named}"/></body>'
        for k in range(many)
    ]


def obj(rng: random.Random, count: int) -> bytes:
    """Return an OBJ with the given number of vertices and possibly invalid faces."""
    sides = rng.choice((3, 4, 40))
    rows = [f"v {k % 17} {k % 13} {k % 7}" for k in range(count)]
    last = count + rng.choice((0, 0, 5))
    rows += ["f " + " ".join(str(rng.randrange(1, last + 1)) for _ in range(sides))] * rng.choice(
        (4, 1000, 400_000 // sides)
    )
    return "\n".join(rows).encode()


def _stl(rng: random.Random, count: int) -> bytes:
    said = rng.choice((count, count, 0, 2**31, 2**32 - 1))
    values = np.random.default_rng(rng.randrange(2**31)).normal(size=(count, 12)).astype("<f4")
    if rng.random() < 0.3:
        values[0, 4] = rng.choice((np.nan, np.inf, 3e38))
    return bytes(80) + struct.pack("<I", said) + b"".join(row.tobytes() + b"\0\0" for row in values)


def _msh(rng: random.Random, count: int) -> bytes:
    head = [rng.choice((count, 0, -1, 2**31 - 1, 10**8)) if rng.random() < 0.4 else count, 0, 0, 4]
    return struct.pack("<4i", *head) + np.zeros((count, 3), "<f4").tobytes() + bytes(48)


def _numbers(rng: random.Random, parts: Parts, folder: Path) -> None:
    count = rng.choice((1, 2, 4))
    own = " ".join([f'{name}="{_vector(rng, name)}"' for name in rng.sample(_PLACED, count)])
    kind = rng.choice(("box", "sphere", "capsule", "cylinder", "ellipsoid", "plane"))
    inertial = ""
    if rng.random() < 0.5:
        mass, center, last = (_number(rng) for _ in range(3))
        inertial = f'<inertial pos="0 0 {center}" mass="{mass}" diaginertia="1 1 {last}"/>'
    place = f'pos="{_number(rng)} 0 .9"' if rng.random() < 0.5 else ""
    parts["world"].append(
        f'<body {place}><freejoint/>{inertial}<geom type="{kind}" {own}/><geom size=".1"/></body>'
    )
    if rng.random() < 0.4:
        name = rng.choice(("boundmass", "boundinertia", "settotalmass", "angle", "autolimits"))
        parts["top"].append(f'<compiler {name}="{_number(rng)}"/>')
    if rng.random() < 0.2:
        parts["top"].append(f'<option timestep="{_number(rng)}" gravity="nan 0 {_number(rng)}"/>')


def _vector(rng: random.Random, name: str) -> str:
    length = {"quat": 4, "rgba": 4, "mass": 1, "density": 1, "margin": 1}.get(name, 3)
    return " ".join(_number(rng) for _ in range(rng.choice((length, length, length, 1, 7))))


def _number(rng: random.Random) -> str:
    return rng.choice(_NUMBERS) if rng.random() < 0.5 else f"{rng.uniform(0, 2):.3f}"


def _machines(rng: random.Random, parts: Parts, folder: Path) -> None:
    """Actuators with states, tendons, key frames, deep trees and many of each."""
    n, many = rng.choice(_COUNTS), "1 " * rng.choice((7, 100_000))
    parts["top"].append(rng.choice((
        f'<actuator><general body="cube" dyntype="user" actdim="{n}"/></actuator>',
        f'<actuator><general body="cube" nsample="{n}" delay="1"/></actuator>',
        f'<tendon><spatial width="{_number(rng)}"><site site="none"/></spatial></tendon>',
        f'<keyframe><key qpos="{many}"/></keyframe>',
        '<contact><exclude body1="cube" body2="table"/></contact>' * rng.choice((1, 10_000)),
        f'<compiler><lengthrange mode="all" inttotal="{n}" timestep="1e-9"/></compiler>'
        '<actuator><general body="cube"/></actuator>',
        "<default>" + '<default class="a">' * 90 + "</default>" * 91,
        f'<visual><quality shadowsize="{n}" offsamples="{n}"/><global offwidth="{n}"/></visual>',
    )))  # fmt: skip
    deep = rng.choice((1, 50, 90))
    parts["world"].append("<body>" * deep + "<geom size='.1' mass='1'/>" + "</body>" * deep)


_CRAFTS: tuple[Callable[[random.Random, Parts, Path], None], ...] = (
    _sizes, _sensors, _textures, _replicates, _meshes, _numbers, _numbers, _machines,
)  # fmt: skip
