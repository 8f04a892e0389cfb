"""The commands that make scenes: ``generate`` and ``compose``."""

from __future__ import annotations

from pathlib import Path

from tyro.conf import Positional

from .printing import print_scene, progress
from .store import store


def generate(
    source: Positional[str],
    /,
    *,
    out: Path | None = None,
    name: str | None = None,
    seed: int = 0,
    backend: str = "embedded",
    figures: Path | None = None,
    allow_failed: bool = False,
    json: bool = False,
) -> int:
    """Turn a text, or a picture of a tabletop, into a simulated table.

    Args:
        source: A description ("a desk with a laptop and two mugs") or the path of a picture.
        out: Folder the bundle goes into; the user cache if left out.
        name: Name of the scene; made from the text if left out.
        seed: The same source and seed give the same scene.
        backend: Who answers the questions about text and image.
        figures: Also write the stage-by-stage pictures of the paper's Sec. 6.1 here.
        allow_failed: Publish even if the scene fails its physical gate.
        json: Print one JSON object instead of text.
    """
    from ..backends import Backends
    from ..bundle import check_name
    from ..pipeline import generate as run

    if name is not None:
        check_name(name)
    with progress(quiet=json) as shown:
        generation = run(source, Backends.select(backend), seed=seed, name=name, progress=shown)
        if figures is not None:
            generation.save_figures(figures)
        path = generation.save(store(out), allow_failed=allow_failed)
    return print_scene(path, generation.scene, json)


def compose(
    text: Positional[str],
    /,
    *,
    out: Path | None = None,
    name: str | None = None,
    seed: int = 0,
    json: bool = False,
) -> int:
    """Turn a text into a table directly, without drawing a picture first: seconds, not a minute.

    Args:
        text: A description ("a round dining table for two").
        out: Folder the bundle goes into; the user cache if left out.
        name: Name of the scene; made from the text if left out.
        seed: The same text and seed give the same scene.
        json: Print one JSON object instead of text.
    """
    from ..bundle import check_name, save
    from ..compose import compose as run
    from ..figures import preview

    if name is not None:
        check_name(name)
    scene = run(text, seed, name=name)
    path = save(scene, store(out), images={"preview": preview(scene)})
    return print_scene(path, scene, json)
