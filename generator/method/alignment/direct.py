"""Sec. 4.3, without TSA: places and sizes given by the reasoner, without a top view."""

from __future__ import annotations

from collections.abc import Mapping

from ...backends.protocols import PoseGuesser, Reasoner
from ...errors import BackendError
from ...scene import TABLE, Instance, Model, Reference, Rotation, SizePrior, View
from .placing import Alignment, place_objects


def ask_layout(
    reference: Reference,
    instances: tuple[Instance, ...],
    models: Mapping[str, Model],
    sizes: Mapping[str, SizePrior],
    rotations: Mapping[str, Rotation],
    view: View,
    reasoner: Reasoner,
    guesser: PoseGuesser,
) -> Alignment:
    """Return the instances placed and scaled by the reasoner; the table has its usual size.

    What stands on what is its answer too, as in TSA, so only x, y and the sizes are others. There
    is no anchor and no top view.

    Raises:
        BackendError: an answer is missing.
    """
    guesses = guesser.guess_layout(reference, instances, sizes, view)
    stacking = dict(reasoner.stacking_order(reference, instances, view))
    names = [i.name for i in instances if i.name != TABLE]
    for name in names:
        if name not in guesses:
            raise BackendError(
                f"guess_layout: {type(guesser).__name__} gave no place for {name!r}."
            )
    yaws = {n: rotations[n].yaw if n in rotations else 0.0 for n in names}
    centers = {n: guesses[n].center for n in names}
    scales = {n: guesses[n].size for n in names}
    table_scale = sizes[TABLE].extent
    placements = place_objects(names, centers, table_scale, yaws, scales, models, stacking)
    return Alignment(None, None, table_scale, placements, None, stacking, {})
