"""What a table generated for a task must hold, by names of things.

A table has one thing for each need, drawn among those that fill it (``SceneDistribution.needs``).
The lists follow from the catalogue's variants: what the hand can take, push or put things on. The
task decides whether a table offers something to do; ``benchmarks/fresh_tables.py`` counts how
often.
"""

from __future__ import annotations

Need = tuple[str, ...]
"""Alternatives of a need; several make up ``generator.language.distribution.Needs``."""

STANDING: Need = (
    "toy block", "building brick", "die", "puzzle cube", "salt shaker", "cream jar",
    "earbuds case", "candle", "pill bottle", "nail polish", "thread spool", "chess piece",
    "matryoshka", "action camera", "glue stick", "lipstick", "can", "pepper shaker",
)  # fmt: skip
"""Small things with a flat foot that the hand takes from any side."""

SMALL: Need = (
    *STANDING, "egg", "strawberry", "mushroom", "garlic", "lemon", "apple", "pear", "cupcake",
    "wristwatch", "figurine", "perfume bottle", "beaker",
)  # fmt: skip
"""Small things of like size, up to a hand's breadth across."""

TINY: Need = (
    "toy block", "building brick", "die", "salt shaker", "cream jar", "earbuds case",
    "nail polish", "thread spool", "chess piece", "glue stick", "egg", "strawberry", "mushroom",
    "garlic", "pill bottle", "lipstick", "wristwatch",
)  # fmt: skip
"""Things of which several go into a tray."""

TRAYS: Need = ("large tray", "tray", "large basket", "basket", "large desk tray")
"""Containers for several things."""

FLAT: Need = (
    "book", "notebook", "cutting board", "screw box", "pipette box", "button tin", "tea tin",
    "hard drive", "meat can", "wallet",
)  # fmt: skip
"""Things with a flat top to put others on, not too high."""

LOW: Need = (
    "toy block", "building brick", "puzzle cube", "die", "sponge", "cream jar", "screw box",
    "button tin", "hard drive", "cookie", "wallet", "pipette box", "sticky notes", "mortar",
)  # fmt: skip
"""Low, broad things that slide before they topple."""
