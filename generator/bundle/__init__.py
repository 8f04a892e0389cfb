"""Bundles: a scene as a folder that anyone can load, and back."""

from .bounds import BOUNDS as BOUNDS
from .copying import copy as copy
from .copying import read_files as read_files
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
from .publishing import discard as discard
from .publishing import put_in_place as put_in_place
from .publishing import steady as steady
from .publishing import sweep as sweep
from .segments import Segments as Segments
