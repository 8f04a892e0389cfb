"""Objects of the ``games`` theme: cards."""

from __future__ import annotations

from ...kit import prints, surfaces
from ...kit.parts import box_part
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import block, box
from ...kit.surfaces import RGB, Look
from .pieces import tile_piece


def _card_face(look: Look, color: RGB) -> surfaces.Tile:
    ink: RGB = (190, 30, 40) if look.chance(0.5) else (28, 28, 32)
    image = prints.canvas(96, 136, (250, 249, 244))
    rank = look.pick(["A", "K", "Q", "J", "7", "10", "2", "9"])
    prints.write(image, rank, 0.15, 0.11, 0.13, ink, bold=True)
    image = image[::-1, ::-1].copy()
    prints.write(image, rank, 0.15, 0.11, 0.13, ink, bold=True)
    mark = [(0.5, 0.3), (0.68, 0.5), (0.5, 0.7), (0.32, 0.5)]
    prints.polygon(image, mark, ink)
    return image


@category("playing_cards", size=(0.063, 0.088, 0.016), mass=0.095, material="paper",
          aliases=("deck of cards", "pack of cards", "cards", "card deck", "deck", "uno deck",
          "deck of uno cards"), themes=("games", "coffee"), roles=("flat",), state="lying flat",
          common=True)  # fmt: skip
def playing_cards(look: Look) -> Shape:
    """A neat deck of playing cards, face up."""
    x, y, h = 0.063, 0.088, look.between(0.014, 0.018)
    red = look.chance(0.5)
    ink: RGB = (190, 30, 40) if red else (28, 28, 32)
    face = prints.canvas(96, 134, (250, 249, 244))
    rank = look.pick(["A", "K", "Q", "J", "7", "10", "2", "9"])
    prints.write(face, rank, 0.14, 0.09, 0.11, ink, bold=True)
    face = face[::-1, ::-1].copy()
    prints.write(face, rank, 0.14, 0.09, 0.11, ink, bold=True)
    prints.disc(face, 0.5, 0.5, 0.19, ink)
    prints.disc(face, 0.5, 0.5, 0.11, (250, 249, 244))
    prints.fill(face, 0.42, 0.4, 0.16, 0.2, ink)
    edge = surfaces.stripes([(250, 249, 244), (206, 204, 198)], 12)
    back = look.color("navy", "crimson", "green", "black", "violet")
    return shape([(block(x, y, h, 0.003), edge), (box(x - 0.003, y - 0.003, 0.0006).move(z=h
                                                                                         - 0.0002),
                                                  face),
                  (box(x - 0.002, y - 0.002, 0.0008).move(z=0.0001), surfaces.plain(back))],
                 [box_part(x, y, h)])  # fmt: skip


CATEGORIES = (
    Category("playing_card", tile_piece(0.063, 0.088, 0.0012, _card_face, ("white", "cream")),
             size=(0.063, 0.088, 0.0012), mass=0.002, material="paper", friction=0.55,
             aliases=("single card", "ace of spades", "ace", "loose card", "face card", "joker",
             "ace of hearts", "two of hearts", "three of hearts", "four of hearts",
             "five of hearts", "six of hearts", "seven of hearts", "eight of hearts",
             "nine of hearts", "ten of hearts", "jack of hearts", "queen of hearts",
             "king of hearts", "two of spades", "three of spades", "four of spades",
             "five of spades", "six of spades", "seven of spades", "eight of spades",
             "nine of spades", "ten of spades", "jack of spades", "queen of spades",
             "king of spades", "ace of diamonds", "two of diamonds", "three of diamonds",
             "four of diamonds", "five of diamonds", "six of diamonds", "seven of diamonds",
             "eight of diamonds", "nine of diamonds", "ten of diamonds", "jack of diamonds",
             "queen of diamonds", "king of diamonds", "ace of clubs", "two of clubs",
             "three of clubs", "four of clubs", "five of clubs", "six of clubs", "seven of clubs",
             "eight of clubs", "nine of clubs", "ten of clubs", "jack of clubs", "queen of clubs",
             "king of clubs", "joker card", "uno card", "cut card", "red card", "yellow card",
             "optical illusion card", "report card"), themes=("games",), roles=("flat",),
             colors=("white",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
