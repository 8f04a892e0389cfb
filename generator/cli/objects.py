"""The ``objects`` commands: list, show, export and check the objects of the catalogue."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import tyro
from tyro.conf import Positional, arg

from ..errors import escape, require_number, require_seed
from ..io.files import check_folder, check_target
from .inspection import Format
from .output import emit, progress

if TYPE_CHECKING:
    from rich.table import Table

    from ..objects.checks import CheckResult

app = tyro.extras.SubcommandApp()

_ALIASES = 3  # maximum in a row of a table

Key = Annotated[Positional[str], arg(metavar="KEY")]


@app.command(name="list")
def list_objects(*, theme: str | None = None, role: str | None = None, json: bool = False) -> int:
    """List objects: key, noun, theme, size, mass and other names.

    Args:
        theme: Only objects of this theme, such as "kitchen".
        role: Only objects with this role, such as "container".
        json: Print a JSON array instead of a table.
    """
    from ..objects.facts import brief_facts, select

    return _print_rows(brief_facts(select(theme, role)), json)


@app.command(name="search")
def search_objects(
    word: Annotated[Positional[str], arg(metavar="WORD")],
    /,
    *,
    limit: int = 10,
    json: bool = False,
) -> int:
    """Search objects by name, best match first.

    Args:
        word: A name or a part of one; the spelling need not be exact.
        limit: Maximum number of objects.
        json: Print a JSON array instead of a table.
    """
    from ..objects.facts import brief_facts, find_matches

    require_number("--limit", limit, minimum=1, maximum=1000, integer=True)
    return _print_rows(brief_facts(find_matches(word, limit)), json)


@app.command(name="show")
def show_object(key: Key, /, *, seed: int = 0, out: Path | None = None, json: bool = False) -> int:
    """Show one object: its facts, the location of its source, and a picture of four looks.

    Args:
        key: Key, noun or other name of an object.
        seed: Seed of the first look; the others use the following seeds.
        out: Path of the picture, a PNG; defaults to KEY.png in the current folder.
        json: Print a JSON object instead of lines.
    """
    from tabletop_objects.catalogue import load_category

    from ..io.pictures import write_picture
    from ..objects.facts import facts_of, require_category

    require_seed(seed)
    category = require_category(key)
    target = Path(f"{category.key}.png") if out is None else out
    check_target(target)
    from ..objects.pictures import draw_looks

    write_picture(draw_looks(load_category(category), seed), target)
    facts = {**facts_of(category), "picture": str(target)}
    emit(facts, json, lambda: _fact_lines(facts))
    return 0


@app.command(name="export")
def export_objects(
    key: Key, /, *, to: tuple[Format, ...], seed: int = 0, out: Path = Path()
) -> int:
    """Export a single object as a free body on a floor, without a table.

    The object stands on z = 0. The floor has the object's own coefficient of friction.

    Args:
        key: Key, noun or other name of an object.
        to: Formats, as in `tabletopgen export`.
        seed: Seed of the variant.
        out: Output folder.
    """
    from tabletop_objects import build

    from ..exports import export_object
    from ..objects.checks import stand_on_floor
    from ..objects.facts import require_category

    require_seed(seed)
    category = require_category(key)
    check_folder(out)
    thing = stand_on_floor(build(category.key, seed))
    for kind in to:
        print(escape(str(export_object(thing, kind, out))), flush=True)
    return 0


@app.command(name="check")
def check_object(key: Key, /, *, out: Path | None = None, json: bool = False) -> int:
    """Check one object: shape, collision parts, size, mass, looks, rest, styles and names.

    The object's module is read directly, so objects that are not in the index yet can be checked
    too. A picture shows the object from four sides.

    Args:
        key: Key of an object.
        out: Path of the picture, a PNG; defaults to KEY-check.png in the current folder.
        json: Print a JSON object instead of a table.
    """
    from tabletop_objects.catalogue import find_source

    from ..objects.checks import check_category
    from ..objects.facts import require_declaration, source_text

    category = require_declaration(key)
    target = Path(f"{category.key}-check.png") if out is None else out
    check_target(target)
    source, line = find_source(category)
    results = check_category(category, source)
    facts: dict[str, Any] = {
        "key": category.key,
        "source": source_text(source, line),
        "size_m": list(category.size),
        "mass_kg": category.mass,
        "checks": [{"name": r.name, "passed": r.passed, "detail": r.detail} for r in results],
        "picture": None,
    }
    if results[0].name == "drawing" and results[0].passed:
        from ..io.pictures import write_picture
        from ..objects.checks import build_variant
        from ..objects.pictures import draw_sides

        facts["picture"] = str(write_picture(draw_sides(build_variant(category, 0)), target))
    if json:
        emit(facts, True, list)
    else:
        _print_checks(facts, results)
    return 0 if all(result.passed for result in results) else 1


@app.command(name="page")
def make_page(*, out: Path, theme: tuple[str, ...] = (), workers: int = 1) -> int:
    """Make a static page of all objects: pictures by theme, with a search box.

    The page needs no server; open index.html in a browser. All objects take several minutes.

    Args:
        out: Folder of the page; its files are replaced.
        theme: Only objects of these themes; all by default.
        workers: Number of drawing processes.
    """
    from ..objects.page import write_page

    require_number("--workers", workers, minimum=1, maximum=64, integer=True)
    check_folder(out)
    with progress(quiet=False) as shown:
        page = write_page(out, theme, workers=workers, shown=shown)
    print(escape(str(page)))
    return 0


# --------------------------------------------------------------------------------------- printing


def _print_rows(rows: Sequence[Mapping[str, Any]], json: bool) -> int:
    if json:
        emit(list(rows), True, list)
        return 0
    table = _table("key", "noun", "theme", "size, cm", "mass, kg", "also called")
    for row in rows:
        table.add_row(
            row["key"],
            row["noun"],
            ", ".join(row["themes"]),
            _size(row["size_m"]),
            f"{row['mass_kg']:.3g}",
            _shorten(row["aliases"]),
        )
    _print_table(table)
    print(f"{len(rows)} {'object' if len(rows) == 1 else 'objects'}")
    return 0


def _print_checks(facts: Mapping[str, Any], results: Sequence[CheckResult]) -> None:
    print(escape(f"{facts['key']}  {facts['source']}"))
    print(f"nominal size {_size(facts['size_m'])} cm, nominal mass {facts['mass_kg']:.3g} kg")
    table = _table("check", "", "measured")
    for result in results:
        table.add_row(result.name, "passed" if result.passed else "FAILED", escape(result.detail))
    _print_table(table)
    failed = sum(not result.passed for result in results)
    print(f"{failed} of {len(results)} checks failed" if failed else "all checks passed")
    if facts["picture"]:
        print(escape(facts["picture"]))


def _fact_lines(facts: Mapping[str, Any]) -> list[str]:
    rows = {
        "themes": ", ".join(facts["themes"]),
        "roles": ", ".join(facts["roles"]) or "none",
        "size": f"{_size(facts['size_m'])} cm, {facts['state']}",
        "mass": f"{facts['mass_kg']:.3g} kg" + (", hollow" if facts["hollow"] else ""),
        "material": f"{facts['material']}, friction {facts['friction']:.2g}",
        "colours": ", ".join(facts["colors"]) or "its own",
        "also called": ", ".join(facts["aliases"]) or "nothing else",
        "source": facts["source"],
        "picture": facts["picture"],
    }
    title = f"{facts['key']}: {facts['noun']}"
    return [title, *(f"  {name:<12} {text}" for name, text in rows.items())]


def _shorten(names: Sequence[str]) -> str:
    more = len(names) - _ALIASES
    return ", ".join(names[:_ALIASES]) + (f" and {more} more" if more > 0 else "")


def _size(size: Sequence[float]) -> str:
    return " x ".join(f"{100 * side:.3g}" for side in size)


def _table(*columns: str) -> Table:
    from rich.table import Table

    table = Table(box=None, pad_edge=False)
    for column in columns:
        whole = column == "key" or column.startswith("size")
        table.add_column(column, overflow="fold", no_wrap=whole)
    return table


def _print_table(table: Table) -> None:
    from rich.console import Console

    console = Console(file=sys.stdout, highlight=False, markup=False, emoji=False)
    console.print(table)
