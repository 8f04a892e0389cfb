"""The commands that look at bundles: ``inspect``, ``verify`` and ``view``."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from tyro.conf import Positional

from ..errors import BundleError, SceneError
from .printing import emit, print_scene
from .store import find, one, some


def inspect(bundle: Positional[str], /, *, json: bool = False) -> int:
    """Show what a bundle holds: its objects, their sizes and masses, and its recorded gate.

    Args:
        bundle: A bundle's name, digest, glob or path.
        json: Print one JSON object instead of a table.
    """
    from ..bundle import load

    path = one(bundle)
    return print_scene(path, load(path), json)


def verify(bundles: Positional[tuple[str, ...]], /, *, json: bool = False) -> int:
    """Check bundles: hashes, paths, numbers, and whether they still simulate soundly.

    Args:
        bundles: Names, digests, globs or paths.
        json: Print one JSON object instead of lines.
    """
    from ..bundle import load
    from ..physics.gate import judge

    results = {}
    for path in [p for wanted in some(bundles) for p in find(wanted)]:
        try:
            report = judge(load(path))
            results[path.name] = list(report.failures)
        except (BundleError, SceneError) as error:
            results[path.name] = [str(error)]
    emit(results, json, lambda: [f"{n}: {'; '.join(f) or 'sound'}" for n, f in results.items()])
    return 1 if any(results.values()) else 0


def view(bundle: Positional[str], /, *, picture: Path | None = None) -> int:
    """Open a bundle in MuJoCo's viewer; without a screen, write a picture instead.

    Args:
        bundle: A bundle's name, digest, glob or path.
        picture: Write a PNG here instead of opening a window.
    """
    path = one(bundle)
    screen = sys.platform in ("darwin", "win32") or any(
        os.environ.get(v) for v in ("DISPLAY", "WAYLAND_DISPLAY")
    )
    if picture is None and screen:
        import mujoco.viewer

        mujoco.viewer.launch_from_path(str(path / "scene.xml"))
        return 0
    from ..bundle import load
    from ..figures import preview, write_picture

    target = picture or Path(f"{path.name}.png")
    write_picture(preview(load(path)), target)
    print(target if picture else f"No screen here; wrote {target}.")
    return 0
