"""A static page, in one folder, that shows all objects by theme and has a word search.

``index.html`` contains a card for each object, its style sheet and its script; ``THEME.webp``
holds the thumbnails of a theme. The page loads no other files and works from ``file://``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from importlib import resources
from pathlib import Path

from tabletop_objects import Category
from tabletop_objects.catalogue import find_source

from ..io.files import write_file
from .checks import size_text
from .facts import source_text
from .thumbnails import COLUMNS, SIDE, Shown, Thumbnails, by_folder, draw_thumbnails, sprite

_TEMPLATE = "page.html"


def write_page(
    folder: Path, themes: Sequence[str] = (), *, workers: int = 1, shown: Shown | None = None
) -> Path:
    """Draw the objects of all or selected themes, write the page, and return its path.

    Raises:
        InputError: A theme does not exist.
        StorageError: The folder cannot be written.
    """
    groups = by_folder(themes)
    keys = [category.key for group in groups.values() for category in group]
    thumbnails = draw_thumbnails(keys, workers=workers, shown=shown)
    files = page_files(groups, thumbnails)
    for name, content in files.items():
        write_file(content, folder / name)
    return folder / "index.html"


def page_files(
    groups: Mapping[str, Sequence[Category]], thumbnails: Thumbnails
) -> dict[str, bytes]:
    """Return the files of the page by name."""
    files = {
        f"{theme}.webp": sprite([thumbnails[category.key] for category in group])
        for theme, group in groups.items()
    }
    return {"index.html": _html(groups).encode(), **files}


def _html(groups: Mapping[str, Sequence[Category]]) -> str:
    text = resources.files(str(__package__)).joinpath(_TEMPLATE).read_text(encoding="utf-8")
    values = {
        "{{count}}": f"{sum(map(len, groups.values())):,}",
        "{{side}}": str(SIDE),
        "{{options}}": "\n".join(_option(theme, group) for theme, group in groups.items()),
        "{{sprites}}": "\n".join(_sprite_style(theme) for theme in groups),
        "{{sections}}": "\n".join(_section(theme, group) for theme, group in groups.items()),
    }
    for name, value in values.items():
        text = text.replace(name, value)
    return text


def _option(theme: str, group: Sequence[Category]) -> str:
    return f'<option value="{escape(theme)}">{escape(theme)} ({len(group)})</option>'


def _sprite_style(theme: str) -> str:
    return f'#{escape(theme)} .thumb {{ background-image: url("{escape(theme)}.webp"); }}'


def _section(theme: str, group: Sequence[Category]) -> str:
    cards = "\n".join(_card(category, number) for number, category in enumerate(group))
    return (
        f'<section id="{escape(theme)}" aria-labelledby="{escape(theme)}-title">\n'
        f'<h2 id="{escape(theme)}-title">{escape(theme)} <span class="count">{len(group)}</span>'
        f"</h2>\n<ul>\n{cards}\n</ul>\n</section>"
    )


def _card(category: Category, number: int) -> str:
    x, y = number % COLUMNS * SIDE, number // COLUMNS * SIDE
    source = escape(source_text(*find_source(category))).replace("/", "/<wbr>")
    words = " ".join([category.key, category.noun, *category.aliases]).lower()
    aliases = ", ".join(category.aliases)
    also = f'<p class="also">{escape(aliases)}</p>' if aliases else ""
    return (
        f'<li data-words="{escape(words)}">'
        f'<span class="thumb" role="img" aria-label="Picture: {escape(category.noun)}" '
        f'style="background-position:-{x}px -{y}px"></span>'
        f"<h3>{escape(category.noun)}</h3>"
        f"<p><span>{size_text(category.size)}</span> <span>{mass_text(category.mass)}</span></p>"
        f'{also}<code class="key">{escape(category.key)}</code>'
        f"<code>{source}</code></li>"
    )


def mass_text(mass: float) -> str:
    """Format a mass in kilograms, for example as "300 g" or "1.2 kg"."""
    return f"{1000 * mass:.3g} g" if mass < 1 else f"{mass:.3g} kg"
