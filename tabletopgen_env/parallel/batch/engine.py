"""MuJoCo Warp for batches: import, version check, devices and their memory."""

from __future__ import annotations

import os
import re
from dataclasses import dataclass
from importlib import import_module, metadata
from pathlib import Path
from types import ModuleType

import numpy as np
import torch
from torch import Tensor

from generator.errors import InputError

PIP = "pip install 'tabletopgen[gpu]'"

_PACKAGES = ("mujoco-warp", "warp-lang")


@dataclass(frozen=True)
class Engine:
    """The modules ``warp`` and ``mujoco_warp``, which are imported only by this class.

    Warp compiles its kernels on first use, which takes a minute, and caches them in a folder of the
    user's cache or in ``$WARP_CACHE_PATH``.
    """

    warp: ModuleType
    physics: ModuleType

    @classmethod
    def load(cls) -> Engine:
        """Import the modules, with Warp's compilation messages disabled.

        Raises:
            InputError: the extra ``gpu`` is not installed, or does not match the version of MuJoCo.
        """
        _check_versions()
        try:
            warp = import_module("warp")
            warp.config.log_level = max(warp.config.log_level, warp.LOG_WARNING)
            return cls(warp, import_module("mujoco_warp"))
        except ImportError as error:
            raise InputError(f"MuJoCo Warp cannot be imported ({error}): {PIP}.") from error


def _check_versions() -> None:
    """Check that MuJoCo Warp is installed and matches the version of MuJoCo."""
    found = {name: _version(name) for name in ("mujoco", *_PACKAGES)}
    if missing := [name for name in _PACKAGES if found[name] is None]:
        raise InputError(
            f"Batched worlds need MuJoCo Warp, but {' and '.join(missing)} "
            f"{'is' if len(missing) == 1 else 'are'} not installed: {PIP}."
        )
    if found["mujoco"] != found["mujoco-warp"]:
        raise InputError(
            f"mujoco {found['mujoco']} and mujoco-warp {found['mujoco-warp']} are installed, "
            f"but their versions must be equal: {PIP}."
        )


def _version(package: str) -> str | None:
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return None


def find_device(name: str | torch.device) -> torch.device:
    """Return the device called ``name``, which is "cuda", "cuda:<number>" or "cpu".

    Raises:
        InputError: the device does not exist.
    """
    try:
        device = torch.device(name)
    except (RuntimeError, TypeError) as error:
        raise InputError(
            f"device must be 'cuda', 'cuda:<number>' or 'cpu', got {name!r}."
        ) from error
    if device.type == "cpu":
        return torch.device("cpu")
    if device.type != "cuda":
        raise InputError(f"Worlds can be simulated on 'cuda' or 'cpu', not on {str(device)!r}.")
    count = torch.cuda.device_count() if torch.cuda.is_available() else 0
    number = device.index or 0
    if number >= count:
        here = f"only {count} CUDA devices" if count else "no CUDA device that torch can use"
        raise InputError(
            f"device={str(device)!r} is not available; there is {here}. Install a CUDA build of "
            "torch and a driver, or use device='cpu' (slow, for tests)."
        )
    return torch.device("cuda", number)


def to_device(array: np.ndarray, device: torch.device) -> Tensor:
    """Return an array as a tensor on a device, with floats in single precision."""
    made = torch.as_tensor(array, device=device)
    return made.float() if made.is_floating_point() else made


def free_bytes(device: torch.device) -> int:
    """Return the free memory of a device in bytes."""
    if device.type == "cuda":
        return torch.cuda.mem_get_info(device)[0]
    told = Path("/proc/meminfo")
    if told.exists() and (found := re.search(r"MemAvailable:\s+(\d+) kB", told.read_text())):
        return int(found[1]) * 1024  # including reclaimable page cache
    return os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
