"""Cut flowers by the stem: bulbs of spring, border and meadow flowers, blooms of the tropics."""

from __future__ import annotations

from ...build.category import Category
from ...build.variants import vary
from ..nature.flowers import Head, on_stem
from .heads import (
    GOLD,
    cluster,
    crane,
    cup,
    daffodil,
    iris,
    layered_head,
    open_head,
    pansy,
    protea,
    snowdrop,
    spike,
    thistle,
)

DARK = (34, 26, 40)
_PEONY = layered_head([(9, 0.03, 0.024, 0.3, 0), (8, 0.027, 0.022, 0.75, 0.002),
                  (7, 0.023, 0.02, 1.1, 0.004), (4, 0.017, 0.014, 1.35, 0.006)], 0.008, None,
                 0.06)  # fmt: skip
_DAHLIA = layered_head([(14, 0.034, 0.012, 0.08, 0), (12, 0.029, 0.011, 0.4, 0.002),
                   (10, 0.023, 0.01, 0.75, 0.004), (7, 0.016, 0.008, 1.1, 0.006)], 0.006, None,
                  0.09)  # fmt: skip
_MUM = layered_head([(18, 0.031, 0.007, 0.05, 0), (17, 0.028, 0.0065, 0.4, 0.002),
                (14, 0.023, 0.006, 0.75, 0.004), (9, 0.016, 0.006, 1.1, 0.005)], 0.006, None,
               0.05)  # fmt: skip
_GERBERA = layered_head([(20, 0.038, 0.0085, 0.08, 0), (15, 0.026, 0.007, 0.25, 0.002)], 0.0105,
                   (70, 44, 30), 0.12)  # fmt: skip
_MARIGOLD = layered_head([(14, 0.023, 0.014, 0.1, 0), (12, 0.02, 0.013, 0.5, 0.002),
                     (10, 0.016, 0.011, 0.9, 0.004), (6, 0.012, 0.009, 1.25, 0.005)], 0.006, None,
                    0.08)  # fmt: skip
_ZINNIA = layered_head([(15, 0.03, 0.012, 0.05, 0), (13, 0.025, 0.011, 0.3, 0.003),
                   (10, 0.019, 0.009, 0.6, 0.005)], 0.0085, GOLD, 0.08)  # fmt: skip
_CAMELLIA = layered_head([(7, 0.027, 0.024, 0.15, 0), (6, 0.023, 0.02, 0.5, 0.002),
                     (6, 0.018, 0.016, 0.85, 0.004), (4, 0.012, 0.011, 1.2, 0.005)], 0.004, GOLD,
                    0.04)  # fmt: skip
_MAGNOLIA = layered_head([(6, 0.048, 0.028, 0.45, 0), (5, 0.042, 0.026, 0.95, 0.001)], 0.007,
                    (150, 160, 70), -0.04)  # fmt: skip
_DANDELION = layered_head([(22, 0.02, 0.0045, 0.05, 0), (20, 0.018, 0.0045, 0.45, 0.001),
                      (14, 0.014, 0.004, 0.85, 0.002)], 0.005, None, 0.06)  # fmt: skip
_CORNFLOWER = layered_head([(11, 0.025, 0.009, 0.2, 0), (9, 0.018, 0.006, 0.6, 0.001)], 0.006,
                      (70, 40, 120), 0.1)  # fmt: skip
_EDELWEISS = layered_head([(9, 0.024, 0.008, 0.05, 0), (6, 0.016, 0.007, 0.2, 0.002)], 0.007,
                     (214, 196, 100), 0.03)  # fmt: skip


def _row(
    key: str, head: Head, colors: tuple[str, ...], long: float, mass: float, *aliases: str,
    leaves: int = 2, nod: float = 0.9, leaf: tuple[float, float] = (0.06, 0.018),
) -> Category:  # fmt: skip
    made = on_stem(head, colors, long, leaves=leaves, nod=nod, leaf=leaf)
    return Category(
        key,
        made,
        _SIZES.get(key, (0.1, 0.1, 0.1)),
        mass,
        aliases,
        ("living",),
        (),
        colors[:2],
        state="lying flat",
    )


