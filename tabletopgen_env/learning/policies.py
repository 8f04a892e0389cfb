"""Policy files: a trained actor's weights with metadata, without executable content.

A file is in safetensors format; its header holds a *card* as JSON. Loading a file unpickles
nothing, and checks sizes, names, shapes and numbers first. The card also stores the network's
outputs for a fixed observation, so that a policy is refused if this package now computes its
features differently, instead of failing at its task.
"""

from __future__ import annotations

import itertools
import json
import math
import warnings
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from importlib import metadata
from pathlib import Path
from typing import Any, get_args

import numpy as np
import torch
from safetensors import SafetensorError, safe_open
from safetensors.torch import save as packed
from torch import Tensor

from generator.errors import InputError, choices
from generator.io.bounded import parse_object
from generator.io.files import write_whole

from ..files import check_type
from ..tasks.names import NAMES
from .algorithms.learner import Learner
from .networks.actor import Actor, Shape, Squash, shape_of, tensors_of
from .recipes import Network, Recipe, as_texts, network_of
from .runs import kept_policy

SHIPPED = Path(__file__).with_name("trained")
"""Folder of the policies shipped with the package."""

KEY = "tabletopgen_policy"
"""Key of the header under which the policy's card is stored as one string, since safetensors does
not preserve the order of keys."""

FORMAT = 1
"""Version of the file format; other versions are rejected."""

MOST_BYTES = 5 * 2**20
"""Maximum size of a policy file."""

_MOST_CARD = 2**16
_MOST_INPUTS, _MOST_PART, _MOST_ACTIONS = 4096, 2**18, 64
_MOST_PARTS = 32
_VERSIONS = ("tabletopgen", "mujoco", "gymnasium", "stable-baselines3", "torch")


@dataclass(frozen=True)
class Card:
    """Metadata of a policy.

    Attributes:
        task: the policy's task.
        env: keyword arguments of its training environment.
        network: its network settings.
        inputs: size of each part of the observation by name, or shape if the part has several axes.
        actions: number of entries of an action.
        squash: function applied to the output layer: "tanh" or "clip".
        recipe: name of the recipe.
        seed: seed of the training run.
        steps: environment steps taken so far.
        scenes: training scenes, as in the recipe; for scenes generated on demand, the training
            part.
        validation: "solved", "episodes", "tables" (number of different tables) and "scenes" of its
            last evaluation during training, if there was one. It is used to select the best policy
            of a run, so it is not a test result.
        versions: versions of the libraries used in training, and of the grasp detector.
    """

    task: str
    env: Mapping[str, Any]
    network: Network
    inputs: Mapping[str, Shape]
    actions: int
    squash: Squash
    recipe: str
    seed: int
    steps: int
    scenes: tuple[str, ...]
    validation: Mapping[str, Any]
    versions: Mapping[str, str]


@dataclass(frozen=True, eq=False)
class TrainedPolicy:
    """A policy for inference; ``predict`` is as in Stable-Baselines3, but always deterministic."""

    card: Card
    actor: Actor

    def predict(
        self, observation: Any, state: Any = None, episode_start: Any = None,
        deterministic: bool = True,
    ) -> tuple[np.ndarray, Any]:  # fmt: skip
        """Return the action for one observation or a batch, and the policy's memory.

        ``state`` is the memory from the last call, None at the start of an episode.
        ``episode_start`` marks the rows of a batch whose episode begins. Policies without memory
        return ``state`` unchanged; policies that use pictures (``networks.sight_extractor``)
        perform worse if it is not passed.

        Raises:
            InputError: the observation or ``state`` has the wrong shape, or ``deterministic`` is
                False.
        """
        if not deterministic:
            raise InputError(
                "Policies from files are deterministic; call predict(deterministic=True)."
            )
        seen, batch = tensors_of(self.card.inputs, observation)
        size = self.actor.memory_size
        if size:
            rows = len(next(iter(seen.values())))
            memory = _memory(state, episode_start, (rows, size))
            with torch.no_grad():
                last, after = self.actor.recall(seen, memory)
            state = after.numpy()
        else:
            with torch.no_grad():
                last = self.actor(seen)
        if self.card.squash == "tanh":  # rounded as in Stable-Baselines3
            scaled = torch.tanh(last).numpy()
            actions = np.float32(-1.0) + np.float32(0.5) * (scaled + 1.0) * np.float32(2.0)
        else:
            actions = np.clip(last.numpy(), -1.0, 1.0)
        return (actions if batch else actions[0]), state


def _memory(state: Any, starts: Any, shape: tuple[int, int]) -> Tensor:
    """Validate and return a policy's memory, with zeros in the rows whose episode begins."""
    if state is None:
        return torch.zeros(shape)
    memory = np.array(state, np.float32)
    if memory.shape != shape or not np.isfinite(memory).all():
        raise InputError(
            f"The policy's state must be finite numbers of shape {shape}, got {memory.shape}. "
            "Pass the state from the last call, or None at the start of an episode."
        )
    if starts is not None:
        memory[np.asarray(starts, bool)] = 0.0
    return torch.from_numpy(memory)


