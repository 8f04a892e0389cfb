"""Checks of a category: shape, parts, size, mass, variants, stability, style, names and index.

``check_category`` runs all checks on the variants of the first seeds. ``tests/catalogue`` and
``tabletopgen objects check`` print the same results.
"""

from __future__ import annotations

import hashlib
import json
import traceback
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from tabletop_objects import CATEGORIES, Category
from tabletop_objects.catalogue import INDEX, look_of, model_of
from tabletop_objects.index import row_of
from tabletop_objects.kit.solids import signed_volume
from tabletop_objects.kit.styles import STYLES

from ..geometry import yaw_quaternion
from ..physics.inertia import body_mass
from ..physics.parts import body_parts, model_parts
from ..physics.spec import new_data
from ..scene import Mesh, Model, Object, Placement, Pose
from ..scene.triangles import areas

if TYPE_CHECKING:
    import mujoco


VARIANTS = 10
"""Number of seeds whose variants are counted; the first ``SOUND`` of them are checked in full."""

SOUND, SIZED = 3, 8
"""Number of seeds whose shapes are checked, and number of seeds whose sizes are averaged."""

MIN_LOOKS = 5
MAX_FACES, MAX_STYLED_FACES, MAX_TEXTURE = 4000, 5000, 640
MAX_PARTS, MAX_PART_VERTICES = 32, 32
MAX_OVERHANG = 0.004  # maximum extent of a part beyond the unit box
MAX_GAP = 6e-4  # maximum distance between the undersides of the mesh and of the parts, metres
MIN_PART = 2e-4  # metres along each axis
SIZE_TOLERANCE = 1.35  # ratio of the mean size to the nominal size along each axis
MAX_VARIANT = 2.2  # ratio of a variant's diagonal to the nominal diagonal
MASS_RANGE = 0.4, 2.5  # ratio of a variant's mass to the nominal mass
MIN_MASS = 0.002  # kg; lighter bodies are given this mass
MAX_STYLED_CHANGE = 0.012  # fraction of the longest side
MAX_DRIFT, MAX_TURN = 0.005, 3.0  # metres and degrees, within one second

INDEX_COMMAND = "python -m tabletop_objects.index"


@dataclass(frozen=True)
class CheckResult:
    """The outcome of one check: its name, whether it passed, and the measured values."""

    name: str
    passed: bool
    detail: str = ""


def check_category(
    category: Category, source: Path, index: Path = INDEX
) -> tuple[CheckResult, ...]:
    """Check a category as it is declared in its module.

    If the drawing function raises an exception, the check "drawing" fails and the checks of its
    models are skipped.

    Args:
        category: the declared category with its drawing function, not its row in the index.
        source: the file that declares it.
        index: the ``index.json`` that should contain its row.
    """
    facts = check_names(category), check_index(category, source, index)
    try:
        models = [build_variant(category, seed) for seed in range(VARIANTS)]
        again = build_variant(category, 1)
        styled = {s: build_variant(category, 0, {"style": s}) for s in sorted(STYLES)}
    except Exception as error:  # drawing functions may be third-party code
        return _drawing_failure(error), *facts
    return (
        CheckResult("drawing", True, f"{VARIANTS} variants, {len(styled)} styles"),
        *check_shape(models[:SOUND]),
        *check_parts(models[:SOUND]),
        check_size(category, models[:SIZED]),
        check_variant_size(category, models[0]),
        check_mass(category, models[0]),
        check_seeds(models[:SOUND], again),
        check_looks(models),
        check_rest(models[0]),
        *(check_style(style, model, models[0]) for style, model in styled.items()),
        *facts,
    )


def build_variant(
    category: Category, seed: int, attributes: Mapping[str, str] = MappingProxyType({})
) -> Model:
    """Build a variant of a category as ``build`` does; the category need not be in the index."""
    return model_of(category, look_of(category, seed, attributes))


def _drawing_failure(error: Exception) -> CheckResult:
    frames = traceback.extract_tb(error.__traceback__)
    at = f" ({frames[-1].filename}:{frames[-1].lineno})" if frames else ""
    return CheckResult("drawing", False, f"{type(error).__name__}: {error}{at}")


def _first(name: str, findings: Iterable[tuple[bool, str]]) -> CheckResult:
    """Return the first result that failed, or the last result if none failed."""
    detail = ""
    for passed, detail in findings:
        if not passed:
            return CheckResult(name, False, detail)
    return CheckResult(name, True, detail)


# ----------------------------------------------------------------------------------------- shape


