"""The eye's weights: where they lie, what comes with them, and how they are read."""

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
"""The weights the package ships, half precision, with categories and temperature beside them."""

JUDGE_PATH = Path(__file__).with_name("judge.safetensors")
"""The weights of the judge of what the eye finds, half precision."""

PROPORTIONS_PATH = Path(__file__).with_name("proportions.safetensors")
"""The weights of the network that tells things' proportions, half precision."""

_MOST_NOTE = 2**16  # bytes of the list of categories

_RESTORE = (
    "Install the package again, restore the file from the repository "
    "(git checkout -- generator/backends/embedded/eye), or train it: "
    "python -m research.eye.{} --help"
)

Network = TypeVar("Network", bound=nn.Module)


@dataclass(frozen=True, eq=False)
class Weights:
    """A network, the category keys of its names but the last, "unknown", and their temperature."""

    eye: Eye
    categories: tuple[str, ...]
    temperature: float


@cache
def load_weights(path: Path = PATH) -> Weights:
    """Read the eye's weights; the last read stay loaded.

    Raises:
        BackendError: the file is missing, damaged or of another network.
    """
    restore = _RESTORE.format("train")
    state, notes = _read(path, restore)
    try:
        categories, temperature = _categories(notes["categories"]), float(notes["temperature"])
        if not 0 < temperature < math.inf:
            raise ValueError(f"its temperature is {temperature}")
        eye = Eye(len(categories) + 1)
        _fill(eye, state)
        eye.to(memory_format=torch.channels_last)  # pyright: ignore[reportCallIssue]
        return Weights(eye, categories, temperature)
    except (KeyError, ValueError, RuntimeError, BackendError) as error:
        raise _useless(path, error, restore) from error


@cache
def load_judge(path: Path = JUDGE_PATH) -> DetectionJudge:
    """Read the judge's weights as ``load_weights`` does."""
    return _load(DetectionJudge(), path, "judging")


@cache
def load_proportions(path: Path = PROPORTIONS_PATH) -> ProportionNetwork:
    """Read the weights of the network of proportions as ``load_weights`` does."""
    return _load(ProportionNetwork(), path, "proportioning")


def save_weights(path: Path, state: dict[str, torch.Tensor], notes: dict[str, str]) -> None:
    """Write weights in half precision; an interrupted write leaves the old file."""
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
        raise BackendError(f"The eye's weights {path.name!r} are missing. {restore}")
    try:
        with safe_open(path, framework="pt") as file:
            state = {key: file.get_tensor(key) for key in file.keys()}  # noqa: SIM118
            return state, file.metadata() or {}
    except (SafetensorError, ValueError, OSError) as error:
        raise _useless(path, error, restore) from error


def _categories(text: str) -> tuple[str, ...]:
    """Return the names that the eye knows, from the notes beside its weights."""
    names = parse_json(text, "its list of categories", BackendError, max_bytes=_MOST_NOTE)
    if not isinstance(names, list):
        raise ValueError("its categories are no list")
    return tuple(printable(name, "a category", BackendError) for name in names)


def _fill(network: nn.Module, state: dict[str, torch.Tensor]) -> None:
    own = network.state_dict()
    network.load_state_dict({k: v.to(own[k].dtype) for k, v in state.items()})
    network.eval().requires_grad_(False)


def _useless(path: Path, error: Exception, restore: str) -> BackendError:
    return BackendError(f"The eye's weights {path.name!r} cannot be used ({error}). {restore}")
