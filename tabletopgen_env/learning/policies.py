"""Policy files: a trained actor's weights with what it was made for, and nothing that runs.

A file is safetensors; its header holds a *card* as JSON. Reading one unpickles nothing, and checks
sizes, names, shapes and numbers before anything is made of them. Beside the card are the answers
of the network to a fixed observation, so that a policy whose features this package has come to
compute otherwise is refused instead of failing at its task.
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
"""Where the policies are that the package ships."""

KEY = "tabletopgen_policy"
"""Where the header has the card; one key alone, as safetensors shuffles several."""

FORMAT = 1
"""The files' version; others are refused."""

MOST_BYTES = 5 * 2**20
"""A policy file is not larger."""

_MOST_CARD = 2**16
_MOST_INPUTS, _MOST_PART, _MOST_ACTIONS = 4096, 2**18, 64
_MOST_PARTS = 32
_VERSIONS = ("tabletopgen", "mujoco", "gymnasium", "stable-baselines3", "torch")


@dataclass(frozen=True)
class Card:
    """What is known of a policy.

    Attributes:
        task: what it does.
        env: keywords of the environment it was trained in.
        network: what it is made of.
        inputs: the observation's parts by name, each with its size, or its shape if it has axes.
        actions: entries of an action.
        squash: what becomes of the last layer's values: "tanh" or "clip".
        recipe: name of the recipe.
        seed: of the training.
        steps: of the environments until then.
        scenes: where it was trained, as the recipe says; of scenes made on demand, their training
            side.
        validation: "solved", "episodes", "tables" (how many different ones) and "scenes" of its
            last evaluation during training, where there was one. The best policy of a run is chosen
            by it, so it is no test.
        versions: of the libraries it was trained with, and of the grasp detector.
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
    """A policy that acts; ``predict`` is that of Stable-Baselines3, deterministic actions only."""

    card: Card
    actor: Actor

    def predict(
        self, observation: Any, state: Any = None, episode_start: Any = None,
        deterministic: bool = True,
    ) -> tuple[np.ndarray, Any]:  # fmt: skip
        """Return the action for one observation, or those of a batch, and what is remembered.

        ``state`` is what the last call returned, None at an episode's start; ``episode_start`` says
        of which rows of a batch the episode begins. Policies that remember nothing return ``state``
        as it is; those that see (``networks.sight_extractor``) act worse without it.

        Raises:
            InputError: the observation or ``state`` has another shape, or ``deterministic`` is
                False.
        """
        if not deterministic:
            raise InputError("A policy file holds no noise; call predict(deterministic=True).")
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
        if self.card.squash == "tanh":  # rounded as Stable-Baselines3 does
            scaled = torch.tanh(last).numpy()
            actions = np.float32(-1.0) + np.float32(0.5) * (scaled + 1.0) * np.float32(2.0)
        else:
            actions = np.clip(last.numpy(), -1.0, 1.0)
        return (actions if batch else actions[0]), state


def _memory(state: Any, starts: Any, shape: tuple[int, int]) -> Tensor:
    """Return what is remembered, nothing of rows whose episode begins."""
    if state is None:
        return torch.zeros(shape)
    memory = np.array(state, np.float32)
    if memory.shape != shape or not np.isfinite(memory).all():
        raise InputError(
            f"The policy remembers finite numbers of shape {shape}, got {memory.shape}. Pass what "
            "its last call returned, or None at the start of an episode."
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
    """Return a copy of what a learner does now; ``validation`` and ``steps`` are the card's."""
    actor, squash = learner.export()
    card = Card(
        recipe.task, dict(recipe.env), recipe.network, actor.inputs, actor.last.out_features,
        squash, recipe.name, seed, steps, as_texts(recipe.scenes), dict(validation or {}),
        {name: _version(name) for name in _VERSIONS} | _detector(recipe.env),
    )  # fmt: skip
    return TrainedPolicy(card, actor)


