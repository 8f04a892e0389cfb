"""Fit of a table to its silhouette: first the known top, then the legs and other parts."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product

import numpy as np
from jaxtyping import Float

from ...geometry import mask_box
from ...meshes.pixels import Mask, dilate, mask_iou
from ...meshes.projection import Projection, fill_hull
from .shapes.frames import descend
from .table_form import LegStyle, TableForm, at_height, corners_of

_TALL = (0.2, 1.4)  # minimum and maximum height of a table in metres
_SLABS = (0.012, 0.02, 0.03, 0.045, 0.06, 0.08)  # candidate thicknesses in metres
_APRONS = (0.06, 0.1)
_GAIN = 0.01  # minimum gain of overlap from another thickness or from boards
_SHOWN = 0.1  # overlap of the legs below which they count as not visible
_CLEAR = 0.002  # minimum gain of overlap, for the whole table, from another kind of legs
_EVEN = 0.03  # overlap that a difference of one width between the insets of the legs is worth
_REACHING = 0.2  # overlap that feet one silhouette height too high or too low are worth
_DEPTHS = (0.03, 0.06, 0.1, 0.15, 0.2)  # depths of the legs behind the rim, in widths of the top
_STARTS, _TRIES = 3, 400  # number of searches for the table's dimensions, and steps of each


@dataclass(frozen=True, eq=False)
class Silhouette:
    """A table's outline in a picture. ``shown`` are the pixels inside the picture's frame."""

    mask: Mask
    shown: Mask
    projection: Projection

    @cached_property
    def bottom(self) -> int:
        """The lowest row of the table."""
        return int(np.flatnonzero((self.mask & self.shown).sum(1) > 1)[-1])

    @cached_property
    def cut_below(self) -> bool:
        """Whether the frame cuts off the lower end of the table."""
        return not self.shown[min(self.bottom + 2, len(self.shown) - 1)].any()

    def overlap(self, drawn: Mask) -> float:
        """Return the intersection over union with a drawn mask, within the frame."""
        return mask_iou(self.mask & self.shown, drawn & self.shown)


@dataclass(frozen=True, eq=False)
class Fitted:
    """A table form, its ``scale`` and ``shift`` in the object frame, and the mask overlap."""

    form: TableForm
    scale: float
    shift: Float[np.ndarray, "3"]
    overlap: float

    def world(self, canonical: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 3"]:
        """Transform vertices of the form's canonical mesh to the object frame."""
        return ((canonical - [0, 0, 0.5]) * self.form.size) * self.scale + self.shift


def fit_table(
    outline: Float[np.ndarray, "k 2"],
    height: float,
    seen: Silhouette,
    fine: Silhouette,
    quick: bool = False,
) -> Fitted:
    """Return the table whose top has the given ``outline`` (metres) and whose silhouette fits best.

    ``height`` is the default height, which is used if the picture does not show the height.
    ``fine`` is the same silhouette at a higher resolution, used to refine the result. A ``quick``
    fit refines only the better kind of legs, from one start.
    """
    scale, shift = place_top(outline, seen)
    usual = TableForm(outline, corners_of(outline), height)
    best, rival = _Legs(usual, scale, shift, seen).fit(height)
    if max(best[1], rival[1]) < _SHOWN:
        overlap = fine.overlap(_Legs(usual, scale, shift, fine).silhouette(usual))
        return Fitted(usual, scale, shift, overlap)
    if quick:
        better = max(best, rival, key=lambda f: f[1])[0]
        return _settle(better, scale, shift, seen, height, 1)
    first, other = (_settle(form, scale, shift, fine, height) for form, _ in (best, rival))
    return other if other.overlap > first.overlap + _CLEAR else first


