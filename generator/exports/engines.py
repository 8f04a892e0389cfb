"""Friction and contact settings that make other physics engines behave like MuJoCo.

Where two bodies touch, MuJoCo takes the larger of their coefficients of friction. Other engines
combine them differently, so each engine gets its own coefficients, in an element that only it
reads:

| engine | two coefficients a, b become | element |
|---|---|---|
| PyBullet | a b | ``contact/lateral_friction`` (URDF) |
| Drake | 2 a b / (a + b) | ``drake:mu_static``, ``drake:mu_dynamic`` (URDF, SDF) |
| Gazebo | min(a, b) | ``mu1``, ``mu2`` (URDF), ``ode/mu`` (SDF) |
| Isaac Sim | max(a, b), set by ``physxMaterial:frictionCombineMode`` | ``UsdPhysicsMaterialAPI`` |

Between an object and the table the result equals MuJoCo's. Between two objects, PyBullet's and
Drake's results equal MuJoCo's if at most one of them is rougher than the table and neither is
smoother; in Drake, neither may be rougher than 1.8 times the table. Gazebo takes the smaller of the
two.

Drake also gets compliant hydroelastic contact, since with point contact a flat body rests on a
single point.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

from ..physics.mjcf import FLOOR
from ..scene import TABLE
from .bodies import ExportBody, ExportPiece
from .files import number_text

DRAKE: Mapping[str, str] = MappingProxyType({"xmlns:drake": "http://drake.mit.edu"})
"""Document attribute that declares Drake's tags."""

HYDROELASTIC_MODULUS = 1e7
"""Pressure in Pa at the centre of a body in Drake: a 0.5 kg plate sinks in by a micrometre."""

_SHARE = 0.25  # edge length of a round piece's hydroelastic mesh, relative to its radius
_REACH = 0.55  # minimum coefficient of the table in Drake, relative to the largest one


@dataclass(frozen=True)
class EngineFriction:
    """The friction coefficient of one body in each physics engine."""

    pybullet: float
    drake: float
    gazebo: float


def engine_friction(bodies: Sequence[ExportBody], table: float) -> Mapping[str, EngineFriction]:
    """Return the friction coefficients of each body by name; the floor has those of the table."""
    wanted = {body.name: max(body.friction, table) for body in bodies}  # on the table, in MuJoCo
    most = max(wanted.values())
    middle = max(table, _REACH * most)
    found = {
        name: EngineFriction(larger / math.sqrt(table), _harmonic(larger, middle), larger)
        for name, larger in wanted.items()
    }
    found[TABLE] = found[FLOOR] = EngineFriction(math.sqrt(table), middle, most)
    return found


def _harmonic(wanted: float, other: float) -> float:
    """Return the x whose harmonic mean with ``other`` is ``wanted`` (``wanted`` < 2 ``other``)."""
    return wanted * other / (2 * other - wanted)


def drake_properties(piece: ExportPiece, friction: float) -> Mapping[str, str | None]:
    """Return the tags that Drake reads in a collision element, with their values, if any."""
    tags: dict[str, str | None] = {
        "drake:compliant_hydroelastic": None,
        "drake:hydroelastic_modulus": number_text([HYDROELASTIC_MODULUS]),
        "drake:mu_static": number_text([friction]),
        "drake:mu_dynamic": number_text([friction]),
    }
    if piece.kind not in ("box", "mesh"):
        radius = piece.radius if piece.kind == "cylinder" else float(piece.half.max())
        tags["drake:mesh_resolution_hint"] = number_text([_SHARE * radius])
    return tags