def check_shape(models: Iterable[Model], max_faces: int = MAX_FACES) -> Iterator[CheckResult]:
    """Check the surfaces, numbers of faces and textures of models, and yield the results."""
    meshes = [model.mesh for model in models]
    volumes = [signed_volume(m.vertices.astype(float), m.faces) for m in meshes]
    faces = max(len(m.faces) for m in meshes)
    side = max(max(m.texture.shape[:2]) for m in meshes)
    low = min(float(m.uv.min()) for m in meshes)
    high = max(float(m.uv.max()) for m in meshes)
    holes = sum(not is_closed(m) for m in meshes)
    yield CheckResult("closed surface", holes == 0, f"{holes} of {len(meshes)} variants have holes")
    filled = f"{min(volumes):.2g} of the unit box"
    yield CheckResult("positive volume", min(volumes) > 0, filled)
    yield CheckResult("faces", faces <= max_faces, f"{faces}, at most {max_faces}")
    texels = f"{side} texels, at most {MAX_TEXTURE}"
    yield CheckResult("texture", side <= MAX_TEXTURE, texels)
    yield CheckResult("uv", low >= 0 and high <= 1, f"from {low:.3f} to {high:.3f}")


def check_parts(models: Iterable[Model]) -> Iterator[CheckResult]:
    """Check the convex parts of models, and yield the results."""
    models = list(models)
    counts = [len(model.parts) for model in models]
    counted = f"{min(counts)} to {max(counts)}, 1 to {MAX_PARTS} allowed"
    yield CheckResult("convex parts", min(counts) >= 1 and max(counts) <= MAX_PARTS, counted)
    if min(counts) == 0:
        return
    vertices = max(len(part.vertices) for model in models for part in model.parts)
    most = f"{vertices} in a part, at most {MAX_PART_VERTICES}"
    yield CheckResult("part vertices", vertices <= MAX_PART_VERTICES, most)
    yield _first("parts within the box", map(_overhang, models))
    yield _first("parts reach the bottom", map(_gap, models))
    yield _first("parts not flat", map(_thickness, models))


def _overhang(model: Model) -> tuple[bool, str]:
    over = max(float(np.abs(part.bounds).max()) for part in model.parts) - 0.5
    return over <= MAX_OVERHANG, f"{max(over, 0):.4f} of the box outside, at most {MAX_OVERHANG}"


def _gap(model: Model) -> tuple[bool, str]:
    low = min(float(part.bounds[0, 2]) for part in model.parts)
    gap = (low + 0.5) * float(model.size[2])
    return gap < MAX_GAP, f"gap of {1000 * max(gap, 0):.2f} mm, less than {1000 * MAX_GAP:.1f}"


def _thickness(model: Model) -> tuple[bool, str]:
    thin = min(float((np.ptp(p.vertices, axis=0) * model.size).min()) for p in model.parts)
    return thin > MIN_PART, f"thinnest {1000 * thin:.2f} mm, more than {1000 * MIN_PART:.1f}"


# -------------------------------------------------------------------------------- size and mass


def check_size(category: Category, models: Iterable[Model]) -> CheckResult:
    """Compare the mean size of the variants with the nominal size."""
    mean = np.mean([model.size for model in models], axis=0)
    ratio = np.abs(np.log(mean / category.size))
    near = bool((ratio < np.log(SIZE_TOLERANCE)).all())
    detail = f"mean {size_text(mean)}, nominal {size_text(category.size)}"
    return CheckResult("nominal size", near, detail)


def check_variant_size(category: Category, model: Model) -> CheckResult:
    """Compare the diagonal of one variant with the nominal diagonal."""
    ratio = float(np.linalg.norm(model.size) / np.linalg.norm(category.size))
    near = 1 / MAX_VARIANT < ratio < MAX_VARIANT
    return CheckResult(
        "size of a variant", near, f"{size_text(model.size)}, {ratio:.2f} times the nominal"
    )


def check_mass(category: Category, model: Model) -> CheckResult:
    """Compare the mass of one variant with the nominal mass."""
    mass, (low, high) = mass_of(model), MASS_RANGE
    near = low * category.mass < mass < high * max(category.mass, MIN_MASS)
    return CheckResult("mass", near, f"{mass:.3g} kg, nominal {category.mass:.3g} kg")


def size_text(size: Iterable[float]) -> str:
    """Format an extent in metres, for example as "8.5 x 8.3 x 9.5 cm"."""
    return " x ".join(f"{100 * side:.3g}" for side in size) + " cm"


