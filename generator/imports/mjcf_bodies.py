"""Free bodies of a gathered MJCF model, compiled separately to find those that MuJoCo rejects."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from ..errors import InputError
from .foreign import Refusals
from .mjcf_files import SIDES, GatheredModel

if TYPE_CHECKING:
    import mujoco

    CompileModel = Callable[[GatheredModel, str], mujoco.MjModel]

MAX_REFUSED = 20
"""Maximum number of bodies left out because MuJoCo rejects them; with more, the import fails."""


def free_bodies(gathered: GatheredModel) -> list[str]:
    """Return the names of the world's child bodies that have a free joint."""
    found = _free_elements(ET.fromstring(gathered.xml))
    return [body.get("name") or f"body_{k + 1}" for k, (_, body) in enumerate(found)]


def keep_bodies(gathered: GatheredModel, which: Sequence[int]) -> GatheredModel:
    """Return the model with only the free bodies at indices ``which`` and without unused assets."""
    root = ET.fromstring(gathered.xml)
    for k, (world, body) in enumerate(_free_elements(root)):
        if k not in which:
            world.remove(body)
    for tag in ("mesh", "material", "texture"):  # textures last, since materials use them
        _drop_unused(root, tag)
    used = {e.get(name) for e in root.iter() for name in ("file", *SIDES)}
    files = {name: content for name, content in gathered.files.items() if name in used}
    return GatheredModel(ET.tostring(root, encoding="unicode"), files)


def _free_elements(root: ET.Element) -> list[tuple[ET.Element, ET.Element]]:
    """Return the world's child bodies that have a free joint, as (parent, body) pairs."""
    return [
        (world, body)
        for world in root.findall("worldbody")
        for body in world.findall("body")
        if body.find("freejoint") is not None
        or any(joint.get("type") == "free" for joint in body.findall("joint"))
    ]


def _drop_unused(root: ET.Element, tag: str) -> None:
    """Remove the assets with the given tag that no other element refers to."""
    used = {e.get(tag) for e in root.iter() if e.tag != tag}
    for asset in root.findall("asset"):
        for element in asset.findall(tag):
            if element.get("name") not in used:
                asset.remove(element)


def compile_sound(
    gathered: GatheredModel,
    what: str,
    refusals: Refusals,
    compile_model: CompileModel,
) -> mujoco.MjModel:
    """Return the compiled model, leaving out the free bodies that MuJoCo rejects.

    Raises:
        InputError: MuJoCo rejects the model for another reason, all its bodies, or more than
            ``MAX_REFUSED`` of them.
    """
    try:
        return compile_model(gathered, what)
    except InputError:
        names, found = free_bodies(gathered), Refusals()
        if len(names) < 2:
            raise
        sound = _list_sound(range(len(names)), names, gathered, what, found, compile_model)
        if not 0 < len(sound) < len(names) or len(found.outcomes) > MAX_REFUSED:
            raise
    refusals.outcomes += found.outcomes
    refusals.first = refusals.first or found.first
    return compile_model(keep_bodies(gathered, sound), what)


def _list_sound(
    which: Sequence[int],
    names: Sequence[str],
    gathered: GatheredModel,
    what: str,
    found: Refusals,
    compile_model: CompileModel,
) -> list[int]:
    """Return the bodies that compile, found by bisection; ``found`` collects the others.

    The search stops at one body beyond ``MAX_REFUSED``.
    """
    if len(found.outcomes) > MAX_REFUSED:
        return []
    if len(which) < len(names):  # all bodies together are already rejected
        try:
            compile_model(keep_bodies(gathered, which), what)
        except InputError as error:
            if len(which) == 1:
                found.add(names[which[0]], error)
                return []
        else:
            return [*which]
    half = len(which) // 2
    return [
        *_list_sound(which[:half], names, gathered, what, found, compile_model),
        *_list_sound(which[half:], names, gathered, what, found, compile_model),
    ]
