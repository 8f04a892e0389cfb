"""Repair of defective foreign meshes, or rejection if it would change too much."""

import numpy as np
import pytest
import trimesh
from backends.modelers.foreign import glb

from generator.errors import BackendError
from generator.meshes.canonical import Normal, normal_mesh
from generator.meshes.repair import fill_holes, flaws, tidy, welded_shape
from generator.physics.inertia import is_watertight
from generator.scene import Mesh

CARD = np.array([[-0.5, 0, 0], [0.5, 0, 0], [0.5, 0, 1], [-0.5, 0, 1]])
TURNED = CARD[:, [1, 0, 2]]
HALVES = np.array([[0, 1, 2], [0, 2, 3]])


def read(mesh: trimesh.Trimesh, faces: int = 6000) -> Mesh:
    return normal_mesh(glb(mesh), "the file", to=Normal(faces=faces, texture=64))


def mesh_of(vertices: object, faces: object) -> trimesh.Trimesh:
    return trimesh.Trimesh(np.array(vertices, float), np.array(faces), process=False)


def torn(share: float) -> trimesh.Trimesh:
    """Return a ball of 1280 faces without some random ones."""
    ball = trimesh.creation.icosphere(3)
    kept = np.random.default_rng(0).random(len(ball.faces)) > share
    return mesh_of(ball.vertices, ball.faces[kept])


def grown(mesh: trimesh.Trimesh, tip: list[float]) -> trimesh.Trimesh:
    """Return a mesh with one more face, on its first edge."""
    corners = [*mesh.faces[0, :2], len(mesh.vertices)]
    return mesh_of([*mesh.vertices, tip], [*mesh.faces, corners])


def tube(closed_below: bool) -> trimesh.Trimesh:
    """Return a mug without a handle as a single sheet: open above, and optionally below."""
    made = trimesh.creation.cylinder(1.0, 2.0, sections=24)
    up = made.face_normals[:, 2]
    return mesh_of(made.vertices, made.faces[up < 0.5 if closed_below else np.abs(up) < 0.5])


@pytest.mark.parametrize(("share", "two"), [(0.02, 1.0), (0.05, 0.995), (0.1, 0.98)])
def test_lost_faces_are_closed_but_for_holes_of_size(share, two):
    """The given number of edges have two faces; the others surround openings."""
    assert _paired(torn(share).faces) < 0.98
    mesh = read(torn(share))
    faces = welded_shape(mesh.vertices, mesh.faces)[1]
    assert _paired(faces) >= two
    assert is_watertight(mesh) == (two == 1)
    assert sum(flaws(faces)) <= 0.01


def _paired(faces: np.ndarray) -> float:
    sides = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    return float((np.unique(sides, axis=0, return_counts=True)[1] == 2).mean())


@pytest.mark.parametrize("share", [0.3, 0.4])
def test_a_mesh_in_tatters_is_refused_with_the_figure(share):
    said = (
        r"^the file is not a surface: after repair, \d+\.\d% of its .* 0\.0% have three .* is 1% in"
    )
    with pytest.raises(BackendError, match=said):
        read(torn(share))


@pytest.mark.parametrize("size", [0.02, 1.0])
def test_loose_triangles_are_refused(size):
    """Small ones must not be treated as holes."""
    rng = np.random.default_rng(3)
    corners = rng.random((100, 1, 3)) + size * rng.random((100, 3, 3))
    with pytest.raises(BackendError, match=r"100\.0% of its edges have one face"):
        read(mesh_of(corners.reshape(-1, 3), np.arange(300).reshape(-1, 3)))


def test_a_small_fin_goes():
    box = trimesh.creation.box()
    edge = box.vertices[box.faces[0, :2]].mean(0)
    mesh = read(grown(box, list(1.4 * edge)))
    assert len(mesh.faces) == 12
    assert is_watertight(mesh)


def test_fins_that_are_much_together_are_refused():
    """Each fin is small, but together they would be a tenth of the whole."""
    ball = trimesh.creation.icosphere(2)
    corners = ball.faces[::8, :2]
    tips = 1.2 * ball.vertices[corners].mean(1)
    fins = np.column_stack([corners, len(ball.vertices) + np.arange(len(tips))])
    few = mesh_of(np.vstack([ball.vertices, tips]), np.vstack([ball.faces, fins[:12]]))
    assert is_watertight(read(few))
    many = mesh_of(np.vstack([ball.vertices, tips]), np.vstack([ball.faces, fins]))
    with pytest.raises(BackendError, match="is not a surface"):
        read(many)


def test_a_large_fin_is_refused_with_the_figure():
    with pytest.raises(BackendError, match=r"5\.0% have three or more, .* manifold"):
        read(grown(trimesh.creation.box(), [2, 2, 2]))


