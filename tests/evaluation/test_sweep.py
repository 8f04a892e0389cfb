"""The camera sweep: its views, their content, and the choice among them."""

from collections.abc import Sequence

import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.errors import InputError
from generator.evaluation.perceptual import EMBEDDED
from generator.evaluation.surfaces.sweep import (
    Station,
    SweepConfig,
    best_views,
    center_and_radius,
    station_camera,
    stations,
    sweep,
)
from generator.scene import Scene

SMALL = SweepConfig(longest=96, elevations=(90.0, 50.0, 10.0), distances=(1.0, 1.5, 2.5))


@pytest.fixture(scope="module")
def scene() -> Scene:
    red = toy_object("cube_1", (0.2, 0.1, 0.1), (-0.3, -0.1), color=(220, 30, 30))
    blue = toy_object("cube_2", (0.1, 0.2, 0.3), (0.3, 0.1), color=(30, 30, 220))
    return toy_scene((red, blue))


def test_the_default_sweep_is_the_papers() -> None:
    taken = stations()
    assert len(taken) == 160
    assert taken[0] == Station(90, 1.0)
    assert taken[-1] == Station(0, 2.5)
    assert len(set(taken)) == 160
    assert {s.elevation for s in taken} == set(range(0, 91, 10))
    assert {s.distance for s in taken} == {round(1 + k / 10, 1) for k in range(16)}


def test_cameras_stand_at_their_distance_and_elevation_and_look_at_the_middle(scene: Scene) -> None:
    center, radius = center_and_radius(scene)
    assert radius == pytest.approx(np.linalg.norm([1.2, 0.7, 1.04]) / 2, abs=1e-6)
    for station in (Station(90, 1.0), Station(40, 1.7), Station(0, 2.5)):
        camera = station_camera(scene, station, 96, 72, SMALL)
        away = camera.position - center
        assert np.linalg.norm(away) == pytest.approx(station.distance * radius)
        assert np.rad2deg(np.arcsin(away[2] / np.linalg.norm(away))) == pytest.approx(
            station.elevation, abs=0.1
        )
        assert away[1] <= 1e-9
        assert np.allclose(camera.project(center[None]), [[48, 36]])


def test_renders_have_the_pictures_proportions_and_show_less_from_afar(scene: Scene) -> None:
    shown = [picture for _, picture in sweep(scene, 0.75, SMALL)]
    assert {p.shape for p in shown} == {(96, 72, 3)}
    inked = [int((p < 250).any(2).sum()) for p in shown]
    assert inked[1] > inked[2]
    assert inked[4] > inked[5]


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(EMBEDDED))
def test_the_view_a_picture_was_taken_from_is_picked(scene: Scene, name: str) -> None:
    taken = dict(sweep(scene, 4 / 3, SMALL))
    for station in (Station(50, 1.5), Station(90, 2.5)):
        (best,) = best_views(scene, taken[station], [EMBEDDED[name]], SMALL)
        assert best.station == station
        assert best.value == pytest.approx(1, abs=1e-5)
        assert len(best.values) == 9
        assert best.facts()["elevation_deg"] == station.elevation
        assert np.array_equal(best.picture, taken[station])


class Darkness:
    """A dummy metric with a given direction."""

    def __init__(self, higher: bool) -> None:
        self.name, self.higher_is_better = "darkness", higher

    def score(self, pictures: Sequence[np.ndarray], reference: np.ndarray) -> np.ndarray:
        return np.array([255 - p.mean() for p in pictures])


def test_lower_is_better_where_the_metric_says_so(scene: Scene) -> None:
    reference = np.full((72, 96, 3), 255, np.uint8)
    most, least = (best_views(scene, reference, [Darkness(h)], SMALL)[0] for h in (True, False))
    assert most.value == most.values.max()
    assert least.value == least.values.min()
    assert least.station.distance == 2.5


@pytest.mark.parametrize(
    "wrong",
    [
        {"elevations": ()},
        {"elevations": (95.0,)},
        {"elevations": (float("nan"),)},
        {"distances": (0.0,)},
        {"longest": 4},
    ],
)
def test_sweeps_that_make_no_sense_are_refused(wrong: dict) -> None:
    with pytest.raises(InputError):
        SweepConfig(**wrong)
