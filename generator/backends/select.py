"""Selection of backends by name, with a lazily loaded table of classes.

``Backends.select("embedded", modeler=MyModeler())`` combines backends. There is no silent fallback:
an error lists the choices for an unknown name, and the pip command for a missing extra.
"""

from __future__ import annotations

import dataclasses
import importlib
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

from ..calls import Session
from ..errors import BackendError, choices
from .protocols import Each, Encoder, Imager, Modeler, Reasoner, Segmenter, in_turn

PROTOCOLS: Mapping[str, type] = {
    "reasoner": Reasoner,
    "imager": Imager,
    "segmenter": Segmenter,
    "modeler": Modeler,
    "encoder": Encoder,
}

_EMBEDDED = "generator.backends.embedded"
_MODELERS = "generator.backends.modelers"
_CLOUD = "generator.backends.cloud"
_HUGGINGFACE = "generator.backends.huggingface"

TABLE: Mapping[str, Mapping[str, str]] = {
    "embedded": {
        "reasoner": f"{_EMBEDDED}.reasoner:EmbeddedReasoner",
        "imager": f"{_EMBEDDED}.imager:EmbeddedImager",
        "segmenter": f"{_EMBEDDED}.segmenter:EmbeddedSegmenter",
        "modeler": f"{_EMBEDDED}.modeler:EmbeddedModeler",
        "encoder": f"{_EMBEDDED}.encoder:EmbeddedEncoder",
    },
    "minisam": {"segmenter": f"{_EMBEDDED}.minisam.segmenter:MiniSamSegmenter"},
    "folder": {"modeler": f"{_MODELERS}.folder:Folder"},
    "hunyuan3d": {"modeler": f"{_MODELERS}.hunyuan3d:Hunyuan3D"},
    "tencent": {"modeler": f"{_MODELERS}.tencent:Tencent"},
    "trellis": {"modeler": f"{_MODELERS}.trellis:Trellis"},
    "triposr": {"modeler": f"{_MODELERS}.triposr:TripoSR"},
    "sam3d": {"modeler": f"{_MODELERS}.sam3d:Sam3D"},
    "cloud": {
        "reasoner": f"{_CLOUD}.reasoner:CloudReasoner",
        "imager": f"{_CLOUD}.imager:CloudImager",
    },
    "huggingface": {
        "segmenter": f"{_HUGGINGFACE}.segmenter:HuggingFaceSegmenter",
        "encoder": f"{_HUGGINGFACE}.encoder:HuggingFaceEncoder",
    },
}
"""The class of each backend name and role, loaded on selection."""


def check_names(default: str, roles: Mapping[str, Any]) -> None:
    """Check the backend name of each role.

    Raises:
        BackendError: a role's name, or ``default`` in its place, is unknown or lacks the role.
    """
    if default not in TABLE:
        raise BackendError(f"Unknown backend {default!r}.{choices(default, TABLE)}")
    names = {role: pick for role in PROTOCOLS if isinstance(pick := roles.get(role, default), str)}
    able = {role: [b for b, answers in TABLE.items() if role in answers] for role in PROTOCOLS}
    for role, name in names.items():
        if name not in TABLE:
            raise BackendError(f"Unknown {role} {name!r}.{choices(name, able[role])}")
    lacking = [
        (
            f"Backend {name!r} has no {role} ({', '.join(_questions(role))}). "
            f"Choose another {role}. Available: {', '.join(sorted(able[role]))}."
        )
        for role, name in names.items()
        if name not in able[role]
    ]
    if lacking:
        raise BackendError(" ".join(lacking))


def _questions(role: str) -> list[str]:
    return [method for method in vars(PROTOCOLS[role]) if not method.startswith("_")]


def _load(name: str, role: str, session: Session) -> Any:
    module, _, attribute = TABLE[name][role].partition(":")
    kind = getattr(importlib.import_module(module), attribute)
    shared = {"session": session} if "session" in _fields(kind) else {}
    try:
        return _add_fallback(role, kind(**shared))
    except BackendError as error:
        raise BackendError(f"{role}: {error}") from error


def _add_fallback(role: str, backend: Any) -> Any:
    """Return a backend whose ``fallback`` field, if present and unset, is the embedded backend."""
    if "fallback" not in _fields(type(backend)) or backend.fallback is not None:
        return backend
    return dataclasses.replace(backend, fallback=_load("embedded", role, Session()))


def _fields(kind: type) -> Mapping[str, Any]:
    return getattr(kind, "__dataclass_fields__", {})


def _check(role: str, backend: Any) -> Any:
    if not isinstance(backend, PROTOCOLS[role]):
        missing = [m for m in _questions(role) if not callable(getattr(backend, m, None))]
        raise BackendError(
            f"{type(backend).__name__} cannot be the {role}: it lacks {', '.join(missing)}. "
            f"See generator.backends.protocols.{PROTOCOLS[role].__name__}."
        )
    return backend


