"""Players of episodes: built-in players, policy files, and functions that return policies.

A policy's own settings determine its observations and actions; the suite determines the rest.
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
"""Players without a policy."""

KINDS = (*SIMPLE, "policy", "function")
"""Kinds of players: `SIMPLE`, policy files, and functions that return a policy."""

OWN = frozenset({*keywords_of("observation"), *keywords_of("action"), "renderer"})
"""Keyword arguments of the environment that a policy sets: its observations and actions."""

OF_TRAINING = frozenset({"randomization", "reward", "certified", "cache", "masters", "infos"})
"""Environment settings that a suite sets, whatever a policy was trained with."""

Act = Callable[[Any], Any]
"""A function that returns the action for an observation."""


class Player(Protocol):
    """A player of episodes, which acts identically in episodes that start with the same seed."""

    def begin(self, env: Any, seed: int) -> Act:
        """Return the actor for the episode that has just started.

        Raises:
            SceneError: the player cannot solve the episode.
        """
        ...


@dataclass(frozen=True)
class PlayerFacts:
    """The part of a result that describes the player.

    Attributes:
        name: its name.
        kind: one of `KINDS`. Policies and functions cannot have a name from `SIMPLE`.
        digest: sha256 of everything that determines its behaviour: the policy file or, for a
            function, the file of its module and the policy's own ``digest``. Empty for other
            players.
        settings: its keyword arguments for the environment.
    """

    name: str
    kind: str
    digest: str = ""
    settings: Mapping[str, Any] = field(default_factory=dict)

    @property
    def title(self) -> str:
        """The name, followed by the kind in parentheses if a built-in player has been renamed."""
        renamed = self.kind in SIMPLE and self.name != self.kind
        return f"{self.name} ({self.kind})" if renamed else self.name

    @property
    def is_disguised(self) -> bool:
        """Whether a policy or a function has the name of one of the players in `SIMPLE`."""
        return self.kind not in SIMPLE and self.name.strip().lower() in SIMPLE


def find_player(name: str, suite: Suite) -> tuple[PlayerFacts, Player]:
    """Return the description of the player with the given name, and the player itself.

    Args:
        name: "random", "zero", "expert", the name of a shipped policy, a policy file, a folder of a
            training run (its best policy), or "module:function": a function without arguments that
            returns a policy. See ``PolicyPlayer``.
        suite: the suite to be played.

    Raises:
        InputError: the player does not exist, or does not fit the suite.
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
    """A player that acts uniformly at random."""

    def begin(self, env: Any, seed: int) -> Act:
        """Return an actor that draws actions with the episode's seed."""
        space: gym.spaces.Box = env.action_space
        rng = np.random.default_rng((seed, 5))
        return lambda _: rng.uniform(space.low, space.high).astype(np.float32)


class ZeroPlayer:
    """A player that returns zero actions, which leave the arm at rest and the hand half open."""

    def begin(self, env: Any, seed: int) -> Act:
        """Return an actor that returns zeros."""
        nothing = np.zeros(env.action_space.shape, np.float32)
        return lambda _: nothing


class ExpertPlayer:
    """The scripted expert, which has access to the full state."""

    def begin(self, env: Any, seed: int) -> Act:
        """Return the expert as an actor; see ``expert.run``."""
        from ..expert.run import TaskExpert

        expert = TaskExpert(env)
        expert.reset()
        return lambda _: expert.act()


@dataclass(frozen=True, eq=False)
class PolicyPlayer:
    """A policy: any object with ``predict(observation, deterministic=True)``.

    ``predict`` returns the action and the policy's memory; a memory that is not None is passed to
    the next call as ``state``. Optional attributes of a policy are ``env``, a dict of keyword
    arguments of the environment for its observations and actions ("observation", "image_size",
    "action" ...); ``observation_space`` and ``action_space``, which are compared with the
    environment's; ``reset()``, called at the start of each episode; and ``digest``, a short text
    that identifies anything not in its module's file, such as its weights.
    """

    policy: Any

    def begin(self, env: Any, seed: int) -> Act:
        """Return the policy as an actor; raise InputError if ``env`` does not fit the policy."""
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
                    f"The policy needs observations {seen} and actions of size {card.actions}; an "
                    f"environment with the policy's settings has observations {shown} and actions "
                    f"of size {taken}. Train it again with this version of the package."
                )
        for name in ("observation_space", "action_space"):
            own, there = getattr(self.policy, name, None), getattr(env, name)
            if own is not None and own != there:
                raise InputError(
                    f"The policy's {name} is {own}, but the environment's is {there}. Give the "
                    "policy an attribute env with its training settings, for example env = "
                    "{'observation': 'pixels', 'image_size': 64}."
                )