def policy_from(
    learner: Learner,
    recipe: Recipe,
    seed: int,
    validation: Mapping[str, Any] | None = None,
    steps: int = 0,
) -> TrainedPolicy:
    """Export a learner as a policy; ``validation`` and ``steps`` are stored in its card."""
    actor, squash = learner.export()
    card = Card(
        recipe.task, dict(recipe.env), recipe.network, actor.inputs, actor.last.out_features,
        squash, recipe.name, seed, steps, as_texts(recipe.scenes), dict(validation or {}),
        {name: _version(name) for name in _VERSIONS} | _detector(recipe.env),
    )  # fmt: skip
    return TrainedPolicy(card, actor)


def save_policy(policy: TrainedPolicy, path: str | Path, half: bool = False) -> Path:
    """Write a policy file atomically into an existing folder.

    ``half`` stores half precision: half the size, with slightly different actions.

    Raises:
        InputError: the file would exceed ``MOST_BYTES``, or a string in its card is not printable.
        StorageError: the file cannot be written.
    """
    path, content = Path(path), policy_bytes(policy, half)
    write_whole(path, content, "The policy", "Choose another folder.")
    return path


def policy_bytes(policy: TrainedPolicy, half: bool = False) -> bytes:
    """Return the content of a policy file; raise InputError as ``save_policy`` does."""
    kind = torch.float16 if half else torch.float32
    weights = {k: v.detach().to(kind).contiguous() for k, v in policy.actor.state_dict().items()}
    kept = Actor(policy.card.network, policy.card.inputs, policy.card.actions)
    _fill(kept, weights)
    _check_printable(asdict(policy.card))
    card = {"format": FORMAT, **asdict(policy.card), "answers": _answers(kept, policy.card.inputs)}
    content = packed(weights, {KEY: json.dumps(card, sort_keys=True, allow_nan=False)})
    if len(content) > MOST_BYTES:
        raise InputError(
            f"The policy has {len(content)} bytes, which exceeds the maximum of {MOST_BYTES}: "
            "use narrower layers, or half=True."
        )
    return content


def shipped_policies() -> dict[str, Path]:
    """Return the names and paths of the shipped policies."""
    return {path.stem: path for path in sorted(SHIPPED.glob("*.safetensors"))}


def load_policy(name: str | Path) -> TrainedPolicy:
    """Load a shipped policy by name, such as "reach-clone", or any policy by path.

    Raises:
        InputError: the file is missing, too large, damaged, not a policy file, or has an
            unsupported version.
    """
    path = Path(name)
    try:
        path = find_policy(name)
        if path.stat().st_size > MOST_BYTES:
            raise InputError(f"{path} exceeds the {MOST_BYTES} bytes of a policy file.")
        with safe_open(path, framework="pt") as file:
            notes = file.metadata() or {}
            card, answers = _card(notes)
            actor = Actor(card.network, card.inputs, card.actions)
            _fill(actor, {key: file.get_tensor(key) for key in file.keys()})  # noqa: SIM118
            _check_answers(answers, _answers(actor, card.inputs))
    except (SafetensorError, ValueError, TypeError, KeyError, RecursionError, OSError) as error:
        if isinstance(error, InputError) and str(path) in str(error):
            raise
        raise InputError(
            f"{path} is not a valid policy file ({type(error).__name__}: {error}). Policy "
            "files are created by training; see docs/guides/training.md."
        ) from error
    if any(card.versions.get(k, v) != v for k, v in _detector(card.env).items()):
        warnings.warn(
            f"{path} was trained with another version of the grasp detector; its grasps may be "
            "worse.",
            stacklevel=2,
        )
    return TrainedPolicy(card, actor)


def find_policy(name: str | Path) -> Path:
    """Return the policy file for a shipped policy's name, a run's folder, or a path.

    Raises:
        InputError: no such file or folder exists, or the folder holds no policy.
    """
    shipped, path = shipped_policies(), Path(name)
    if path.is_dir():
        return kept_policy(path)
    if str(name) in shipped:
        return shipped[str(name)]
    if path.is_file():
        return path
    raise InputError(
        f"Unknown policy {str(name)!r}: it is neither a file nor a shipped policy."
        + choices(str(name), shipped)
    )


def _fill(actor: Actor, weights: Mapping[str, Tensor]) -> None:
    own = actor.state_dict()
    if set(own) != set(weights):
        odd = sorted(set(own) ^ set(weights))[:3]
        raise ValueError(f"the weights do not match the network: {', '.join(odd)}")
    for name, value in weights.items():
        if value.dtype not in (torch.float16, torch.float32) or value.shape != own[name].shape:
            raise ValueError(f"{name} is {value.dtype} of {tuple(value.shape)}, not "
                             f"{tuple(own[name].shape)}")  # fmt: skip
        if not torch.isfinite(value).all():
            raise ValueError(f"{name} is not finite")
    actor.load_state_dict({k: v.float() for k, v in weights.items()})
    actor.eval().requires_grad_(False)


