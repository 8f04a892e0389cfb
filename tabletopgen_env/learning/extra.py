"""What training and charts need beyond the package: the extras ``train`` and ``plot``."""

from __future__ import annotations

import importlib

from generator.errors import InputError

PIP = "pip install 'tabletopgen[train]'"


def need(package: str, what: str, extra: str) -> None:
    """Make sure that a package is installed.

    Raises:
        InputError: it is not; the message is ``what`` with the line that installs the extra.
    """
    try:
        importlib.import_module(package)
    except ImportError as error:
        raise InputError(f"{what}: pip install 'tabletopgen[{extra}]'.") from error


def need_sb3() -> None:
    """Make sure that Stable-Baselines3 is there (InputError: it is not installed)."""
    need("stable_baselines3", "Policies need Stable-Baselines3", "train")


def tensorboard_there() -> bool:
    """Tell whether TensorBoard is installed."""
    try:
        import tensorboard  # noqa: F401
    except ImportError:
        return False
    return True
