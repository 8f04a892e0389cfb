"""A picture of a table with one thing, to be rebuilt: the least work that a photo makes."""

from pathlib import Path

import numpy as np
from posing.truth import photograph

from generator.composition import compose
from generator.io.pictures import write_picture


def take_picture(path: Path, text: str = "a die") -> None:
    """Write a picture of a composed table, drawn without OpenGL."""
    path.parent.mkdir(parents=True, exist_ok=True)
    truth = photograph(text, compose(text, 0), np.random.default_rng(0))
    write_picture(np.asarray(truth.picture), path)