def save_policy(policy: TrainedPolicy, path: str | Path, half: bool = False) -> Path:
    """Write a policy file, whole or not at all; its folder must be there.

    ``half`` keeps half precision: half the size, slightly other actions.

    Raises:
        InputError: it would be larger than ``MOST_BYTES``, or a text of its card cannot be shown.
        StorageError: it cannot be written.
    """
    path, content = Path(path), policy_bytes(policy, half)
    write_whole(path, content, "The policy", "Choose another folder.")
    return path


def policy_bytes(policy: TrainedPolicy, half: bool = False) -> bytes:
    """Return a policy file's content; raises InputError as ``save_policy``."""
    kind = torch.float16 if half else torch.float32
    weights = {k: v.detach().to(kind).contiguous() for k, v in policy.actor.state_dict().items()}
    kept = Actor(policy.card.network, policy.card.inputs, policy.card.actions)
    _fill(kept, weights)
    _check_printable(asdict(policy.card))
    card = {"format": FORMAT, **asdict(policy.card), "answers": _answers(kept, policy.card.inputs)}
    content = packed(weights, {KEY: json.dumps(card, sort_keys=True, allow_nan=False)})
    if len(content) > MOST_BYTES:
        raise InputError(
            f"The policy has {len(content)} bytes, a policy file at most {MOST_BYTES}: use "
            "narrower layers, or half=True."
        )
    return content


def shipped_policies() -> dict[str, Path]:
    """Return the policies the package ships, by name."""
    return {path.stem: path for path in sorted(SHIPPED.glob("*.safetensors"))}


def load_policy(name: str | Path) -> TrainedPolicy:
    """Read the policy of a shipped policy's name ("reach-clone"), or of a file's path.

    Raises:
        InputError: there is none, it is too large, damaged, of another version, or no policy.
    """
    path = Path(name)
    try:
        path = find_policy(name)
        if path.stat().st_size > MOST_BYTES:
            raise InputError(f"{path} has more than a policy file's {MOST_BYTES} bytes.")
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
            f"{path} is no sound policy file ({type(error).__name__}: {error}). Policy files are "
            "made by training; see docs/guides/training.md."
        ) from error
    if any(card.versions.get(k, v) != v for k, v in _detector(card.env).items()):
        warnings.warn(
            f"{path} learned with another grasp detector than this version of the package ships; "
            "it may grasp worse than it did.",
            stacklevel=2,
        )
    return TrainedPolicy(card, actor)


def find_policy(name: str | Path) -> Path:
    """Return the file of a shipped policy's name, of a run's folder, or of a path.

    Raises:
        InputError: none of them is there, or the folder holds no policy.
    """
    shipped, path = shipped_policies(), Path(name)
    if path.is_dir():
        return kept_policy(path)
    if str(name) in shipped:
        return shipped[str(name)]
    if path.is_file():
        return path
    raise InputError(
        f"There is no policy {str(name)!r}: neither a file nor a shipped one."
        + choices(str(name), shipped)
    )


def _fill(actor: Actor, weights: Mapping[str, Tensor]) -> None:
    own = actor.state_dict()
    if set(own) != set(weights):
        odd = sorted(set(own) ^ set(weights))[:3]
        raise ValueError(f"its weights are not those of its network: {', '.join(odd)}")
    for name, value in weights.items():
        if value.dtype not in (torch.float16, torch.float32) or value.shape != own[name].shape:
            raise ValueError(f"{name} is {value.dtype} of {tuple(value.shape)}, not "
                             f"{tuple(own[name].shape)}")  # fmt: skip
        if not torch.isfinite(value).all():
            raise ValueError(f"{name} is not finite")
    actor.load_state_dict({k: v.float() for k, v in weights.items()})
    actor.eval().requires_grad_(False)


def _answers(actor: Actor, inputs: Mapping[str, Shape]) -> list[float]:
    """Return what a network makes of a fixed observation."""
    rng = np.random.default_rng(0)
    seen: Any = {
        name: rng.normal(0.0, 0.3, shape_of(size)) for name, size in sorted(inputs.items())
    }
    with torch.no_grad():
        last = actor(tensors_of(inputs, seen.get("", seen))[0])
    return [float(v) for v in last[0]]