_SIZES: dict[str, tuple[float, float, float]] = {
    "daffodil": (0.212, 0.0687, 0.0468),
    "iris": (0.242, 0.0925, 0.0773),
    "poppy": (0.2, 0.0699, 0.0346),
    "peony": (0.216, 0.0649, 0.0478),
    "chrysanthemum": (0.218, 0.0701, 0.0527),
    "dahlia": (0.215, 0.076, 0.0551),
    "gerbera": (0.237, 0.0871, 0.0433),
    "marigold": (0.169, 0.0513, 0.0373),
    "zinnia": (0.2, 0.0685, 0.046),
    "camellia": (0.169, 0.0599, 0.0386),
    "gardenia": (0.167, 0.0599, 0.0386),
    "magnolia": (0.225, 0.0861, 0.0872),
    "dandelion": (0.169, 0.0495, 0.0328),
    "cornflower": (0.188, 0.0558, 0.0343),
    "edelweiss": (0.163, 0.0543, 0.0266),
    "anemone": (0.2, 0.0609, 0.0278),
    "hibiscus": (0.191, 0.0961, 0.065),
    "petunia": (0.172, 0.0636, 0.0298),
    "primrose": (0.159, 0.0487, 0.0199),
    "pansy": (0.168, 0.0598, 0.0216),
    "hydrangea": (0.23, 0.0893, 0.0887),
    "geranium": (0.195, 0.0611, 0.0604),
    "forget_me_not": (0.166, 0.0406, 0.0377),
    "hyacinth": (0.239, 0.0787, 0.0804),
    "gladiolus": (0.359, 0.0842, 0.0642),
    "foxglove": (0.3, 0.0726, 0.0761),
    "hollyhock": (0.33, 0.1, 0.105),
    "freesia": (0.227, 0.0599, 0.0449),
    "bluebell": (0.232, 0.0562, 0.0327),
    "crocus": (0.186, 0.0456, 0.0306),
    "snowdrop": (0.168, 0.0398, 0.0234),
    "thistle": (0.19, 0.0483, 0.0404),
    "bird_of_paradise": (0.29, 0.0482, 0.126),
    "protea": (0.225, 0.064, 0.0646),
}

_BLADE = (0.11, 0.011)

