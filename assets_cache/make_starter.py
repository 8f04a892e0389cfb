"""Make the starter bundles anew: ``python -m assets_cache.make_starter``.

Fourteen tables over eight themes and several table outlines, composed, judged and published into
``assets_cache/starter``. The same catalogue gives the same bundles, byte for byte.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

from generator.bundle import save
from generator.compose import compose
from generator.errors import SceneError
from generator.figures import preview

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
"""Name and text of each starter scene."""

MOST_BYTES = 40 * 2**20
"""All starter bundles together stay below this."""


def make(folder: Path) -> list[Path]:
    """Compose every starter scene into ``folder``, each with a seed of its own.

    Raises:
        SceneError: a scene does not come to rest soundly, or all weigh too much.
    """
    paths = []
    for number, (name, prompt) in enumerate(PROMPTS.items()):
        scene = compose(prompt, 5 * number, name=name)
        paths.append(save(scene, folder, images={"preview": preview(scene)}))
        print(f"{paths[-1].name}: {len(scene.objects)} objects", flush=True)
    weight = sum(p.stat().st_size for path in paths for p in path.rglob("*") if p.is_file())
    print(f"{len(paths)} bundles, {weight / 2**20:.1f} MB")
    if weight > MOST_BYTES:
        raise SceneError(f"The starter bundles weigh {weight} bytes; at most {MOST_BYTES} may be.")
    return paths


def main() -> int:
    """Replace ``assets_cache/starter`` once all scenes are made."""
    target = Path(__file__).parent / "starter"
    with tempfile.TemporaryDirectory(dir=target.parent, prefix=".starter-") as made:
        make(Path(made))
        shutil.rmtree(target, ignore_errors=True)
        shutil.copytree(made, target)
        target.chmod(0o755)  # the temporary folder it is copied from is private
    return 0


if __name__ == "__main__":
    sys.exit(main())
