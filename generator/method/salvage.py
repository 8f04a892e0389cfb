"""A scene that fails its gate gives up what spoils it: what nobody saw first, then the misfits.

One thing found wrong - two things taken for one, a shadow made solid - would otherwise cost the
whole table. What is left out is named by the provenance and the report.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..scene import (
    Placement,
    Scene,
    SizePrior,
    names_in,
)
from .supplement import Supplement

Placements = tuple[Placement, ...]


def salvaged(
    build: Callable[[Placements, Supplement, tuple[str, ...]], Scene],
    add: Callable[[Placements, tuple[str, ...]], Supplement],
    placements: Placements,
    sizes: Mapping[str, SizePrior],
    most: int,
) -> Scene:
    """Return the first scene to pass its gate, or else the one with all that was found.

    Args:
        build: assembles and judges what was found, what is added to it, with these warnings.
        add: gives what a text asks for beyond what is placed, told what was left out.
        placements: what was found, where it stands.
        sizes: commonsense sizes of it.
        most: how many found things may be left out.
    """
    extra, told = add(placements, ()), ()
    whole = None
    gone: tuple[str, ...] = ()
    chosen = 0
    while True:
        scene = build(placements, extra, told)
        if scene.report is None or scene.report.passed:
            return _recorded(scene, gone)
        if extra.placements:
            extra = extra.without(scene.report.failures)
            continue
        whole = whole or scene
        name = misfit(scene.report.failures, placements, sizes)
        if name is None or chosen >= most:
            return whole
        chosen += 1
        left = without(placements, name)
        inside = _inside(placements, name)
        told += (f"{name} was left out: {_why(name, scene.report.failures)}.",)
        told += tuple(f"{other} was left out with {name}." for other in inside)
        gone += (name, *inside)
        placements = left
        extra = add(placements, gone)


def allowance(share: float, count: int) -> int:
    """Return how many of ``count`` things may be left out: a share of them, never all.

    Of two or more it is one at least, unless the share is 0.
    """
    return min(max(1, int(share * count + 1e-9)), count - 1) if share and count else 0


def misfit(
    failures: Sequence[str], placements: Sequence[Placement], sizes: Mapping[str, SizePrior]
) -> str | None:
    """Return which placed thing the gate's failures name most; None if they name none.

    Of those named equally often it is the one whose size is farthest from its kind's.
    """
    words = [word for failure in failures for word in names_in(failure)]
    named = [(words.count(p.name), _oddness(p, sizes), p.name) for p in placements]
    count, _, name = max(named, default=(0, 0.0, ""))
    return name if count else None


def without(placements: Sequence[Placement], name: str) -> Placements:
    """Return the placements without ``name`` and what is in it.

    What stood on one of these stands on what ``name`` stood on.
    """
    (first,) = (p for p in placements if p.name == name)
    gone = {name, *_inside(placements, name)}
    return tuple(
        replace(p, on=first.on, inside=first.inside) if p.on in gone else p
        for p in placements
        if p.name not in gone
    )


def _inside(placements: Sequence[Placement], name: str) -> tuple[str, ...]:
    """Return what is in ``name``, and what is in that, in the order of the placements."""
    gone = {name}
    while more := {p.name for p in placements if p.inside and p.on in gone} - gone:
        gone |= more
    return tuple(p.name for p in placements if p.name in gone - {name})


def _oddness(placement: Placement, sizes: Mapping[str, SizePrior]) -> float:
    """Return by what factor the longest side differs from the prior's, as a logarithm."""
    prior = sizes.get(placement.name)
    if prior is None:
        return 0.0
    return abs(float(np.log(placement.scale.max() / prior.extent.max())))


def _why(name: str, failures: Sequence[str]) -> str:
    return "; ".join(f for f in failures if name in names_in(f))


def _recorded(scene: Scene, gone: tuple[str, ...]) -> Scene:
    if not gone or scene.report is None:
        return scene
    dropped = tuple(sorted({*scene.report.dropped, *gone}))
    return scene.replace(report=replace(scene.report, dropped=dropped))
