"""What is smoked: cigarettes, cigars, pipes."""

from __future__ import annotations

from ...build.category import Category
from ...build.recipes import open_vessel, put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import cylinder, join
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def cigarette(look: Look) -> Shape:
    """A cigarette lying, its filter to the right."""
    long = look.between(0.076, 0.095)
    color = look.color("white", "cream", "brown", "tan")
    r = 0.004 * look.between(0.9, 1.15)
    paper = straight((-0.5 * long, 0, 0.96 * r), (0.22 * long, 0, 0.96 * r), r, 14)
    tip = straight((0.219 * long, 0, 0.96 * r), (0.5 * long, 0, 0.96 * r), r, 14)
    leaf = straight((-0.5 * long - 0.0006, 0, 0.96 * r), (-0.49 * long, 0, 0.96 * r), 0.8 * r, 10)
    return put_down(
        [
            (paper, textures.plain(color)),
            (tip, textures.spots(look.rng, (222, 160, 90), (246, 206, 140), 0.15)),
            (leaf, textures.plain((110, 76, 46))),
        ],
        paper,
        tip,
    )


def cigar(look: Look) -> Shape:
    """A cigar lying with its band."""
    color = look.color("brown", "bronze", "tan", "terracotta")
    body = rod([(-0.07, 0, 0.0083), (-0.03, 0, 0.0083), (0.05, 0, 0.0083), (0.07, 0, 0.0083)],
               [0.0075, 0.0088, 0.0086, 0.0035], 14)  # fmt: skip
    band = straight((0.03, 0, 0.0083), (0.045, 0, 0.0083), 0.0091, 16)
    end = straight((-0.0705, 0, 0.0083), (-0.068, 0, 0.0083), 0.006, 12)
    return put_down(
        [
            (
                body,
                textures.scratches(look.rng, tint_color(color, 0.75), tint_color(color, 0.55), 80),
            ),
            (band, textures.plain(look.own_color("red", "gold", "green"))),
            (end, textures.plain((70, 54, 44))),
        ],
        body,
        factor=look.between(0.8, 1.15),
    )


def pipe(look: Look) -> Shape:
    """A tobacco pipe lying on its side against its bowl."""
    color = look.color("brown", "wooden", "bronze", "black", "terracotta")
    bowl, _ = open_vessel([(0.008, 0), (0.017, 0.004), (0.02, 0.02), (0.018, 0.045)], 0.005, 0.012)
    ash = cylinder(0.0125, 0.002, 16).move(z=0.034)
    stem = rod([(0.012, 0, 0.008), (0.05, 0, 0.012), (0.075, 0, 0.02)], [0.008, 0.006, 0.005], 10)
    bit = rod([(0.073, 0, 0.0195), (0.11, 0, 0.03), (0.135, 0, 0.031)], [0.0052, 0.004, 0.003], 10)
    foot = cylinder(0.0105, 0.004, 16)
    return put_down(
        [
            (join([bowl, stem, foot]), look.surface(color, "wood")),
            (ash, textures.plain((70, 56, 46))),
            (bit, textures.plain((34, 32, 32))),
        ],
        join([bowl, foot]),
        stem,
        bit,
        factor=look.between(0.9, 1.15),
        foot=0.3,
    )


CATEGORIES = (
    Category("cigarette", cigarette, (0.085, 0.008, 0.008), 0.001, ("filter cigarette",), ("living",
             ), (), ("white",), state="lying"),
    Category("cigar", cigar, (0.14, 0.018, 0.017), 0.012, ("cuban cigar",), ("living",), (),
             ("brown",), state="lying"),
    Category("smoking_pipe", pipe, (0.16, 0.042, 0.047), 0.05, ("tobacco pipe", "wooden pipe"),
             ("living",), (), ("brown",)),
)  # fmt: skip
"""The module's categories."""
