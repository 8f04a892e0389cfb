"""Loose papers by kind: letters, bills, certificates, plans, reports, maps of the stars."""

from __future__ import annotations

import numpy as np

from ...build.making import Drawing, at_box, dye, spindle
from ...build.recipes import Pieces
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import RGB
from ...surfaces.look import Look
from ..rows import Rows
from .papers import GRAY, INK, paper


def _invoice(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.fill(image, 0, 0, 1, 0.05, accent)
    prints.write(image, look.pick(["INVOICE", "BILL"]), 0.3, 0.11, 0.06, accent, True)
    prints.lines(image, look.rng, (0.08, 0.18, 0.4, 0.1), 4, GRAY)
    for k in range(8):
        prints.fill(image, 0.08, 0.34 + 0.055 * k, 0.84, 0.003, GRAY)
        prints.lines(image, look.rng, (0.1, 0.355 + 0.055 * k, 0.4, 0.03), 1, INK, 0.5)
        prints.fill(image, 0.78, 0.36 + 0.055 * k, 0.12, 0.014, INK)
    prints.fill(image, 0.6, 0.82, 0.32, 0.06, accent)
    prints.write(image, "TOTAL", 0.76, 0.85, 0.035, (250, 250, 246), True)


def _contract(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.write(image, "CONTRACT", 0.5, 0.09, 0.06, INK, True)
    prints.lines(image, look.rng, (0.1, 0.16, 0.8, 0.58), 18, GRAY)
    for x in (0.1, 0.56):
        prints.fill(image, x, 0.87, 0.34, 0.006, INK)
        way = [(x + 0.03 + 0.03 * k, 0.85 - 0.03 * (k % 2) - 0.01 * np.sin(k)) for k in range(9)]
        prints.stroke(image, way, 0.008, (40, 60, 150))


def _letterhead(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.disc(image, 0.16, 0.08, 0.04, accent)
    prints.fill(image, 0.26, 0.06, 0.4, 0.02, accent)
    prints.lines(image, look.rng, (0.1, 0.18, 0.4, 0.08), 3, GRAY)
    prints.lines(image, look.rng, (0.1, 0.32, 0.8, 0.44), 13, INK)
    prints.stroke(
        image, [(0.12 + 0.03 * k, 0.86 - 0.03 * (k % 2)) for k in range(9)], 0.008, (40, 60, 150)
    )


def _resume(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.fill(image, 0, 0, 0.32, 1, accent)
    prints.disc(image, 0.16, 0.12, 0.07, (232, 200, 172))
    prints.lines(image, look.rng, (0.05, 0.26, 0.22, 0.5), 12, (226, 226, 230))
    prints.write(image, "RESUME", 0.66, 0.08, 0.06, INK, True)
    for y in (0.18, 0.45, 0.7):
        prints.fill(image, 0.38, y, 0.3, 0.016, accent)
        prints.lines(image, look.rng, (0.38, y + 0.04, 0.54, 0.18), 6, GRAY)


def _cheque(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.write(image, "BANK", 0.16, 0.18, 0.15, accent, True)
    prints.fill(image, 0.08, 0.46, 0.6, 0.012, INK)
    prints.stroke(
        image, [(0.1 + 0.03 * k, 0.4 - 0.05 * (k % 2)) for k in range(14)], 0.02, (40, 60, 150)
    )
    prints.fill(image, 0.74, 0.34, 0.2, 0.18, (250, 250, 248))
    prints.write(image, "250.00", 0.84, 0.43, 0.12, INK)
    prints.fill(image, 0.08, 0.66, 0.5, 0.012, INK)
    prints.fill(image, 0.66, 0.76, 0.28, 0.012, INK)
    prints.stroke(
        image, [(0.68 + 0.025 * k, 0.72 - 0.06 * (k % 2)) for k in range(9)], 0.02, (40, 60, 150)
    )
    prints.fill(image, 0.08, 0.88, 0.6, 0.05, GRAY)


def _coupon(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.fill(image, 0.02, 0.05, 0.96, 0.9, accent)
    prints.fill(image, 0.68, 0.05, 0.012, 0.9, (250, 250, 246))
    prints.write(
        image, look.pick(["20% OFF", "GIFT 50", "FREE"]), 0.34, 0.42, 0.3, (250, 250, 246), True
    )
    prints.lines(image, look.rng, (0.1, 0.7, 0.45, 0.14), 2, (236, 230, 226))
    prints.barcode(image, look.rng, 0.73, 0.36, 0.22)


def _blueprint(look: Look, image: prints.Canvas, accent: RGB) -> None:
    image[:] = (34, 78, 150)
    pale: RGB = (214, 228, 246)
    for k in range(1, 12):
        prints.fill(image, k / 12, 0, 0.003, 1, (58, 102, 172))
        prints.fill(image, 0, k / 12, 1, 0.004, (58, 102, 172))
    for path in ([(0.1, 0.12), (0.72, 0.12), (0.72, 0.75), (0.1, 0.75), (0.1, 0.12)], [(0.4,
             0.12), (0.4, 0.5)],
                 [(0.1, 0.5), (0.3, 0.5)], [(0.5, 0.5), (0.72, 0.5)], [(0.4, 0.75), (0.4,
             0.62)]):  # fmt: skip
        prints.stroke(image, path, 0.014, pale)
    prints.disc(image, 0.4, 0.5, 0.11, pale, 0.1)
    prints.fill(image, 0.76, 0.72, 0.2, 0.22, pale)
    prints.lines(image, look.rng, (0.78, 0.75, 0.16, 0.16), 4, (34, 78, 150))


def _floor(look: Look, image: prints.Canvas, accent: RGB) -> None:
    for path in ([(0.1, 0.12), (0.9, 0.12), (0.9, 0.85), (0.1, 0.85), (0.1, 0.12)], [(0.45, 0.12),
             (0.45, 0.5)],
                 [(0.1, 0.5), (0.3, 0.5)], [(0.55, 0.5), (0.9, 0.5)], [(0.45, 0.85), (0.45,
             0.66)]):  # fmt: skip
        prints.stroke(image, path, 0.02, INK)
    prints.fill(image, 0.16, 0.2, 0.16, 0.2, (190, 206, 226))
    prints.fill(image, 0.65, 0.22, 0.16, 0.12, (226, 206, 180))
    prints.disc(image, 0.66, 0.68, 0.08, (206, 222, 196))


def _booklet(title: tuple[str, ...], *colors: str) -> Drawing:
    """A small booklet: slips between covers."""

    def draw(look: Look) -> Pieces:
        color = look.color(*colors)
        cover = prints.canvas(144, 72, color)
        ink = (250, 250, 246) if sum(color) < 420 else (34, 40, 60)
        prints.write(cover, look.pick(title), 0.5, 0.4, 0.2, ink, True)
        prints.fill(cover, 0.25, 0.66, 0.5, 0.03, ink)  # type: ignore[arg-type]
        return [
            (at_box(0.16, 0.075, 0.001), textures.plain(color)),
            (at_box(0.156, 0.073, 0.006, (0, 0, 0.001)), prints.pages(look.rng)),
            (at_box(0.16, 0.075, 0.001, (0, 0, 0.007)), cover),
            (
                at_box(0.02, 0.0755, 0.0084, (-0.0705, 0, 0)),
                dye(look, "charcoal", "navy", "maroon"),
            ),
        ]

    return draw


def _rolled_plan(look: Look) -> Pieces:
    """A plan half rolled up."""
    image = prints.canvas(176, 128, (34, 78, 150))
    _blueprint(look, image, INK)
    sheet = at_box(0.36, 0.27, 0.0011)
    roll = (
        spindle((-0.135, 0.008), (-0.135, 0.016), (0.135, 0.016), (0.135, 0.008))
        .turn(2, np.pi / 2)
        .move(x=0.185)
    )
    return [(sheet, image), (roll, textures.plain((236, 238, 240)))]


A4 = (0.21, 0.297)


_row = Rows("office", ("white",), "lying flat", spread=0.06, roles=("flat",)).of_drawing


CATEGORIES = (
    _row("invoice", paper(*A4, _invoice, "white"), (*A4, 0.0011), 0.005, ("bill", "tax return",
             "bank statement", "payslip", "pay slip", "utility bill", "tax form", "order form")),
    _row("contract", paper(*A4, _contract, "white", "ivory", sheets=3), (0.225, 0.305, 0.0033),
             0.015,
         ("agreement", "lease agreement", "affidavit", "subpoena", "insurance policy", "treaty",
             "signed contract", "legal document", "rental agreement", "last will", "testament")),
    vary(_row("official_letter", paper(*A4, _letterhead, "white", "ivory"), (*A4, 0.0011), 0.005,
             ("business letter", "prescription", "memo", "memorandum", "cover letter", "iou",
             "prescription note", "printed letter")), 0.08),
    _row("resume", paper(*A4, _resume, "white"), (*A4, 0.0011), 0.005, ("cv", "curriculum vitae",
             "job application")),
    _row("cheque", paper(0.17, 0.078, _cheque, "sky", "mint", "cream", "lavender"), (0.17, 0.078,
             0.0011), 0.002, ("bank cheque", "paper cheque", "bank check", "paycheck",
             "money order"), ("mint",)),
    _row("chequebook", _booklet(("CHEQUES", "BANK"), "navy", "maroon", "green"), (0.16, 0.0755,
             0.0084), 0.05, ("cheque book", "checkbook", "passbook", "savings book",
             "cheque book cover", "bank book", "ration book", "ticket book", "receipt book"),
             ("navy",)),
    _row("coupon", paper(0.15, 0.07, _coupon, "white", accents=("red", "orange", "green",
             "purple", "blue")), (0.15, 0.07, 0.0011), 0.002, (
             "gift coupon", "discount voucher")),
    vary(_row("blueprint", _rolled_plan, (0.38, 0.27, 0.032), 0.05, ("building plan",
    "architect plan",
             "technical drawing", "construction plan"), ("blue",)), 0.08),
    _row("floor_plan", paper(0.297, 0.21, _floor, "white", "cream"), (0.297, 0.21, 0.0011),
             0.006, ("floorplan", "ground plan", "house plan", "site plan")),
)  # fmt: skip
"""The module's categories."""
