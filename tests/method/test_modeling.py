"""Canonical coordinate alignment: exact quarter turns, size axes, each instance's own view."""

import dataclasses
import itertools

import numpy as np
import pytest

from generator.errors import BackendError, InputError
from generator.geometry import quaternion_matrix, ray_view
from generator.method.models import make_models, measured_size, size_axes_turn
from generator.scene import ConvexPart, Instance, Mesh, Model, Reference, SizePrior, View
from generator.scene.quarter_turns import apply_quarter_turns, quarter_turn, turn

AXES = "xyz"
CORNERS = np.array(list(itertools.product((-0.5, 0.5), repeat=3)))
VIEW = View(0.1, 0.9, 0.6)


def test_the_orientation_a_modeler_saw_goes_along_with_the_turns():
    """The world positions of the model's corners are the same before and after."""
    seen = quaternion_matrix(np.array([0.8, 0.1, -0.5, 0.3]))
    model = dataclasses.replace(wedge(), orientation=seen)
    for steps in ([("x", 90)], [("z", 90), ("y", 180)], [("y", -90), ("x", 90), ("z", 90)]):
        made = turn(model, steps)
        assert made.orientation is not None
        before = (model.mesh.vertices * model.size) @ seen.T
        after = (made.mesh.vertices * made.size) @ made.orientation.T
        np.testing.assert_allclose(after, before, atol=1e-7)
    assert turn(wedge(), [("x", 90)]).orientation is None


def wedge() -> Model:
    """Return an asymmetric model, 0.3 x 0.2 x 0.1 m, with a lying cylinder part."""
    vertices = np.array(
        [[-0.5, -0.5, -0.5], [0.5, -0.5, -0.5], [-0.5, 0.5, -0.3], [-0.1, -0.2, 0.5]]
    )
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    mesh = Mesh(vertices, faces, np.zeros((4, 2)), np.zeros((2, 2, 3)))
    parts = (ConvexPart(CORNERS * [1.0, 0.4, 0.4], "cylinder", 0), ConvexPart(vertices))
    return Model("wedge", "wedge", mesh, np.array([0.3, 0.2, 0.1]), parts=parts)


class Recorder:
    """A modeler that records its requests, and a reasoner with a fixed answer."""

    def __init__(self, steps: tuple[tuple[str, int], ...] = ()) -> None:
        self.steps = steps
        self.views: list[View] = []
        self.reviewed: list[Mesh] = []

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        self.views.append(view)
        return wedge()

    def review_orientation(self, mesh, instance, size):
        self.reviewed.append(mesh)
        return self.steps


def instance(name: str, box: tuple[int, int, int, int]) -> Instance:
    mask = np.zeros((60, 80), bool)
    mask[box[1] : box[3], box[0] : box[2]] = True
    crop = np.zeros((8, 8, 4))
    return Instance(name, "thing", np.array(box), mask, crop, np.array(box))


@pytest.mark.parametrize("axis", AXES)
def test_four_quarter_turns_are_none(axis):
    np.testing.assert_array_equal(quarter_turn([(axis, 90)] * 4), np.eye(3))
    np.testing.assert_array_equal(quarter_turn([(axis, 270)]), quarter_turn([(axis, -90)]))


def test_turns_follow_the_right_hand():
    np.testing.assert_array_equal(quarter_turn([("z", 90)]) @ [1, 0, 0], [0, 1, 0])
    np.testing.assert_array_equal(quarter_turn([("x", 90)]) @ [0, 1, 0], [0, 0, 1])
    np.testing.assert_array_equal(quarter_turn([("y", 90)]) @ [0, 0, 1], [1, 0, 0])


def test_turns_form_the_group_of_the_cube():
    steps = [((a, d),) for a in AXES for d in (90, 180, 270)]
    reached = {quarter_turn(s).tobytes() for s in [(), *steps]}
    for _ in range(3):
        turns = [np.frombuffer(m, dtype=int).reshape(3, 3) for m in reached]
        reached |= {(quarter_turn(s) @ m).tobytes() for m in turns for s in steps}
    assert len(reached) == 24
    for m in reached:
        turn = np.frombuffer(m, dtype=int).reshape(3, 3)
        np.testing.assert_array_equal(turn @ turn.T, np.eye(3))
        assert round(np.linalg.det(turn)) == 1


