"""Wrappers of the ``page`` package that prepare a scene for the viewer and record an episode."""

from __future__ import annotations

from pathlib import Path

from generator.errors import BundleError

from ..page.episodes import RecordedPlay, record_play
from ..page.options import FolderOptions
from ..page.scene_folder import scene_folder

_OPTIONS = FolderOptions(formats=(), episodes=0)  # heavier imports are deferred


def write_view(bundle: Path, folder: Path) -> None:
    """Prepare a bundle for the viewer in an empty folder: ``view.json`` and its files.

    Raises:
        BundleError: the bundle is damaged.
        OSError: the folder is not writable.
    """
    made = scene_folder(bundle, _OPTIONS)
    if made.row.error is not None:
        raise BundleError(made.row.error)
    for name, content in made.files.items():
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(content)


def play_episode(bundle: Path, task: str, seed: int) -> RecordedPlay:
    """Record the scripted expert in one episode of a task in a scene.

    Raises:
        SceneError: the scene has no valid task, or the expert cannot solve it with this seed.
    """
    return record_play(bundle, task, seed, tries=1)
