"""The ``tabletopgen`` command; what it prints for ``--help`` is written here, and nowhere else."""

from __future__ import annotations

import dataclasses
import json
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import tyro

from .errors import (
    BackendError,
    BundleError,
    InputError,
    SceneError,
    StorageError,
    TabletopError,
)

if TYPE_CHECKING:
    from .scene import Scene

EXIT_CODES: tuple[tuple[type[TabletopError], int], ...] = (
    (InputError, 2),
    (BackendError, 3),
    (BundleError, 4),
    (StorageError, 5),
    (SceneError, 6),
)

DESCRIPTION = """Turn a text, or one picture of a tabletop, into a simulated table.

The store of finished tables has commands of its own: tabletopgen cache --help.

Exit codes: 0 done, 1 a check failed, 2 bad input or usage, 3 backend, 4 bundle, 5 storage, 6 scene,
130 interrupted.
"""

app = tyro.extras.SubcommandApp()
Positional = tyro.conf.Positional


@app.command
def generate(
    source: Positional[str],
    /,
    *,
    out: Path | None = None,
    name: str | None = None,
    seed: int = 0,
    backend: str = "embedded",
    figures: Path | None = None,
    allow_failed: bool = False,
    json: bool = False,
) -> int:
    """Turn a text, or a picture of a tabletop, into a simulated table.

    Args:
        source: A description ("a desk with a laptop and two mugs") or the path of a picture.
        out: Folder the bundle goes into; the user cache if left out.
        name: Name of the scene; made from the text if left out.
        seed: The same source and seed give the same scene.
        backend: Who answers the questions about text and image.
        figures: Also write the stage-by-stage pictures of the paper's Sec. 6.1 here.
        allow_failed: Publish even if the scene fails its physical gate.
        json: Print one JSON object instead of text.
    """
    from .backends import Backends
    from .bundle import check_name
    from .pipeline import generate as run

    if name is not None:
        check_name(name)
    with _progress(quiet=json) as progress:
        generation = run(source, Backends.select(backend), seed=seed, name=name, progress=progress)
        if figures is not None:
            generation.save_figures(figures)
        path = generation.save(_store(out), allow_failed=allow_failed)
    return _print_scene(path, generation.scene, json)


@app.command
def compose(
    text: Positional[str],
    /,
    *,
    out: Path | None = None,
    name: str | None = None,
    seed: int = 0,
    json: bool = False,
) -> int:
    """Turn a text into a table directly, without drawing a picture first: seconds, not a minute.

    Args:
        text: A description ("a round dining table for two").
        out: Folder the bundle goes into; the user cache if left out.
        name: Name of the scene; made from the text if left out.
        seed: The same text and seed give the same scene.
        json: Print one JSON object instead of text.
    """
    from .bundle import check_name, save
    from .compose import compose as run
    from .figures import preview

    if name is not None:
        check_name(name)
    scene = run(text, seed, name=name)
    path = save(scene, _store(out), images={"preview": preview(scene)})
    return _print_scene(path, scene, json)


@app.command
def inspect(bundle: Positional[str], /, *, json: bool = False) -> int:
    """Show what a bundle holds: its objects, their sizes and masses, and its recorded gate.

    Args:
        bundle: A bundle's name, digest, glob or path.
        json: Print one JSON object instead of a table.
    """
    from .bundle import load

    path = _one(bundle)
    return _print_scene(path, load(path), json)


@app.command
def verify(bundles: Positional[tuple[str, ...]], /, *, json: bool = False) -> int:
    """Check bundles: hashes, paths, numbers, and whether they still simulate soundly.

    Args:
        bundles: Names, digests, globs or paths.
        json: Print one JSON object instead of lines.
    """
    from .bundle import load
    from .physics.gate import judge

    results = {}
    for path in [p for wanted in _some(bundles) for p in _find(wanted)]:
        try:
            report = judge(load(path))
            results[path.name] = list(report.failures)
        except (BundleError, SceneError) as error:
            results[path.name] = [str(error)]
    _emit(results, json, lambda: [f"{n}: {'; '.join(f) or 'sound'}" for n, f in results.items()])
    return 1 if any(results.values()) else 0


@app.command
def view(bundle: Positional[str], /, *, picture: Path | None = None) -> int:
    """Open a bundle in MuJoCo's viewer; without a screen, write a picture instead.

    Args:
        bundle: A bundle's name, digest, glob or path.
        picture: Write a PNG here instead of opening a window.
    """
    path = _one(bundle)
    screen = sys.platform in ("darwin", "win32") or any(
        os.environ.get(v) for v in ("DISPLAY", "WAYLAND_DISPLAY")
    )
    if picture is None and screen:
        import mujoco.viewer

        mujoco.viewer.launch_from_path(str(path / "scene.xml"))
        return 0
    from .bundle import load
    from .figures import preview, write_picture

    target = picture or Path(f"{path.name}.png")
    write_picture(preview(load(path)), target)
    print(target if picture else f"No screen here; wrote {target}.")
    return 0


