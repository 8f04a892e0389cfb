"""Regeneration of the starter bundles: ``python -m assets_cache.make_starter``.

It composes, checks and publishes fourteen tables of eight themes and several outlines in
``assets_cache/starter``, and the tables for specific tasks in ``assets_cache/tasks``. The same
catalogue gives the same bundles, byte for byte; unchanged bundles keep their certificates. Certify
the others afterwards; an interrupted certification resumes::

    python -m tabletopgen_env certify assets_cache/starter assets_cache/tasks --workers 2
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

from generator.bundle import save
from generator.composition import compose
from generator.errors import BundleError, SceneError
from generator.method.figures import preview

PROMPTS: Mapping[str, str] = {
    "office-desk": "an office desk with a laptop, a mouse, a notebook, a pen, a mug and a stapler",
    "office-round": "a small round table with a laptop, a mug, two books and an apple",
    "dining-two": "a round dining table for two",
    "dining-family": "a rectangular dining table with three plates, three forks, three tumblers, "
    "a bowl and a bottle",
    "dining-fruit": "an oval dining table with a bowl, an apple, an orange, a banana and a vase",
    "kitchen-baking": "a kitchen table with a mixing bowl, two eggs, a rolling pin and a mug",
    "kitchen-cutting": "a slatted kitchen table with a cutting board, a knife, a tomato, a carrot "
    "and a bowl",
    "coffee-square": "a square coffee table with two mugs, a book, a remote control and a candle",
    "coffee-oval": "an oval coffee table with a teapot, two cups and a plate",
    "workbench": "a workbench with a hammer, a screwdriver, a wrench, a tape measure and a box",
    "workbench-toys": "a triangular table with four toy blocks, a toy car and a bowl",
    "craft": "a crafting table with scissors, a yarn ball, a glue bottle, a tape roll and a cup",
    "vanity": "a round vanity table with a lipstick, a perfume bottle, a cream jar and a mirror",
    "lab": "a lab bench with a beaker, a flask, a test tube rack, a bottle and a notebook",
}
"""Names and prompts of the tables for any task."""

_KITCHEN = (
    "A wooden kitchen table with a large bowl, a wide cutting board, a small cucumber, a carrot "
    "and a salt shaker"
)
_COFFEE = "A round coffee table with a cup, an apple and a book"

Recipe = tuple[str, int]
"""A prompt and a seed."""

STARTERS: Mapping[str, Recipe] = {
    name: (prompt, 5 * number) for number, (name, prompt) in enumerate(PROMPTS.items())
}

TASKS: Mapping[str, Recipe] = {
    "kitchen-task-1": (_KITCHEN, 0),
    "kitchen-task-2": (_KITCHEN, 1),
    "kitchen-task-3": (_KITCHEN, 2),
    "coffee-table-task-1": (_COFFEE, 0),
    "coffee-table-task-2": (_COFFEE, 2),
    "coffee-table-task-3": (_COFFEE, 3),
    "tidy-task-1": ("A wooden table with a tray, a die, an egg, a lipstick and a toy block", 0),
    "tidy-task-2": ("An office desk with a desk tray, a marker, a glue stick, a die and a mug", 1),
    "tidy-task-3": ("A kitchen table with a large tray, two eggs, a lime and a salt shaker", 2),
}
"""Tables with the objects that a task needs, by name: the presets of Sequence, and Tidy.

With other seeds the apple may be wider than the gripper, or a neighbour may be too close.
"""

MOST_BYTES = 40 * 2**20
"""Maximum total size of all bundles, in bytes."""


def make(folder: Path, recipes: Mapping[str, Recipe]) -> list[Path]:
    """Compose scenes into ``folder``; return their bundle paths.

    Raises:
        SceneError: a scene fails the checks.
    """
    paths = []
    for name, (text, seed) in recipes.items():
        scene = compose(text, seed, name=name)
        paths.append(save(scene, folder, images={"preview": preview(scene)}))
        print(f"{paths[-1].name}: {len(scene.objects)} objects", flush=True)
    return paths


def remake(here: Path, folders: Mapping[str, Mapping[str, Recipe]]) -> None:
    """Compose all scenes, and then replace the bundle folders in ``here`` that have these names.

    Raises:
        SceneError: a scene fails the checks, or the bundles are too large in total.
    """
    with tempfile.TemporaryDirectory(dir=here, prefix=".starter-") as made:
        paths, kept = [], 0
        for name, recipes in folders.items():
            paths += make(Path(made) / name, recipes)
            kept += keep_certificates(here / name, Path(made) / name)
        weight = sum(p.stat().st_size for p in Path(made).rglob("*") if p.is_file())
        print(f"{len(paths)} bundles, {weight / 2**20:.1f} MB; {kept} keep their certificates")
        if weight > MOST_BYTES:
            raise SceneError(f"The bundles have {weight} bytes; the maximum is {MOST_BYTES}.")
        for name in folders:
            shutil.rmtree(here / name, ignore_errors=True)
            shutil.copytree(Path(made) / name, here / name)


def keep_certificates(old: Path, new: Path) -> int:
    """Copy the certificates that are still valid to the bundles in ``new``; return their number.

    Damaged certificates, and those of another scene, are not copied.
    """
    from tabletopgen_env.certificates.certificate import FILE, read_certificate

    kept = 0
    for path in sorted(new.iterdir()):
        if not (old / path.name / FILE).is_file():
            continue
        shutil.copyfile(old / path.name / FILE, path / FILE)
        try:
            read_certificate(path)
            kept += 1
        except BundleError as error:
            (path / FILE).unlink()
            print(f"the certificate was not kept: {error}")
    return kept


def main() -> int:
    """Regenerate the shipped bundles.

    Raises:
        SceneError: a scene fails the checks, or the bundles are too large in total.
    """
    remake(Path(__file__).parent, {"starter": STARTERS, "tasks": TASKS})
    return 0


if __name__ == "__main__":
    sys.exit(main())
