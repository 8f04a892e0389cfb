import contextlib
import dataclasses
import resource
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
import trimesh
from extent import EXHAUSTIVE, count
from shapes import UNIT, sphere_mesh
from toy import cube_mesh

from generator.errors import SceneError
from generator.physics import decomposition
from generator.physics.decomposition import CutBudget, decompose
from generator.physics.parts import model_parts, scale_part
from generator.sandbox import SandboxLimits
from generator.scene import ConvexPart, Mesh, Model


def angle_mesh() -> Mesh:
    """An L: a floor and a wall, as one outline drawn along y."""
    outline = np.array([[-5, -5], [5, -5], [5, 5], [4, 5], [4, -4], [-5, -4]]) / 10
    front, back = (np.insert(outline, 1, y, axis=1) for y in (-0.5, 0.5))
    sides = []
    for k in range(6):
        n = (k + 1) % 6
        sides += [[k, n, n + 6], [k, n + 6, k + 6]]
    caps = [[0, 4, 1], [0, 5, 4], [1, 4, 2], [2, 4, 3]]
    caps = [[a, c, b] for a, b, c in caps] + [[a + 6, b + 6, c + 6] for a, b, c in caps]
    return Mesh(np.concatenate([front, back]), sides + caps, np.zeros((12, 2)), np.zeros((2, 2, 3)))


def inside(parts: tuple[ConvexPart, ...], point: list[float]) -> bool:
    from scipy.spatial import ConvexHull

    hulls = [ConvexHull(part.vertices).equations for part in parts]
    return any((h[:, :3] @ point + h[:, 3] < 1e-9).all() for h in hulls)


@pytest.mark.slow
def test_a_hollow_stays_open(tmp_path: Path) -> None:
    parts = decompose(angle_mesh(), np.full(3, 0.1), cache=tmp_path)
    assert len(parts) >= 2
    assert inside(parts, [0, 0, -0.45])
    assert inside(parts, [0.45, 0, 0.2])
    assert not inside(parts, [-0.2, 0, 0.2])


def test_a_ball_is_one_hull_and_is_kept(tmp_path: Path, monkeypatch) -> None:
    parts = decompose(sphere_mesh(), np.full(3, 0.1), cache=tmp_path)
    assert len(parts) == 1
    monkeypatch.setattr(decomposition, "_coacd", None)  # not called a second time
    again = decompose(sphere_mesh(), np.full(3, 0.1), cache=tmp_path)
    np.testing.assert_array_equal(again[0].vertices, parts[0].vertices)


@pytest.mark.slow
def test_a_damaged_cache_is_made_again(tmp_path: Path) -> None:
    parts = decompose(cube_mesh(), np.full(3, 0.1), cache=tmp_path)
    next(tmp_path.iterdir()).write_bytes(b"not an archive")
    again = decompose(cube_mesh(), np.full(3, 0.1), cache=tmp_path)
    np.testing.assert_array_equal(again[0].vertices, parts[0].vertices)


