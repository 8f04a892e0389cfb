"""Names of objects that tables generated for a task must contain.

For each need, a table has one object drawn from the alternatives (``SceneDistribution.needs``). The
lists are based on the random variants of the catalogue's objects: they name objects that the hand
can grasp or push, or that can carry others. The task determines whether a table has a valid
instance; ``benchmarks/fresh_tables.py`` measures how often.
"""

from __future__ import annotations

Need = tuple[str, ...]
"""Alternative objects, one of which a scene must contain; see ``language.distribution.Needs``."""

STANDING: Need = (
    "toy block", "building brick", "die", "puzzle cube", "salt shaker", "cream jar",
    "earbuds case", "candle", "pill bottle", "nail polish", "thread spool", "chess piece",
    "matryoshka", "action camera", "glue stick", "lipstick", "can", "pepper shaker",
)  # fmt: skip
"""Small objects with a flat foot that the hand can grasp from any side."""

SMALL: Need = (
    *STANDING, "egg", "strawberry", "mushroom", "garlic", "lemon", "apple", "pear", "cupcake",
    "wristwatch", "figurine", "perfume bottle", "beaker",
)  # fmt: skip
"""Small objects of similar size, up to a hand's breadth across."""

TINY: Need = (
    "toy block", "building brick", "die", "salt shaker", "cream jar", "earbuds case",
    "nail polish", "thread spool", "chess piece", "glue stick", "egg", "strawberry", "mushroom",
    "garlic", "pill bottle", "lipstick", "wristwatch",
)  # fmt: skip
"""Objects so small that several fit into a tray."""

TRAYS: Need = ("large tray", "tray", "large basket", "basket", "large desk tray")
"""Containers for several objects."""

FLAT: Need = (
    "book", "notebook", "cutting board", "screw box", "pipette box", "button tin", "tea tin",
    "hard drive", "meat can", "wallet",
)  # fmt: skip
"""Objects with a low, flat top that can carry others."""

LOW: Need = (
    "toy block", "building brick", "puzzle cube", "die", "sponge", "cream jar", "screw box",
    "button tin", "hard drive", "cookie", "wallet", "pipette box", "sticky notes", "mortar",
)  # fmt: skip
"""Low, broad objects that slide before they topple."""
