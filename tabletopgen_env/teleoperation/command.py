"""The ``teleop`` command: a person controls the arm, and kept episodes become a dataset."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, Protocol

import numpy as np
from rich.markup import escape
from tyro.conf import OmitArgPrefixes, Positional, arg

from generator.errors import InputError, SceneError, require_number

from ..recording.config import Format, LeRobotConfig, RecordConfig
from ..rendering.config import CameraName

if TYPE_CHECKING:
    import gymnasium as gym

    from ..learning.policies import Card, TrainedPolicy
    from ..recording.episodes import RecordedEpisode
    from .inputs import HumanInput
    from .session import TeleopEpisode, TeleopSession, TeleopStatus

Device = Literal["page", "window"]

SIZE = (480, 640)
"""Height and width of the pictures on the operator's display."""

_LEROBOT = LeRobotConfig()
_OF_POLICY = ("preset", "cameras", "kinds", "image_size", "observation")  # set by the policy
_KEPT = ("state", "pixels+state", "pixels+proprio")  # observation modes that datasets support
_WAIT = 0.05  # seconds between checks for an open page


class Driving(Protocol):
    """A display with keyboard or gamepad input."""

    def read(self) -> HumanInput | None:
        """Return the current input; None while no operator is connected."""
        ...

    def show(self, picture: np.ndarray, status: TeleopStatus) -> None:
        """Show a picture and the status of the episode."""
        ...


def teleop(
    policy: Annotated[Positional[str | None], arg(metavar="[POLICY]")] = None,
    /,
    *,
    config: Annotated[RecordConfig, OmitArgPrefixes],
    out: Path,
    format: Format = "npz",
    resume: bool = False,
    device: Device = "page",
    view: CameraName = "front",
    port: int = 0,
    steps: int = 1200,
    lerobot: OmitArgPrefixes[LeRobotConfig] = _LEROBOT,
) -> None:
    """Drive the arm by keyboard or gamepad, and record kept episodes as a dataset.

    With a POLICY, the policy acts until you take over. Ctrl-C, or closing the window, ends the
    recording; the dataset then holds the episodes that you kept, even after an error.

    Args:
        policy: Name of a shipped policy, a policy file, or a run's folder. It determines the task
            and the observation, and the randomization if it has one.
        config: What to record; episodes, noise and keep_failures have no effect here.
        out: A new folder for the dataset, or a file (hdf5, robomimic).
        format: The dataset's format. With lerobot, each kept episode is saved immediately, and
            --resume continues an interrupted recording.
        resume: Resume an interrupted recording from the episodes beside OUT (lerobot).
        device: A page in a browser on this machine (keyboard, gamepad), or a window.
        view: The camera to display.
        port: Port of the page; 0 for any free port.
        steps: Maximum number of steps per episode, at 20 per second.
        lerobot: Settings of a LeRobot dataset.
    """
    require_number("--steps", steps, minimum=1, integer=True)
    config = replace(config, player="human")
    config.check()
    acting, own = None, {}
    if policy is not None:
        acting = _load(policy)
        own = dict(acting.card.env)
        _check_left_out(config, acting.card, policy)
        player = f"human and {Path(policy).name}"
        config = replace(config, player=player, task=acting.card.task)
    from ..recording.recorder import write_dataset
    from .session import TeleopSession

    with closing(_environment(config, steps, own)) as env:
        session = TeleopSession(env, view, acting)

        def drive(first: int) -> Iterator[RecordedEpisode]:
            with closing(_device(device, port)) as driving:
                seeds = (int(np.random.default_rng((config.seed, n)).integers(2**31))
                         for n in count(first))  # fmt: skip
                yield from play(session, driving, env, view, enumerate(seeds, first))

        try:
            path = write_dataset(config, env, drive, out, format, resume, lerobot)
        except BaseException:
            if session.kept and out.exists():
                print(escape(f"{out}: the episodes kept so far"))
            raise
    print(escape(f"{path}: {session.kept} episodes kept"))


