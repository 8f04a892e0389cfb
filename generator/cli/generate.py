"""The ``generate``, ``compose`` and ``import`` commands, which make scenes."""

from __future__ import annotations

import os
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

from tyro.conf import OmitArgPrefixes, Positional, arg

from ..backends.paid_run import save_ledger, scene_key
from ..errors import DryRunError, InputError, SceneError, escape, exit_code, require_seed
from ..imports.options import ImportOptions
from ..io.files import check_folder
from ..scene import Density, Intrinsics
from . import paid_options
from .output import outcome_lines, print_scene, progress, store
from .paid_options import NO_CALLS, USUAL, Calls, Chosen


@dataclass(frozen=True)
class CameraOptions:
    """Known properties of the picture besides its colours.

    Attributes:
        depth: Depth map of the picture, of the same size: a 16-bit PNG in millimetres, 0 where
            unknown. Sizes and positions are then measured.
        intrinsics: With --depth: fx,fy,cx,cy of the picture's camera in pixels.
    """

    depth: Path | None = None
    intrinsics: str | None = None


@dataclass(frozen=True)
class OutputOptions:
    """Output files and folders.

    Attributes:
        out: Folder for the new bundle; defaults to the user cache.
        name: Name of the scene; derived from the text by default.
        figures: Also write the pictures of each stage (Sec. 6.1 of the paper) to this folder.
        allow_failed: Publish the scene even if it fails its physical gate.
    """

    out: Path | None = None
    name: str | None = None
    figures: Path | None = None
    allow_failed: bool = False


UNLIKE = exit_code(SceneError(""))
"""Exit code if the scene's view does not match its picture."""

_CAMERA, _OUTPUT, _IMPORT = CameraOptions(), OutputOptions(), ImportOptions()


def generate(
    source: Annotated[Positional[str], arg(metavar="TEXT|PICTURE")],
    /,
    *,
    output: OmitArgPrefixes[OutputOptions] = _OUTPUT,
    seed: int = 0,
    camera: OmitArgPrefixes[CameraOptions] = _CAMERA,
    without: Literal["dro", "tsa", "both"] | None = None,
    timings: bool = False,
    mix: Chosen = USUAL,
    calls: Calls = NO_CALLS,
    json: bool = False,
) -> int:
    """Turn a text, or a picture of a tabletop, into a simulated table.

    The exit code is 6 if the simulated view does not match the picture.

    Args:
        source: A description ("a desk with a laptop and two mugs") or the path of a picture.
        output: Output files and folders.
        seed: The same source and seed give the same scene.
        camera: Known properties of the picture besides its colours.
        without: Omit a stage, as in the paper's ablations: the backend estimates the results of dro
            (rotations), tsa (positions and sizes) or both from the picture. Nothing is refined
            then.
        timings: Also print the duration of every stage in seconds.
        mix: Backends for text and images, which can differ per role.
        calls: Cost limit of server requests, and the cache of their responses.
        json: Print a JSON object instead of text.
    """
    from ..method.reference import fetch, fetch_depth, is_picture_name

    require_seed(seed)
    content, metres = fetch(source), fetch_depth(camera.depth)
    folder, figures = _check_output(output.out, output.name), output.figures
    if figures is not None:
        check_folder(figures, "--figures")
    depth, intrinsics = camera.depth, camera.intrinsics
    lens = None if intrinsics is None else _intrinsics(intrinsics)

    from ..generation import Config  # slow imports, only after the options are checked
    from ..pipeline import generate as run

    left_out = ("dro", "tsa") if without == "both" else (without,) if without else ()
    session = calls.session()
    chosen = mix.select(session)
    what = Path(source) if is_picture_name(source) else source
    scene = scene_key("generate", what, depth, intrinsics, seed, without, chosen.identity())
    try:
        with paid_options.answering(session, scene), progress(quiet=json) as shown:
            if calls.dry_run and not chosen.asks_servers():
                raise DryRunError("")
            generation = run(
                content, chosen, Config(without=left_out), seed, name=output.name,
                progress=shown, depth=metres, intrinsics=lens,
            )  # fmt: skip
            if calls.dry_run:  # all answers are stored
                raise DryRunError("")
            if figures is not None:
                generation.save_figures(figures)
            path = generation.save(folder, allow_failed=output.allow_failed)
    except DryRunError as error:
        return paid_options.print_dry_run(error, json, mix, chosen)
    save_ledger(session, path)
    seconds = generation.seconds if timings else None
    match = generation.match
    done = print_scene(path, generation.scene, json, seconds, session, match)
    if match is not None and match.doubts:
        print(escape(f"error: {path.name} does not match the picture: {' '.join(match.doubts)}"),
              file=sys.stderr)  # fmt: skip
        return UNLIKE
    return done


