"""The commands that look at a text or at bundles: ``explain``, ``inspect``, ``verify``, ..."""

from __future__ import annotations

import dataclasses
import math
import os
import secrets
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Annotated, Any, Literal

from tyro import conf
from tyro.conf import Positional

from ..errors import (
    InputError,
    MissingError,
    TabletopError,
    escape,
    require_number,
    require_seed,
)
from ..io.files import check_folder, check_target
from .output import emit, find, one, print_scene, some
from .plugins import VERIFIERS, find_commands
from .plugins import load as load_plugin

Format = Literal["mjcf", "urdf", "sdf", "glb", "usd", "usdz"]


def explain(
    text: Annotated[Positional[str], conf.arg(metavar="TEXT")],
    /,
    *,
    seed: int = 0,
    json: bool = False,
) -> int:
    """Show how the embedded planner reads a text, and what it does not understand.

    Args:
        text: English about a tabletop.
        seed: What vague words ("a few") are drawn with.
        json: Print one JSON array instead of lines.
    """
    from ..language.explanation import explain as explain_text
    from ..language.explanation import summarize

    rows = explain_text(text, seed)
    lines = [f"{row.role:<15} {row.phrase:<32} {row.meaning}".rstrip() for row in rows]
    emit(
        [dataclasses.asdict(row) for row in rows], json,
        lambda: [summarize(text, seed), "", *lines],
    )  # fmt: skip
    return 0


def inspect(
    bundle: Annotated[Positional[str], conf.arg(metavar="BUNDLE")], /, *, json: bool = False
) -> int:
    """Show what a bundle holds: its objects, their sizes and masses, and its recorded gate.

    Args:
        bundle: A bundle's name, digest, glob or path.
        json: Print one JSON object instead of a table.
    """
    from ..bundle import load

    path = one(bundle)
    return print_scene(path, load(path), json)


def verify(
    bundles: Annotated[Positional[tuple[str, ...]], conf.arg(metavar="BUNDLE [BUNDLE ...]")],
    /,
    *,
    json: bool = False,
    replay: int = 0,
    seed: int | None = None,
) -> int:
    """Check bundles: hashes, paths, numbers, and whether they still simulate soundly.

    Certificates are checked with --replay alone; environments check those they read for damage.

    Args:
        bundles: Names, digests, globs or paths.
        json: Print one JSON object instead of lines: the failures of each bundle; with --replay an
            object for each, with "failures", "replayed" (how many episodes) and "seed".
        replay: Play so many episodes of each certificate again, drawn at random: what the expert
            is said to have solved, it has to solve. Other versions of packages, and other kinds of
            processors, may play an episode otherwise.
        seed: What draws the episodes; another one each time if left out.
    """
    require_number("verify needs --replay", replay, minimum=0, maximum=10_000, integer=True)
    if seed is not None:
        require_seed(seed)
    paths = [p for wanted in some(bundles) for p in find(wanted)]
    if not replay:
        return verify_all(paths, json)
    drawn = secrets.randbelow(2**31) if seed is None else seed
    print(f"replaying with --seed {drawn}", file=sys.stderr)
    replaying = Replaying(drawn, tuple(_verifiers(replay, drawn)))
    return verify_all(paths, json, replaying=replaying)


def _verifiers(count: int, seed: int) -> Iterator[Verifier]:
    """Yield what checks bundles by playing.

    Raises:
        InputError: a check cannot be loaded, or there is none.
    """
    found = find_commands(VERIFIERS).values()
    if not found:
        raise InputError("Nothing here plays certificates again. Install tabletopgen anew.")
    for entry in found:
        yield partial(load_plugin(entry), count=count, seed=seed)


Verifier = Callable[[Path], tuple[int, Sequence[object]]]
"""Plays a bundle's episodes; returns how many, and what is wrong."""


@dataclasses.dataclass(frozen=True)
class Replaying:
    """Further checks of sound bundles, which play episodes drawn by ``seed``."""

    seed: int
    verifiers: tuple[Verifier, ...]


def verify_all(
    paths: Iterable[Path],
    json: bool,
    *,
    may_vanish: bool = False,
    replaying: Replaying | None = None,
) -> int:
    """Verify bundles; return the exit code.

    ``may_vanish``: one that another process removes meanwhile is left out, not unsound.
    """
    from ..bundle import load_verified
    from ..physics.gate import judge

    results: dict[str, list[str]] = {}
    notes: dict[str, str] = {}
    replayed: dict[str, int] = {}
    for path in paths:
        try:
            report = judge(load_verified(path))
            results[path.name] = [str(f) for f in report.failures]
            if report.lean is not None:
                notes[path.name] = f", gravity leaning by {math.degrees(report.lean):.3g}°"
            if replaying is not None and not results[path.name]:
                for verifier in replaying.verifiers:
                    played, wrong = verifier(path)
                    replayed[path.name] = replayed.get(path.name, 0) + played
                    results[path.name] += map(str, wrong)
                notes[path.name] = (
                    f"{notes.get(path.name, '')}, {replayed[path.name]} episodes replayed"
                )
        except TabletopError as error:
            if not (may_vanish and isinstance(error, MissingError)):
                results[path.name] = [str(error)]
    facts = results if replaying is None else {
        name: {"failures": failed, "replayed": replayed.get(name, 0), "seed": replaying.seed}
        for name, failed in results.items()
    }  # fmt: skip
    emit(
        facts, json,
        lambda: [f"{n}: {'; '.join(f) or 'sound'}{notes.get(n, '')}" for n, f in results.items()],
    )  # fmt: skip
    return 1 if any(results.values()) else 0


