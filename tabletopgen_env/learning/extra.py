"""Optional dependencies for training and charts: the extras ``train`` and ``plot``."""

from __future__ import annotations

import importlib

from generator.errors import InputError

PIP = "pip install 'tabletopgen[train]'"


def need(package: str, what: str, extra: str) -> None:
    """Check that a package is installed.

    Raises:
        InputError: the package is not installed; the message is ``what`` with the command that
            installs the extra.
    """
    try:
        importlib.import_module(package)
    except ImportError as error:
        raise InputError(f"{what}: pip install 'tabletopgen[{extra}]'.") from error


def need_sb3() -> None:
    """Check that Stable-Baselines3 is installed; raise InputError if it is not."""
    need("stable_baselines3", "Policies need Stable-Baselines3", "train")


def tensorboard_there() -> bool:
    """Return whether TensorBoard is installed."""
    try:
        import tensorboard  # noqa: F401
    except ImportError:
        return False
    return True