def _call(module: str, function: str) -> Any:
    """Import a module, searching the working directory last, and call one of its functions."""
    here = str(Path.cwd())
    if here not in sys.path and "" not in sys.path:
        sys.path.append(here)
    try:
        policy = getattr(importlib.import_module(module), function)()
    except Exception as error:  # the function can raise any exception
        raise InputError(
            f"{module}:{function} does not create a policy ({type(error).__name__}: {error}). "
            "Pass an importable module and a function in it that takes no arguments."
        ) from error
    if not callable(getattr(policy, "predict", None)):
        raise InputError(
            f"{module}:{function} returns a {type(policy).__name__} without "
            "predict(observation, deterministic=True)."
        )
    return policy


def _digest_of(module: str, own: object, name: str) -> str:
    """Return the sha256 of a module file's content and the policy's digest, joined by a NUL byte.

    The result is empty if there is neither.
    """
    told = printable(own, f"{name}: the policy's digest", InputError).encode()
    file = getattr(sys.modules.get(module), "__file__", None)
    source = Path(file).read_bytes() if file and Path(file).is_file() else b""
    whole = b"\0".join([source, told]) if told else source
    return hashlib.sha256(whole).hexdigest() if whole else ""


def _load(name: str, suite: Suite) -> tuple[PlayerFacts, Player]:
    """Load a policy file."""
    from ..learning.extra import need_sb3

    need_sb3()
    from ..learning.policies import find_policy, load_policy, shipped_policies

    if not Path(name).exists() and name not in shipped_policies():
        known = (*SIMPLE, *shipped_policies(), "FILE", "module:function")
        raise InputError(f"Unknown policy {name!r}." + choices(name, known))
    path = find_policy(name)
    policy = load_policy(path)
    if policy.card.task != suite.of.task:
        raise InputError(
            f"{name} was trained for {policy.card.task}, but {suite.name} is a suite of "
            f"{suite.of.task}. Use a suite of {policy.card.task}."
        )
    settings = _own_settings(policy.card.env, name, suite)
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    known_as = name if name in shipped_policies() else path.name
    return PlayerFacts(known_as, "policy", digest, settings), PolicyPlayer(policy)


def _own_settings(given: Any, name: str, suite: Suite) -> dict[str, Any]:
    """Validate and return a policy's keyword arguments for the environment."""
    if not isinstance(given, Mapping):
        raise InputError(f"{name}: env must be a dict of environment settings, got {given!r:.80}.")
    rate = given.get("control_hz", suite.of.control_hz)
    if rate != suite.of.control_hz:
        raise InputError(
            f"{name} acts at {rate} Hz, but {suite.name} runs at {suite.of.control_hz} Hz."
        )
    for key in given:
        if key not in OWN | OF_TRAINING:
            why = "set by the suite" if key in KEYWORDS else "not an environment setting"
            raise InputError(f"{name}: the policy's env has {key!r}, which is {why}. Remove it.")
    kept = {k: v for k, v in given.items() if k in OWN and k != "control_hz"}
    return {key: _plain(key, value) for key, value in sorted(kept.items())}


def _plain(key: str, value: Any) -> Any:
    """Return a setting as a JSON value: a string, a number, or a list or dict of these."""
    if isinstance(value, Mapping):  # sizes per camera
        return {str(name): _plain(key, part) for name, part in sorted(value.items())}
    if isinstance(value, list | tuple):
        return [_plain(key, part) for part in value]
    if not isinstance(value, str | bool | int | float):
        raise InputError(
            "A policy's env may only contain strings, numbers, and lists or dicts of these, so "
            f"that results can record the settings; {key} is {value!r:.80}."
        )
    return value


def _inputs(space: Any) -> dict[str, tuple[int, ...]]:
    """Return the shape of each part of an observation by name, or under "" if it is not a dict."""
    if isinstance(space, gym.spaces.Dict):
        return {name: tuple(part.shape or ()) for name, part in space.spaces.items()}
    return {"": tuple(space.shape)}


def _shape(size: int | tuple[int, ...]) -> tuple[int, ...]:
    return (size,) if isinstance(size, int) else tuple(size)