def test_an_unwritable_cache_only_costs_time(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    assert decompose(cube_mesh(), np.full(3, 0.1), cache=tmp_path / "file" / "below")


@pytest.mark.slow
def test_overlapping_solids_in_one_mesh_are_decomposed_in_time(tmp_path: Path) -> None:
    ball = sphere_mesh(12, 6)
    shifted = ball.vertices + np.float32([0.05, 0, 0])
    faces = np.concatenate([ball.faces, ball.faces + len(ball.vertices)])
    both = Mesh(
        (np.concatenate([ball.vertices, shifted]) / 1.1).astype(np.float32), faces,
        np.zeros((2 * len(ball.vertices), 2)), ball.texture,
    )  # fmt: skip
    parts = decompose(both, np.full(3, 0.1), cache=tmp_path)
    assert len(parts) < 12, "their surface is rebuilt first; 24 without"
    assert inside(parts, [0, 0, 0])


def together(*meshes: trimesh.Trimesh) -> Mesh:
    joined = trimesh.util.concatenate(list(meshes))
    vertices = (joined.vertices - joined.bounds.mean(0)) / joined.extents.max()
    faces = np.asarray(joined.faces, np.int32)
    return Mesh(
        vertices.astype(np.float32), faces, np.zeros((len(vertices), 2)), sphere_mesh().texture
    )


@pytest.mark.slow
def test_crossed_bars_and_solids_turned_inside_out_are_decomposed_in_time(tmp_path: Path) -> None:
    bars = [trimesh.creation.box(extents=e) for e in ((1.0, 0.2, 0.2), (0.2, 1.0, 0.24))]
    balls = [trimesh.creation.icosphere(1, 0.4) for _ in range(2)]
    balls[1].apply_translation([0.04, 0, 0])
    for ball in balls:
        ball.invert()
    for meshes in (bars, balls):
        parts = decompose(together(*meshes), np.full(3, 0.1), cache=tmp_path)
        assert inside(parts, [0.05, 0.02, 0.02])


def test_pieces_apart_do_not_overlap() -> None:
    one, other = (trimesh.creation.box(extents=(0.2, 0.2, 0.2)) for _ in range(2))
    for away, meets in (((0.3, 0, 0), False), ((0.1, 0, 0), True), ((0.15, 0.15, 0.15), True)):
        both = together(one, other.copy().apply_translation(away))
        assert decomposition._overlaps(both.vertices.astype(float), both.faces) is meets


def test_a_mesh_without_an_area_is_refused(tmp_path: Path) -> None:
    line = Mesh(
        np.float32([[0, 0, 0], [0, 0, 0], [0.2, 0, 0]]), np.int32([[0, 1, 2]]), np.zeros((3, 2)),
        sphere_mesh().texture,
    )  # fmt: skip
    with pytest.raises(SceneError, match="only zero-area triangles"):
        decompose(line, np.full(3, 0.1), cache=tmp_path)


def test_a_mesh_that_holds_more_than_its_hull_overlaps_itself() -> None:
    ball = sphere_mesh()
    vertices = ball.vertices.astype(float)
    assert not decomposition._overlaps(vertices, ball.faces)
    assert decomposition._overlaps(vertices, np.concatenate([ball.faces, ball.faces]))
    assert not decomposition._overlaps(vertices * [1, 1, 0], ball.faces), "flat"


def test_limits_hold_and_leave_nothing(tmp_path: Path) -> None:
    limits = SandboxLimits(cpu_seconds=30, memory=2**20)
    with pytest.raises(SceneError, match="memory"):
        decompose(sphere_mesh(), np.full(3, 0.1), limits=limits, cache=tmp_path)
    assert not list(tmp_path.iterdir())


def rough_mesh(seed: int) -> Mesh:
    """Return loose triangles, which give more pieces than can be merged in reasonable time."""
    corners = np.random.default_rng(seed).standard_normal((3 * 2000, 3))
    return together(trimesh.Trimesh(corners, np.arange(len(corners)).reshape(-1, 3), process=False))


@contextlib.contextmanager
def timed() -> Iterator[list[float]]:
    """Add the CPU seconds of child processes in the context to the list."""
    seconds: list[float] = []
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    yield seconds
    seconds.append(resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)


@dataclasses.dataclass(frozen=True)
class Cut:
    """The first rough mesh decomposed once: its parts, CPU time, and the cache that has it."""

    parts: tuple[ConvexPart, ...]
    seconds: float
    cache: Path


@pytest.fixture(scope="module")
def rough(tmp_path_factory: pytest.TempPathFactory) -> Cut:
    cache = tmp_path_factory.mktemp("rough")
    with timed() as seconds:
        parts = decompose(rough_mesh(0), np.full(3, 0.1), cache=cache)
    return Cut(parts, *seconds, cache)


@pytest.mark.slow
def test_a_rough_mesh_is_cut_coarsely_not_given_up(rough: Cut) -> None:
    assert 1 <= len(rough.parts) <= 24
    assert 1 < rough.seconds < 30


def of_pieces(monkeypatch: pytest.MonkeyPatch, pieces: int) -> list[int]:
    """Make each mesh give this number of pieces; return the meshes that are cut, by faces."""
    cut: list[int] = []

    def coacd(vertices, faces, limits, cpu):
        cut.append(len(faces))
        return [vertices], pieces

    monkeypatch.setattr(decomposition, "_coacd", coacd)
    return cut


def test_an_import_has_a_budget_of_pieces(tmp_path: Path, monkeypatch) -> None:
    cut = of_pieces(monkeypatch, 4)
    meshes = [together(trimesh.creation.icosphere(0, 1 + k)) for k in range(2)]
    meshes += [together(trimesh.creation.box(extents=(1, 1, 1 + k))) for k in range(3)]
    for _ in range(2):  # the second time from the cache
        budget = CutBudget(10)
        done = []
        for mesh in meshes:
            try:
                decompose(mesh, np.ones(3), cache=tmp_path, budget=budget)
                done.append(True)
            except SceneError as error:
                assert "used all convex parts" in str(error)
                done.append(False)
        assert done == [True, True, True, True, False]  # the first two are equal
    assert cut == [20, 12, 12]
    assert decompose(meshes[0], np.ones(3), cache=tmp_path, budget=budget), "met again"


def test_a_mesh_that_fails_counts_as_a_rough_one(tmp_path: Path, monkeypatch) -> None:
    calls: list[int] = []

    def fail(vertices, faces, limits, cpu):
        calls.append(len(faces))
        raise SceneError("it breaks its reader")

    monkeypatch.setattr(decomposition, "_coacd", fail)
    budget = CutBudget(50)
    for k in range(5):
        for _ in range(2):
            with pytest.raises(SceneError, match="breaks" if k < 2 else "used all convex parts"):
                decompose(
                    together(trimesh.creation.box(extents=(1, 1, 1 + k))), np.ones(3),
                    cache=tmp_path, budget=budget,
                )  # fmt: skip
    assert len(calls) == 2


def test_hulls_without_their_pieces_are_made_again(tmp_path: Path, monkeypatch) -> None:
    of_pieces(monkeypatch, 3)
    decompose(cube_mesh(), np.ones(3), cache=tmp_path)
    (kept,) = tmp_path.iterdir()
    np.savez(kept, np.zeros((4, 3)))
    budget = CutBudget(10)
    assert decompose(cube_mesh(), np.ones(3), cache=tmp_path, budget=budget)[0].vertices.any()
    assert budget.left == 7


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_the_budget_bounds_the_time_of_many_rough_meshes(rough: Cut) -> None:
    """A smaller budget than usual, for two rough meshes, except in an exhaustive run."""
    budget, made = CutBudget() if EXHAUSTIVE else CutBudget(60), 0
    with timed() as seconds:
        for seed in range(8):
            with contextlib.suppress(SceneError):
                decompose(rough_mesh(seed), np.ones(3), cache=rough.cache, budget=budget)
                made += 1
    assert 1 <= made <= count(4, 2)
    assert rough.seconds + seconds[0] < count(90, 45)


def test_known_parts_are_scaled_not_made(monkeypatch) -> None:
    monkeypatch.setattr(decomposition, "decompose", None)
    part = ConvexPart(UNIT, "cylinder", 1)
    model = Model("a", "a", cube_mesh(), np.ones(3), parts=(part,))
    (found,) = model_parts(model, np.array([0.1, 0.2, 0.3]))
    assert (found.kind, found.axis) == ("cylinder", 1)
    np.testing.assert_allclose(np.ptp(found.vertices, axis=0), [0.1, 0.2, 0.3])


def test_flat_parts_get_a_thickness() -> None:
    sheet = dataclasses.replace(ConvexPart(UNIT), vertices=UNIT * [1, 1, 1e-6])
    assert np.ptp(scale_part(sheet, np.full(3, 0.1)).vertices, axis=0)[2] >= 3.9e-4
