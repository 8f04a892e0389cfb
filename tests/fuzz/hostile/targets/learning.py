"""Files of training: policies, recipes, resumed runs, and cached arrays."""

import functools
import io
import json
import random
import struct
import zipfile
from pathlib import Path
from typing import Any

import numpy as np

from generator.physics import decomposition
from tabletopgen_env.learning import plots, runs
from tabletopgen_env.learning.algorithms.sb3 import Sb3Learner
from tabletopgen_env.learning.networks.actor import Actor
from tabletopgen_env.learning.policies import KEY, Card, TrainedPolicy, load_policy, policy_bytes
from tabletopgen_env.learning.recipes import Network, Recipe, recipe, recipe_of

from ..judging import accepts, accepts_any, command
from ..odd import put
from ..streams import spoiled
from ..values import TEXTS, mutate, written
from . import Run
from .files import toml

_WORDS = ("sac", "td3", "ppo", "ppo-batch", "clone", "Reach", "Lift", "Stack", "table", "goal",
          "flat", "state", "relu", "tanh", "clip", "ee_delta", "detected", "starter:train",
          "fresh")  # fmt: skip


# --------------------------------------------------------------------------------------- policies
@functools.cache
def _policy() -> bytes:
    network = Network("flat", (8, 8), 8)
    card = Card("Reach", {}, network, {"": 12}, 4, "tanh", "small", 0, 100, ("starter:train",), {},
                {"torch": "2"})  # fmt: skip
    return policy_bytes(TrainedPolicy(card, Actor(network, {"": 12}, 4)))


def policies(rng: random.Random, folder: Path) -> Run:
    """Policy files, and untrusted zip files of Stable-Baselines3."""
    raw = _policy()
    size = struct.unpack("<Q", raw[:8])[0]
    header, data = json.loads(raw[8 : 8 + size]), raw[8 + size :]
    kind = rng.randrange(10)
    if kind < 4:
        card = mutate(json.loads(header["__metadata__"][KEY]), rng, _WORDS, raw=True)
        header["__metadata__"][KEY] = written(card, rng).decode("utf-8", "replace")
        raw = _safetensors(json.dumps(header).encode(), data)
    elif kind < 6:
        raw = _safetensors(written(mutate(header, rng, ("F16", "F64", "I8", "BOOL")), rng), data)
    elif kind == 6:
        raw = spoiled(raw, rng)
    elif kind == 7:
        floats = np.frombuffer(data, "<f4").copy()
        floats[rng.randrange(len(floats))] = rng.choice((np.nan, np.inf, 3e38, 1e-45))
        raw = _safetensors(json.dumps(header).encode(), floats.tobytes())
    elif kind == 8:
        length = rng.choice((0, 2**63, 2**64 - 1, 100 * 2**20, size + len(data)))
        raw = struct.pack("<Q", length) + raw[8:]
    else:
        raw = _zip(rng)
    path = folder / rng.choice(("p.safetensors", "p.safetensors", "best.safetensors", "p.zip"))
    put(path, raw, rng)
    played = rng.random() < 0.05

    def load() -> None:
        policy = load_policy(path)
        policy.predict({n: np.zeros(k) for n, k in policy.card.inputs.items()}
                       if "" not in policy.card.inputs
                       else np.zeros(policy.card.inputs[""]))  # fmt: skip

    def run() -> bool:
        good = accepts(load)
        if path.suffix == ".zip" or played:
            good |= command("enjoy", str(path), "--episodes", "0")
            command("enjoy", str(path), "--scenes", "none-such")
            command("enjoy", str(folder), "--scenes", "none-such")
        return good

    return run


def _safetensors(header: bytes, data: bytes) -> bytes:
    header += b" " * (-len(header) % 8)
    return struct.pack("<Q", len(header)) + header + data


class _Harm:
    """Writes outside the folder when it is unpickled."""

    def __reduce__(self) -> Any:
        return open, ("../../precious/file.txt", "w")