def _settle(
    form: TableForm,
    scale: float,
    shift: Float[np.ndarray, "3"],
    seen: Silhouette,
    usual: float,
    searches: int = _STARTS,
) -> Fitted:
    """Optimise a table form's legs and its placement jointly, and return both.

    Low legs near the rim look the same as high legs further in. Among equally good fits, the legs
    have the same inset from the front as from the side.
    """
    width = float(min(form.size[:2]))
    steps = np.array([0.01, 1.0, 1.0, 0.02, 0.02, 0.02, 0.01, -0.01, 0.05])
    if seen.cut_below:
        steps[-1] = 1e-6  # the height is not visible
    moved = _pixel_moves(seen.projection)
    tall_rows = float(np.ptp(np.flatnonzero(seen.mask.any(1))) + 1)

    def start(inset: tuple[float, float]) -> np.ndarray:
        raw = replace(form, inset=inset)
        tried = _Legs(raw, scale, shift, seen).ground(raw, usual)
        return np.array([0.0, 0.0, 0.0, *_leg_measures(tried), tried.height])

    def make(p: np.ndarray) -> tuple[TableForm, float, Float[np.ndarray, "3"]]:
        tried = replace(_with_legs(form, p[3:8]), height=float(np.clip(p[8], *_TALL)))
        return tried, float(scale * np.exp(p[0])), shift + moved(p[1:3])

    def goodness(p: np.ndarray) -> float:
        tried, size, place = make(p)
        drawn = _Legs(tried, size, place, seen).silhouette(tried)
        rows = np.flatnonzero(drawn.any(1))
        low = abs(float(rows[-1]) - seen.bottom) if len(rows) and not seen.cut_below else 0.0
        return seen.overlap(drawn) - _EVEN * abs(p[3] - p[4]) - _REACHING * low / tall_rows

    deep = [d * width for d in _DEPTHS]
    places = [form.inset, *((form.inset[0], d) for d in deep), *((d, d) for d in deep)]
    starts = sorted((start(place) for place in places), key=goodness)[-searches:]
    searched = (descend(lambda p: -goodness(p), begin, steps, _TRIES) for begin in starts)
    found = max(searched, key=goodness)
    tried, size, place = make(found)
    overlap = seen.overlap(_Legs(tried, size, place, seen).silhouette(tried))
    return Fitted(tried, size, place, overlap)


def _leg_measures(form: TableForm) -> np.ndarray:
    """Return leg insets (x, y), lean, and upper and lower width, relative to the top's width."""
    width = float(min(form.size[:2]))
    return np.array([*form.inset, form.lean, form.high, form.low]) / width


def _with_legs(form: TableForm, measures: np.ndarray) -> TableForm:
    """Return a form with the given ``_leg_measures``, clipped to valid values."""
    width = float(min(form.size[:2]))
    least = 0.012 / width
    most, slimmest = (0.9, 0.1) if form.legs == "pedestal" else (0.16, 0.3)
    x, y = (float(v) * width for v in np.clip(measures[:2], 0, 0.6))
    lean = float(np.clip(measures[2], -0.1, 0.3)) * width
    high = float(np.clip(measures[3], least, most))
    low = float(np.clip(measures[4], max(least, slimmest * high), most)) * width
    return replace(form, inset=(x, y), lean=lean, high=high * width, low=low)


def _pixel_moves(view: Projection) -> Callable[[np.ndarray], Float[np.ndarray, "3"]]:
    """Return a function that converts pixel shifts (right, down) at the origin to 3D shifts."""
    return lambda step: view.pixel * (step[0] * view.rotation[0] + step[1] * view.rotation[1])


def place_top(
    outline: Float[np.ndarray, "k 2"], seen: Silhouette
) -> tuple[float, Float[np.ndarray, "3"]]:
    """Return the scale and shift that align a top with the upper part of a silhouette.

    The part of the silhouette directly below the top may be legs and is ignored.
    """
    view, mask = seen.projection, seen.mask & seen.shown
    flat = np.column_stack([outline, np.zeros(len(outline))])
    x0, y0, x1, _ = mask_box(mask)
    wanted = np.array([(x0 + x1) / 2, y0])
    scale, shift = (x1 - 1 - x0) * view.pixel / float(np.ptp(flat[:, 0])), np.zeros(3)
    moved = _pixel_moves(view)

    for _ in range(5):
        at = view.project(flat * scale + shift)
        scale *= (x1 - x0) / float(np.ptp(at[:, 0]))
        at = view.project(flat * scale + shift)
        shift = shift + moved(wanted - [(at[:, 0].min() + at[:, 0].max()) / 2, at[:, 1].min()])

    def cost(p: np.ndarray) -> float:
        top = _draw([flat * scale * np.exp(p[0]) + shift + moved(p[1:])], view)
        below = np.maximum.accumulate(top, axis=0)
        wrong = (top & ~mask) | (mask & ~below)
        return float((wrong & seen.shown).sum() / mask.sum())

    found = descend(cost, np.zeros(3), (0.04, 3.0, 3.0), 120)
    return float(scale * np.exp(found[0])), shift + moved(found[1:])


def _draw(pieces: Iterable[Float[np.ndarray, "_n 3"]], view: Projection) -> Mask:
    canvas = np.zeros((view.height, view.width), np.uint8)
    solids = list(pieces)
    ends = np.cumsum([len(piece) for piece in solids])[:-1]
    for flat in np.split(view.project(np.concatenate(solids)), ends):
        fill_hull(canvas, flat)
    return canvas > 0


