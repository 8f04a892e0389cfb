"""Recipes: everything that decides a training run, as data.

The shipped ones are in ``recipes.toml``, a table each; one of your own is a TOML file with the same
keys at its top. A run keeps its recipe beside its weights.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, field, fields
from datetime import date, time
from pathlib import Path
from typing import Any, Literal, get_args

from generator.errors import InputError, choices, require, require_known
from generator.io.bounded import parse_toml, printable, read_regular

from ..scenes.production.recipe import MOST_SEEDS
from ..tasks.names import NAMES

Algorithm = Literal["sac", "td3", "ppo", "ppo-batch", "clone"]
Extractor = Literal["table", "goal", "flat", "look", "sight"]
Activation = Literal["relu", "tanh"]

FILE = Path(__file__).with_name("recipes.toml")
"""The recipes that are shipped."""

STARTS = "starts"
"""The ``randomization`` of recipes whose ``env`` names none: without, a table starts alike."""

MOST_BYTES = 2**16
"""A recipe's file is not larger."""

_ELSEWHERE = frozenset({
    "render", "render_mode", "render_size", "renderer", "worlds", "robot", "cache", "masters",
})  # fmt: skip


@dataclass(frozen=True)
class Network:
    """What a policy is made of.

    Attributes:
        extractor: "table" for ``network.TableExtractor`` (state), "goal" for the same on goal
            observations, "flat" for all entries as they are, "look" for state and height maps, with
            a head that finds grasps (``look_extractor``), "sight" for the same of pictures with
            depth (``sight_extractor``).
        layers: widths of the hidden layers after it.
        width: of what the extractor pools the other objects to.
        activation: "relu" or "tanh".
    """

    extractor: Extractor = "table"
    layers: tuple[int, ...] = (256, 256)
    width: int = 64
    activation: Activation = "relu"

    @property
    def finds_grasps(self) -> bool:
        """Whether it has a head that finds grasps."""
        return self.extractor in ("look", "sight")

    def __post_init__(self) -> None:
        require_known(self.extractor, get_args(Extractor), "Network has no extractor")
        require_known(self.activation, get_args(Activation), "Network has no activation")
        require(self, "width", minimum=1, maximum=1024, integer=True)
        sizes = self.layers if isinstance(self.layers, tuple) else ()
        if not (0 < len(sizes) <= 8 and all(type(s) is int and 0 < s <= 4096 for s in sizes)):
            raise InputError(
                f"Network needs layers to be 1 to 8 whole numbers up to 4096, got {self.layers!r}."
            )