# ------------------------------------------------------------------------------ variants and rest


def check_seeds(models: Iterable[Model], again: Model) -> CheckResult:
    """Check that models differ between seeds and that ``again`` equals the second model."""
    prints = [fingerprint(model) for model in models]
    distinct = len({*prints})
    same = fingerprint(again) == prints[1]
    repeat = "repeats" if same else "does not repeat"
    detail = f"{distinct} of {len(prints)} variants differ; the same seed {repeat}"
    return CheckResult("seeds", distinct == len(prints) and same, detail)


def check_looks(models: Iterable[Model]) -> CheckResult:
    """Check that the variants look sufficiently different."""
    looks = count_looks(models)
    return CheckResult("looks", looks >= MIN_LOOKS, f"{looks} of {VARIANTS}, at least {MIN_LOOKS}")


def check_rest(model: Model) -> CheckResult:
    """Check that a standing model stays at rest for one second."""
    moved, turned = drift(model)
    detail = f"moves {1000 * moved:.1f} mm and turns {turned:.1f}° in 1 s"
    return CheckResult("rest", moved < MAX_DRIFT and turned < MAX_TURN, detail)


def check_style(style: str, model: Model, plain: Model) -> CheckResult:
    """Check the shape and parts of a styled model, and compare its size with the unstyled model."""
    results = *check_shape([model], MAX_STYLED_FACES), *check_parts([model])
    change = float((np.abs(model.size - plain.size) / plain.size.max()).max())
    sized = CheckResult("size", change <= MAX_STYLED_CHANGE, f"changes by {change:.1%}")
    failed = [f"{r.name}: {r.detail}" for r in (*results, sized) if not r.passed]
    detail = "; ".join(failed) or f"{len(model.mesh.faces)} faces"
    return CheckResult(f"style {style}", not failed, detail)


# ----------------------------------------------------------------------------------------- facts


def check_names(category: Category) -> CheckResult:
    """Check that no other category uses one of this category's names."""
    names = {category.noun, *category.aliases}
    taken = {
        f"{name!r} is already a name of {other}"
        for name in names
        for other, is_noun in _claims().get(name, ())
        if other != category.key and not (is_noun and name == category.noun)
    }
    return CheckResult("names", not taken, "; ".join(sorted(taken)) or f"{len(names)} names")


@cache
def _claims() -> Mapping[str, tuple[tuple[str, bool], ...]]:
    """Map each name to pairs: a category's key, and whether the name is that category's noun."""
    claims: dict[str, tuple[tuple[str, bool], ...]] = {}
    for key, category in CATEGORIES.items():
        for name in {category.noun, *category.aliases}:
            claims[name] = (*claims.get(name, ()), (key, name == category.noun))
    return MappingProxyType(claims)


def check_index(category: Category, source: Path, index: Path = INDEX) -> CheckResult:
    """Check that the row in the index matches the category declared in its module."""
    module = f"{source.parent.name}.{source.stem}"
    row = _rows(index).get(category.key)
    current = row is not None and row == json.loads(json.dumps(row_of(module, category)))
    state = "current" if current else "missing" if row is None else "out of date"
    advice = "" if current else f"; run: {INDEX_COMMAND}"
    return CheckResult("index", current, f"the object's row is {state}{advice}")


@cache
def _rows(index: Path) -> Mapping[str, dict[str, object]]:
    return MappingProxyType(json.loads(index.read_bytes()))


def stand_on_floor(model: Model) -> Object:
    """Return a model as a body of real size with its underside at z = 0."""
    middle = np.array([0.0, 0.0, model.size[2] / 2])
    parts = body_parts(model, model.size)
    weight = body_mass(model.mesh, model.size, model.physics, parts)
    return Object(
        model.name, model, Placement(model.name, 0.0, middle, model.size), parts,
        weight.mass, weight.com, weight.inertia, model.physics.friction,
        Pose(middle, yaw_quaternion(0.0)),
    )  # fmt: skip


_SIZE, _COLOR, _SPREAD = 0.05, 8.0, 6.0  # visible steps of log size and of colour values (0 to 255)


