"""Ablations (Sec. 4.3), in which the reasoner's answers replace a stage of the method.

Without DRO, the reasoner gives the rotations (this module); without TSA, it gives the positions and
sizes (``alignment.placement.ask_layout``).
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..backends.protocols import PoseGuesser, Reasoner
from ..errors import BackendError
from ..geometry import wrap
from ..scene import TABLE, Instance, Reference, Rotation, SizePrior, View


def pose_guesser(reasoner: Reasoner) -> PoseGuesser:
    """Return the reasoner as a backend that can answer questions about poses.

    Raises:
        BackendError: the reasoner cannot answer such questions.
    """
    if isinstance(reasoner, PoseGuesser):
        return reasoner
    questions = ("guess_rotations", "guess_layout")
    missing = [q for q in questions if not callable(getattr(reasoner, q, None))]
    raise BackendError(
        f"{type(reasoner).__name__} does not implement {' and '.join(missing)}, which replace the "
        "stages 'dro' (rotation) and 'tsa' (alignment). Implement "
        "generator.backends.protocols.PoseGuesser, or do not omit these stages."
    )


def ask_rotations(
    reference: Reference,
    instances: tuple[Instance, ...],
    sizes: Mapping[str, SizePrior],
    view: View,
    guesser: PoseGuesser,
) -> dict[str, Rotation]:
    """Return the yaw that the reasoner gives each instance except the table; the losses are NaN.

    Raises:
        BackendError: an answer is missing or is not a finite angle.
    """
    guesses = guesser.guess_rotations(reference, instances, sizes, view)
    rotations: dict[str, Rotation] = {}
    for name in (i.name for i in instances if i.name != TABLE):
        if name not in guesses or not np.isfinite(guesses[name]):
            raise BackendError(
                f"guess_rotations: {type(guesser).__name__} returned no finite yaw for {name!r}."
            )
        rotations[name] = Rotation(name, wrap(float(guesses[name])), float("nan"))
    return rotations