def _zip(rng: random.Random) -> bytes:
    """Return a model-like zip: with a harmful pickle, compression bombs, or unusual names."""
    import pickle

    file = io.BytesIO()
    names = ("data", "policy.pth", "pytorch_variables.pth", "../../precious/file.txt", "x" * 300)
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as packed:
        for name in names[: rng.randrange(1, 6)]:
            packed.writestr(name, rng.choice((pickle.dumps(_Harm()), bytes(2**20), b"{}")))
    return spoiled(file.getvalue(), rng) if rng.random() < 0.5 else file.getvalue()


# ---------------------------------------------------------------------------------------- recipes
@functools.cache
def _recipe() -> Recipe:
    return recipe_of({
        "name": "small", "task": "Reach", "algorithm": "sac", "steps": 120, "envs": 2,
        "scenes": ["starter:train", "x"], "env": {"observation": "state", "action": "ee_delta"},
        "network": {"layers": [16, 16], "width": 8, "extractor": "table", "activation": "relu"},
        "options": {"gamma": 0.9, "batch_size": 16, "buffer_size": 50}, "variants": 5,
    })  # fmt: skip


def recipes(rng: random.Random, folder: Path) -> Run:
    """User recipes, command-line changes to them, and their results."""
    payload = {k: v for k, v in _recipe().facts().items() if k not in ("name", "cloning")}
    content = toml(mutate(payload, rng, _WORDS))
    if rng.random() < 0.15:
        content = spoiled(content, rng)
    if rng.random() < 0.05:
        content = rng.choice((b"a = " + b"[" * 50_000, b"a." * 20_000 + b"b=1", b"[a]\n" * 9000))
    path = folder / "mine.toml"
    put(path, content, rng)
    keys = (
        "steps",
        "options.gamma",
        "env.observation",
        "network.layers",
        "a" * 3000,
        "",
        ".",
        "x.",
    )
    changes = [f"{rng.choice(keys)}={rng.choice((*TEXTS, '[1,2]', 'nan', '1e400'))}"
               for _ in range(rng.randrange(3))]  # fmt: skip
    mutated = mutate(_recipe().facts(), rng, _WORDS)
    trained = rng.random() < 0.05

    def read() -> None:
        json.dumps(recipe(str(path)).facts())

    def of_json() -> None:
        if isinstance(mutated, dict):
            recipe_of(mutated).facts()

    def run() -> bool:
        good = accepts_any(read, of_json, lambda: recipe("reach", changes))
        if trained:
            command("train", str(path), "--scenes", "none-such", "--out", "run")
        return good

    return run


# ------------------------------------------------------------------------------------------- runs
@functools.cache
def _checkpoint() -> tuple[bytes, bytes, dict[str, Any]]:
    """Return a run's model.zip, its replay buffer, and its counts."""
    import tempfile

    from tabletopgen_env.learning.demonstrations.replay import write_buffer

    with tempfile.TemporaryDirectory() as place:
        model = _model()
        model.save(Path(place, "model.zip"))
        write_buffer(model.replay_buffer, Path(place, "replay.npz"))
        return (
            Path(place, "model.zip").read_bytes(), Path(place, "replay.npz").read_bytes(),
            {"steps": 10, "updates": 5, "episodes": 1, "seconds": 1.0, "best": 0.5,
             "cloned": False},
        )  # fmt: skip


@functools.cache
def _model() -> Any:
    import gymnasium as gym
    from gymnasium import spaces
    from stable_baselines3 import SAC

    class Nothing(gym.Env[Any, Any]):
        observation_space = spaces.Box(-1, 1, (12,))
        action_space = spaces.Box(-1, 1, (4,))

    keywords = {"net_arch": [8]}
    return SAC("MlpPolicy", Nothing(), policy_kwargs=keywords, buffer_size=50, device="cpu")


