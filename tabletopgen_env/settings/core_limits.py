"""Settings that the batched core does not support."""

from __future__ import annotations

from collections.abc import Collection

from generator.errors import InputError

from ..randomization import settings as randomization
from ..rendering.config import ObservationMode
from .config import EnvConfig


def check_core(
    config: EnvConfig, who: str, shown: Collection[ObservationMode] = ("state", "goal")
) -> None:
    """Check that the batched core (``core``) supports a config; ``who`` names the caller.

    ``shown`` are the supported observation modes.

    Raises:
        InputError: the config has an unsupported observation, action or randomisation.
    """
    chosen, views = randomization.resolve(config.randomization), config.observation
    for wrong, why in (
        (views.mode not in shown, f"observation={views.mode!r}"),
        (views.grasp_hint, f"grasp_hint={views.grasp_hint!r}"),
        (views.looks, f"geometry={views.geometry!r}"),
        (chosen.is_on("noise"), "noise in readings"),
        (chosen.is_on("delay"), "delayed actions"),
    ):
        if wrong:
            raise InputError(
                f"{who} supports observation={' or '.join(map(repr, shown))} without a grasp hint, "
                f"and does not support {why}."
            )
