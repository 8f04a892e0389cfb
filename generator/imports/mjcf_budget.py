"""How much a foreign MJCF may make MuJoCo allocate, counted before it is compiled.

The limits of the child process hold for whatever is not counted here. What is counted ends with a
reason that says what to change.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping, Sequence

from ..errors import InputError
from ..meshes.reading.bounds import MOST_FACES, MOST_TEXELS, MOST_TEXELS_TOGETHER
from ..pictures import DamagedHeader, png_size

MOST_GEOMS = 10_000
"""Geoms of a model, those that replicates make counted each."""

MOST_COPIES = 200
"""Copies that one replicate makes."""

_UNUSED = (
    "size", "sensor", "keyframe", "custom", "actuator", "tendon", "equality", "contact",
)  # fmt: skip
"""Sections that no scene is read from."""


def drop_unused(root: ET.Element) -> None:
    """Remove the sections and attributes that an import ignores and a compiler spends time on."""
    for element in root.iter():
        element.attrib.pop("user", None)
        for child in element.findall("lengthrange"):  # simulates actuators for as long as it says
            element.remove(child)
    for section in [child for child in root if child.tag in _UNUSED]:
        root.remove(section)


def merge_textures(root: ET.Element) -> None:
    """Keep one of textures that differ in nothing but their names, as MuJoCo makes each of them."""
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
    """Check how many geoms and elements a model has once its replicates are expanded.

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
                    f"The model replicates a body {count.strip()[:40]!r} times; whole numbers up "
                    f"to {MOST_COPIES} are read. Correct the count, or replicate less."
                )
            times *= int(count)
        if geoms > MOST_GEOMS or elements > most_elements:
            raise InputError(
                f"The model has more than {MOST_GEOMS} geoms or {most_elements} elements, those "
                "that replicates make counted each. Replicate less, or take things out."
            )
        waiting += [(child, times) for child in element]


def check_assets(root: ET.Element, files: Mapping[str, bytes], sides: Iterable[str]) -> None:
    """Check how much the textures and meshes of a model unpack to.

    ``files`` are those that the model names, by name; ``sides`` the attributes that name the
    pictures of a cube. Equal textures are one (``merge_textures``); meshes count once for each
    element.

    Raises:
        InputError: a texture, or all, have too many texels; meshes have too many faces.
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
                    f"{MOST_TEXELS} of one, and {MOST_TEXELS_TOGETHER} of all, are read. Make "
                    "textures smaller or fewer."
                )
        elif element.tag == "mesh" and (name := element.get("file", "")) in files:
            faces += files[name].count(b"\nf") if name.endswith(".obj") else 0
            if faces > MOST_FACES:
                raise InputError(
                    f"The meshes of the model have more than {MOST_FACES} faces. Reduce them."
                )


def _file_texels(element: ET.Element, named: Sequence[bytes]) -> float:
    """Return how many texels MuJoCo makes of the files of a texture."""
    texels = sum(map(_texels_of, named))
    cells = math.prod(map(_number, element.get("gridsize", "1 1").split()))
    return max(texels, 6 * texels / cells) if cells > 1 else texels  # six cells are kept


def _texels_of(raw: bytes) -> int:
    """Return how many texels a PNG has, by its header; 0 if it is none, which MuJoCo refuses."""
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
    """Return a number that is not negative; 0 for a text that is none, which MuJoCo refuses."""
    try:
        value = float(text)
    except ValueError:
        return 0.0
    return math.inf if math.isnan(value) else max(value, 0.0)
