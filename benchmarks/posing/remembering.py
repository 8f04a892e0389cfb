"""Backends with cached answers: runs that differ in late stages share their early queries."""

from __future__ import annotations

import dataclasses
import hashlib
from collections.abc import Callable, Mapping
from types import SimpleNamespace
from typing import Any

import numpy as np

from generator.backends import Backends
from generator.backends.protocols import Imager, Modeler, PoseGuesser, Reasoner, Segmenter


def remembering(backends: Backends) -> Backends:
    """Return backends that answer repeated queries with equal arguments from a cache.

    Arguments are compared by content, so a query that differs in one pixel is not repeated. The
    encoder, whose answers carry gradients, is not cached.
    """
    reasoner = _remember(backends.reasoner, Reasoner, PoseGuesser)
    imager, segmenter = _remember(backends.imager, Imager), _remember(backends.segmenter, Segmenter)
    return Backends(
        reasoner, imager, segmenter, _remember(backends.modeler, Modeler), backends.encoder
    )


def _remember(backend: Any, *protocols: type) -> Any:
    names = [name for p in protocols for name in vars(p) if not name.startswith("_")]
    methods = {name: getattr(backend, name, None) for name in names}
    return SimpleNamespace(**{n: _memory(m) for n, m in methods.items() if callable(m)})


def _memory(method: Callable[..., Any]) -> Callable[..., Any]:
    answers: dict[str, Any] = {}

    def ask(*args: Any, **named: Any) -> Any:
        key = digest((args, named))
        if key not in answers:
            answers[key] = method(*args, **named)
        return answers[key]

    return ask


def digest(value: Any) -> str:
    """Return a hash of a value's content: dataclasses, arrays, mappings and plain values."""
    state = hashlib.sha256()
    _feed(value, state.update)
    return state.hexdigest()


def _feed(value: Any, update: Callable[[bytes], None]) -> None:
    update(f"<{type(value).__name__}".encode())
    if isinstance(value, np.ndarray):
        update(f"{value.dtype}{value.shape}".encode())
        update(np.ascontiguousarray(value).tobytes())
    elif dataclasses.is_dataclass(value) and not isinstance(value, type):
        for field in dataclasses.fields(value):
            update(field.name.encode())
            _feed(getattr(value, field.name), update)
    elif isinstance(value, Mapping):
        for key, held in value.items():
            _feed(key, update)
            _feed(held, update)
    elif isinstance(value, list | tuple):
        for held in value:
            _feed(held, update)
    else:
        update(repr(value).encode())
    update(b">")