CATEGORIES = (
    _row("daffodil", daffodil, ("yellow", "yellow", "white", "cream"), 0.2, 0.015, "narcissus",
         "jonquil", "daffodil stem", leaf=_BLADE),
    _row("iris", iris, ("purple", "indigo", "blue", "violet", "white"), 0.22, 0.02, "iris flower",
         "purple iris", "iris stem", "irises", nod=0.3, leaf=_BLADE),
    _row("poppy", open_head(5, 0.034, 0.034, 0.35, 0.0075, DARK), ("red", "red", "orange", "coral"),
             0.19, 0.008, "poppies", "red poppy", "poppy flower", "remembrance poppy", leaves=1,
             nod=1.1),
    _row("peony", _PEONY, ("pink", "pink", "white", "magenta", "coral"), 0.21, 0.03, "peonies",
         "peony flower", "ranunculus", "pink peony", leaf=(0.07, 0.026), nod=0.75),
    _row("chrysanthemum", _MUM, ("yellow", "white", "pink", "amber", "maroon"), 0.21, 0.02,
         "chrysanth", "pom pom flower", "mum flower", nod=0.85),
    _row("dahlia", _DAHLIA, ("crimson", "pink", "orange", "purple", "yellow"), 0.21, 0.025,
         "dahlia flower", nod=0.85, leaf=(0.06, 0.026)),
    _row("gerbera", _GERBERA, ("orange", "pink", "red", "yellow", "coral"), 0.22, 0.018,
         "gerbera daisy", "gerber daisy", "gerbera flower", leaves=0, nod=1.05),
    _row("marigold", _MARIGOLD, ("orange", "orange", "gold", "yellow"), 0.15, 0.012, "calendula",
         "marigold flower", leaf=(0.05, 0.016)),
    _row("zinnia", _ZINNIA, ("pink", "orange", "red", "magenta"), 0.19, 0.014, "zinnia flower"),
    _row("camellia", _CAMELLIA, ("pink", "red", "white", "crimson"), 0.14, 0.015,
         "camellia flower", leaf=(0.06, 0.03), leaves=3),
    vary(_row("gardenia", _CAMELLIA, ("white", "ivory"), 0.13, 0.014, "gardenia flower",
             "jasmine",
         leaf=(0.06, 0.03), leaves=3)),
    _row("magnolia", _MAGNOLIA, ("white", "pink", "cream"), 0.19, 0.02, "magnolia flower",
         "magnolia blossom", leaf=(0.07, 0.03), nod=0.5),
    vary(_row("dandelion", _DANDELION, ("yellow", "gold"), 0.16, 0.006, "dandelion flower",
             leaves=1,
         leaf=(0.06, 0.014), nod=0.9)),
    _row("cornflower", _CORNFLOWER, ("blue", "indigo", "blue"), 0.18, 0.006, "knapweed",
         "bachelor's button", leaf=(0.06, 0.006)),
    vary(_row("edelweiss", _EDELWEISS, ("white", "ivory"), 0.12, 0.006, "edelweiss flower",
         leaf=(0.04, 0.008), nod=1.05)),
    _row("anemone", open_head(8, 0.027, 0.02, 0.2, 0.008, DARK, (240, 236, 240)), ("purple", "red",
         "blue", "magenta"), 0.18, 0.01, "anemone flower", "windflower", "cosmos", nod=1.1),
    vary(_row("hibiscus", open_head(5, 0.046, 0.038, 0.3, 0.006, (250, 210, 70), (150, 20, 50),
    0.05),
         ("red", "pink", "orange", "coral"), 0.16, 0.015, "hibiscus flower", "mallow",
         leaf=(0.07, 0.036), nod=1.0)),
    vary(_row("petunia", open_head(5, 0.03, 0.028, 0.25, 0.005, (250, 240, 180), (246, 240, 246)),
         ("purple", "magenta", "pink", "red"), 0.13, 0.008, "petunia flower", "morning glory",
         "begonia", leaf=(0.045, 0.024), nod=1.1)),
    vary(_row("primrose", open_head(5, 0.02, 0.018, 0.1, 0.004, (240, 180, 40), (246, 214, 80)),
         ("yellow", "pink", "purple", "white"), 0.12, 0.006, "primula", "buttercup", "cowslip",
         "oxlip", leaf=(0.06, 0.028), nod=1.1)),
    _row("pansy", pansy, ("purple", "purple", "maroon", "blue"), 0.12, 0.006, "pansies",
         "violet flower", "pansy flower", "sweet violet", nod=1.2, leaf=(0.04, 0.018)),
    _row("hydrangea", cluster(60, 0.036, 0.022), ("blue", "pink", "lavender", "white"), 0.2, 0.04,
         "hydrangea head", "hydrangea flower", "hydrangea stem", "lilac", leaf=(0.08, 0.045),
         nod=0.3),
    _row("geranium", cluster(30, 0.024, 0.02), ("red", "pink", "coral", "white"), 0.17, 0.015,
         "geranium flower", "pelargonium", "verbena", leaf=(0.05, 0.045), nod=0.35),
    vary(_row("forget_me_not", cluster(18, 0.015, 0.012, (250, 220, 80)), ("sky", "sky", "blue"),
             0.12,
         0.004, "forget-me-not", "statice", "statice bunch", "baby's breath", "gypsophila",
         leaf=(0.04, 0.01), nod=0.4)),
    vary(_row("hyacinth", spike(26, 0.075, 0.032, 0.011, 1.2), ("blue", "pink", "purple",
             "white"),
         0.13, 0.03, "hyacinth flower", "grape hyacinth", "muscari", leaf=(0.12, 0.016), nod=0.06)),
    _row("gladiolus", spike(12, 0.15, 0.03, 0.018, 0.9, one_side=True), ("red", "pink", "coral",
             "white", "purple"), 0.2, 0.04, "gladioli", "gladiola", "sword lily", "gladioluses",
             leaf=(0.14, 0.016), nod=0.05),
    _row("foxglove", spike(18, 0.12, 0.024, 0.0115, 2.2), ("purple", "pink", "magenta", "white"),
         0.17, 0.02, "foxglove flower", "penstemon", "snapdragon", leaf=(0.08, 0.03), nod=0.06),
    vary(_row("hollyhock", spike(12, 0.13, 0.028, 0.0175, 1.3), ("pink", "maroon", "white",
             "yellow"),
         0.18, 0.03, "delphinium", "larkspur", "lupin", "lupine", leaf=(0.06, 0.045), nod=0.06)),
    vary(_row("freesia", spike(7, 0.06, 0.016, 0.013, 0.5, one_side=True), ("yellow", "white",
             "pink",
         "lavender"), 0.16, 0.01, "freesia flower", "alstroemeria", leaf=_BLADE, nod=0.25)),
    vary(_row("bluebell", spike(10, 0.07, 0.018, 0.009, 2.5, one_side=True), ("indigo", "blue",
         "violet"), 0.15, 0.006, "bluebell flower", "harebell", "lily of the valley", leaf=_BLADE,
         nod=0.2)),
    vary(_row("crocus", cup(3, 0.04, 0.018, 1.3), ("purple", "lavender", "yellow", "white"), 0.09,
         0.006, "crocuses", "crocus flower", "saffron crocus", leaf=(0.07, 0.005), nod=0.1)),
    vary(_row("snowdrop", snowdrop, ("white", "white", "ivory"), 0.11, 0.003, "snowdrop flower",
         leaf=(0.07, 0.006), nod=-0.5)),
    _row("thistle", thistle, ("purple", "magenta", "violet"), 0.17, 0.01, "scottish thistle",
         "thistle head", "sea holly", leaf=(0.07, 0.014), nod=0.2),
    vary(_row("bird_of_paradise", crane, ("orange", "orange", "amber"), 0.22, 0.03, "strelitzia",
         "bird of paradise flower", "heliconia", leaves=1, leaf=(0.1, 0.04), nod=0.1)),
    vary(_row("protea", protea, ("pink", "coral", "crimson"), 0.18, 0.05, "protea flower",
         "king protea", "banksia", leaf=(0.07, 0.018), leaves=3, nod=0.2)),
)  # fmt: skip
"""The module's categories."""