def _answers(actor: Actor, inputs: Mapping[str, Shape]) -> list[float]:
    """Compute a network's outputs for a fixed observation."""
    rng = np.random.default_rng(0)
    seen: Any = {
        name: rng.normal(0.0, 0.3, shape_of(size)) for name, size in sorted(inputs.items())
    }
    with torch.no_grad():
        last = actor(tensors_of(inputs, seen.get("", seen))[0])
    return [float(v) for v in last[0]]


def _check_answers(kept: list[float], own: list[float]) -> None:
    """Raise ValueError if a network's outputs differ from the saved ones."""
    if len(kept) != len(own) or not np.allclose(kept, own, rtol=1e-3, atol=1e-3):
        raise ValueError(
            "the network's outputs differ from the saved ones: this version of the package "
            "processes observations differently, or the file was changed"
        )


def _card(notes: Mapping[str, str]) -> tuple[Card, list[float]]:
    """Return the validated card in a file's header, and the saved outputs."""
    if KEY not in notes:
        raise ValueError(f"the header has no {KEY!r}")
    if len(notes[KEY]) > _MOST_CARD:
        raise ValueError(f"the card has more than {_MOST_CARD} characters")
    payload = parse_object(notes[KEY], "the card", InputError)
    _check_printable(payload)
    version = payload.pop("format", None)
    if type(version) is not int or version != FORMAT:
        raise ValueError(f"the version is {version!r}, but this package reads version {FORMAT}")
    if set(payload) != {*(f.name for f in fields(Card)), "answers"}:
        raise ValueError(f"the card has unexpected keys: {', '.join(sorted(payload))}")
    inputs = {check_type(k, str): _shape(v) for k, v in check_type(payload["inputs"], dict).items()}
    parts = [math.prod(shape_of(shape)) for shape in inputs.values()]
    sizes = (*(n for shape in inputs.values() for n in shape_of(shape)), payload["actions"])
    if not inputs or ("" in inputs and len(inputs) > 1) or len(inputs) > _MOST_PARTS:
        raise ValueError(f"invalid observation parts {inputs}")
    if (
        max(parts) > _MOST_PART
        or not all(0 < size <= _MOST_INPUTS for size in sizes)
        or sizes[-1] > _MOST_ACTIONS
    ):
        raise ValueError(f"invalid sizes {sizes}")
    network = network_of(check_type(payload["network"], dict), "the card")
    wide = (min(sum(parts), _MOST_INPUTS), *network.layers, check_type(payload["actions"], int))
    if sum(a * b for a, b in itertools.pairwise(wide)) > MOST_BYTES:
        raise ValueError(f"invalid layer widths {network.layers}")
    task, squash = check_type(payload["task"], str), check_type(payload["squash"], str)
    if task not in NAMES:
        raise ValueError(f"unknown task {task!r}")
    if squash not in get_args(Squash):
        raise ValueError(f"unknown squash function {squash!r}")
    env = check_type(payload["env"], dict)
    Recipe(
        "checks that they are consistent", task, "sac", env=env, network=network
    )  # checks that the values are consistent
    versions = _table(payload["versions"], str)
    answers = [check_type(v, float) for v in check_type(payload["answers"], list)]
    return Card(
        task, env, network, inputs, payload["actions"], squash,  # pyright: ignore
        check_type(payload["recipe"], str), check_type(payload["seed"], int),
        check_type(payload["steps"], int),
        tuple(check_type(v, str) for v in check_type(payload["scenes"], list)),
        _validation(check_type(payload["validation"], dict)), versions,
    ), answers  # fmt: skip


def _shape(payload: Any) -> Shape:
    """Parse the size or shape of an observation part."""
    if not isinstance(payload, list):
        return check_type(payload, int)
    if not 1 < len(payload) <= 3:
        raise ValueError(f"invalid observation shape {payload}")
    return tuple(check_type(n, int) for n in payload)


def _table(payload: Any, kind: type) -> dict[str, Any]:
    return {check_type(k, str): check_type(v, kind) for k, v in check_type(payload, dict).items()}


def _validation(payload: dict[str, Any]) -> dict[str, Any]:
    if not payload:
        return {}
    solved, played, tables = (check_type(payload[k], int) for k in ("solved", "episodes", "tables"))
    if not (0 <= solved <= played and 0 < tables <= played):
        raise ValueError(f"invalid validation: {solved} of {played} episodes on {tables} tables")
    scenes = check_type(payload["scenes"], str)
    return {"solved": solved, "episodes": played, "tables": tables, "scenes": scenes}


def _check_printable(value: Any) -> None:
    """Raise InputError for strings with control characters."""
    if isinstance(value, str) and not value.isprintable():
        raise InputError(f"The strings of a policy's card must be printable, got {value!r}.")
    if isinstance(value, dict):
        value = [*value, *value.values()]
    if isinstance(value, list | tuple):
        for part in value:
            _check_printable(part)


def _detector(env: Mapping[str, Any]) -> dict[str, str]:
    """Return a dict with the grasp detector's digest, or an empty dict if no detector is used."""
    if env.get("grasp_hint") != "detected":
        return {}
    from ..detection.detector import shipped_digest

    return {"grasp-detector": shipped_digest()}


def _version(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return "unknown"
