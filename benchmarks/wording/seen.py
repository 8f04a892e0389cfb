"""The content of a saved bundle, by plain MuJoCo: boxes, outlines, supports, colours.

Metres, in the frame of ``docs/concepts/frames.md``: +x right, +y away, +z up. Nothing is taken from
the bundle's report.
"""

from __future__ import annotations

import colorsys
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
from scipy.spatial import ConvexHull, QhullError

TABLE = "table"
SETTLE = 0.3
"""Seconds of simulation before contacts are read."""
LIFT = 0.05
"""Minimum share of its weight that a contact must carry to support an object."""
THIN = 3e-4
"""Minimum height in metres of an object's bottom above its support's lowest point: a sheet of
paper."""
HEAP = 0.01
"""Maximum height in metres above the rim at which an object in a container may start, as on a
heap."""


@dataclass(frozen=True)
class Thing:
    """A simulated object: corners of its box, points of its mesh (n, 3), colours (m, 3).

    ``label`` is its name; ``stand_in`` means that it is a plain shape. ``areas`` (m,) are the
    shares of the surface with the colours, RGB from 0 to 1. ``own`` are the extents along its own
    axes, if known.
    """

    name: str
    label: str
    points: np.ndarray
    stand_in: bool = False
    colours: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    areas: np.ndarray = field(default_factory=lambda: np.zeros(0))
    own: np.ndarray | None = None

    @cached_property
    def low(self) -> np.ndarray:
        """The minimum corner of its box."""
        return self.points.min(0)

    @cached_property
    def high(self) -> np.ndarray:
        """The maximum corner of its box."""
        return self.points.max(0)

    @property
    def centre(self) -> np.ndarray:
        """The centre of its box."""
        return (self.low + self.high) / 2

    @property
    def size(self) -> np.ndarray:
        """The extents of its box."""
        return self.high - self.low

    @property
    def extents(self) -> np.ndarray:
        """Its length, width and height in its own axes."""
        return self.size if self.own is None else self.own

    @cached_property
    def foot(self) -> np.ndarray:
        """The position of the lowest tenth of its height, (2,)."""
        under = self.points[:, 2] <= self.low[2] + 0.1 * self.size[2]
        return self.points[under, :2].mean(0)

    @cached_property
    def edges(self) -> np.ndarray:
        """Lines around the outline seen from above, (k, 3): inside is where n·p + c <= 0."""
        try:
            return ConvexHull(self.points[:, :2]).equations
        except (QhullError, ValueError):
            lows, highs = self.low[:2], self.high[:2]
            axes = np.array([[1.0, 0], [0, 1], [-1, 0], [0, -1]])
            return np.column_stack([axes, [-highs[0], -highs[1], lows[0], lows[1]]])

    def covers(self, place: np.ndarray, slack: float = 0.005) -> bool:
        """Return whether a position (2,) is within the outline seen from above."""
        return bool((self.edges[:, :2] @ place + self.edges[:, 2] <= slack).all())

    def share(self, colour: str) -> float:
        """Return the share of the surface with a colour, from 0 to 1."""
        of = [is_colour(rgb, colour) for rgb in self.colours]
        return float(self.areas[of].sum() / max(self.areas.sum(), 1e-12)) if of else 0.0


@dataclass(frozen=True)
class Seen:
    """All objects of a bundle, the tabletop (width, depth) in metres, and their supports."""

    things: tuple[Thing, ...]
    top: tuple[float, float]
    carriers: Mapping[str, frozenset[str]] = field(default_factory=dict)

    def below(self, name: str) -> set[str]:
        """Return all direct and indirect supports of an object."""
        found: set[str] = set()
        left = [name]
        while left:
            for under in self.carriers.get(left.pop(), frozenset()) - found:
                found.add(under)
                left.append(under)
        return found - {name}

    def on(self, a: Thing, b: Thing) -> bool:
        """Return whether ``a`` stands on ``b``, directly or indirectly, and starts above it."""
        return b.name in self.below(a.name) and bool(a.low[2] > b.low[2] + THIN)

    def inside(self, a: Thing, b: Thing) -> bool:
        """Return whether ``b`` supports ``a`` within its outline, starting below its rim."""
        over = b.covers(a.centre[:2]) or b.covers(a.foot)
        return self.on(a, b) and over and bool(a.low[2] < b.high[2] + HEAP)


def look(bundle: Path, told: Iterable[Mapping[str, Any]] = ()) -> Seen:
    """Simulate a bundle for ``SETTLE`` seconds and return its content.

    ``told`` are the objects of a command's ``--json``, which give labels and stand-ins.
    """
    model = mujoco.MjModel.from_xml_path(str(bundle / "scene.xml"))
    model.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)  # no contacts in sleep
    data = mujoco.MjData(model)
    if model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    for _ in range(round(SETTLE / model.opt.timestep)):
        mujoco.mj_step(model, data)
    mujoco.mj_forward(model, data)
    known = {str(o["name"]): o for o in told}
    free = [b for b in range(1, model.nbody) if model.body(b).name != TABLE]
    things = tuple(_thing(model, data, b, known.get(model.body(b).name, {})) for b in free)
    table = _points(model, data, model.body(TABLE).id)
    width, depth = (table.max(0) - table.min(0))[:2]
    return Seen(things, (float(width), float(depth)), find_carriers(model, data))


