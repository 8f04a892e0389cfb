"""Bundles: scenes stored as folders that anyone can load, and functions to save and load them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..io.lazy import lazy_names

if TYPE_CHECKING:
    from .bounds import BOUNDS as BOUNDS
    from .files import copy as copy
    from .files import read_files as read_files
    from .folder import SCHEMA as SCHEMA
    from .folder import check as check
    from .folder import check_name as check_name
    from .folder import load as load
    from .folder import load_picture as load_picture
    from .folder import load_pictures as load_pictures
    from .folder import load_segments as load_segments
    from .folder import load_verified as load_verified
    from .folder import read_inside as read_inside
    from .folder import save as save
    from .folder import verify as verify
    from .identity import digest as digest
    from .identity import load_digest as load_digest
    from .identity import load_fingerprint as load_fingerprint
    from .identity import load_kinds as load_kinds
    from .identity import load_report as load_report
    from .publication import discard as discard
    from .publication import put_in_place as put_in_place
    from .publication import steady as steady
    from .publication import sweep as sweep
    from .segments import Segments as Segments

_HOMES = {
    "BOUNDS": "bounds",
    "SCHEMA": "folder",
    "Segments": "segments",
    "check": "folder",
    "check_name": "folder",
    "copy": "files",
    "digest": "identity",
    "discard": "publication",
    "load": "folder",
    "load_digest": "identity",
    "load_fingerprint": "identity",
    "load_kinds": "identity",
    "load_picture": "folder",
    "load_pictures": "folder",
    "load_report": "identity",
    "load_segments": "folder",
    "load_verified": "folder",
    "put_in_place": "publication",
    "read_files": "files",
    "read_inside": "folder",
    "save": "folder",
    "steady": "publication",
    "sweep": "publication",
    "verify": "folder",
}

__getattr__, __dir__ = lazy_names(__name__, _HOMES)
