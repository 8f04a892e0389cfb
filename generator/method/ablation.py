"""Sec. 4.3, ablations: the reasoner gives the numbers in place of a stage.

Without DRO it gives the rotations (here); without TSA, places and sizes
(``alignment.placement.ask_layout``).
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..backends.protocols import PoseGuesser, Reasoner
from ..errors import BackendError
from ..geometry import wrap
from ..scene import TABLE, Instance, Reference, Rotation, SizePrior, View


def pose_guesser(reasoner: Reasoner) -> PoseGuesser:
    """Return the reasoner as one that can be asked for poses.

    Raises:
        BackendError: the reasoner cannot.
    """
    if isinstance(reasoner, PoseGuesser):
        return reasoner
    questions = ("guess_rotations", "guess_layout")
    missing = [q for q in questions if not callable(getattr(reasoner, q, None))]
    raise BackendError(
        f"{type(reasoner).__name__} does not answer {' and '.join(missing)}, which stand in for "
        "DRO and TSA where they are left out. See generator.backends.protocols.PoseGuesser, or "
        "leave nothing out."
    )


def ask_rotations(
    reference: Reference,
    instances: tuple[Instance, ...],
    sizes: Mapping[str, SizePrior],
    view: View,
    guesser: PoseGuesser,
) -> dict[str, Rotation]:
    """Return the yaw that the reasoner gives for every instance but the table, without a loss.

    Raises:
        BackendError: an answer is missing, or no finite angle.
    """
    guesses = guesser.guess_rotations(reference, instances, sizes, view)
    rotations: dict[str, Rotation] = {}
    for name in (i.name for i in instances if i.name != TABLE):
        if name not in guesses or not np.isfinite(guesses[name]):
            raise BackendError(
                f"guess_rotations: {type(guesser).__name__} gave no finite yaw for {name!r}."
            )
        rotations[name] = Rotation(name, wrap(float(guesses[name])), float("nan"))
    return rotations
