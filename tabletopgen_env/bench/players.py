"""Who plays: a random or a zero action, the scripted expert, a policy file, a policy of your own.

A policy's own settings decide what it sees and how it moves the robot; all else is the suite's.
"""

from __future__ import annotations

import hashlib
import importlib
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol

import gymnasium as gym
import numpy as np

from generator.errors import InputError, choices
from generator.io.bounded import printable

from ..settings.keywords import KEYWORDS, keywords_of
from .instances import Suite

SIMPLE = ("random", "zero", "expert")
"""Players that need no policy."""

KINDS = (*SIMPLE, "policy", "function")
"""What players are: one of `SIMPLE`, a policy file, a function that returns a policy."""

OWN = frozenset({*keywords_of("observation"), *keywords_of("action"), "renderer"})
"""Keywords of an environment that are a policy's: what it sees, and how it moves the robot."""

OF_TRAINING = frozenset({"randomization", "reward", "certified", "cache", "masters", "infos"})
"""Keywords that a policy was trained with, in place of which a suite has its own."""

Act = Callable[[Any], Any]
"""Returns the action for an observation."""


class Player(Protocol):
    """Someone who plays episodes, alike whenever an episode begins with the same seed."""

    def begin(self, env: Any, seed: int) -> Act:
        """Return what acts in the episode that has just begun.

        Raises:
            SceneError: it knows that it cannot do it.
        """
        ...


@dataclass(frozen=True)
class PlayerFacts:
    """What a result says of who played.

    Attributes:
        name: what it is called.
        kind: one of `KINDS`. No policy or function is called as one of `SIMPLE`.
        digest: a sha256 of what decides how it plays: of a policy file; of the file of a function's
            module, and of the policy's own ``digest``. Empty for others.
        settings: its own keywords of the environment.
    """

    name: str
    kind: str
    digest: str = ""
    settings: Mapping[str, Any] = field(default_factory=dict)

    @property
    def title(self) -> str:
        """The name, with the kind of a simple player that is called otherwise."""
        renamed = self.kind in SIMPLE and self.name != self.kind
        return f"{self.name} ({self.kind})" if renamed else self.name

    @property
    def is_disguised(self) -> bool:
        """Whether a policy or a function is called as one of `SIMPLE`."""
        return self.kind not in SIMPLE and self.name.strip().lower() in SIMPLE


def find_player(name: str, suite: Suite) -> tuple[PlayerFacts, Player]:
    """Return who a name means, and what is said of it.

    Args:
        name: "random", "zero", "expert", the name of a shipped policy, a policy file, a folder of
            a training run (its best policy), or "module:function": a function without arguments
            that returns a policy. See ``PolicyPlayer``.
        suite: where it is to play.

    Raises:
        InputError: there is none, or it does not fit the suite.
    """
    if name in SIMPLE:
        simple: Mapping[str, Player] = {
            "random": RandomPlayer(), "zero": ZeroPlayer(), "expert": ExpertPlayer()
        }  # fmt: skip
        return PlayerFacts(name, name), simple[name]
    module, colon, function = name.partition(":")
    if colon and module and function.isidentifier() and not Path(name).exists():
        policy = _call(module, function)
        settings = _own_settings(getattr(policy, "env", {}), name, suite)
        digest = _digest_of(module, getattr(policy, "digest", ""), name)
        return PlayerFacts(name, "function", digest, settings), PolicyPlayer(policy)
    return _load(name, suite)


class RandomPlayer:
    """Acts uniformly at random."""

    def begin(self, env: Any, seed: int) -> Act:
        """Return what draws actions by the episode's seed."""
        space: gym.spaces.Box = env.action_space
        rng = np.random.default_rng((seed, 5))
        return lambda _: rng.uniform(space.low, space.high).astype(np.float32)


class ZeroPlayer:
    """Does nothing: actions of zeros, which leave the arm where it is and the hand half open."""

    def begin(self, env: Any, seed: int) -> Act:
        """Return what gives zeros."""
        nothing = np.zeros(env.action_space.shape, np.float32)
        return lambda _: nothing


class ExpertPlayer:
    """The scripted expert, which knows the whole world."""

    def begin(self, env: Any, seed: int) -> Act:
        """Return the expert's actions; see ``expert.run``."""
        from ..expert.run import TaskExpert

        expert = TaskExpert(env)
        expert.reset()
        return lambda _: expert.act()


