"""The eye's weights: where they lie, what comes with them, and how they are read."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import torch

from ....errors import BackendError
from .network import Eye

PATH = Path(__file__).with_name("eye.safetensors")
"""The weights the package ships, half precision, with categories and temperature beside them."""

_RESTORE = (
    "Install the package again, restore the file from the repository "
    "(git checkout -- generator/backends/embedded/eye), or train it: "
    "python -m generator.training.train --help"
)


@dataclass(frozen=True, eq=False)
class Weights:
    """A network ready to look, the category keys its names stand for, and their temperature.

    The last of the network's names is "unknown" and has no key.
    """

    eye: Eye
    categories: tuple[str, ...]
    temperature: float


@cache
def load_weights(path: Path = PATH) -> Weights:
    """Read the weights; the last read stay loaded.

    Raises:
        BackendError: the file is missing, damaged or of another network.
    """
    from safetensors import SafetensorError, safe_open

    if not path.is_file():
        raise BackendError(f"The eye's weights {path.name!r} are missing. {_RESTORE}")
    try:
        with safe_open(path, framework="pt") as file:
            notes = file.metadata() or {}
            categories = tuple(json.loads(notes["categories"]))
            state = {key: file.get_tensor(key) for key in file.keys()}  # noqa: SIM118
        eye = Eye(len(categories) + 1)
        eye.load_state_dict({k: v.to(eye.state_dict()[k].dtype) for k, v in state.items()})
    except (SafetensorError, KeyError, ValueError, RuntimeError, OSError) as error:
        message = f"The eye's weights {path.name!r} cannot be used ({error}). {_RESTORE}"
        raise BackendError(message) from error
    eye.eval().requires_grad_(False)
    eye.to(memory_format=torch.channels_last)  # pyright: ignore[reportCallIssue]
    return Weights(eye, categories, float(notes["temperature"]))


def save_weights(
    path: Path, state: dict[str, torch.Tensor], categories: tuple[str, ...], temperature: float
) -> None:
    """Write weights in half precision; an interrupted write leaves the old file."""
    from safetensors.torch import save_file

    small = {
        k: (v.half() if v.is_floating_point() else v).detach().cpu().contiguous()
        for k, v in state.items()
    }
    notes = {"categories": json.dumps(list(categories)), "temperature": f"{temperature:.4f}"}
    partial = path.with_suffix(".partial")
    save_file(small, partial, metadata=notes)
    partial.chmod(0o644)
    partial.replace(path)
