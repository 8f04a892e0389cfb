"""One episode after the other: what a process of a run does."""

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
"""Steps between the pictures of an episode."""

STRIP = 6
"""Pictures in a film strip."""

_SHOWN = (240, 320)  # height and width of pictures
_KEPT = 4  # compiled worlds: episodes come table by table


@dataclass(frozen=True)
class SuiteOutcome:
    """How an episode ended: ``reward`` is the mean of a step, rounded."""

    solved: bool
    steps: int
    reward: float


@dataclass(frozen=True)
class FailurePictures:
    """What is kept of episodes that fail.

    Attributes:
        strips: Folder for a film strip (PNG) of each episode that fails.
        videos: Folder for a film (animated WebP) of each episode that fails.
    """

    strips: Path | None = None
    videos: Path | None = None

    def __bool__(self) -> bool:
        return self.strips is not None or self.videos is not None


@dataclass(frozen=True)
class Playing:
    """What a process needs to play: the suite, who plays, and where the tables are.

    Attributes:
        suite: what is played.
        player: who plays, by name; see ``players.find_player``.
        bundles: the tables' bundles by digest.
        pictures: what is kept of failures.
    """

    suite: Suite
    player: str
    bundles: Mapping[str, Path]
    pictures: FailurePictures = FailurePictures()


class Stage:
    """An environment at the tables of a suite, and who plays there."""

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
        """Play an episode, and once more for its pictures if it fails and they are wanted."""
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
        except SceneError:  # who plays knows that it cannot go on
            pass
        _look(env, frames)
        return SuiteOutcome(solved, len(rewards), round(sum(rewards) / max(len(rewards), 1), 6))


def stem_of(episode: SuiteEpisode) -> str:
    """Return what the pictures of an episode are called."""
    asked = [part for part in (episode.instance.target, episode.instance.goal) if part]
    return "-".join([episode.table.digest, *asked, str(episode.number)])


def _look(env: TabletopEnv, frames: list[Any] | None) -> None:
    if frames is not None:
        frames.append(env.render())


def _write(frames: list[Any], pictures: FailurePictures, stem: str) -> None:
    """Write a film strip and a film.

    Raises:
        StorageError: they cannot be written.
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
    """Return what plays; made once in each process."""
    return Stage(playing)
