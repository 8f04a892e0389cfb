"""Recipes: the complete settings of a training run, as data.

The shipped recipes are the tables of ``recipes.toml``; your own recipe is a TOML file with the same
keys at the top level. A run stores its recipe beside its weights.
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
"""The file of the shipped recipes."""

STARTS = "starts"
"""The default ``randomization`` of recipes; without it, every episode on a table starts from the
same state.
"""

MOST_BYTES = 2**16
"""Maximum size of a recipe file."""

_ELSEWHERE = frozenset({
    "render", "render_mode", "render_size", "renderer", "worlds", "robot", "cache", "masters",
})  # fmt: skip


@dataclass(frozen=True)
class Network:
    """The architecture of a policy.

    Attributes:
        extractor: feature extractor. "table": ``network.TableExtractor`` (state); "goal": the same
            for goal observations; "flat": all entries unchanged; "look": state and height maps,
            with a head that finds grasps (``look_extractor``); "sight": the same for pictures with
            depth (``sight_extractor``).
        layers: widths of the hidden layers after the extractor.
        width: number of features into which the extractor pools the other objects.
        activation: "relu" or "tanh".
    """

    extractor: Extractor = "table"
    layers: tuple[int, ...] = (256, 256)
    width: int = 64
    activation: Activation = "relu"

    @property
    def finds_grasps(self) -> bool:
        """Whether the policy has a grasp head."""
        return self.extractor in ("look", "sight")

    def __post_init__(self) -> None:
        require_known(self.extractor, get_args(Extractor), "Unknown Network.extractor")
        require_known(self.activation, get_args(Activation), "Unknown Network.activation")
        require(self, "width", minimum=1, maximum=1024, integer=True)
        sizes = self.layers if isinstance(self.layers, tuple) else ()
        if not (0 < len(sizes) <= 8 and all(type(s) is int and 0 < s <= 4096 for s in sizes)):
            raise InputError(
                f"Network layers must be 1 to 8 integers from 1 to 4096, got {self.layers!r}."
            )


@dataclass(frozen=True)
class Recipe:
    """Settings for training a policy on one task.

    Attributes:
        name: the recipe's name.
        task: the task; see ``tabletopgen_env.tasks``.
        algorithm: "sac", "td3" or "ppo" of Stable-Baselines3, "ppo-batch" for this package's
            ``ppo``, or "clone" for cloning only.
        steps: total environment steps; for cloning, the rounds apply instead.
        envs: environments stepped in parallel.
        processes: number of processes that share the environments evenly; None for threads of the
            current process. The results do not depend on it, except with "refreshing" scenes.
        scenes: training scenes: one or several strings accepted by the package ``scenes``. Only the
            training part of scenes generated on demand ("fresh", "refreshing", "curriculum") is
            used.
        batch: settings of ``ppo.batches.BatchConfig``: "ppo-batch" trains on a ``TabletopBatchEnv``
            of ``envs`` worlds, on a GPU. None for environments on the CPU's cores. Evaluation runs
            on the CPU in both cases.
        held_out: evaluation scenes; only the held-out part of scenes generated on demand is used.
        variants: number of different "fresh" tables (per prompt, if there is one), training and
            held-out tables together. If it is small, each table is compiled once and used
            repeatedly. Ignored for other scenes.
        env: further keyword arguments of the environment. Recipes read by ``recipe`` have the
            randomization ``STARTS`` unless they set another one; "none" disables it.
        network: the policy's architecture.
        options: keyword arguments of the Stable-Baselines3 class, where "action_noise" is a
            standard deviation (TD3); for "ppo-batch", settings of ``ppo.config.PPOConfig``.
        hindsight: relabelled goals per true goal (HER); 0 for none.
        demonstrations: episodes of the expert in the initial replay buffer.
        cloning: settings of ``CloningConfig``: the actor starts as a clone of the expert. None for
            random initial weights.

    Raises:
        InputError: a value is out of range, or settings are inconsistent.
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
        require_known(self.task, NAMES, "Unknown Recipe.task")
        require_known(self.algorithm, get_args(Algorithm), "Unknown Recipe.algorithm")
        require(self, "steps", "envs", minimum=1, integer=True)
        if self.processes is not None:
            require(self, "processes", minimum=1, integer=True)
        require(self, "hindsight", "demonstrations", minimum=0, integer=True)
        require(self, "variants", minimum=1, maximum=MOST_SEEDS, integer=True)
        for side in ("scenes", "held_out"):
            _check_scenes(self.name, side, getattr(self, side))
        known = env_keywords()
        for key in self.env:
            require_known(key, known, f"{self.name}: an environment has no setting")
        self._check_together()

    @property
    def observation(self) -> str:
        """The observation mode."""
        return str(self.env.get("observation", "state"))

    @property
    def looks(self) -> bool:
        """Whether the observation includes height maps."""
        return self.env.get("geometry", "none") != "none"

    def facts(self) -> dict[str, Any]:
        """Return the recipe as JSON-compatible values for ``recipe_of``."""
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
             "hindsight cannot be combined with grasp_hint, whose entries follow the true goal and "
             "not the relabelled goal; remove one of the two settings"),
            (self.demonstrations and self.algorithm not in ("sac", "td3"),
             "demonstrations need the replay buffer of SAC or TD3"),
            (self.cloning is not None and self.algorithm not in ("sac", "clone"),
             "only SAC's actor can be cloned"),
            (self.algorithm == "clone" and self.cloning is None, "'clone' needs a [cloning] table"),
            (self.batch is not None and self.algorithm != "ppo-batch",
             "only 'ppo-batch' trains on a batch"),
            (self.batch is not None and self.processes is not None,
             "batch and processes cannot be combined; remove one of the two settings"),
            (self.cloning is not None
             and self.observation != ("pixels+proprio" if sees else "state"),
             "cloning needs observation='state', or 'pixels+proprio' for the extractor 'sight'"),
            ((self.demonstrations or self.cloning is not None)
             and self.env.get("action", "ee_delta") != "ee_delta",
             "the expert needs action='ee_delta'"),
            (self.network.extractor == "table" and self.observation != "state",
             "the extractor 'table' needs observation='state'"),
            (self.looks != (self.network.extractor == "look"),
             "the extractor 'look' and geometry='height_map' require each other"),
            (self.looks and (self.observation != "state" or self.env.get("grasp_hint")),
             "the extractor 'look' needs observation='state' without a grasp hint"),
            (sees and self.observation != "pixels+proprio",
             "the extractor 'sight' needs observation='pixels+proprio'"),
            (self.network.extractor == "goal" and self.observation != "goal",
             "the extractor 'goal' needs observation='goal'"),
            (self.network.extractor == "flat" and self.observation not in ("state", "goal"),
             "policies for pictures and point clouds need your own training script"),
        ):  # fmt: skip
            if wrong:
                raise InputError(f"{self.name}: {why}.")