class _Legs:
    """A comparison of forms' legs and slabs with the silhouette below a placed tabletop."""

    def __init__(
        self, form: TableForm, scale: float, shift: Float[np.ndarray, "3"], seen: Silhouette
    ) -> None:
        self.form, self.scale, self.shift, self.seen = form, scale, shift, seen
        self.top = _draw([self._place(at_height(form.outline, 0.0))], seen.projection)

    @cached_property
    def _counted(self) -> Mask:
        """The pixels inside the picture and outside the tabletop, which count for the overlap."""
        return self.seen.shown & ~dilate(self.top, 3)

    @cached_property
    def _wanted(self) -> Mask:
        return self.seen.mask & self._counted

    def _place(self, points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 3"]:
        return points * self.scale + self.shift

    def draw(self, form: TableForm) -> Mask:
        """Return the silhouette of a form's slab and legs."""
        slab = np.concatenate([at_height(form.outline, z) for z in (-form.thickness, 0.0)])
        down = np.array([0.0, 0.0, form.height])
        pieces = [piece.reshape(-1, 3) - down for piece in form.pieces()]
        return _draw([self._place(p) for p in [slab, *pieces]], self.seen.projection)

    def silhouette(self, form: TableForm) -> Mask:
        """Return the silhouette of a table of the given form, including the fitted top."""
        return self.draw(form) | self.top

    def overlap(self, form: TableForm) -> float:
        """Return the IoU of a form and the silhouette, excluding the tabletop."""
        return mask_iou(self.draw(form) & self._counted, self._wanted)

    def ground(self, form: TableForm, usual: float) -> TableForm:
        """Return a form whose height brings its feet down to the silhouette's lowest row.

        If the frame cuts the legs, the form has at least the default height.
        """
        low, high = _TALL
        feet = form.feet()
        for _ in range(12):
            middle = (low + high) / 2
            rows = self.seen.projection.project(self._place(at_height(feet, -middle)))[:, 1]
            low, high = (middle, high) if rows.max() < self.seen.bottom + 1 else (low, middle)
        found = max(low, usual) if self.seen.cut_below else low
        return replace(form, height=found)

    def fit(self, usual: float) -> tuple[tuple[TableForm, float], tuple[TableForm, float]]:
        """Return the best form with posts as legs, the best other form, and both overlaps."""
        kinds = ("posts", "sled", "trestle", "pedestal")
        firsts = [self._best(self._coarse(kind, usual)) for kind in kinds]
        rival = max(firsts[1:], key=lambda f: f[1])
        best, rival = (self._refine(self._add_boards(*f)[0], usual) for f in (firsts[0], rival))
        return self._refine(self._add_boards(*best)[0], usual), rival

    def _add_boards(self, form: TableForm, overlap: float) -> tuple[TableForm, float]:
        """Return the form, with another slab thickness or an apron if that fits clearly better."""
        aprons = (0.0, *_APRONS) if form.legs == "posts" else (0.0,)
        finer = self._best(replace(form, thickness=t, apron=a) for t, a in product(_SLABS, aprons))
        return finer if finer[1] > overlap + _GAIN else (form, overlap)

    def _best(self, forms: Iterable[TableForm]) -> tuple[TableForm, float]:
        return max(((form, self.overlap(form)) for form in forms), key=lambda f: f[1])

    def _coarse(self, kind: LegStyle, usual: float) -> Iterable[TableForm]:
        width = float(min(self.form.size[:2]))
        insets, leans, sides, tapers = (0.03, 0.1, 0.2, 0.32), (0.0, 0.08), (0.05, 0.1), (1.0, 0.5)
        if kind == "pedestal":
            insets, leans, sides, tapers = (0.1,), (0.0,), (0.06, 0.12, 0.25), (7.0, 4.0, 2.5)
        elif kind in ("sled", "trestle"):
            leans, tapers = (0.0,), (1.0,)
        for x, y, lean, side, taper in product(insets, insets, leans, sides, tapers):
            high, low = side * width, side * min(taper, 0.8 / side) * width
            inset = (x * width, y * width)
            yield self.ground(
                replace(self.form, legs=kind, inset=inset, lean=lean * width, high=high, low=low),
                usual,
            )

    def _refine(self, form: TableForm, usual: float) -> tuple[TableForm, float]:
        """Return the form with refined leg dimensions, and its overlap below the top."""

        def make(p: np.ndarray) -> TableForm:
            return self.ground(_with_legs(form, p), usual)

        start, steps = _leg_measures(form), (0.04, 0.04, 0.03, 0.015, -0.015)
        found = make(descend(lambda p: -self.overlap(make(p)), start, steps, 160, 1e-3))
        return found, self.overlap(found)