def test_a_small_wall_inside_goes():
    """A bar with an inner wall joined to its sides: no edge of the wall has two faces."""
    bar = np.array([[x, y, z] for x in (0, 5, 10) for y in (0, 1) for z in (0, 1)], float)
    quads = [(0, 4, 5, 1), (4, 8, 9, 5), (2, 3, 7, 6), (6, 7, 11, 10), (0, 2, 6, 4), (4, 6, 10, 8),
             (1, 5, 7, 3), (5, 9, 11, 7), (0, 1, 3, 2), (8, 10, 11, 9), (4, 5, 7, 6)]  # fmt: skip
    walled = mesh_of(bar, [f for a, b, c, d in quads for f in ((a, b, c), (a, c, d))])
    assert flaws(walled.faces)[1] > 0.1
    mesh = read(walled)
    assert len(mesh.faces) == 20
    assert is_watertight(mesh)


def test_crumbs_and_what_reduction_leaves_go_from_shapes_too():
    ball = trimesh.creation.icosphere(3)
    crumb = trimesh.creation.icosphere(0, 1e-3).apply_translation([2, 0, 0])
    made = trimesh.util.concatenate([ball, crumb])
    fin = grown(made, list(1.01 * made.vertices[made.faces[0, 0]]))
    vertices, faces = welded_shape(fin.vertices, fin.faces)
    faces = np.vstack([faces, faces[:1, [0, 0, 1]], faces[5:6], faces[5:6]])
    assert len(tidy(vertices, faces)) == len(ball.faces)


@pytest.mark.parametrize(
    "open_one",
    [
        tube(closed_below=True),
        tube(closed_below=False),
        mesh_of(np.vstack([CARD, TURNED]), np.vstack([HALVES, HALVES + 4])),
    ],
    ids=["cup", "mug with an open bottom", "pair of leaf cards"],
)
def test_what_is_open_stays_open_and_as_it_is(open_one):
    mesh = read(open_one)
    assert len(mesh.faces) == len(open_one.faces)
    assert not is_watertight(mesh)


def test_leaf_cards_that_share_their_middle_are_refused():
    half = [[0, 0, 0], [0, 0, 1]]
    for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1)):
        half += [[x, y, 0], [x, y, 1]]
    faces = [f for a in (2, 4, 6, 8) for f in ([0, a, a + 1], [0, a + 1, 1])]
    with pytest.raises(BackendError, match=r"47\.1% of its edges have one face"):
        read(mesh_of(half, faces))


def test_things_that_touch_along_an_edge_are_sound():
    two = [trimesh.creation.box(), trimesh.creation.box().apply_translation([1, 1, 0])]
    mesh = read(trimesh.util.concatenate(two))
    assert len(mesh.faces) == 24
    assert is_watertight(mesh)


def test_holes_that_meet_in_a_corner_are_closed_each():
    ball = trimesh.creation.icosphere(3)
    around = np.flatnonzero((ball.faces == 100).any(1))
    first = around[0]
    apart = [f for f in around if len({*ball.faces[f]} & {*ball.faces[first]}) == 1]
    kept = np.ones(len(ball.faces), bool)
    kept[[first, apart[0]]] = False
    faces = np.asarray(ball.faces[kept])
    assert flaws(faces)[0] > 0
    vertices, closed = fill_holes(np.asarray(ball.vertices), faces)
    assert len(vertices) == len(ball.vertices) + 2
    assert mesh_of(vertices, closed).is_watertight
    assert flaws(closed) == (0, 0)


def test_flaws_are_shares_of_all_edges():
    box = trimesh.creation.box()
    assert flaws(box.faces) == (0, 0)
    over = box.faces.copy()
    over[0] = over[0, ::-1]
    assert flaws(over) == (0, 3 / 18)
    assert flaws(np.array([[0, 1, 2]])) == (1, 0)
    assert flaws(HALVES) == (0, 0)


def test_a_long_rim_and_a_way_that_ends_are_followed():
    """Rims of ten thousand sides take linear time, and slits get no fan."""
    count = 10_000
    turn = 2 * np.pi * np.arange(count) / count
    rim = np.column_stack([np.cos(turn), np.sin(turn), np.zeros(count)])
    around = np.arange(count)
    fan = np.column_stack([around, np.roll(around, -1), np.full(count, count)])
    vertices = np.vstack([rim, [[0, 0, 1]]])
    assert len(fill_holes(vertices, fan)[1]) == count
    same_way = np.array([[0, 1, 2], [0, 1, 3]])  # two sides 0-1: what is left is no loop
    assert len(fill_holes(np.eye(4, 3), same_way)[1]) == 2