def appearance(model: Model) -> Float[np.ndarray, "9"]:
    """Return a model's log size and its colours' mean and spread, in units of a visible step."""
    mesh = model.mesh
    area = areas(mesh.vertices.astype(float) * model.size, mesh.faces)
    height, width = mesh.texture.shape[:2]
    colors = []
    for weights in np.array([(4, 1, 1), (1, 4, 1), (1, 1, 4), (2, 2, 2)]) / 6:
        u, v = np.einsum("k,fkd->df", weights, mesh.uv[mesh.faces])
        rows = np.clip(((1 - v) * height).astype(int), 0, height - 1)
        colors.append(mesh.texture[rows, np.clip((u * width).astype(int), 0, width - 1)])
    seen, share = np.concatenate(colors).astype(float), np.tile(area, 4) / area.sum() / 4
    mean = share @ seen
    spread = np.sqrt(share @ (seen - mean) ** 2)
    return np.concatenate([np.log(model.size) / _SIZE, mean / _COLOR, spread / _SPREAD])


def count_looks(models: Iterable[Model]) -> int:
    """Count the models that visibly differ from every model counted before."""
    looks: list[Float[np.ndarray, "9"]] = []
    for model in models:
        here = appearance(model)
        if all(np.abs(here - other).max() > 1 for other in looks):
            looks.append(here)
    return len(looks)


def is_closed(mesh: Mesh) -> bool:
    """Return whether, after merging vertices, each edge is used equally often in both directions.

    Only vertices with bitwise identical positions are merged.
    """
    _, index = np.unique(mesh.vertices + np.float32(0), axis=0, return_inverse=True)
    faces = index.reshape(-1)[mesh.faces].astype(np.int64)
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    count = len(mesh.vertices)
    forwards = np.sort(edges[:, 0] * count + edges[:, 1])
    backwards = np.sort(edges[:, 1] * count + edges[:, 0])
    return bool((forwards == backwards).all())


def mass_of(model: Model) -> float:
    """Return the mass in kilograms of a model at its nominal size."""
    return body_mass(model.mesh, model.size, model.physics, model_parts(model, model.size)).mass


def fingerprint(model: Model) -> str:
    """Return a digest of a model's visual and collision data."""
    mesh = model.mesh
    arrays = mesh.vertices, mesh.faces, mesh.uv, mesh.texture, model.size
    digest = hashlib.sha256()
    for array in (*arrays, *(part.vertices for part in model.parts)):
        digest.update(str(array.shape).encode())
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


MASS = 0.2
"""Mass of a free body, in kg; the motion of a uniform solid does not depend on it."""

STEPS = 500
"""Number of time steps, each of 2 ms."""


def floor_spec() -> mujoco.MjSpec:
    """Return a spec that contains a floor at z = 0."""
    import mujoco

    spec = mujoco.MjSpec()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[1, 1, 1])
    return spec


def stand(spec: mujoco.MjSpec, model: Model, free: bool) -> mujoco.MjsBody:
    """Add a model's collision parts to ``spec`` as a body on the floor, and return the body."""
    import mujoco

    body = spec.worldbody.add_body(name=model.name, pos=[0, 0, model.size[2] / 2])
    for k, part in enumerate(model.parts):
        mesh = spec.add_mesh(name=f"part{k}")
        mesh.uservert = (part.vertices * model.size).astype(np.float32).ravel()
        mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
        body.add_geom(
            type=mujoco.mjtGeom.mjGEOM_MESH,
            meshname=f"part{k}",
            friction=[model.physics.friction, 0.005, 1e-4],
        )
    if free:
        body.add_freejoint()
        center, spread = _moments(model)
        inertia = MASS * (np.trace(spread) * np.eye(3) - spread)
        body.explicitinertial, body.mass, body.ipos = True, MASS, center
        body.fullinertia = inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    return body


def drift(model: Model) -> tuple[float, float]:
    """Return how far a model on the floor moves (metres) and turns (degrees) within one second."""
    import mujoco

    spec = floor_spec()
    stand(spec, model, free=True)
    compiled = spec.compile()
    data = new_data(compiled)
    for _ in range(STEPS):
        mujoco.mj_step(compiled, data)
    moved = float(np.linalg.norm(data.qpos[:3] - [0, 0, model.size[2] / 2]))
    return moved, float(2 * np.degrees(np.arccos(min(1.0, abs(data.qpos[3])))))


def _moments(model: Model) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3 3"]]:
    """Return a uniform solid's centre of mass and its covariance about that centre."""
    v = model.mesh.vertices.astype(float) * model.size
    a, b, c = (v[model.mesh.faces[:, k]] for k in range(3))
    w = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
    s = a + b + c
    center = (w[:, None] * s / 4).sum(0) / w.sum()
    second = sum(np.einsum("n,ni,nj->ij", w, p, p) for p in (a, b, c, s)) / 20 / w.sum()
    return center, second - np.outer(center, center)