@dataclass(frozen=True)
class Backends:
    """The backends of the five roles that a generation needs."""

    reasoner: Reasoner
    imager: Imager
    segmenter: Segmenter
    modeler: Modeler
    encoder: Encoder

    @classmethod
    def select(
        cls, default: str = "embedded", *, session: Session | None = None, **roles: Any
    ) -> Backends:
        """Return backends selected by name; each role may be set to a name or to your own object.

        ``default`` is used for the roles (``reasoner``, ``imager``, ``segmenter``, ``modeler``,
        ``encoder``) that ``roles`` does not set. Backends selected by name that call servers share
        ``session`` with its store, ledger and budget; None creates a new one that stores nothing.

        Raises:
            BackendError: an unknown backend or role, a backend without the role, a missing extra,
                or an object that lacks a method of its protocol.
        """
        for role in roles:
            if role not in PROTOCOLS:
                raise BackendError(f"Unknown role {role!r}.{choices(role, PROTOCOLS)}")
        check_names(default, roles)
        shared = Session() if session is None else session
        chosen = {role: roles.get(role, default) for role in PROTOCOLS}
        return cls(
            **{
                role: _check(role, _load(pick, role, shared))
                if isinstance(pick, str)
                else _add_fallback(role, _check(role, pick))
                for role, pick in chosen.items()
            }
        )

    def check(self) -> None:
        """Call ``check()`` of every role that has one.

        Raises:
            BackendError: a folder, a model or a key is missing.
        """
        for role in PROTOCOLS:
            check = getattr(getattr(self, role), "check", None)
            if check is not None:
                check()

    def each(self, role: str) -> Each:
        """Return a function that applies ``work`` to items, concurrently if the role has a session.

        Only calls to servers are concurrent; local computation is sequential.
        """
        session = getattr(getattr(self, role), "session", None)
        return session.each if isinstance(session, Session) else in_turn

    def asks_servers(self) -> bool:
        """Return whether any role has a ``session``, so that its answers come from a server."""
        return any(hasattr(getattr(self, role), "session") for role in PROTOCOLS)

    def for_text(self) -> Backends:
        """Return a variant for pictures drawn from text prompts, possibly with a faster modeler."""
        quick = getattr(self.modeler, "for_text", None)
        return self if quick is None else dataclasses.replace(self, modeler=quick())

    def identity(self) -> dict[str, dict[str, Any]]:
        """Return each role's stable name and fields, as recorded in provenance, without secrets."""
        return {
            field.name: _identity(getattr(self, field.name)) for field in dataclasses.fields(self)
        }


def _identity(backend: Any) -> dict[str, Any]:
    settings = {}
    if dataclasses.is_dataclass(backend) and not isinstance(backend, type):
        shown = (field.name for field in dataclasses.fields(backend) if field.repr)
        settings = {name: _record(getattr(backend, name)) for name in shown}
    recorded = {k: v for k, v in settings.items() if v is not _UNTOLD}
    return {"class": stable_name(type(backend)), **recorded}


def stable_name(kind: type) -> str:
    """Return the name by which provenance records a class, which does not depend on its module.

    A backend in the table is called by its name and role ("embedded.modeler"), another class of
    this project by its bare name, and a user's class by its module and name.
    """
    place = f"{kind.__module__}:{kind.__qualname__}"
    for name, answers in TABLE.items():
        for role, listed in answers.items():
            if listed == place:
                return f"{name}.{role}"
    ours = kind.__module__.partition(".")[0] == __name__.partition(".")[0]
    return kind.__qualname__ if ours else place.replace(":", ".")


def _record(value: Any) -> Any:
    """Return the provenance record of a setting, or ``_UNTOLD`` if it cannot be serialised."""
    if isinstance(value, str | int | float | bool | type(None)):
        return value
    if isinstance(value, tuple | list):
        parts = [_record(part) for part in value]
        return _UNTOLD if _UNTOLD in parts else parts
    return _identity(value) if dataclasses.is_dataclass(value) else _UNTOLD


_UNTOLD: Any = object()


@dataclass(frozen=True)
class Mix:
    """The backend of each role. docs/guides/backends.md lists what backends require.

    Attributes:
        backend: Backend of all roles that are not set below.
        reasoner: Backend that plans scenes and estimates names, sizes and supports.
        imager: Backend that draws, completes and renders pictures.
        segmenter: Backend that detects and segments objects.
        modeler: Backend that turns the picture of an object into a mesh.
        encoder: Backend whose features compare a render with the picture.
    """

    backend: str | None = "embedded"
    reasoner: str | None = None
    imager: str | None = None
    segmenter: str | None = None
    modeler: str | None = None
    encoder: str | None = None

    @property
    def given(self) -> bool:
        """Whether any backend is given."""
        return any(getattr(self, field.name) is not None for field in fields(self))

    @property
    def default(self) -> str:
        """The backend of roles that are not set."""
        return self.backend or "embedded"

    def roles(self) -> dict[str, str]:
        """Return the backend name of each of the five roles."""
        return {role: getattr(self, role) or self.default for role in PROTOCOLS}

    def identity(self) -> dict[str, Any]:
        """Return the settings that determine the backends, as JSON values; defaults are omitted."""
        others = {role: name for role, name in self.roles().items() if name != self.default}
        return {"backend": self.default, **({"roles": others} if others else {})}

    def select(self, session: Session | None = None) -> Backends:
        """Return the backends.

        Raises:
            BackendError: a name is unknown, or a role has no backend.
        """
        return Backends.select(self.default, session=session, **self.roles())