def env_keywords() -> frozenset[str]:
    """Return the keyword arguments of the environment that a recipe can set."""
    from ..settings import KEYWORDS

    return KEYWORDS - _ELSEWHERE | {"preset"}


def recipe(name: str, changes: Iterable[str] = ()) -> Recipe:
    """Load a recipe.

    Args:
        name: name of a shipped recipe, or path of a TOML file.
        changes: "key=value" pairs with TOML values that override the recipe's settings
            ("steps=1000", "options.gamma=0.9").

    Raises:
        InputError: the recipe does not exist, a key is unknown, or a value has the wrong type or is
            out of range.
    """
    if name.endswith(".toml"):
        path = Path(name)
        payload, name = _read(path), path.stem
    else:
        shipped = _read(FILE)
        if name not in shipped:
            raise InputError(
                f"Unknown recipe {name!r}."
                + choices(name, shipped)
                + (" For your own recipe, pass the path of a TOML file.")
            )
        payload = shipped[name]
    payload = _merge({"env": {"randomization": STARTS}}, payload)
    for change in changes:
        payload = _merge(payload, _change(change))
    _check_values(name, payload)
    return recipe_of({"name": name, **payload})


def recipe_of(payload: Mapping[str, Any]) -> Recipe:
    """Create a recipe from the content of a TOML or JSON file.

    Raises:
        InputError: a key is unknown or missing, or a value has the wrong type or is out of range.
    """
    name = printable(payload.get("name", "recipe"), "A recipe's name", InputError)
    known = {f.name for f in fields(Recipe)}
    for key in payload:
        require_known(key, known, f"{name}: a recipe has no setting")
    for key in ("task", "algorithm"):
        if key not in payload:
            raise InputError(f"{name}: the setting {key!r} is missing.")
    values: dict[str, Any] = {**payload, "name": name}
    for key in ("env", "options", "cloning", "batch", "network"):
        if not isinstance(values.get(key, {}), Mapping | None):
            raise InputError(f"{name}: {key} must be a table of settings, got {values[key]!r}.")
    for key in ("env", "options"):
        values[key] = dict(values.get(key) or {})
    for key in ("scenes", "held_out"):
        if isinstance(values.get(key), list):
            values[key] = tuple(values[key])
    values["network"] = network_of(values.get("network") or {}, name)
    return Recipe(**values)