def play(
    session: TeleopSession,
    driving: Driving,
    env: gym.Env[Any, np.ndarray],
    view: CameraName,
    seeds: Iterator[tuple[int, int]],
) -> Iterator[RecordedEpisode]:
    """Yield the episodes that the operator keeps, until the window is closed.

    ``seeds`` are the episodes' numbers and seeds. The simulation pauses while no page is open.

    Raises:
        SceneError: 50 consecutive seeds gave no valid task.
    """
    frame = 1 / env.metadata["render_fps"]
    base: Any = env.unwrapped
    for number in _begin_each(session, seeds):
        done: TeleopEpisode | Literal["dropped"] | None = None
        while done is None:
            start = time.monotonic()
            given = driving.read()
            if given is None and not hasattr(driving, "address"):
                return  # the window was closed
            if given is None:
                time.sleep(_WAIT)
                continue
            done = session.advance(given)
            driving.show(base.picture(view), session.status)
            time.sleep(max(0.0, start + frame - time.monotonic()))
        if done != "dropped":
            yield as_recorded(done, number)


def _begin_each(session: TeleopSession, seeds: Iterator[tuple[int, int]]) -> Iterator[int]:
    """Begin an episode for each seed with a valid task; yield its number."""
    from ..recording.recorder import MOST_MISSES

    missed = 0
    for number, seed in seeds:
        try:
            session.begin(seed)
        except SceneError as error:
            missed += 1
            if missed == MOST_MISSES:
                raise SceneError(
                    f"{missed} consecutive seeds gave no valid task. Use other scenes or another "
                    f"task. Last error: {error}"
                ) from error
            continue
        missed = 0
        yield number


def as_recorded(episode: TeleopEpisode, number: int) -> RecordedEpisode:
    """Return an episode in the form for datasets, with the actor in the column ``human``."""
    from ..learning.demonstrations.recorded import Demonstration, stack
    from ..recording.episodes import recorded_episode

    actions = np.stack(episode.actions)
    shown = Demonstration(
        stack(episode.observations), actions, actions, np.asarray(episode.rewards, np.float32),
        episode.solved, str(episode.infos[-1]["instruction"]),
    )  # fmt: skip
    found = recorded_episode(
        number, episode.seed, shown, episode.infos, episode.felt, episode.digest
    )
    human = np.array([*episode.by_human, episode.by_human[-1]], bool)
    facts = {**found.facts, "human_steps": int(sum(episode.by_human))}
    return replace(found, infos={**found.infos, "human": human}, facts=facts)


def _load(policy: str) -> TrainedPolicy:
    """Return a policy from its name, file or run."""
    from ..learning.extra import need_sb3

    need_sb3()
    from ..learning.policies import load_policy

    return load_policy(policy)


def _check_left_out(config: RecordConfig, card: Card, policy: str) -> None:
    """Check that datasets support the policy's observation, and the config's settings.

    Raises:
        InputError: either check fails.
    """
    mode, geometry = (card.env.get(name) for name in ("observation", "geometry"))
    if mode not in (None, *_KEPT) or geometry not in (None, "none"):
        raise InputError(
            f"The policy {policy} uses the observation {mode or 'state'!r}"
            f"{f' with {geometry!r}' if geometry else ''}, which datasets do not support. Use a "
            f"policy with one of {', '.join(map(repr, _KEPT))}."
        )
    usual = RecordConfig()
    decided = {name: getattr(usual, name) for name in _OF_POLICY}
    if "randomization" in card.env:
        decided["randomization"] = usual.randomization
    given = [name for name, value in decided.items() if getattr(config, name) != value]
    if config.name not in (usual.name, card.task):
        given = ["task", *given]
    if given:
        flags = ", ".join(f"--{name.replace('_', '-')}" for name in given)
        raise InputError(
            f"The policy {policy} determines the task ({card.task}) and the observations. Omit "
            f"{flags}, or omit the policy."
        )


def _environment(config: RecordConfig, steps: int, own: dict[str, Any]) -> gym.Env[Any, Any]:
    """Return the environment of a config and a policy's ``own`` keywords for ``steps`` steps."""
    import gymnasium as gym

    return gym.make(
        f"tabletopgen_env:TabletopGen/{config.name}-v0", max_episode_steps=steps,
        **{**config.keywords, **own, "render_mode": "rgb_array", "render_size": SIZE},
    )  # fmt: skip


def _device(device: Device, port: int) -> Any:
    """Return the open operator display; for a page, print its address. The caller closes it."""
    if device == "window":
        from .window import TeleopWindow

        return TeleopWindow(*SIZE)
    from .page import TeleopPage

    page = TeleopPage(port)
    print(f"Open {page.address} in a browser on this machine. Ctrl-C ends the recording.")
    return page
