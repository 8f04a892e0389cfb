"""Checks that ``scene.xml``, which is derived, matches the values in ``scene.json``."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from ..errors import BundleError
from ..io.pictures import encode_png
from ..physics.mjcf import Document, document
from ..physics.spec import compile_spec, list_warnings, new_data, no_console, spec_of, unsimulatable
from .decoder import Decoded

if TYPE_CHECKING:
    import mujoco

_AT_START = " from its start"
_MAX_CONTACTS = 4096  # contacts at the start of a scene; a crowded table has a few hundred

# Attributes whose numbers are computed, and may be rounded differently on another machine.
_COMPUTED = frozenset(
    ["fullinertia", "mass", "pos", "quat", "qpos", "scale", "size", "vertex", "xyaxes"]
)
_ROUNDING = 1e-6  # relative to the largest number of the attribute
_NUMBER = re.compile(r"-?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:e[-+]?[0-9]+)?")
_ONE_TEXTURE = '<mujoco><asset><texture name="t" type="2d" file="t.png"/></asset></mujoco>'


def check_xml(decoded: Decoded, raw: bytes) -> str:
    """Compare a bundle's ``scene.xml`` with its values; return the document made from the values.

    Everything must be equal except computed numbers, which may be rounded differently on another
    machine.

    Raises:
        BundleError: the documents differ.
    """
    wanted = document(decoded.scene, paths=decoded.paths).xml
    if raw == wanted.encode():
        return wanted
    if difference := _difference(ET.fromstring(wanted), _parse(raw, 2 * len(wanted))):
        raise BundleError(
            f"scene.xml does not match scene.json: {difference}. Create the bundle again."
        )
    return wanted


def check_builds(decoded: Decoded, xml: str, contents: Mapping[str, bytes]) -> mujoco.MjModel:
    """Return MuJoCo's model of a scene's document, with a single pixel for each texture.

    Textures are built one at a time, since MuJoCo holds three copies of each while building.
    ``contents`` are the files to which the document refers, by path.

    Raises:
        SceneError: MuJoCo cannot build the scene.
    """
    name, files = decoded.scene.name, dict(contents)
    pixel = encode_png(np.zeros((1, 1, 3), np.uint8))
    for path in {texture for _, texture in decoded.paths.values()}:
        compile_spec(spec_of(Document(_ONE_TEXTURE, {"t.png": files[path]}), name), name)
        files[path] = pixel
    return compile_spec(spec_of(Document(xml, files), name), name)


def check_starts(model: mujoco.MjModel, name: str) -> None:
    """Check that MuJoCo can compute the forces at the start of the scene ``name``.

    Bodies that overlap completely may have more contacts than fit in MuJoCo's memory.

    Raises:
        SceneError: the forces cannot be computed.
    """
    import mujoco

    try:
        data = new_data(model)
        mujoco.mj_resetDataKeyframe(model, data, 0)
        with no_console():
            mujoco.mj_forward(model, data)
    except mujoco.FatalError as error:
        raise unsimulatable(name, str(error), _AT_START) from error
    said = [*list_warnings(data)]
    if data.ncon > _MAX_CONTACTS:
        said.append(f"the scene has {data.ncon} contacts; at most {_MAX_CONTACTS} are allowed")
    if not np.isfinite(data.qacc).all():
        said.append("some contact forces are not finite")
    if said:
        raise unsimulatable(name, said[0], _AT_START)


def _parse(raw: bytes, maximum: int) -> ET.Element:
    """Parse XML of at most ``maximum`` bytes; reject declarations, entities and comments."""
    if len(raw) > maximum:
        raise BundleError(
            f"scene.xml does not match scene.json: scene.xml has {len(raw)} bytes; at most "
            f"{maximum} are expected."
        )
    if b"<!" in raw or b"<?" in raw:
        raise BundleError(
            "scene.xml does not match scene.json: it contains a declaration or a comment."
        )
    try:
        return ET.fromstring(raw.decode())
    except (ET.ParseError, ValueError) as error:
        raise BundleError(f"scene.xml is not valid XML ({error}).") from error


def _difference(wanted: ET.Element, found: ET.Element) -> str:
    """Describe how two elements differ, or return "" if they are equal."""
    name = wanted.get("name", "")[:80]
    where = f"<{wanted.tag}{f' name={name!r}' if name else ''}>"
    if wanted.tag != found.tag:
        return f"the file has {found.tag[:80]!r} in place of {where}"
    if wanted.attrib.keys() != found.attrib.keys():
        return f"{where} has different attributes"
    for key, value in wanted.attrib.items():
        if not (value == found.attrib[key] or _close(key, value, found.attrib[key])):
            return f"{where} has {key}={found.attrib[key][:80]!r}, not {value[:80]!r}"
    if (found.text or "").strip() or (found.tail or "").strip():
        return f"{where} contains text"
    if len(wanted) != len(found):
        return f"{where} has {len(found)} elements, not {len(wanted)}"
    differences = (_difference(one, other) for one, other in zip(wanted, found, strict=True))
    return next((text for text in differences if text), "")


def _close(key: str, wanted: str, found: str) -> bool:
    """Return whether an attribute is computed and its numbers agree to within rounding."""
    words = found.split(" ")
    if key not in _COMPUTED or not all(map(_NUMBER.fullmatch, words)):
        return False
    numbers, others = [float(word) for word in wanted.split(" ")], [float(word) for word in words]
    allowed = _ROUNDING * max(map(abs, numbers))
    return len(numbers) == len(others) and all(
        abs(a - b) <= allowed for a, b in zip(numbers, others, strict=True)
    )
