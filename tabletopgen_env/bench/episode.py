"""Execution of a run's episodes, one after another in each process."""

from __future__ import annotations

import atexit
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from generator.errors import SceneError
from generator.threads import single_thread

if TYPE_CHECKING:
    import numpy as np
    from jaxtyping import UInt8

    from ..env import TabletopEnv
    from .instances import Suite, SuiteEpisode

FRAME_EVERY = 4
"""Steps between two pictures of an episode."""

STRIP = 6
"""Pictures in a film strip."""

_SHOWN = (240, 320)  # height and width of pictures
_KEPT = 4  # compiled worlds: consecutive episodes share a table


@dataclass(frozen=True)
class SuiteOutcome:
    """The outcome of an episode; ``reward`` is the rounded mean reward per step."""

    solved: bool
    steps: int
    reward: float


@dataclass(frozen=True)
class FailurePictures:
    """Folders for pictures of failed episodes.

    Attributes:
        strips: Folder for a film strip (PNG) of each failed episode.
        videos: Folder for a video (animated WebP) of each failed episode.
    """

    strips: Path | None = None
    videos: Path | None = None

    def __bool__(self) -> bool:
        return self.strips is not None or self.videos is not None


@dataclass(frozen=True)
class Playing:
    """Settings of the processes that run episodes.

    Attributes:
        suite: the suite.
        player: name of the player; see ``players.find_player``.
        bundles: the tables' bundles by digest.
        pictures: pictures of failed episodes.
    """

    suite: Suite
    player: str
    bundles: Mapping[str, Path]
    pictures: FailurePictures = FailurePictures()


class Stage:
    """An environment with the tables of a suite, and the player that acts in it."""

    def __init__(self, playing: Playing) -> None:
        from ..env import make_env
        from .players import find_player

        self._playing = playing
        facts, self._player = find_player(playing.player, playing.suite)
        settings: dict[str, Any] = {**facts.settings, **playing.suite.settings, "cache": _KEPT}
        if playing.pictures:
            settings |= {"render_mode": "rgb_array", "render_size": _SHOWN}
        first = next(iter(playing.bundles.values()))
        self.env = make_env(first, task=playing.suite.of.task, **settings)
        atexit.register(self.env.close)

    def play(self, episode: SuiteEpisode) -> SuiteOutcome:
        """Run an episode; if it fails and pictures are requested, run it again to render them."""
        with single_thread():
            outcome = self._play(episode, None)
            if self._playing.pictures and not outcome.solved:
                frames: list[UInt8[np.ndarray, "h w 3"]] = []
                self._play(episode, frames)
                _write(frames, self._playing.pictures, stem_of(episode))
        return outcome

    def _play(self, episode: SuiteEpisode, frames: list[Any] | None) -> SuiteOutcome:
        from ..episodes import Held

        suites = self._playing.suite.of
        env, bundle = self.env, self._playing.bundles[episode.table.digest]
        options = {"scene": bundle, **episode.instance.options}
        seen, _ = env.reset(seed=episode.seed, options=options)
        rewards: list[float] = []
        held, solved = Held(suites.hold), False
        _look(env, frames)
        try:
            act = self._player.begin(env, episode.seed)
            while not solved and len(rewards) < suites.time_limit:
                seen, reward, _, _, info = env.step(act(seen))
                rewards.append(float(reward))
                solved = held.after(info)
                if len(rewards) % FRAME_EVERY == 0:
                    _look(env, frames)
        except SceneError:  # the player has no way to continue
            pass
        _look(env, frames)
        return SuiteOutcome(solved, len(rewards), round(sum(rewards) / max(len(rewards), 1), 6))


def stem_of(episode: SuiteEpisode) -> str:
    """Return the file stem for an episode's pictures."""
    asked = [part for part in (episode.instance.target, episode.instance.goal) if part]
    return "-".join([episode.table.digest, *asked, str(episode.number)])


def _look(env: TabletopEnv, frames: list[Any] | None) -> None:
    if frames is not None:
        frames.append(env.render())


def _write(frames: list[Any], pictures: FailurePictures, stem: str) -> None:
    """Write the requested pictures of an episode: a film strip, a video, or both.

    Raises:
        StorageError: a file cannot be written.
    """
    import io

    import numpy as np
    from PIL import Image

    from generator.io.files import write_file
    from generator.io.pictures import write_picture
    from generator.render.sheet import grid

    if pictures.strips is not None:
        picks = np.linspace(0, len(frames) - 1, STRIP).round().astype(int)
        sheet = grid([frames[k] for k in picks], columns=STRIP, cell=320)
        write_picture(sheet, pictures.strips / f"{stem}.png")
    if pictures.videos is not None:
        first, *others = (Image.fromarray(frame) for frame in frames)
        film = io.BytesIO()
        first.save(film, "WEBP", save_all=True, append_images=others, duration=200, quality=80)
        write_file(film.getvalue(), pictures.videos / f"{stem}.webp")


def stage_of(playing: Playing) -> Stage:
    """Create the environment and the player; this is done once per process."""
    return Stage(playing)