def as_texts(scenes: str | tuple[str, ...]) -> tuple[str, ...]:
    """Return a recipe's scenes, one string or several, as a tuple of strings."""
    return scenes if isinstance(scenes, tuple) else (scenes,)


def network_of(payload: Mapping[str, Any], name: str) -> Network:
    """Create a network's settings from the content of a file; ``name`` is used in error messages.

    Raises:
        InputError: a key is unknown, or a value has the wrong type or is out of range.
    """
    known = {f.name for f in fields(Network)}
    for key in payload:
        require_known(key, known, f"{name}: a network has no setting")
    values = dict(payload)
    if isinstance(values.get("layers"), list):
        values["layers"] = tuple(values["layers"])
    return Network(**values)


def _check_scenes(name: str, side: str, value: Any) -> None:
    several = as_texts(value)
    if not several or not all(isinstance(s, str) and s for s in several):
        raise InputError(f"{name}: {side} must be a string or a list of strings, got {value!r}.")


def _read(path: Path) -> dict[str, Any]:
    raw = read_regular(path, "The recipe", InputError, max_bytes=MOST_BYTES)
    return parse_toml(raw, f"{path}", InputError)


def _check_values(name: str, value: Any) -> None:
    """Reject values that JSON cannot represent: dates, times and non-finite numbers."""
    inner = (
        value.values() if isinstance(value, Mapping) else value if isinstance(value, list) else ()
    )
    for part in inner:
        _check_values(name, part)
    if isinstance(value, (date, time)):
        raise InputError(f"{name}: {value} is a date or a time; put it in quotes.")
    if isinstance(value, float) and not math.isfinite(value):
        raise InputError(f"{name}: {value} is not a finite number.")


def _change(text: str) -> dict[str, Any]:
    key, equals, value = text.partition("=")
    try:
        if not equals:
            raise ValueError("the change lacks '='")
        try:
            return _toml(f"{key} = {value}")
        except ValueError:  # an unquoted word is a string
            return _toml(f"{key} = {json.dumps(value.strip())}")
    except ValueError as error:
        raise InputError(
            "A change to a recipe must have the form 'key=value' with a TOML value, got "
            f"{text!r} ({error})."
        ) from error


def _toml(text: str) -> dict[str, Any]:
    return parse_toml(text.encode(), "It", InputError)


def _merge(payload: Mapping[str, Any], change: Mapping[str, Any]) -> dict[str, Any]:
    merged = dict(payload)
    for key, value in change.items():
        both = isinstance(value, Mapping) and isinstance(merged.get(key), Mapping)
        merged[key] = _merge(merged[key], value) if both else value
    return merged