def compose(
    text: Annotated[Positional[str], arg(metavar="TEXT")],
    /,
    *,
    out: Path | None = None,
    name: str | None = None,
    seed: int = 0,
    density: Density | None = None,
    json: bool = False,
) -> int:
    """Turn a text into a table directly, without drawing a picture first: 2 to 6 CPU seconds.

    Args:
        text: A description ("a round dining table for two").
        out: Folder for the bundle; defaults to the user cache.
        name: Name of the scene; derived from the text by default.
        seed: The same text and seed give the same scene.
        density: How full the table is; by default as the text describes it ("cluttered").
        json: Print a JSON object instead of text.
    """
    folder = _check_output(out, name)

    from ..bundle import save
    from ..composition import compose as run
    from ..method.figures import preview

    scene = run(text, seed, name=name, density=density)
    path = save(scene, folder, images={"preview": preview(scene)})
    return print_scene(path, scene, json)


def import_(
    source: Annotated[Positional[Path], arg(metavar="SOURCE")],
    /,
    *,
    out: Path | None = None,
    options: OmitArgPrefixes[ImportOptions] = _IMPORT,
    allow_failed: bool = False,
    json: bool = False,
) -> int:
    """Turn a scene of another program into a bundle: a MJCF, GLB or OBJ file, or a folder of files.

    In an MJCF file, bodies with a free joint become objects, and the body that supports them
    becomes the table; meshes, colours, textures, masses, friction and collision shapes are kept. A
    folder needs a poses.json, which lists the files and their poses. Models without collision
    shapes are decomposed into convex parts. A single object without a table is placed on a plain
    one. The scene is settled and checked, and a table lists the result for each object: taken,
    repaired, replaced by its hull, refused or left out.

    Args:
        source: An MJCF file (.xml), a GLB or OBJ file, a folder with poses.json, or the folder of
            an MJCF export.
        out: Folder for the bundle; defaults to the user cache.
        options: Import options.
        allow_failed: Publish the scene even if it fails its physical gate.
        json: Print a JSON object instead of text.
    """
    if not os.path.lexists(source):
        raise InputError(
            f"No file or folder at {str(source)!r}. Specify an MJCF, GLB or OBJ file, or a folder."
        )
    folder = _check_output(out, options.name)

    from ..bundle import save
    from ..imports import import_scene, list_outcomes
    from ..method.figures import preview

    scene = import_scene(source, options)
    outcomes = list_outcomes(scene)
    if not (allow_failed or scene.report is None or scene.report.passed):
        print(escape("\n".join(outcome_lines(outcomes))), file=sys.stderr)
        raise SceneError(
            f"{source} fails the physical gate: {scene.report.failure_text}. Leave out the "
            "failing objects (--drop-failing), or publish the scene anyway (--allow-failed)."
        )
    path = save(scene, folder, images={"preview": preview(scene)}, allow_failed=allow_failed)
    return print_scene(path, scene, json, outcomes=outcomes)


import_.__name__ = "import"


def _check_output(out: Path | None, name: str | None) -> Path:
    """Return the folder for a new bundle after checking the bundle's name."""
    from ..bundle import check_name

    if name is not None:
        check_name(name)
    return store(out)


def _intrinsics(text: str) -> Intrinsics:
    """Parse ``fx,fy,cx,cy``; raise InputError if it is not four numbers."""
    try:
        fx, fy, cx, cy = (float(part) for part in text.split(","))
    except ValueError as error:
        raise InputError(
            f"--intrinsics must be four numbers, fx,fy,cx,cy in pixels, got {text!r}."
        ) from error
    return Intrinsics(fx, fy, cx, cy)