@dataclass(frozen=True, eq=False)
class PolicyPlayer:
    """A policy: anything with ``predict(observation, deterministic=True)``.

    Of what that returns the first is the action, the second what the policy remembers: if that is
    not None, the next call gets it as ``state``. A policy may have an ``env``, a dict of keywords
    of the environment (what it sees and how it moves the robot: "observation", "image_size",
    "action" ...), an ``observation_space`` and an ``action_space``, which are compared with the
    environment's, a ``reset()``, called when an episode begins, and a ``digest``, a short text that
    stands for what is not in its module's file, such as its weights.
    """

    policy: Any

    def begin(self, env: Any, seed: int) -> Act:
        """Return the policy's actions (InputError: it has other spaces than the environment)."""
        self._check(env)
        if (reset := getattr(self.policy, "reset", None)) is not None:
            reset()
        from ..learning.evaluation import EpisodePlayer

        return EpisodePlayer(self.policy).act

    def _check(self, env: Any) -> None:
        card = getattr(self.policy, "card", None)
        if card is not None and hasattr(card, "inputs"):
            shown, taken = _inputs(env.observation_space), int(np.prod(env.action_space.shape))
            seen = {name: _shape(size) for name, size in card.inputs.items()}
            if (seen, card.actions) != (shown, taken):
                raise InputError(
                    f"The policy sees {seen} and has {card.actions} entries of an action; the "
                    f"environment of its card shows {shown} and takes {taken}. Train it again "
                    "with this version of the package."
                )
        for name in ("observation_space", "action_space"):
            own, there = getattr(self.policy, name, None), getattr(env, name)
            if own is not None and own != there:
                raise InputError(
                    f"The policy's {name} is {own}, the environment's {there}. Give the policy an "
                    "attribute env with the settings that it was trained with, as in "
                    "env = {'observation': 'pixels', 'image_size': 64}."
                )


def _call(module: str, function: str) -> Any:
    """Return what a function of a module returns; the working directory is looked in last."""
    here = str(Path.cwd())
    if here not in sys.path and "" not in sys.path:
        sys.path.append(here)
    try:
        policy = getattr(importlib.import_module(module), function)()
    except Exception as error:  # whatever foreign code raises
        raise InputError(
            f"{module}:{function} makes no policy ({type(error).__name__}: {error}). Name a "
            "module that can be imported, and a function in it that takes no arguments."
        ) from error
    if not callable(getattr(policy, "predict", None)):
        raise InputError(
            f"{module}:{function} returns a {type(policy).__name__} without "
            "predict(observation, deterministic=True)."
        )
    return policy


def _digest_of(module: str, own: object, name: str) -> str:
    """Return the sha256 of the file of an imported module, its policy's own digest after a NUL.

    Empty if there is neither.
    """
    told = printable(own, f"{name}: the policy's digest", InputError).encode()
    file = getattr(sys.modules.get(module), "__file__", None)
    source = Path(file).read_bytes() if file and Path(file).is_file() else b""
    whole = b"\0".join([source, told]) if told else source
    return hashlib.sha256(whole).hexdigest() if whole else ""


def _load(name: str, suite: Suite) -> tuple[PlayerFacts, Player]:
    """Return the policy of a file."""
    from ..learning.extra import need_sb3

    need_sb3()
    from ..learning.policies import find_policy, load_policy, shipped_policies

    if not Path(name).exists() and name not in shipped_policies():
        known = (*SIMPLE, *shipped_policies(), "FILE", "module:function")
        raise InputError(f"There is no policy {name!r}." + choices(name, known))
    path = find_policy(name)
    policy = load_policy(path)
    if policy.card.task != suite.of.task:
        raise InputError(
            f"{name} does {policy.card.task}, and {suite.name} is of {suite.of.task}. Run a suite "
            f"of {policy.card.task}."
        )
    settings = _own_settings(policy.card.env, name, suite)
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    known_as = name if name in shipped_policies() else path.name
    return PlayerFacts(known_as, "policy", digest, settings), PolicyPlayer(policy)


def _own_settings(given: Any, name: str, suite: Suite) -> dict[str, Any]:
    """Return those of a policy's settings that are its own; all are checked."""
    if not isinstance(given, Mapping):
        raise InputError(f"{name}: env is a dict of an environment's settings, got {given!r:.80}.")
    rate = given.get("control_hz", suite.of.control_hz)
    if rate != suite.of.control_hz:
        raise InputError(
            f"{name} acts at {rate} Hz, and {suite.name} is played at {suite.of.control_hz} Hz."
        )
    for key in given:
        if key not in OWN | OF_TRAINING:
            why = "the suite's" if key in KEYWORDS else "no setting of an environment"
            raise InputError(f"{name}: its env has {key!r}, which is {why}. Leave it out.")
    kept = {k: v for k, v in given.items() if k in OWN and k != "control_hz"}
    return {key: _plain(key, value) for key, value in sorted(kept.items())}


def _plain(key: str, value: Any) -> Any:
    """Return a setting as a JSON value: a text, a number, a list or a table of these."""
    if isinstance(value, Mapping):  # sizes by camera
        return {str(name): _plain(key, part) for name, part in sorted(value.items())}
    if isinstance(value, list | tuple):
        return [_plain(key, part) for part in value]
    if not isinstance(value, str | bool | int | float):
        raise InputError(
            "A policy's env has names, numbers, and lists or tables of them, so that results can "
            f"name them: {key} is {value!r:.80}."
        )
    return value


def _inputs(space: Any) -> dict[str, tuple[int, ...]]:
    """Return the parts of an observation as a card lists them: one without a name is all."""
    if isinstance(space, gym.spaces.Dict):
        return {name: tuple(part.shape or ()) for name, part in space.spaces.items()}
    return {"": tuple(space.shape)}


def _shape(size: int | tuple[int, ...]) -> tuple[int, ...]:
    return (size,) if isinstance(size, int) else tuple(size)
