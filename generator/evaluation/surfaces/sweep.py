"""The camera sweep (supplement, Sec. 8.1): 160 views of a scene, each compared with a picture.

For other methods' scenes the picture's camera is unknown. Every scene is therefore rendered from
the front, at elevations from straight above down to table height and at distances from near to far.
Each metric uses its best view.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from jaxtyping import Float, UInt8

from ...errors import InputError
from ...geometry import Camera
from ...render.raster import render
from ...render.sheet import scene_items
from ...scene import Scene, View

ELEVATIONS = tuple(float(e) for e in range(90, -1, -10))
"""Elevations in degrees above the horizon, in the order of the paper."""

DISTANCES = tuple(round(1.0 + 0.1 * k, 1) for k in range(16))
"""Distances as multiples of the scene's radius."""

_LEVEL = 1e-3  # radians; the elevation of a view must be above 0


@dataclass(frozen=True)
class SweepConfig:
    """Settings of the camera sweep.

    ``fov`` is the vertical field of view, and ``azimuth`` is as in ``View`` (0 is the view from the
    front), both in radians. ``longest`` is the longer side of the renders in pixels; their aspect
    ratio is that of the picture.
    """

    fov: float = float(np.deg2rad(60.0))
    azimuth: float = 0.0
    longest: int = 256
    elevations: tuple[float, ...] = ELEVATIONS
    distances: tuple[float, ...] = DISTANCES
    shadows: bool = False

    def __post_init__(self) -> None:
        if not (self.elevations and self.distances):
            raise InputError("A sweep needs at least one elevation and one distance.")
        angles = np.array(self.elevations)
        if not ((angles >= 0) & (angles <= 90)).all() or min(self.distances) <= 0:
            raise InputError(
                "The elevations of a sweep must be between 0 and 90 degrees, and its distances "
                "must be positive."
            )
        if not 16 <= self.longest <= 2048:
            raise InputError(
                "The longer side of a sweep's renders must be 16 to 2048 pixels, got "
                f"{self.longest}."
            )


@dataclass(frozen=True)
class Station:
    """The camera position of one view: its elevation in degrees and its distance in scene radii."""

    elevation: float
    distance: float


class Metric(Protocol):
    """A measure of image similarity; ``name`` identifies the measure and the model that it uses."""

    @property
    def name(self) -> str:
        """The key under which the value is reported."""
        ...

    @property
    def higher_is_better(self) -> bool:
        """Whether larger values mean greater similarity."""
        ...

    def score(
        self,
        pictures: Sequence[UInt8[np.ndarray, "_h _w 3"]],
        reference: UInt8[np.ndarray, "a b 3"],
    ) -> Float[np.ndarray, "n"]:
        """Return the similarity of each picture to the reference."""
        ...


@dataclass(frozen=True, eq=False)
class Best:
    """The best view for one metric, and the metric's values for all views, in order."""

    metric: str
    higher_is_better: bool
    value: float
    station: Station
    picture: UInt8[np.ndarray, "h w 3"]
    values: Float[np.ndarray, "n"]

    def facts(self) -> dict[str, Any]:
        """Return the best value and the view that has it, as JSON values."""
        return {
            "value": round(self.value, 5),
            "higher_is_better": self.higher_is_better,
            "elevation_deg": self.station.elevation,
            "distance_radii": self.station.distance,
        }


def stations(config: SweepConfig | None = None) -> tuple[Station, ...]:
    """Return the views of a sweep: all distances at each elevation, 160 views by default."""
    config = config or SweepConfig()
    return tuple(Station(e, d) for e in config.elevations for d in config.distances)


def center_and_radius(scene: Scene) -> tuple[Float[np.ndarray, "3"], float]:
    """Return the centre of the scene's bounding box and half the box's diagonal, in metres."""
    points = np.concatenate([item.vertices for item in scene_items(scene)])
    low, high = points.min(0), points.max(0)
    return (low + high) / 2, float(np.linalg.norm(high - low)) / 2


def station_camera(
    scene: Scene, station: Station, width: int, height: int, config: SweepConfig
) -> Camera:
    """Return the camera of one view of the sweep."""
    center, radius = center_and_radius(scene)
    elevation = float(np.clip(np.deg2rad(station.elevation), _LEVEL, np.pi / 2))
    view = View(config.azimuth, elevation, config.fov)
    return Camera.looking_at(center, view, station.distance * radius, width, height)


def sweep(
    scene: Scene, aspect: float = 4 / 3, config: SweepConfig | None = None
) -> Iterator[tuple[Station, UInt8[np.ndarray, "h w 3"]]]:
    """Render the scene on white from each view in turn; ``aspect`` is width over height."""
    config = config or SweepConfig()
    wide = aspect >= 1
    width = config.longest if wide else max(1, round(config.longest * aspect))
    height = max(1, round(config.longest / aspect)) if wide else config.longest
    items = scene_items(scene)
    for station in stations(config):
        camera = station_camera(scene, station, width, height, config)
        yield station, render(items, camera, supersample=1, shadows=config.shadows).image


def best_views(
    scene: Scene,
    reference: UInt8[np.ndarray, "h w 3"],
    metrics: Sequence[Metric],
    config: SweepConfig | None = None,
) -> tuple[Best, ...]:
    """Return, for each metric, the view in the sweep that is most similar to ``reference``."""
    taken = list(sweep(scene, reference.shape[1] / reference.shape[0], config))
    pictures = [picture for _, picture in taken]
    found = []
    for metric in metrics:
        values = np.asarray(metric.score(pictures, reference), float)
        k = int(np.argmax(values) if metric.higher_is_better else np.argmin(values))
        best = float(values[k]), taken[k][0], pictures[k]
        found.append(Best(metric.name, metric.higher_is_better, *best, values))
    return tuple(found)
