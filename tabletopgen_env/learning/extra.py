"""What training needs beyond the package: the extra ``train``."""

from __future__ import annotations

from generator.errors import InputError

PIP = "pip install 'tabletopgen[train]'"


def need_sb3() -> None:
    """Make sure that Stable-Baselines3 is there.

    Raises:
        InputError: it is not installed.
    """
    try:
        import stable_baselines3  # noqa: F401
    except ImportError as error:
        raise InputError(f"Policies need Stable-Baselines3: {PIP}.") from error


def tensorboard_there() -> bool:
    """Tell whether TensorBoard is installed."""
    try:
        import tensorboard  # noqa: F401
    except ImportError:
        return False
    return True