def view(
    bundle: Annotated[Positional[str], conf.arg(metavar="BUNDLE")],
    /,
    *,
    picture: Path | None = None,
) -> int:
    """Open a bundle in MuJoCo's viewer; without a screen, write a picture instead.

    Args:
        bundle: A bundle's name, digest, glob or path.
        picture: Write a PNG here instead of opening a window.
    """
    from ..bundle import load
    from ..physics.spec import compile_spec, scene_spec

    path = one(bundle)
    if picture is not None:
        check_target(picture, "--picture")
    scene = load(path)
    screen = sys.platform in ("darwin", "win32") or any(
        os.environ.get(v) for v in ("DISPLAY", "WAYLAND_DISPLAY")
    )
    if picture is None and screen:
        import mujoco.viewer

        # What was checked, not the file, which may be another by now.
        mujoco.viewer.launch(compile_spec(scene_spec(scene), scene.name))
        return 0
    from ..io.pictures import write_picture
    from ..method.figures import preview

    target = picture or Path(f"{path.name}.png")
    write_picture(preview(scene), target)
    print(escape(str(target) if picture else f"No screen here; wrote {target}."))
    return 0


def export(
    bundles: Annotated[Positional[tuple[str, ...]], conf.arg(metavar="BUNDLE [BUNDLE ...]")],
    /,
    *,
    to: tuple[Format, ...],
    out: Path = Path(),
) -> int:
    """Write bundles in formats of other programs: glTF, MJCF, SDF, URDF, USD.

    glb and usdz are one file, the others a folder with the document and its meshes and textures.
    Beside mjcf, urdf and sdf are scripts that load them: load_mujoco.py, load_pybullet.py and
    load_drake.py.

    Args:
        bundles: Names, digests, globs or paths.
        to: Formats: mjcf has every mesh in a file; usd and usdz need the extra "usd".
        out: The folder they go into.
    """
    from ..bundle import load
    from ..exports import export as write

    check_folder(out)
    for path in [p for wanted in some(bundles) for p in find(wanted)]:
        scene = load(path)
        for kind in to:
            print(escape(str(write(scene, kind, out, path.name))), flush=True)
    return 0


def compare(
    sources: Annotated[Positional[tuple[str, ...]], conf.arg(metavar="[PICTURE] BUNDLE")],
    /,
    *,
    out: Path | None = None,
    json: bool = False,
) -> int:
    """Compare a bundle with its picture: masks, the scene from its camera, an overlay, figures.

    Args:
        sources: A picture and a bundle (name, digest, glob or path); the bundle alone means the
            picture it keeps: the one it was made from, or drawn for its text.
        out: Where the sheet goes, a PNG; named after the bundle if left out.
        json: Print one JSON object instead of lines.
    """
    from .. import comparison
    from ..bundle import load, load_picture, load_segments
    from ..io.pictures import write_picture
    from ..method.reference import read_image

    if not 1 <= len(sources) <= 2:
        raise InputError("Name one bundle, or a picture and the bundle made from it.")
    path = one(sources[-1])
    target = out if out is not None else Path(f"{path.name}-compare.png")
    check_target(target)
    scene, segments, kept = load(path), load_segments(path), load_picture(path, "reference")
    if segments is None or kept is None:
        raise InputError(
            f"{path.name} keeps no picture with instances, as scenes made by `tabletopgen "
            "generate` do; make it again with that command."
        )
    picture = read_image(Path(sources[0])) if len(sources) == 2 else kept
    compared = comparison.compare(scene, segments, picture)
    write_picture(comparison.comparison_sheet(compared), target)
    facts = {"bundle": str(path), "sheet": str(target), **compared.facts()}
    emit(facts, json, lambda: _lines(facts))
    return 0


def _lines(facts: Mapping[str, Any]) -> list[str]:
    rows = [
        f"  {o['name']:<22} IoU {o['iou']:.2f}"
        + ("" if o["color_difference"] is None else f"  colour {o['color_difference']:.1f}")
        + ("" if o["built"] else "  not in the scene")
        + ("" if o["found"] else "  not in the picture")
        for o in [facts["table"], *facts["objects"]]
    ]
    return [facts["sheet"], *rows, f"  mean IoU of the objects: {facts['mean_iou']:.2f}"]
