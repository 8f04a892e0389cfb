"""What the studio takes from the pages' package: a scene as the viewer loads it, and an episode."""

from __future__ import annotations

from pathlib import Path

from generator.errors import BundleError

from ..page.episodes import RecordedPlay, record_play
from ..page.options import FolderOptions
from ..page.scene_folder import scene_folder

_OPTIONS = FolderOptions(formats=(), episodes=0)  # the rest is made when it is asked for


def write_view(bundle: Path, folder: Path) -> None:
    """Write a bundle into an empty folder as the viewer loads it: ``view.json`` and its files.

    Raises:
        BundleError: the bundle is damaged.
        OSError: the disk refuses.
    """
    made = scene_folder(bundle, _OPTIONS)
    if made.row.error is not None:
        raise BundleError(made.row.error)
    for name, content in made.files.items():
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(content)


def play_episode(bundle: Path, task: str, seed: int) -> RecordedPlay:
    """Have the scripted expert play one episode of a task at a scene.

    Raises:
        SceneError: the scene offers nothing to do, or the expert knows no way with this seed.
    """
    return record_play(bundle, task, seed, tries=1)
