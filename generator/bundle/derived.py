"""``scene.xml`` is derived: it must say what the values say, and nothing else."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Mapping

import numpy as np

from ..errors import BundleError
from ..mjcf import Document, compiled, document, spec_of
from ..png import encode_png
from .decoding import Decoded

_ROUNDING, _NEAR_ZERO = 1e-5, 1e-12
"""Numbers of two machines that write the same values differ by less."""

_ONE_TEXTURE = '<mujoco><asset><texture name="t" type="2d" file="t.png"/></asset></mujoco>'
_NUMBER = re.compile(r"-?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:e[-+]?[0-9]+)?")


def check_xml(decoded: Decoded, raw: bytes) -> str:
    """Compare a bundle's ``scene.xml`` with its values; return the document of the values.

    The same bytes are what the same machine writes. Computed numbers may end in another digit
    elsewhere: then elements, attributes and words must be the same, and numbers within rounding.

    Raises:
        BundleError: the document says something else.
    """
    wanted = document(decoded.scene, paths=decoded.paths).xml
    if raw != wanted.encode():
        difference = _difference(ET.fromstring(wanted), _parsed(raw, 2 * len(wanted)))
        if difference:
            raise BundleError(
                f"scene.xml does not fit scene.json: {difference}. Make the bundle again."
            )
    return wanted


def check_builds(decoded: Decoded, xml: str, contents: Mapping[str, bytes]) -> None:
    """Check that MuJoCo builds all that a scene's document draws.

    It keeps three copies of a texture meanwhile, so textures are built one by one, and the scene
    with a single pixel for each.

    Args:
        decoded: the scene.
        xml: its document.
        contents: the files that it refers to, by path.

    Raises:
        SceneError: it does not.
    """
    name, files = decoded.scene.name, dict(contents)
    pixel = encode_png(np.zeros((1, 1, 3), np.uint8))
    for path in {texture for _, texture in decoded.paths.values()}:
        compiled(spec_of(Document(_ONE_TEXTURE, {"t.png": files[path]}), name), name)
        files[path] = pixel
    compiled(spec_of(Document(xml, files), name), name)


def _parsed(raw: bytes, most: int) -> ET.Element:
    """Parse plain elements of at most ``most`` bytes: no declarations, entities or comments."""
    if len(raw) > most:
        raise BundleError(f"scene.xml does not fit scene.json: it has {len(raw)} bytes.")
    if b"<!" in raw or b"<?" in raw:
        raise BundleError("scene.xml does not fit scene.json: it holds more than elements.")
    try:
        return ET.fromstring(raw.decode())
    except (ET.ParseError, ValueError) as error:
        raise BundleError(f"scene.xml is no XML ({error}).") from error


def _difference(wanted: ET.Element, found: ET.Element) -> str:
    """Say where two elements differ; empty where they do not."""
    name = wanted.get("name", "")[:80]
    where = f"<{wanted.tag}{f' name={name!r}' if name else ''}>"
    if wanted.tag != found.tag:
        return f"{found.tag[:80]!r} is where {where} should be"
    if wanted.attrib.keys() != found.attrib.keys():
        return f"{where} has other attributes"
    for key, value in wanted.attrib.items():
        if not _same(value, found.attrib[key]):
            return f"{where} has {key}={found.attrib[key][:80]!r}, not {value[:80]!r}"
    if (found.text or "").strip() or (found.tail or "").strip():
        return f"{where} holds text"
    if len(wanted) != len(found):
        return f"{where} has {len(found)} elements, not {len(wanted)}"
    return next(filter(None, map(_difference, wanted, found)), "")


def _same(wanted: str, found: str) -> bool:
    """Return whether two attributes are equal, or lists of numbers that are within rounding."""
    if wanted == found:
        return True
    words, others = wanted.split(" "), found.split(" ")
    return len(words) == len(others) and all(map(_is_close, words, others))


def _is_close(wanted: str, found: str) -> bool:
    """Return whether two words are equal, or decimals within rounding; integers are exact."""
    integer = wanted.lstrip("-").isdecimal()
    if wanted == found or integer or not (_NUMBER.fullmatch(wanted) and _NUMBER.fullmatch(found)):
        return wanted == found
    return math.isclose(float(wanted), float(found), rel_tol=_ROUNDING, abs_tol=_NEAR_ZERO)
