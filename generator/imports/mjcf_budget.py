"""Limits on the memory that MuJoCo allocates for a foreign MJCF model, checked before compilation.

The limits of the child process apply to everything that is not counted here. The checks here give a
reason and a fix.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping, Sequence

from ..errors import InputError
from ..meshes.reading.bounds import MOST_FACES, MOST_TEXELS, MOST_TEXELS_TOGETHER
from ..pictures import DamagedHeader, png_size

MOST_GEOMS = 10_000
"""Maximum number of geoms of a model, including replicated ones."""

MOST_COPIES = 200
"""Maximum number of copies per replicate element."""

_UNUSED = (
    "size", "sensor", "keyframe", "custom", "actuator", "tendon", "equality", "contact",
)  # fmt: skip
"""MJCF sections that are ignored when a scene is read."""


def drop_unused(root: ET.Element) -> None:
    """Remove sections and attributes that an import ignores but that would lengthen compilation."""
    for element in root.iter():
        element.attrib.pop("user", None)
        for child in element.findall("lengthrange"):  # simulates actuators for an arbitrary time
            element.remove(child)
    for section in [child for child in root if child.tag in _UNUSED]:
        root.remove(section)


def merge_textures(root: ET.Element) -> None:
    """Merge textures that differ only in name, since MuJoCo allocates memory for each of them."""
    kept: dict[tuple[tuple[str, str], ...], str] = {}
    renamed: dict[str, str] = {}
    for asset in root.findall("asset"):
        for texture in [child for child in asset.findall("texture") if child.get("name")]:
            key = tuple(sorted((k, v) for k, v in texture.items() if k != "name"))
            name = texture.attrib["name"]
            if kept.setdefault(key, name) != name:
                renamed[name] = kept[key]
                asset.remove(texture)
    for element in root.iter():
        if (name := element.get("texture", "")) in renamed:
            element.set("texture", renamed[name])


def check_copies(root: ET.Element, most_elements: int) -> None:
    """Check the numbers of geoms and elements that a model has once ``replicate`` is expanded.

    Raises:
        InputError: there are more than ``MOST_GEOMS`` geoms or ``most_elements``.
    """
    waiting = [(root, 1)]
    elements = geoms = 0
    while waiting:
        element, times = waiting.pop()
        elements += times
        geoms += times * (element.tag == "geom")
        if element.tag == "replicate":
            count = element.get("count", "1")
            if not _is_few(count):
                raise InputError(
                    f"The model replicates a body {count.strip()[:40]!r} times; only whole numbers "
                    f"up to {MOST_COPIES} are allowed. Correct the count, or make fewer copies."
                )
            times *= int(count)
        if geoms > MOST_GEOMS or elements > most_elements:
            raise InputError(
                f"The model has more than {MOST_GEOMS} geoms or {most_elements} elements, "
                "including replicated ones. Make fewer copies, or remove objects."
            )
        waiting += [(child, times) for child in element]


def check_assets(root: ET.Element, files: Mapping[str, bytes], sides: Iterable[str]) -> None:
    """Check the decompressed size of a model's textures and meshes.

    ``files`` are the model's files, by name; ``sides`` the attributes that refer to the pictures of
    a cube. Equal textures count once (``merge_textures``), meshes once per element.

    Raises:
        InputError: a texture, or all textures together, have too many texels, or the meshes have
            too many faces.
    """
    texels = faces = 0
    for element in root.iter():
        if element.tag == "texture":
            named = [files[n] for s in ("file", *sides) if (n := element.get(s, "")) in files]
            own = _file_texels(element, named) if named else _builtin_texels(element)
            texels += own
            if own > MOST_TEXELS or texels > MOST_TEXELS_TOGETHER:
                raise InputError(
                    f"The texture {element.get('name', '')[:80]!r} has {own:.4g} texels; at most "
                    f"{MOST_TEXELS} are allowed, and {MOST_TEXELS_TOGETHER} for all textures. Use "
                    "smaller or fewer textures."
                )
        elif element.tag == "mesh" and (name := element.get("file", "")) in files:
            faces += files[name].count(b"\nf") if name.endswith(".obj") else 0
            if faces > MOST_FACES:
                raise InputError(
                    f"The meshes of the model have more than {MOST_FACES} faces. Simplify the "
                    "meshes."
                )


def _file_texels(element: ET.Element, named: Sequence[bytes]) -> float:
    """Return the number of texels that MuJoCo allocates for the files of a texture."""
    texels = sum(map(_texels_of, named))
    cells = math.prod(map(_number, element.get("gridsize", "1 1").split()))
    return max(texels, 6 * texels / cells) if cells > 1 else texels  # six sides are stored


def _texels_of(raw: bytes) -> int:
    """Return a PNG's texel count from its header, or 0 for other files, which MuJoCo rejects."""
    try:
        return math.prod(png_size(raw))
    except DamagedHeader:
        return 0


def _builtin_texels(element: ET.Element) -> float:
    width, height = (_number(element.get(side, "0")) for side in ("width", "height"))
    flat = element.get("type", "cube") == "2d"
    channels = max(3.0, _number(element.get("nchannel", "3")))
    return width * (height if flat else 6 * width) * channels / 3


def _is_few(text: str) -> bool:
    digits = text.strip()
    return digits.isdecimal() and len(digits) < 10 and int(digits) <= MOST_COPIES


def _number(text: str) -> float:
    """Parse a nonnegative number; return 0 for invalid text, which MuJoCo rejects anyway."""
    try:
        value = float(text)
    except ValueError:
        return 0.0
    return math.inf if math.isnan(value) else max(value, 0.0)
