"""Poses compared with ground truth: single rendered objects, and whole scenes from a picture.

    python benchmarks/pose.py single --split dev --cases 60 --elevation 5 --occlude 0.15
    python benchmarks/pose.py single --meshes FOLDER --cases 40 --size-error 0.2 --sheet
    python benchmarks/pose.py scenes --split dev --cases 6

``single`` draws objects without rotational symmetry (``--symmetric`` includes finite symmetries,
with errors modulo the symmetry), with the NumPy renderer instead of the optimiser's own, and runs
the rotation stage on them. Camera, yaw, position and size are known; flags perturb the stage's
input, each by at most the stated amount (hidden pixels are missing in the crop). Cases whose
picture would be nearly the same from another side are skipped and counted. ``--paper N`` also runs
the first N cases with the paper's settings. ``scenes`` composes tables, draws each, passes only the
picture to ``generator.pipeline.generate`` and compares the result with the truth; the yaw error is
the rotation that brings the two textured surfaces closest together, since a rebuilt model has its
own axes.

Each split has its own catalogue variants and random numbers: develop on "dev", report "test". Rows
are written to ``<name>.csv`` as they finish (a second run resumes; use a new ``--out`` for new
code), then a summary to ``<name>.md`` and curves to ``<name>.png``.
"""

from __future__ import annotations

import argparse
from dataclasses import fields
from pathlib import Path

import numpy as np
from jaxtyping import UInt8
from posing import scenes, singles
from posing.cases import STREAMS, Draw, usable
from posing.meshes import Up, load_model, mesh_files
from posing.spoiling import Spoiling
from posing.tables import alone, command_line

from generator.errors import InputError, TabletopError
from generator.scene import Model
from tabletop_objects import get_category

HERE = Path(__file__).parent


def parser() -> argparse.ArgumentParser:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    modes = p.add_subparsers(dest="mode", required=True)
    usual = Spoiling()
    single = modes.add_parser("single", help="single objects, the rotation stage alone")
    single.add_argument("--cases", type=int, default=200)
    single.add_argument("--meshes", type=Path, help="folder of OBJ, GLB or PLY files, metres")
    single.add_argument("--up", choices=("auto", "y", "z"), default="auto", help="of the meshes")
    single.add_argument("--only", nargs="*", default=(), help="categories; all by default")
    single.add_argument("--symmetric", action="store_true", help="include finite symmetries")
    single.add_argument("--elevation", type=float, default=usual.elevation, metavar="DEG")
    single.add_argument("--azimuth", type=float, default=usual.azimuth, metavar="DEG")
    single.add_argument("--erode", type=int, default=usual.erode, metavar="PX")
    single.add_argument("--holes", type=int, default=usual.holes, metavar="N")
    single.add_argument("--occlude", type=float, default=usual.occlude, metavar="SHARE")
    single.add_argument("--light", type=float, default=usual.light)
    single.add_argument("--tint", type=float, default=usual.tint)
    single.add_argument("--blur", type=float, default=usual.blur, metavar="PX")
    single.add_argument("--size-error", type=float, default=usual.size_error, metavar="SHARE")
    single.add_argument(
        "--paper",
        type=int,
        default=0,
        metavar="N",
        help="cases to repeat with the paper's settings, minutes each",
    )
    whole = modes.add_parser("scenes", help="whole scenes, all stages, from the picture alone")
    whole.add_argument("--cases", type=int, default=40)
    for mode in (single, whole):
        mode.add_argument("--split", choices=tuple(STREAMS), default="dev")
        mode.add_argument("--seed", type=int, default=1)
        mode.add_argument("--workers", type=int, default=1)
        mode.add_argument("--sheet", action="store_true", help="draw the worst cases")
        mode.add_argument("--out", type=Path, default=HERE / "results")
    return p


def spoiling_of(args: argparse.Namespace) -> Spoiling:
    """Return the perturbations of the given flags."""
    return Spoiling(**{f.name: getattr(args, f.name) for f in fields(Spoiling)})


def draw_of(args: argparse.Namespace) -> Draw:
    """Return the distribution of cases for the given flags."""
    only = tuple(get_category(word).key for word in args.only)
    models = foreign(args.meshes, args.up, args.symmetric) if args.meshes else ()
    return Draw(args.split, args.seed, spoiling_of(args), only, models, symmetric=args.symmetric)


def foreign(folder: Path, up: Up, symmetric: bool) -> tuple[Model, ...]:
    """Return the usable meshes of a folder; print the reasons why others are not usable."""
    models = []
    for path in mesh_files(folder):
        try:
            models.append(load_model(path, up))
        except InputError as error:
            print(f"not used: {error}")
    if not models:
        raise InputError(f"No mesh of {str(folder)!r} can be used; the reasons are printed above.")
    return usable(models, symmetric)


def stem(args: argparse.Namespace) -> str:
    """Return the name of a run's files: the settings that determine its cases."""
    name = f"pose_{args.mode}_{args.split}" + (f"_seed{args.seed}" if args.seed != 1 else "")
    if args.mode == "scenes":
        return name
    if args.meshes:
        name += f"_{args.meshes.resolve().name}" + ("" if args.up == "auto" else args.up)
    name += "".join(f"_{get_category(word).key}" for word in args.only)
    name += "_symmetric" if args.symmetric else ""
    return name + spoiling_of(args).label()


def write(path: Path, image: UInt8[np.ndarray, "h w 3"]) -> None:
    """Write a picture."""
    from PIL import Image

    Image.fromarray(image).save(path)


def main() -> None:
    args = parser().parse_args()
    if args.cases < 1 or args.workers < 1:
        raise SystemExit("--cases and --workers must be at least 1.")
    alone()
    try:
        name = stem(args)
        args.out.mkdir(parents=True, exist_ok=True)
        table = args.out / f"{name}.csv"
        if args.mode == "single":
            draw = draw_of(args)
            done = singles.run(draw, args.cases, args.paper, args.workers, table, command_line())
            if args.sheet:
                write(args.out / f"{name}_worst.png", singles.sheet(done.rows, draw))
        else:
            sheets = args.out / f"{name}_sheets" if args.sheet else None
            done = scenes.run(
                args.split, args.seed, args.cases, args.workers, table, command_line(), sheets
            )
    except TabletopError as error:
        raise SystemExit(str(error)) from error
    (args.out / f"{name}.md").write_text(done.text)
    write(args.out / f"{name}.png", done.plot)
    print(done.text)


if __name__ == "__main__":
    main()
