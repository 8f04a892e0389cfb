"""The weights of the built-in detector: files, metadata and loading."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TypeVar

import torch
from torch import nn

from ....errors import BackendError
from ....io.bounded import parse_json, printable
from .judge import DetectionJudge
from .network import Eye
from .proportions import ProportionNetwork

PATH = Path(__file__).with_name("eye.safetensors")
"""The shipped weights in half precision, with categories and temperature as metadata."""

JUDGE_PATH = Path(__file__).with_name("judge.safetensors")
"""The weights of the network that selects detections, in half precision."""

PROPORTIONS_PATH = Path(__file__).with_name("proportions.safetensors")
"""The weights of the network that estimates proportions, in half precision."""

_MOST_NOTE = 2**16  # maximum size of the category list in bytes

_RESTORE = (
    "Reinstall the package, restore the file from the repository (git checkout -- "
    "generator/backends/embedded/eye), or train it: python -m research.eye.{} --help"
)

Network = TypeVar("Network", bound=nn.Module)


@dataclass(frozen=True, eq=False)
class Weights:
    """A network, its category keys (without the final "unknown"), and its temperature."""

    eye: Eye
    categories: tuple[str, ...]
    temperature: float


@cache
def load_weights(path: Path = PATH) -> Weights:
    """Load the detector's weights; the most recent ones are cached.

    Raises:
        BackendError: the file is missing, damaged or for another network.
    """
    restore = _RESTORE.format("train")
    state, notes = _read(path, restore)
    try:
        categories, temperature = _categories(notes["categories"]), float(notes["temperature"])
        if not 0 < temperature < math.inf:
            raise ValueError(f"the temperature must be positive and finite, got {temperature}")
        eye = Eye(len(categories) + 1)
        _fill(eye, state)
        eye.to(memory_format=torch.channels_last)  # pyright: ignore[reportCallIssue]
        return Weights(eye, categories, temperature)
    except (KeyError, ValueError, RuntimeError, BackendError) as error:
        raise _useless(path, error, restore) from error


@cache
def load_judge(path: Path = JUDGE_PATH) -> DetectionJudge:
    """Load the weights of the selection network, as ``load_weights`` does."""
    return _load(DetectionJudge(), path, "judging")


@cache
def load_proportions(path: Path = PROPORTIONS_PATH) -> ProportionNetwork:
    """Load the weights of the proportion network, as ``load_weights`` does."""
    return _load(ProportionNetwork(), path, "proportioning")


def save_weights(path: Path, state: dict[str, torch.Tensor], notes: dict[str, str]) -> None:
    """Write weights in half precision; an interrupted write leaves the old file unchanged."""
    from safetensors.torch import save_file

    small = {
        k: (v.half() if v.is_floating_point() else v).detach().cpu().contiguous()
        for k, v in state.items()
    }
    partial = path.with_suffix(".partial")
    save_file(small, partial, metadata=notes)
    partial.chmod(0o644)
    partial.replace(path)


def _load(network: Network, path: Path, script: str) -> Network:
    restore = _RESTORE.format(script)
    state, _ = _read(path, restore)
    try:
        _fill(network, state)
    except (KeyError, RuntimeError) as error:
        raise _useless(path, error, restore) from error
    return network


def _read(path: Path, restore: str) -> tuple[dict[str, torch.Tensor], dict[str, str]]:
    from safetensors import SafetensorError, safe_open

    if not path.is_file():
        raise BackendError(f"The detector's weights file {path.name!r} is missing. {restore}")
    try:
        with safe_open(path, framework="pt") as file:
            state = {key: file.get_tensor(key) for key in file.keys()}  # noqa: SIM118
            return state, file.metadata() or {}
    except (SafetensorError, ValueError, OSError) as error:
        raise _useless(path, error, restore) from error


def _categories(text: str) -> tuple[str, ...]:
    """Return the detector's category names, read from the metadata of its weights."""
    names = parse_json(text, "the list of categories", BackendError, max_bytes=_MOST_NOTE)
    if not isinstance(names, list):
        raise ValueError("the categories must be a list")
    return tuple(printable(name, "a category", BackendError) for name in names)


def _fill(network: nn.Module, state: dict[str, torch.Tensor]) -> None:
    own = network.state_dict()
    network.load_state_dict({k: v.to(own[k].dtype) for k, v in state.items()})
    network.eval().requires_grad_(False)


def _useless(path: Path, error: Exception, restore: str) -> BackendError:
    return BackendError(
        f"The detector's weights file {path.name!r} cannot be used ({error}). {restore}"
    )