def run_folders(rng: random.Random, folder: Path) -> Run:
    """Folders of runs: recipes, evaluations, checkpoints, replay buffers."""
    place = folder / "run"
    facts: Any = {"format": 1, "seed": 0, "recipe": _recipe().facts()}
    model, replay, counts = _checkpoint()
    rows = ["steps,seconds,episodes,solved,reward,length", "10,1.5,20,3,0.5,30", "20,2,20,9,1,10"]
    what = rng.randrange(6)
    if what == 0:
        facts = mutate(facts, rng, _WORDS, raw=True)
    elif what == 1:
        cells = rows[rng.randrange(3)].split(",")
        cells[rng.randrange(len(cells))] = rng.choice((*TEXTS, "0", "-5", "1e400", "9" * 5000))
        rows[rng.randrange(3)] = ",".join(cells)
    elif what == 2:
        counts = mutate(counts, rng, raw=True)
    elif what == 3:
        model = spoiled(model, rng) if rng.random() < 0.7 else _zip(rng)
    elif what == 4:
        replay = _npz(rng, replay)
    share = 0.1 if what == 5 else 0.02
    put(place / "recipe.json", written(facts, rng), rng, share)
    put(place / "evaluations.csv", "\n".join(rows).encode("utf-8", "surrogatepass"), rng, share)
    named = f"checkpoint-{rng.choice(('10', '10', '²', '9' * 300, '-1', 'part', 'x'))}"
    for name, content in (("model.zip", model), ("counts.json", written(counts, rng)),
                          ("replay.npz", replay)):  # fmt: skip
        put(place / named[:200] / name, content, rng, share)
    if rng.random() < 0.05:
        (place / "checkpoint-99").symlink_to(rng.choice(("../../../precious", ".", "nowhere")))

    def restore() -> None:
        run = runs.open_run(place)
        run.rows()
        run.restore(Sb3Learner(_model(), Network("flat", (8, 8), 8)))

    def plot() -> None:
        run = runs.open_run(place)
        plots.draw(plots.bands([run]), "steps")

    def begin() -> None:
        runs.begin(place, _recipe(), 0)

    return lambda: accepts_any(plot, begin, restore)


def _npz(rng: random.Random, good: bytes) -> bytes:
    """Return a file of arrays: damaged, of other types and sizes, or with pickles and bombs."""
    kind = rng.randrange(4)
    if kind == 0:
        return spoiled(good, rng)
    with np.load(io.BytesIO(good)) as file:
        arrays = {name: file[name] for name in file.files}
    if kind == 1:
        name = rng.choice(list(arrays))
        arrays[name] = rng.choice((
            np.zeros(0), np.zeros((3, 3)), np.array("x"), np.array([2**62, 1, 50]),
            np.array([-5, 0, 50]), arrays[name].astype("U8"), arrays[name] * 1j,
            np.array([object()]), arrays[name][None],
            np.full(arrays[name].shape, np.nan),
        ))  # fmt: skip
    elif kind == 2:
        arrays.pop(rng.choice(list(arrays)))
    file = io.BytesIO()
    np.savez_compressed(file, **arrays)
    raw = file.getvalue()
    if kind == 3:
        raw = _lying(rng)
    return raw


def _lying(rng: random.Random) -> bytes:
    """Return arrays with headers that claim too much, or that inflate a thousandfold."""
    shape = rng.choice(("(99999999999,)", "(-1,)", "(2147483647, 2147483647)", "(1000000000,)"))
    kind = rng.choice(("'<f8'", "'|O'", "'<U999999999'", "[('a', '<f8')]", "'<f4'"))
    head = f"{{'descr': {kind}, 'fortran_order': False, 'shape': {shape}, }}".encode()
    head += b" " * (-(len(head) + 11) % 64) + b"\n"
    body = b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head + bytes(100)
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as packed:
        for name in ("position.npy", "actions.npy", "0.npy", "heights.npy", "arr_0.npy"):
            packed.writestr(name, body)
    return file.getvalue()


def arrays(rng: random.Random, folder: Path) -> Run:
    """Cached arrays: convex hulls in the user's cache, lessons of the grasp detector."""
    from research.grasps import training

    hulls = io.BytesIO()
    np.savez(hulls, np.zeros((4, 3)), np.eye(3))
    lessons = io.BytesIO()
    cells = training.CELLS
    np.savez_compressed(
        lessons, heights=np.zeros((1, 2, cells, cells), np.uint16), facing=np.zeros(1),
        grasps=np.zeros((2, len(training.COLUMNS))), counts=np.array([2]),
    )  # fmt: skip
    put(folder / "hulls.npz", _npz(rng, hulls.getvalue()), rng)
    put(folder / "lessons.npz", _npz(rng, lessons.getvalue()), rng)
    return lambda: accepts_any(
        lambda: decomposition._read(folder / "hulls.npz"),
        lambda: training.read(folder / "lessons.npz"),
    )