def find_carriers(model: mujoco.MjModel, data: mujoco.MjData) -> dict[str, frozenset[str]]:
    """Return for each body the bodies whose contacts carry at least ``LIFT`` of its weight."""
    lift: dict[tuple[int, int], float] = defaultdict(float)
    for k, contact in enumerate(data.contact):
        force = np.zeros(6)
        mujoco.mj_contactForce(model, data, k, force)
        up = float(contact.frame.reshape(3, 3)[:, 2] @ force[:3])  # on geom 1 from geom 2
        one, two = (int(model.geom_bodyid[g]) for g in contact.geom)
        lift[two, one] += up
        lift[one, two] -= up
    under: dict[str, set[str]] = defaultdict(set)
    gravity = float(np.linalg.norm(model.opt.gravity))
    for (upper, lower), force in lift.items():
        if force > LIFT * gravity * float(model.body_mass[upper]):
            under[model.body(upper).name].add(model.body(lower).name)
    return {name: frozenset(names) for name, names in under.items()}


def _thing(model: mujoco.MjModel, data: mujoco.MjData, body: int, told: Mapping[str, Any]) -> Thing:
    name = model.body(body).name
    points = _points(model, data, body)
    colours, areas = _colours(model, body)
    label, stand_in = str(told.get("label", name)), bool(told.get("stand_in", False))
    own = np.ptp(points @ data.xmat[body].reshape(3, 3), axis=0)
    return Thing(name, label, points, stand_in, colours, areas, own)


def _meshes(model: mujoco.MjModel, body: int) -> list[int]:
    """Return the visual geoms."""
    first, count = int(model.body_geomadr[body]), int(model.body_geomnum[body])
    geoms = range(first, first + count)
    return [g for g in geoms if model.geom_group[g] == 2 and model.geom_dataid[g] >= 0]


def _points(model: mujoco.MjModel, data: mujoco.MjData, body: int) -> np.ndarray:
    found = []
    for geom in _meshes(model, body):
        mesh = model.mesh(int(model.geom_dataid[geom]))
        first, count = int(mesh.vertadr[0]), int(mesh.vertnum[0])
        turn = data.geom_xmat[geom].reshape(3, 3)
        found.append(model.mesh_vert[first : first + count] @ turn.T + data.geom_xpos[geom])
    return np.concatenate(found) if found else data.xpos[body][None]


_PLACES = np.array([
    [i + 1 / 3, j + 1 / 3, 4 - i - j + 1 / 3] for i in range(5) for j in range(5 - i)
]) / 5  # fmt: skip
"""Sample positions in a triangle for colours: weights of its corners."""


def _colours(model: mujoco.MjModel, body: int) -> tuple[np.ndarray, np.ndarray]:
    """Return colours at sample positions of each triangle, and the area of each sample."""
    colours, areas = [np.zeros((0, 3))], [np.zeros(0)]
    for geom in _meshes(model, body):
        mesh = model.mesh(int(model.geom_dataid[geom]))
        first, count = int(mesh.faceadr[0]), int(mesh.facenum[0])
        corners = model.mesh_vert[int(mesh.vertadr[0]) :][model.mesh_face[first : first + count]]
        a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
        areas += [area / len(_PLACES)] * len(_PLACES)
        material = int(model.geom_matid[geom])
        tint = model.mat_rgba[material] if material >= 0 else model.geom_rgba[geom]
        plain = np.tile(tint[:3], (count, 1))
        texture = _texture(model, material)
        if texture is not None and mesh.texcoordadr[0] >= 0:
            uv = model.mesh_texcoord[int(mesh.texcoordadr[0]) :]
            ends = uv[model.mesh_facetexcoord[first : first + count]]
            height, width = texture.shape[:2]
            for weights in _PLACES:
                at = np.einsum("fkc,k->fc", ends, weights) % 1.0
                rows = np.minimum((at[:, 1] * height).astype(int), height - 1)
                columns = np.minimum((at[:, 0] * width).astype(int), width - 1)
                colours.append(plain * texture[rows, columns, :3] / 255.0)
        else:
            colours += [plain] * len(_PLACES)
    return np.concatenate(colours), np.concatenate(areas)


def _texture(model: mujoco.MjModel, material: int) -> np.ndarray | None:
    """Return a material's texture, row 0 at v = 0, or None."""
    ids = model.mat_texid[material] if material >= 0 else np.array([-1])
    used = [int(t) for t in ids if t >= 0]
    if not used:
        return None
    t = used[0]
    shape = (int(model.tex_height[t]), int(model.tex_width[t]), int(model.tex_nchannel[t]))
    first = int(model.tex_adr[t])
    return np.asarray(model.tex_data[first : first + int(np.prod(shape))]).reshape(shape)


HUES: Mapping[str, tuple[float, float]] = {
    "red": (335, 22), "orange": (12, 45), "yellow": (38, 72), "green": (70, 175),
    "blue": (175, 262), "purple": (255, 330), "pink": (300, 360), "brown": (8, 45),
}  # fmt: skip
"""Hues in degrees."""


def is_colour(rgb: np.ndarray, colour: str) -> bool:
    """Return whether RGB values from 0 to 1 match a colour's name."""
    hue, strong, light = colorsys.rgb_to_hsv(*(float(np.clip(c, 0, 1)) for c in rgb[:3]))
    if colour == "white":
        return strong < 0.25 and light > 0.65
    if colour in ("black", "grey"):
        return light < 0.32 if colour == "black" else strong < 0.2 and 0.2 < light < 0.85
    low, high = HUES[colour]
    within = low <= 360 * hue <= high if low < high else 360 * hue >= low or 360 * hue <= high
    return within and strong > 0.25 and light > 0.15