@dataclass(frozen=True)
class Recipe:
    """How a policy for one task is trained.

    Attributes:
        name: what it is called.
        task: what to do; see ``tabletopgen_env.tasks``.
        algorithm: "sac", "td3" or "ppo" of Stable-Baselines3, "ppo-batch" for our own of
            ``ppo``, or "clone" for cloning alone.
        steps: of the environments, all together; of cloning its rounds decide, not this.
        envs: environments stepped together.
        processes: in how many processes they are, split evenly; None for threads of this one. It
            decides nothing but the time, but for "refreshing" scenes.
        scenes: where it trains; anything ``scenes`` takes that is a text, or several. Of those
            made on demand ("fresh", "refreshing", "curriculum") only the training side is used.
        batch: settings of ``ppo.batches.BatchConfig``: "ppo-batch" trains on a ``TabletopBatchEnv``
            of ``envs`` worlds, on a GPU. None for slots on the CPU's cores. It is evaluated on
            the CPU either way.
        held_out: where it is evaluated; of those made on demand only the held-out side.
        variants: how many tables "fresh" scenes are drawn from, both sides together (of a text, so
            many of it): few enough to be met again, and compiled once, or ever new ones. Of other
            scenes it means nothing.
        env: further keywords of the environment. Those read by ``recipe`` have the randomization
            ``STARTS`` unless they name another; "none" is none.
        network: what the policy is made of.
        options: keywords of Stable-Baselines3's class, "action_noise" the standard deviation of
            TD3's; of "ppo-batch" those of ``ppo.config.PPOConfig``.
        hindsight: goals replayed for each true one (HER); 0 for none.
        demonstrations: episodes of the expert in the replay buffer from the start.
        cloning: settings of ``CloningConfig``: the actor starts from the cloned expert. None for
            a random start.

    Raises:
        InputError: a value out of range, or some that do not go together.
    """

    name: str
    task: str
    algorithm: Algorithm
    steps: int = 1_000_000
    envs: int = 1
    processes: int | None = None
    scenes: str | tuple[str, ...] = "starter:train"
    held_out: str | tuple[str, ...] = "starter:held_out"
    variants: int = 1_000_000
    env: Mapping[str, Any] = field(default_factory=dict)
    network: Network = field(default_factory=Network)
    options: Mapping[str, Any] = field(default_factory=dict)
    hindsight: int = 0
    demonstrations: int = 0
    cloning: Mapping[str, Any] | None = None
    batch: Mapping[str, Any] | None = None

    def __post_init__(self) -> None:
        require_known(self.task, NAMES, "Recipe has no task")
        require_known(self.algorithm, get_args(Algorithm), "Recipe has no algorithm")
        require(self, "steps", "envs", minimum=1, integer=True)
        if self.processes is not None:
            require(self, "processes", minimum=1, integer=True)
        require(self, "hindsight", "demonstrations", minimum=0, integer=True)
        require(self, "variants", minimum=1, maximum=MOST_SEEDS, integer=True)
        for side in ("scenes", "held_out"):
            _check_scenes(self.name, side, getattr(self, side))
        known = env_keywords()
        for key in self.env:
            require_known(key, known, f"{self.name}: an environment has no")
        self._check_together()

    @property
    def observation(self) -> str:
        """The observation mode."""
        return str(self.env.get("observation", "state"))

    @property
    def looks(self) -> bool:
        """Whether the observation has height maps."""
        return self.env.get("geometry", "none") != "none"

    def facts(self) -> dict[str, Any]:
        """Return it as JSON and ``recipe_of`` have it."""
        own = {f.name: getattr(self, f.name) for f in fields(self)}
        own |= {"network": asdict(self.network), "env": dict(self.env)}
        own |= {"options": dict(self.options)}
        for key in ("cloning", "batch"):
            table = getattr(self, key)
            own[key] = None if table is None else dict(table)
        return json.loads(json.dumps(own))

    def _check_together(self) -> None:
        sees = self.network.extractor == "sight"
        for wrong, why in (
            (self.hindsight and self.observation != "goal", "hindsight needs observation='goal'"),
            (self.hindsight and self.algorithm not in ("sac", "td3"), "hindsight needs SAC or TD3"),
            (self.hindsight and self.env.get("grasp_hint"),
             "hindsight cannot be with grasp_hint, whose entries follow the true goal and not the "
             "replayed one; leave one of them out"),
            (self.demonstrations and self.algorithm not in ("sac", "td3"),
             "demonstrations go into the replay buffer of SAC or TD3"),
            (self.cloning is not None and self.algorithm not in ("sac", "clone"),
             "only SAC's actor can be cloned"),
            (self.algorithm == "clone" and self.cloning is None, "'clone' needs cloning"),
            (self.batch is not None and self.algorithm != "ppo-batch",
             "only 'ppo-batch' trains on a batch"),
            (self.batch is not None and self.processes is not None,
             "a batch has no processes; leave one of them out"),
            (self.cloning is not None
             and self.observation != ("pixels+proprio" if sees else "state"),
             "cloning needs observation='state', or 'pixels+proprio' for the extractor 'sight'"),
            ((self.demonstrations or self.cloning is not None)
             and self.env.get("action", "ee_delta") != "ee_delta",
             "the expert acts in action='ee_delta'"),
            (self.network.extractor == "table" and self.observation != "state",
             "the extractor 'table' needs observation='state'"),
            (self.looks != (self.network.extractor == "look"),
             "the extractor 'look' and geometry='height_map' need each other"),
            (self.looks and (self.observation != "state" or self.env.get("grasp_hint")),
             "the extractor 'look' needs observation='state' without a grasp hint"),
            (sees and self.observation != "pixels+proprio",
             "the extractor 'sight' needs observation='pixels+proprio'"),
            (self.network.extractor == "goal" and self.observation != "goal",
             "the extractor 'goal' needs observation='goal'"),
            (self.network.extractor == "flat" and self.observation not in ("state", "goal"),
             "policies of pictures and point clouds are for scripts of your own"),
        ):  # fmt: skip
            if wrong:
                raise InputError(f"{self.name}: {why}.")


def env_keywords() -> frozenset[str]:
    """Return what a recipe may say of its environment."""
    from ..settings import KEYWORDS

    return KEYWORDS - _ELSEWHERE | {"preset"}