def _check_answers(kept: list[float], own: list[float]) -> None:
    """Refuse a network that computes other things than the one that was saved."""
    if len(kept) != len(own) or not np.allclose(kept, own, rtol=1e-3, atol=1e-3):
        raise ValueError(
            "its network answers otherwise than when it was saved: this version of the package "
            "looks at observations in another way, or the file was changed"
        )


def _card(notes: Mapping[str, str]) -> tuple[Card, list[float]]:
    """Return the card of a file's header, every value checked, and the answers kept with it."""
    if KEY not in notes:
        raise ValueError(f"its header has no {KEY!r}")
    if len(notes[KEY]) > _MOST_CARD:
        raise ValueError(f"its card has more than {_MOST_CARD} characters")
    payload = parse_object(notes[KEY], "its card", InputError)
    _check_printable(payload)
    version = payload.pop("format", None)
    if type(version) is not int or version != FORMAT:
        raise ValueError(f"it is of version {version!r}, this package reads {FORMAT}")
    if set(payload) != {*(f.name for f in fields(Card)), "answers"}:
        raise ValueError(f"its card has the keys {', '.join(sorted(payload))}")
    inputs = {check_type(k, str): _shape(v) for k, v in check_type(payload["inputs"], dict).items()}
    parts = [math.prod(shape_of(shape)) for shape in inputs.values()]
    sizes = (*(n for shape in inputs.values() for n in shape_of(shape)), payload["actions"])
    if not inputs or ("" in inputs and len(inputs) > 1) or len(inputs) > _MOST_PARTS:
        raise ValueError(f"a policy cannot look at {inputs}")
    if (
        max(parts) > _MOST_PART
        or not all(0 < size <= _MOST_INPUTS for size in sizes)
        or sizes[-1] > _MOST_ACTIONS
    ):
        raise ValueError(f"a policy cannot have sizes {sizes}")
    network = network_of(check_type(payload["network"], dict), "its card")
    wide = (min(sum(parts), _MOST_INPUTS), *network.layers, check_type(payload["actions"], int))
    if sum(a * b for a, b in itertools.pairwise(wide)) > MOST_BYTES:
        raise ValueError(f"a policy file cannot hold layers of {network.layers}")
    task, squash = check_type(payload["task"], str), check_type(payload["squash"], str)
    if task not in NAMES or squash not in get_args(Squash):
        raise ValueError(f"there is no task {task!r} with {squash!r}")
    env = check_type(payload["env"], dict)
    Recipe("its card", task, "sac", env=env, network=network)  # checks that they go together
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
    """Return the size, or the shape, of an observation's part."""
    if not isinstance(payload, list):
        return check_type(payload, int)
    if not 1 < len(payload) <= 3:
        raise ValueError(f"a policy cannot look at shape {payload}")
    return tuple(check_type(n, int) for n in payload)


def _table(payload: Any, kind: type) -> dict[str, Any]:
    return {check_type(k, str): check_type(v, kind) for k, v in check_type(payload, dict).items()}


def _validation(payload: dict[str, Any]) -> dict[str, Any]:
    if not payload:
        return {}
    solved, played, tables = (check_type(payload[k], int) for k in ("solved", "episodes", "tables"))
    if not (0 <= solved <= played and 0 < tables <= played):
        raise ValueError(f"{solved} of {played} episodes at {tables} tables cannot be")
    scenes = check_type(payload["scenes"], str)
    return {"solved": solved, "episodes": played, "tables": tables, "scenes": scenes}


def _check_printable(value: Any) -> None:
    """Refuse texts that would do something to a terminal (InputError: there is one)."""
    if isinstance(value, str) and not value.isprintable():
        raise InputError(f"A policy's card has only text that can be shown, got {value!r}.")
    if isinstance(value, dict):
        value = [*value, *value.values()]
    if isinstance(value, list | tuple):
        for part in value:
            _check_printable(part)


def _detector(env: Mapping[str, Any]) -> dict[str, str]:
    """Return what tells the grasp detector of an environment's state, if there is one in it."""
    if env.get("grasp_hint") != "detected":
        return {}
    from ..detection.detector import shipped_digest

    return {"grasp-detector": shipped_digest()}


def _version(name: str) -> str:
    try:
        return metadata.version(name)
    except metadata.PackageNotFoundError:
        return "unknown"
