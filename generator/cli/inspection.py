"""Commands that inspect texts and bundles: ``explain``, ``inspect``, ``verify``, ..."""

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
    """Show how the embedded planner interprets a text, and what it does not understand.

    Args:
        text: An English description of a tabletop.
        seed: Seed for vague words ("a few").
        json: Print a JSON array instead of lines.
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
    """Show the content of a bundle: objects, sizes, masses, and the recorded gate.

    Args:
        bundle: A bundle's name, digest, glob pattern or path.
        json: Print a JSON object instead of a table.
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
    """Check bundles: hashes, paths, numbers, and physical stability.

    Certificates are checked with --replay only; environments check the certificates they read for
    damage.

    Args:
        bundles: Names, digests, glob patterns or paths.
        json: Print a JSON object instead of lines: the failures of each bundle; with --replay, an
            object per bundle with "failures", "replayed" (number of episodes) and "seed".
        replay: Replay this many randomly drawn episodes of each certificate; the expert must solve
            the episodes that it is recorded to have solved. Other package versions and processors
            may give different episodes.
        seed: Seed for drawing the episodes; random by default.
    """
    require_number("--replay", replay, minimum=0, maximum=10_000, integer=True)
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
    """Yield functions that check bundles by replaying episodes.

    Raises:
        InputError: a check cannot be loaded, or none is installed.
    """
    found = find_commands(VERIFIERS).values()
    if not found:
        raise InputError("No installed package can replay certificates. Reinstall tabletopgen.")
    for entry in found:
        yield partial(load_plugin(entry), count=count, seed=seed)


Verifier = Callable[[Path], tuple[int, Sequence[object]]]
"""A function that replays a bundle's episodes and returns their number and a list of problems."""


@dataclasses.dataclass(frozen=True)
class Replaying:
    """Additional checks of valid bundles that replay episodes drawn with ``seed``."""

    seed: int
    verifiers: tuple[Verifier, ...]


def verify_all(
    paths: Iterable[Path],
    json: bool,
    *,
    may_vanish: bool = False,
    replaying: Replaying | None = None,
) -> int:
    """Verify bundles and return the exit code.

    ``may_vanish``: bundles that another process removes in the meantime are skipped, not failed.
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
                notes[path.name] = f", gravity tilted by {math.degrees(report.lean):.3g}°"
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
        lambda: [f"{n}: {'; '.join(f) or 'valid'}{notes.get(n, '')}" for n, f in results.items()],
    )  # fmt: skip
    return 1 if any(results.values()) else 0


def view(
    bundle: Annotated[Positional[str], conf.arg(metavar="BUNDLE")],
    /,
    *,
    picture: Path | None = None,
) -> int:
    """Open a bundle in MuJoCo's viewer; without a display, write a picture instead.

    Args:
        bundle: A bundle's name, digest, glob pattern or path.
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

        # The checked content, since the file may have changed meanwhile.
        mujoco.viewer.launch(compile_spec(scene_spec(scene), scene.name))
        return 0
    from ..io.pictures import write_picture
    from ..method.figures import preview

    target = picture or Path(f"{path.name}.png")
    write_picture(preview(scene), target)
    print(escape(str(target) if picture else f"No display available; wrote {target}."))
    return 0


def export(
    bundles: Annotated[Positional[tuple[str, ...]], conf.arg(metavar="BUNDLE [BUNDLE ...]")],
    /,
    *,
    to: tuple[Format, ...],
    out: Path = Path(),
) -> int:
    """Export bundles for other programs: glTF, MJCF, SDF, URDF, USD.

    glb and usdz are single files; the other formats are folders with a document, meshes and
    textures. mjcf, urdf and sdf come with scripts that load them: load_mujoco.py, load_pybullet.py
    and load_drake.py.

    Args:
        bundles: Names, digests, glob patterns or paths.
        to: Formats: mjcf stores each mesh in a file; usd and usdz need the extra "usd".
        out: Output folder.
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
    """Compare a bundle with its picture: masks, the rendered scene, an overlay, and figures.

    Args:
        sources: A picture and a bundle (name, digest, glob pattern or path). With a bundle alone,
            its own picture is used: the one it was made from, or drawn for its text.
        out: Path of the comparison sheet, a PNG; named after the bundle by default.
        json: Print a JSON object instead of lines.
    """
    from .. import comparison
    from ..bundle import load, load_picture, load_segments
    from ..io.pictures import write_picture
    from ..method.reference import read_image

    if not 1 <= len(sources) <= 2:
        raise InputError("Specify one bundle, or a picture and the bundle made from it.")
    path = one(sources[-1])
    target = out if out is not None else Path(f"{path.name}-compare.png")
    check_target(target)
    scene, segments, kept = load(path), load_segments(path), load_picture(path, "reference")
    if segments is None or kept is None:
        raise InputError(
            f"{path.name} contains no picture with instances. Generate the scene with "
            "`tabletopgen generate`, which stores one."
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