def recipe(name: str, changes: Iterable[str] = ()) -> Recipe:
    """Return a recipe.

    Args:
        name: one that is shipped, or the path of a TOML file.
        changes: "key=value" with a TOML value, each in place of what the recipe says
            ("steps=1000", "options.gamma=0.9").

    Raises:
        InputError: no such recipe, an unknown key, or a value of wrong type or out of range.
    """
    if name.endswith(".toml"):
        path = Path(name)
        payload, name = _read(path), path.stem
    else:
        shipped = _read(FILE)
        if name not in shipped:
            raise InputError(
                f"Unknown recipe {name!r}." + choices(name, shipped) + " One of your own is the "
                "path of a TOML file."
            )
        payload = shipped[name]
    payload = _merge({"env": {"randomization": STARTS}}, payload)
    for change in changes:
        payload = _merge(payload, _change(change))
    _check_values(name, payload)
    return recipe_of({"name": name, **payload})


def recipe_of(payload: Mapping[str, Any]) -> Recipe:
    """Make a recipe of what a TOML or JSON file holds.

    Raises:
        InputError: an unknown or missing key, or a value of wrong type or out of range.
    """
    name = printable(payload.get("name", "recipe"), "A recipe's name", InputError)
    known = {f.name for f in fields(Recipe)}
    for key in payload:
        require_known(key, known, f"{name}: a recipe has no")
    for key in ("task", "algorithm"):
        if key not in payload:
            raise InputError(f"{name}: a recipe needs {key!r}.")
    values: dict[str, Any] = {**payload, "name": name}
    for key in ("env", "options", "cloning", "batch", "network"):
        if not isinstance(values.get(key, {}), Mapping | None):
            raise InputError(f"{name}: {key} is a table of settings, got {values[key]!r}.")
    for key in ("env", "options"):
        values[key] = dict(values.get(key) or {})
    for key in ("scenes", "held_out"):
        if isinstance(values.get(key), list):
            values[key] = tuple(values[key])
    values["network"] = network_of(values.get("network") or {}, name)
    return Recipe(**values)


def as_texts(scenes: str | tuple[str, ...]) -> tuple[str, ...]:
    """Return what a recipe says of its scenes, one text or several, as several."""
    return scenes if isinstance(scenes, tuple) else (scenes,)


def network_of(payload: Mapping[str, Any], name: str) -> Network:
    """Make a network's description of what a file holds; ``name`` is the file's for messages.

    Raises:
        InputError: an unknown key, or a value of wrong type or out of range.
    """
    known = {f.name for f in fields(Network)}
    for key in payload:
        require_known(key, known, f"{name}: a network has no")
    values = dict(payload)
    if isinstance(values.get("layers"), list):
        values["layers"] = tuple(values["layers"])
    return Network(**values)


def _check_scenes(name: str, side: str, value: Any) -> None:
    several = as_texts(value)
    if not several or not all(isinstance(s, str) and s for s in several):
        raise InputError(f"{name}: {side} is a text or several, got {value!r}.")


def _read(path: Path) -> dict[str, Any]:
    raw = read_regular(path, "The recipe", InputError, max_bytes=MOST_BYTES)
    return parse_toml(raw, f"{path}", InputError)


def _check_values(name: str, value: Any) -> None:
    """Refuse what JSON has not: dates, times, and numbers that are not finite."""
    inner = (
        value.values() if isinstance(value, Mapping) else value if isinstance(value, list) else ()
    )
    for part in inner:
        _check_values(name, part)
    if isinstance(value, (date, time)):
        raise InputError(f"{name}: {value} is a date or a time; put it in quotes.")
    if isinstance(value, float) and not math.isfinite(value):
        raise InputError(f"{name}: {value} is no number a recipe can hold.")


def _change(text: str) -> dict[str, Any]:
    key, equals, value = text.partition("=")
    try:
        if not equals:
            raise ValueError("it lacks '='")
        try:
            return _toml(f"{key} = {value}")
        except ValueError:  # a bare word is a text
            return _toml(f"{key} = {json.dumps(value.strip())}")
    except ValueError as error:
        raise InputError(
            f"A change is 'key=value' with a TOML value, got {text!r} ({error})."
        ) from error


def _toml(text: str) -> dict[str, Any]:
    return parse_toml(text.encode(), "It", InputError)


def _merge(payload: Mapping[str, Any], change: Mapping[str, Any]) -> dict[str, Any]:
    merged = dict(payload)
    for key, value in change.items():
        both = isinstance(value, Mapping) and isinstance(merged.get(key), Mapping)
        merged[key] = _merge(merged[key], value) if both else value
    return merged
