import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.errors import InputError, TabletopError, choices
from generator.scene import (
    ConvexPart,
    Failure,
    Mesh,
    Model,
    Physics,
    Placement,
    Pose,
    Report,
    Rotation,
    SizePrior,
    View,
)

CUBE = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])


def mesh(vertices: np.ndarray = CUBE) -> Mesh:
    return Mesh(vertices, [[0, 1, 2], [5, 6, 7]], np.zeros((8, 2)), np.zeros((1, 1, 3)))


def test_values_do_not_change() -> None:
    value = mesh()
    with pytest.raises(AttributeError):
        value.opacity = 0.5  # type: ignore[misc]
    with pytest.raises(ValueError, match="read-only"):
        value.vertices[0] = 1


def test_values_do_not_share_the_callers_array() -> None:
    extent = np.ones(3)
    prior = SizePrior("mug", extent)
    extent[0] = 9
    assert prior.extent[0] == 1


@pytest.mark.parametrize(
    "make",
    [
        lambda: mesh(CUBE * np.nan),
        lambda: Mesh(CUBE, [[0, 1, 8]], np.zeros((8, 2)), np.zeros((1, 1, 3))),
        lambda: Mesh(CUBE, [[0, 1]], np.zeros((8, 2)), np.zeros((1, 1, 3))),
        lambda: Mesh(CUBE, [[0, 1, 2]], np.zeros((7, 2)), np.zeros((1, 1, 3))),
        lambda: Model("a", "a", mesh(CUBE * 2), np.ones(3)),
        lambda: Model("a", "a", mesh(), np.array([1, 0, 1])),
        lambda: Physics(density=-1),
        lambda: Physics(shell=2.0),
        lambda: Rotation("a", np.nan, 0.1),
        lambda: Rotation("a", 0.0, 0.1, margin=-0.1),
        lambda: Rotation("a", 0.0, 0.1, margin=np.nan),
        lambda: Rotation("a", 0.0, 0.1, width=0.0),
        lambda: Placement("a", np.nan, np.zeros(3), np.ones(3)),
        lambda: Placement("a", 0.0, np.zeros(3), -np.ones(3)),
        lambda: Placement("a", 0.0, np.zeros(2), np.ones(3)),
        lambda: Pose(np.zeros(3), np.array([1, 1, 0, 0])),
        lambda: View(0.0, 0.0, 0.5),
        lambda: View(np.nan, 1.0, 0.5),
        lambda: ConvexPart(np.zeros((3, 3))),
        lambda: SizePrior("a", np.array([1, 1, np.inf])),
    ],
)
def test_bad_values_are_refused(make) -> None:
    with pytest.raises(InputError):
        make()


def test_every_error_is_one_of_ours_and_a_builtin() -> None:
    assert issubclass(InputError, TabletopError)
    assert issubclass(InputError, ValueError)


def test_choices_names_the_near_match() -> None:
    assert choices("mgu", ["mug", "plate"]) == " Did you mean 'mug'? Available: mug, plate."
    assert choices("x", []) == " Available: nothing."


def test_a_report_passes_only_without_failures() -> None:
    assert Report(0.0, 0.0, 0.0).passed
    assert not Report(0.0, 0.0, 0.0, failures=(Failure("floats", ("mug",)),)).passed


@pytest.mark.parametrize("name", ["", "table", "world", "a/b", "a\nb"])
def test_object_names_that_mujoco_cannot_have_are_refused(name: str) -> None:
    with pytest.raises(InputError, match=r"object name|unique"):
        toy_scene((toy_object(name, (0.05,) * 3, (0.0, 0.0)),))