cache = tyro.extras.SubcommandApp()


@cache.command(name="list")
def cache_list(pattern: Positional[str] = "*", /, *, json: bool = False) -> int:
    """List the bundles that can be found by name: the starters, and those in the user cache.

    Args:
        pattern: Glob on the names.
        json: Print one JSON array instead of lines.
    """
    import assets_cache

    entries = [p for p in assets_cache.entries() if p.match(pattern)]
    _emit([str(p) for p in entries], json, lambda: [p.name for p in entries] or ["no bundles"])
    return 0


@cache.command(name="rm")
def cache_remove(bundles: Positional[tuple[str, ...]], /) -> int:
    """Remove bundles from the user cache.

    Args:
        bundles: Names, digests or globs.
    """
    import assets_cache

    for path in [p for wanted in _some(bundles) for p in assets_cache.find(wanted)]:
        assets_cache.remove(path)
        print(f"removed {path.name}")
    return 0


@cache.command(name="verify")
def cache_verify(*, json: bool = False) -> int:
    """Check every bundle in the store.

    Args:
        json: Print one JSON object instead of lines.
    """
    import assets_cache

    return verify(tuple(str(p) for p in assets_cache.entries()), json=json)


# ------------------------------------------------------------------------------------ plumbing


def _store(out: Path | None) -> Path:
    import assets_cache

    return out if out is not None else assets_cache.user_root()


def _find(wanted: str) -> list[Path]:
    import assets_cache

    return list(assets_cache.find(wanted))


def _some(bundles: tuple[str, ...]) -> tuple[str, ...]:
    if not bundles:
        raise InputError("Name at least one bundle; `tabletopgen cache list` shows what there is.")
    return bundles


def _one(wanted: str) -> Path:
    found = _find(wanted)
    if len(found) > 1:
        names = ", ".join(p.name for p in found[:8])
        raise InputError(f"{wanted!r} fits {len(found)} bundles: {names}. Name one.")
    return found[0]


@contextmanager
def _progress(*, quiet: bool) -> Iterator[Callable[[str, int, int], None] | None]:
    """Show the running stage on standard error, if that is a terminal."""
    if quiet:
        yield None
        return
    from rich.console import Console

    console = Console(stderr=True)
    with console.status("starting") as status:

        def show(stage: str, number: int, total: int) -> None:
            status.update(f"[{number}/{total}] {stage}")
            if not console.is_terminal:
                console.print(f"[{number}/{total}] {stage}", highlight=False, markup=False)

        yield show


def _describe(path: Path, scene: Scene) -> dict[str, Any]:
    report = scene.report
    return {
        "bundle": str(path),
        "name": scene.name,
        "table_m": [round(float(v), 3) for v in scene.table.scale],
        "objects": [
            {
                "name": o.name,
                "label": o.label,
                "size_m": [round(float(v), 3) for v in o.scale],
                "mass_kg": round(o.mass, 3),
                "position_m": [round(float(v), 3) for v in o.pose.position],
                "on": o.placement.on,
            }
            for o in scene.objects
        ],
        "passed": None if report is None else report.passed,
        "report": None if report is None else dataclasses.asdict(report),
        "warnings": list(scene.provenance.warnings),
    }


def _print_scene(path: Path, scene: Scene, as_json: bool) -> int:
    facts = _describe(path, scene)

    def lines() -> list[str]:
        rows = [
            f"  {o['name']:<22} {o['label']:<18} "
            + "x".join(f"{100 * v:.1f}" for v in o["size_m"])
            + f" cm  {o['mass_kg']:.3f} kg  on {o['on']}"
            for o in facts["objects"]
        ]
        report = scene.report
        gate = (
            "no report"
            if report is None
            else ("passed" if report.passed else "FAILED: " + "; ".join(report.failures))
        )
        notes = [f"  note: {w}" for w in facts["warnings"]]
        return [str(path), *rows, f"  gate: {gate}", *notes]

    _emit(facts, as_json, lines)
    return 0


def _emit(value: Any, as_json: bool, lines: Callable[[], list[str]]) -> None:
    print(json.dumps(value, indent=2) if as_json else "\n".join(lines()))


def main(args: list[str] | None = None) -> None:
    """Run the command line; every expected error becomes one line and an exit code."""
    arguments = sys.argv[1:] if args is None else args
    try:
        if arguments[:1] == ["cache"]:
            code = cache.cli(prog="tabletopgen cache", args=arguments[1:], use_underscores=False)
        else:
            code = app.cli(
                prog="tabletopgen",
                description=DESCRIPTION,
                args=arguments,
                use_underscores=False,
            )
    except TabletopError as error:
        print(f"error: {error}", file=sys.stderr)
        code = next(number for kind, number in EXIT_CODES if isinstance(error, kind))
    except KeyboardInterrupt:
        print("interrupted; nothing was published", file=sys.stderr)
        code = 130
    raise SystemExit(code)


if __name__ == "__main__":
    main()