def test_turning_twice_is_turning_by_the_product():
    model = wedge()
    first, second = [("x", 90), ("z", 180)], [("y", -90)]
    mesh, parts = apply_quarter_turns(*apply_quarter_turns(model.mesh, model.parts, first), second)
    whole, pieces = apply_quarter_turns(model.mesh, model.parts, [*first, *second])
    np.testing.assert_array_equal(mesh.vertices, whole.vertices)
    for a, b in zip(parts, pieces, strict=True):
        np.testing.assert_array_equal(a.vertices, b.vertices)
        assert (a.kind, a.axis) == (b.kind, b.axis)


def test_sizes_and_cylinder_axes_go_along():
    model = turn(wedge(), [("x", 90), ("z", 90)])
    np.testing.assert_allclose(model.size, [0.1, 0.3, 0.2])
    assert model.parts[0].axis == 1
    low, high = model.parts[0].bounds
    assert np.argmax(high - low) == 1


def test_a_turn_keeps_the_mesh_outside_out():
    model = turn(wedge(), [("y", 90)])

    def volume(mesh: Mesh) -> float:
        a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
        return float((np.cross(a, b) * c).sum() / 6)

    assert volume(model.mesh) == pytest.approx(volume(wedge().mesh))


@pytest.mark.parametrize("step", [("w", 90), ("x", 45)])
def test_odd_steps_are_refused(step):
    with pytest.raises(InputError, match="multiple of 90"):
        quarter_turn([step])


def test_length_and_width_follow_the_prior():
    long, wide, square = np.array([3.0, 1, 1]), np.array([1.0, 3, 1]), np.array([1.0, 1.05, 1])
    assert size_axes_turn(long, wide) == (("z", 90),)
    assert size_axes_turn(long, long) == ()
    assert size_axes_turn(long, square) == ()


def test_each_instance_is_seen_along_its_own_ray_and_aligned():
    reference = Reference(np.zeros((60, 80, 3)))
    things = (instance("a_1", (2, 4, 12, 20)), instance("b_1", (60, 30, 76, 50)))
    sizes = {t.name: SizePrior(t.name, np.array([0.1, 0.3, 0.2])) for t in things}
    backend = Recorder((("x", 90),))
    models = make_models(reference, things, sizes, VIEW, backend, backend)
    for mesh in backend.reviewed:  # in metres, where the canonical mesh fills a cube
        np.testing.assert_allclose(mesh.extent, wedge().size, rtol=1e-6)
    assert len(backend.reviewed) == len(things)
    assert list(models) == ["a_1", "b_1"]
    for thing, seen in zip(things, backend.views, strict=True):
        middle = (thing.box[:2] + thing.box[2:]) / 2
        assert seen == ray_view(VIEW, middle, 80, 60)
    # Upright (x turn), then the longer side to y as the prior says.
    np.testing.assert_allclose(models["a_1"].size, [0.1, 0.3, 0.2])
    assert (models["a_1"].name, models["a_1"].label) == ("a_1", "thing")


def test_a_missing_size_is_named():
    thing = instance("a_1", (2, 4, 12, 20))
    backend = Recorder()
    with pytest.raises(BackendError, match="a_1"):
        make_models(Reference(np.zeros((60, 80, 3))), (thing,), {}, VIEW, backend, backend)


@pytest.mark.parametrize(
    ("have", "measured", "want"),
    [
        ((0.3, 0.1, 0.2), (0.2, 0.08, 0.1), (0.2, 0.08, 0.1)),
        ((0.1, 0.3, 0.2), (0.2, 0.08, 0.1), (0.08, 0.2, 0.1)),  # the longer side is the length
        ((0.3, 0.1, 0.2), (0.3, 0.1, 0.01), (0.3, 0.1, 0.2 / 1.8)),  # by far implausible
    ],
)
def test_measured_sizes_are_kept_unless_implausible(have, measured, want):
    made = dataclasses.replace(wedge(), size=np.array(have))
    np.testing.assert_allclose(measured_size(made, np.array(measured)), want)


def test_a_handle_may_point_away():
    """A mug with a square measurement hides its handle; it is not squeezed."""
    made = dataclasses.replace(wedge(), size=np.array([0.12, 0.08, 0.1]), category="mug")
    found = measured_size(made, np.array([0.09, 0.09, 0.11]))
    np.testing.assert_allclose(found, [0.135, 0.09, 0.11])
