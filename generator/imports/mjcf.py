"""Reading of foreign MJCF: free bodies become objects; one fixed body or geom becomes the table.

MuJoCo compiles the file; everything is taken from the compiled model at its initial state, so that
defaults, frames, classes and fitted shapes have MuJoCo's meaning. A colliding mesh is its convex
hull, as in MuJoCo.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Bool, Float, Int, UInt8

from ..errors import InputError, choices
from ..meshes.reading.bounds import MOST_FACES
from ..meshes.reading.surface import ColoredSurface
from ..physics.inertia import MassProperties, join_bodies
from ..physics.spec import new_data, write_no_log
from ..scene import ConvexPart
from .foreign import ForeignBody, ForeignScene, Refusals, check_count
from .mjcf_bodies import compile_sound
from .mjcf_files import GatheredModel, gather
from .shapes import Solid, hull_corners, solid_part, solid_surface

if TYPE_CHECKING:
    import mujoco

from typing import TYPE_CHECKING

from tabletop_objects.values import PICTURE, frozen_array

from ..meshes.reading.textures import MOST_TEXTURE

if TYPE_CHECKING:
    import mujoco


TABLE_WORDS = re.compile(r"table|desk|bench|counter|island|worktop", re.IGNORECASE)
"""Pattern of names that suggest a table."""

_KINDS: dict[int, Solid] = {3: "capsule", 2: "ellipsoid", 4: "ellipsoid", 5: "cylinder", 6: "box"}
_PLANE, _MESH = 0, 7  # of mjtGeom
_JOINTED = "the body has joints other than free ones; only rigid bodies can be imported"
_UNDER = 0.05  # metres that an object may penetrate its support
_SEEN = 0.01  # minimum opacity of a visible geom


def read_mjcf(path: Path, folder: Path | None = None, table: str | None = None) -> ForeignScene:
    """Read an MJCF file; the files that it uses must be in ``folder`` (by default, the file's own).

    ``table`` is the name of the fixed body or geom that is the table; None detects it by its name,
    or as the support of most objects.

    Raises:
        InputError: the file cannot be read (``mjcf_files``) or compiled, has joints other than free
            ones, no free body, or no table.
    """
    refusals = Refusals()
    model = compile_sound(
        gather(path, folder), f"the model {path.name!r}", refusals, compile_foreign
    )
    _check_meshes(model)
    reader = _ModelReader(model)
    stem = str(model.names[: model.names.find(b"\0")].decode("utf-8", "replace")) or path.stem
    if (single := reader.single_body(stem)) is not None:
        return ForeignScene(stem, None, (single,), refused=tuple(refusals.outcomes))
    reader.check_joints(refusals)
    check_count(len(reader.free))
    objects: list[ForeignBody] = []
    for b in reader.free:
        with refusals.catching(model.body(b).name or f"body_{b}"):
            objects.append(reader.body(b))
    refusals.check_left(objects)
    fixed, name = reader.find_table(table, objects)
    return ForeignScene(
        stem, reader.fixed_body(name, fixed), tuple(objects), tuple(reader.list_left(fixed)),
        tuple(refusals.outcomes),
    )  # fmt: skip


def compile_foreign(gathered: GatheredModel, what: str) -> mujoco.MjModel:
    """Compile a gathered model with MuJoCo; ``what`` names the model in error messages.

    Raises:
        InputError: MuJoCo rejects it.
    """
    import mujoco

    write_no_log()
    try:
        return mujoco.MjModel.from_xml_string(gathered.xml, gathered.files)
    except ValueError as error:
        said = " ".join(str(error).split())[:500]
        raise InputError(f"MuJoCo rejects {what}: {said!r}. Correct the file.") from error


def _check_meshes(model: mujoco.MjModel) -> None:
    """Check the number of triangles of meshes; a mesh counts once for each geom that uses it."""
    shown = model.geom_dataid[model.geom_type == _MESH]
    _check_faces(int(model.mesh_facenum[shown].sum(dtype=np.int64)))


def _check_faces(count: int) -> None:
    if count > MOST_FACES:
        raise InputError(
            f"The visible geoms of the model have at least {count} triangles, counting repeated "
            f"meshes; at most {MOST_FACES} are allowed. Simplify meshes, or remove objects."
        )


class _ModelReader:
    """Reads bodies from a compiled model at its initial state."""

    def __init__(self, model: mujoco.MjModel) -> None:
        import mujoco

        self.model = model
        self.data = new_data(model)
        mujoco.mj_kinematics(model, self.data)
        mujoco.mj_comPos(model, self.data)
        free = int(mujoco.mjtJoint.mjJNT_FREE)
        self.free = [int(model.jnt_bodyid[j]) for j in range(model.njnt) if
                     model.jnt_type[j] == free]  # fmt: skip
        self.solid: Bool[np.ndarray, "g"] = (model.geom_contype | model.geom_conaffinity) != 0
        self.looks = GeomLooks(model)
        self._drawn = 0  # triangles
        self._meshes: dict[int, tuple[Any, Any, Any]] = {}  # by index; geoms may share them
        colors = [self.looks.color(g)[3] > _SEEN for g in range(model.ngeom)]
        self.seen: Bool[np.ndarray, "g"] = np.array(colors, bool).reshape(-1)

    def single_body(self, name: str) -> ForeignBody | None:
        """Return a jointless model's body, or None if it is a table or there are several bodies."""
        groups = self._fixed_groups()
        if self.model.njnt or len(groups) != 1:
            return None
        ((known, geoms),) = groups.items()
        if TABLE_WORDS.search(known):
            return None
        body = int(self.model.geom_bodyid[geoms[0]])
        called = self.model.body(int(self.model.body_rootid[body])).name if body else known
        rigid = np.flatnonzero(self.model.body_mass > 0).tolist()
        masses = [self._mass(b, np.zeros(3), np.eye(3)) for b in rigid]
        mass = join_bodies(masses) if masses else None
        return self._body(called or name, geoms, np.zeros(3), np.eye(3), mass)

    def check_joints(self, refusals: Refusals) -> None:
        """Refuse bodies with joints other than free joints; raise if no free body is left."""
        model = self.model
        other = [j for j in range(model.njnt) if int(model.jnt_bodyid[j]) not in self.free]
        tops = {int(model.body_rootid[model.jnt_bodyid[j]]) for j in other}
        self.free = [b for b in self.free if b not in tops]
        if other:
            names = sorted({model.body(int(model.jnt_bodyid[j])).name or "(unnamed body)"
                            for j in other})  # fmt: skip
            error = InputError(
                f"The model has {len(other)} joints other than free ones, in "
                f"{', '.join(names[:5])}. Only rigid bodies with a free joint can be imported; "
                "remove robots and doors from the model."
            )
            if not self.free:
                raise error
            for top in sorted(tops):
                refusals.add(model.body(top).name or f"body_{top}", InputError(_JOINTED))
        if not self.free:
            raise InputError(
                "The model has no free body, so nothing on its table can move. Give each object a "
                "<freejoint/>."
            )

    def body(self, body: int) -> ForeignBody:
        """Return a free body, including everything welded to it."""
        model, data = self.model, self.data
        position, rotation = data.xpos[body].copy(), data.xmat[body].reshape(3, 3).copy()
        geoms = np.flatnonzero(model.body_weldid[model.geom_bodyid] == body)
        masses = [
            self._mass(b, position, rotation)
            for b in np.flatnonzero(model.body_weldid == body).tolist()
            if model.body_mass[b] > 0
        ]
        name = model.body(body).name
        if not masses:
            raise InputError(f"The body {name!r} has no mass.")
        return self._body(name, geoms, position, rotation, join_bodies(masses))

    def fixed_body(self, name: str, geoms: Int[np.ndarray, "k"]) -> ForeignBody:
        """Return the given fixed geoms as a single body in the world frame."""
        return self._body(name, geoms, np.zeros(3), np.eye(3), None)

    def find_table(
        self, asked: str | None, objects: Sequence[ForeignBody]
    ) -> tuple[Int[np.ndarray, "k"], str]:
        """Return the geoms and the name of the table: the one ``asked`` for, or a detected one."""
        groups = self._fixed_groups()
        if asked is not None:
            if asked not in groups:
                raise InputError(
                    f"There is no fixed body or geom named {asked!r}." + choices(asked, groups)
                )
            return groups[asked], asked
        if not groups:
            raise InputError(
                "The model has no table: its only fixed geoms that collide are planes. Add a fixed "
                "body, made of boxes or a mesh, on which the objects stand."
            )
        votes = dict.fromkeys(groups, 0)
        boxes = {name: self._box(geoms) for name, geoms in groups.items()}
        for thing in objects:
            world = thing.surface.vertices @ thing.rotation.T + thing.position
            low, middle = world[:, 2].min(), (world.min(0) + world.max(0))[:2] / 2
            under = [
                (box[1, 2], name) for name, box in boxes.items()
                if (box[0, :2] <= middle).all() and (middle <= box[1, :2]).all()
                and box[1, 2] <= low + _UNDER
            ]  # fmt: skip
            if under:
                votes[max(under)[1]] += 1
        called = [name for name in groups if TABLE_WORDS.search(name)]
        best = max(groups, key=lambda name: (votes[name] > 0, name in called, votes[name]))
        if not votes[best]:
            raise InputError(
                "The model has no table: nothing fixed is below any of its free bodies. Choose "
                "the table (--table)." + choices("table", groups)
            )
        return groups[best], best

    def list_left(self, table: Int[np.ndarray, "k"]) -> Iterable[str]:
        """Yield a message for each kind of content that the import ignores."""
        others = [name for name, geoms in self._fixed_groups().items() if geoms[0] not in table]
        if others:
            yield f"fixed objects are ignored: {', '.join(sorted(others)[:8])}"
        for what, count in (
            ("actuators", self.model.nu), ("tendons", self.model.ntendon),
            ("equality constraints", self.model.neq),
        ):  # fmt: skip
            if count:
                yield f"{count} {what} are ignored"

    def _fixed_groups(self) -> dict[str, Int[np.ndarray, "k"]]:
        """Return each fixed body's geoms by name; a geom of the world body counts as a body."""
        model = self.model
        groups: dict[str, list[int]] = {}
        for g in range(model.ngeom):
            body = int(model.geom_bodyid[g])
            if model.body_weldid[body] != 0 or model.geom_type[g] == _PLANE:
                continue
            top = int(model.body_rootid[body])
            name = model.body(top).name if top else model.geom(g).name
            groups.setdefault(name or (f"body {top}" if top else f"geom {g}"), []).append(g)
        return {n: np.array(k) for n, k in groups.items() if self.solid[k].any()}

    def _box(self, geoms: Int[np.ndarray, "k"]) -> Float[np.ndarray, "2 3"]:
        """Return the lower and upper corners of the collision geoms' bounding box in world axes."""
        points = [self._part(int(g), np.zeros(3), np.eye(3)).bounds for g in geoms if self.solid[g]]
        return np.stack([np.min(points, axis=0)[0], np.max(points, axis=0)[1]])

    def _body(
        self,
        name: str,
        geoms: Int[np.ndarray, "k"],
        position: Float[np.ndarray, "3"],
        rotation: Float[np.ndarray, "3 3"],
        mass: MassProperties | None,
    ) -> ForeignBody:
        geoms = geoms[self.model.geom_type[geoms] != _PLANE]
        if not np.isfinite(self.data.geom_xpos[geoms]).all():
            raise InputError(f"The body {name!r} has a position that is not finite.")
        solid = geoms[self.solid[geoms]]
        drawn = geoms[~self.solid[geoms] & self.seen[geoms]]
        if not len(drawn):
            drawn = solid
        if not len(drawn):
            raise InputError(f"The body {name!r} has no geom that collides or is visible.")
        friction = self.model.geom_friction[solid, 0]
        return ForeignBody(
            name, position, rotation, self._surface(drawn, position, rotation),
            tuple(self._part(int(g), position, rotation) for g in solid), mass,
            float(friction.max()) if len(friction) else None,
        )  # fmt: skip

    def _mass(
        self, body: int, position: Float[np.ndarray, "3"], rotation: Float[np.ndarray, "3 3"]
    ) -> MassProperties:
        model, data = self.model, self.data
        axes = rotation.T @ data.ximat[body].reshape(3, 3)
        com = rotation.T @ (data.xipos[body] - position)
        inertia = axes @ np.diag(model.body_inertia[body]) @ axes.T
        return MassProperties(float(model.body_mass[body]), com, inertia)

    def _place(
        self, geom: int, position: Float[np.ndarray, "3"], rotation: Float[np.ndarray, "3 3"]
    ) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3 3"]]:
        """Return a geom's position and rotation in the frame with the given pose."""
        data = self.data
        turn = rotation.T @ data.geom_xmat[geom].reshape(3, 3)
        return rotation.T @ (data.geom_xpos[geom] - position), turn

    def _part(
        self, geom: int, position: Float[np.ndarray, "3"], rotation: Float[np.ndarray, "3 3"]
    ) -> ConvexPart:
        center, turn = self._place(geom, position, rotation)
        kind = int(self.model.geom_type[geom])
        if kind == _MESH:
            points = self._mesh(geom)[0] @ turn.T + center
            return ConvexPart(hull_corners(points))
        return solid_part(self._solid(geom), self._half(geom), center, turn)

    def _solid(self, geom: int) -> Solid:
        kind = int(self.model.geom_type[geom])
        if kind not in _KINDS:
            raise InputError(
                f"The geom {self.model.geom(geom).name!r} has an unsupported shape; use boxes, "
                "spheres, cylinders, capsules, ellipsoids or meshes."
            )
        return _KINDS[kind]

    def _half(self, geom: int) -> Float[np.ndarray, "3"]:
        """Return a primitive's half extents along its axes; those of a capsule exclude its caps."""
        size, kind = self.model.geom_size[geom], int(self.model.geom_type[geom])
        if kind == 2:
            return np.full(3, size[0])
        return size[[0, 0, 1]] if kind in (3, 5) else size.copy()

    def _surface(
        self,
        geoms: Int[np.ndarray, "k"],
        position: Float[np.ndarray, "3"],
        rotation: Float[np.ndarray, "3 3"],
    ) -> ColoredSurface:
        """Return the combined surface of several geoms in the frame with the given pose."""
        pictures: list[UInt8[np.ndarray, "h w 3"]] = []
        known: dict[int, int] = {}
        rows: list[tuple[Any, ...]] = []
        count = 0
        for geom in map(int, geoms):
            center, turn = self._place(geom, position, rotation)
            if self.model.geom_type[geom] == _MESH:
                vertices, faces, uv = self._mesh(geom)
            else:
                vertices, faces = solid_surface(self._solid(geom), self._half(geom))
                uv = None
            picture, index = self.looks.picture(geom), -1
            color = self.looks.color(geom)
            if picture is not None and uv is None:
                color = np.append(picture.reshape(-1, 3).mean(0) / 255, color[3])
            elif picture is not None:
                index = known.setdefault(id(picture), len(pictures))
                if index == len(pictures):
                    pictures.append(picture)
            self._drawn += len(faces)
            _check_faces(self._drawn)
            flat = np.round(255 * color[:3].clip(0, 1)).astype(np.uint8)
            rows.append((
                vertices @ turn.T + center, faces + count,
                np.zeros((len(vertices), 2)) if uv is None else uv,
                np.tile(flat, (len(vertices), 1)), np.full(len(faces), index), color[3],
            ))  # fmt: skip
            count += len(vertices)
        columns = [np.concatenate([row[k] for row in rows]) for k in range(5)]
        alphas = [float(row[5]) for row in rows]
        opacity = float(np.clip(np.mean(alphas), 0.05, 1.0)) if max(alphas) < 1 else 1.0
        vertices, faces, uv, colors, picture = columns
        return ColoredSurface(vertices, faces, uv, colors, picture, tuple(pictures), opacity)

    def _mesh(
        self, geom: int
    ) -> tuple[Float[np.ndarray, "n 3"], Int[np.ndarray, "m 3"], Float[np.ndarray, "n 2"] | None]:
        """Return a geom's mesh in the geom's frame, and texture coordinates with v pointing up."""
        mesh = int(self.model.geom_dataid[geom])
        if mesh not in self._meshes:
            self._meshes[mesh] = self._read_mesh(mesh)
        vertices, faces, uv = self._meshes[mesh]
        return vertices, faces, None if uv is None else uv * self.looks.repeat(geom)

    def _read_mesh(
        self, mesh: int
    ) -> tuple[Float[np.ndarray, "n 3"], Int[np.ndarray, "m 3"], Float[np.ndarray, "n 2"] | None]:
        model = self.model
        at, count = model.mesh_faceadr[mesh], model.mesh_facenum[mesh]
        faces = model.mesh_face[at : at + count].astype(np.int64)
        first, number = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
        vertices = model.mesh_vert[first : first + number].astype(np.float64)
        if model.mesh_texcoordadr[mesh] < 0:
            return vertices, faces, None
        texcoords = int(model.mesh_texcoordnum[mesh])
        which = model.mesh_facetexcoord[at : at + count].astype(np.int64)
        pairs, index = np.unique((faces * texcoords + which).ravel(), return_inverse=True)
        corner, which = np.divmod(pairs, texcoords)
        uv = model.mesh_texcoord[model.mesh_texcoordadr[mesh] + which].astype(np.float64)
        uv = np.column_stack([uv[:, 0], 1 - uv[:, 1]])
        return vertices[corner], index.reshape(-1, 3), uv


class GeomLooks:
    """The appearance of a model's geoms, which are given by index."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._model = model
        self._pictures: dict[tuple[int, bytes], UInt8[np.ndarray, "h w 3"]] = {}

    def color(self, geom: int) -> Float[np.ndarray, "4"]:
        """Return a geom's own RGBA, or its material's if its own is the default, as in MuJoCo."""
        model = self._model
        material, own = int(model.geom_matid[geom]), model.geom_rgba[geom]
        if material < 0 or not np.allclose(own, [0.5, 0.5, 0.5, 1.0]):
            return own.astype(np.float64)
        return model.mat_rgba[material].astype(np.float64)

    def repeat(self, geom: int) -> Float[np.ndarray, "2"]:
        """Return how often a geom's texture repeats along each of its two axes."""
        material = int(self._model.geom_matid[geom])
        if material < 0:
            return np.ones(2)
        return self._model.mat_texrepeat[material].astype(np.float64)

    def picture(self, geom: int) -> UInt8[np.ndarray, "h w 3"] | None:
        """Return a geom's tinted texture (a cube map's first face), or None if it has no texture.

        Geoms with the same texture and colour get the same read-only array, so that meshes share
        it. Its longest side is at most ``MOST_TEXTURE``.
        """
        texture = self._texture(geom)
        if texture < 0:
            return None
        tint = self.color(geom)[:3].clip(0, 1)
        key = texture, tint.tobytes()
        if key not in self._pictures:
            self._pictures[key] = self._tint(texture, tint)
        return self._pictures[key]

    def _texture(self, geom: int) -> int:
        """Return the index of a geom's texture, or -1 if it has none."""
        import mujoco

        material = int(self._model.geom_matid[geom])
        if material < 0:
            return -1
        roles = (mujoco.mjtTextureRole.mjTEXROLE_RGB, mujoco.mjtTextureRole.mjTEXROLE_RGBA)
        return max(int(self._model.mat_texid[material, int(role)]) for role in roles)

    def _tint(self, texture: int, tint: Float[np.ndarray, "3"]) -> UInt8[np.ndarray, "h w 3"]:
        import cv2

        model = self._model
        height, width = int(model.tex_height[texture]), int(model.tex_width[texture])
        channels, at = int(model.tex_nchannel[texture]), int(model.tex_adr[texture])
        data = model.tex_data[at : at + height * width * channels]
        data = data.reshape(height, width, channels)
        pixels = np.repeat(data[..., :1], 3, axis=2) if channels < 3 else data[..., :3]
        if height == 6 * width:
            pixels = pixels[:width]
        longest = max(pixels.shape[:2])
        if longest > MOST_TEXTURE:
            size = [max(1, side * MOST_TEXTURE // longest) for side in pixels.shape[1::-1]]
            pixels = cv2.resize(pixels, size, interpolation=cv2.INTER_AREA)
        return frozen_array(np.round(pixels * tint), *PICTURE, "A texture")
