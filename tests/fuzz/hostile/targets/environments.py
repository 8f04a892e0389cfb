"""User input of environments and planners: options, settings, scene names, texts."""

import functools
import json
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from toy import toy_object, toy_scene

from generator.backends.embedded.reasoner import EmbeddedReasoner
from generator.composition import compose
from generator.errors import TabletopError
from generator.physics.gate import judge
from generator.scene import ScenePlan
from generator.scene.paper_json import from_paper
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.randomization import Randomization
from tabletopgen_env.scenes import resolve
from tabletopgen_env.tasks.names import NAMES

from ..judging import accepts, accepts_any
from ..values import NUMBERS, TEXTS, mutate, number, text, value
from . import Run


@functools.cache
def _env(task: str) -> TabletopEnv:
    cubes = [toy_object(f"cube_{k}", (0.04, 0.04, 0.04), (-0.15 + 0.12 * k, -0.1)) for k in (1, 2)]
    tray = toy_object("bowl_1", (0.17, 0.17, 0.06), (0.22, 0.1), wall=0.008)
    scene = toy_scene((*cubes, tray))
    return make_env(scene.replace(report=judge(scene)), task=task)


def options(rng: random.Random, folder: Path) -> Run:
    """Options of ``reset``, seeds, and actions."""
    task = rng.choice(("Reach", "Lift", "PickPlace", "Push", "Stack"))
    given: Any = {"target": "cube_1", "goal": rng.choice(("spot", "bowl_1", [0.1, 0.1]))}
    if rng.random() < 0.8:
        given = mutate(given, rng, ("cube_1", "cube_2", "bowl_1", "spot"))
    seed = rng.choice((0, 1, number(rng)))
    env = _env(task)
    shape = env.action_space.shape or ()
    action: Any = np.full(shape, rng.choice(NUMBERS[:20]), dtype=object)
    if rng.random() < 0.5:
        action = np.full(shape, float(rng.choice((np.nan, np.inf, 1e308, 0.5, -7.0))))
    if rng.random() < 0.2:
        action = rng.choice((np.zeros(0), np.zeros((2, 7)), None, "x", 1.0, [0.0] * 99))

    def step() -> None:
        env.reset(seed=0)
        seen, reward, *_ = env.step(action)
        assert np.isfinite(np.asarray(seen)).all() and np.isfinite(reward)

    return lambda: accepts_any(
        lambda: env.reset(seed=_whole(seed), options=given if isinstance(given, dict) else None),
        step,
    )


def _whole(seed: Any) -> Any:
    """Return a seed that Gymnasium accepts; it rejects others itself."""
    return seed if type(seed) is int and 0 <= seed < 2**63 else 0


def settings(rng: random.Random, folder: Path) -> Run:
    """Settings of environments and of their randomisation."""
    known: Any = {
        "observation": "state", "action": "ee_delta", "reward": "dense", "randomization": "starts",
        "certified": False, "grasp_hint": None, "cache": 4, "render_size": [48, 64],
    }  # fmt: skip
    drawn: Any = {
        "mass": [0.5, 2.0], "light_turn": 0.1, "delay": 2, "distractors": [0, 3], "move": 0.1,
    }  # fmt: skip
    given = mutate(known, rng, ("state", "goal", "rgb", "joint_delta", "sparse", "all"))
    spread = mutate(drawn, rng)
    task = rng.choice((*NAMES, *TEXTS[:20]))

    def make() -> None:
        if isinstance(given, dict):
            make_env(_env("Reach").scenes if hasattr(_env("Reach"), "scenes") else "starter",
                     task=task, **given).close()  # fmt: skip

    def vary() -> None:
        if isinstance(spread, dict):
            Randomization(**spread)

    return lambda: accepts_any(make, vary)


def scene_names(rng: random.Random, folder: Path) -> Run:
    """Values of ``scenes``."""
    extra = ("starter", "starter:train", "starter:", "fresh", "refreshing", "fresh:a mug", "lab",
             "lab-*", "starter:held_out")  # fmt: skip
    chosen: Any = rng.choice((*TEXTS, *extra))
    if rng.random() < 0.4:
        chosen = [rng.choice((*TEXTS, *extra)) for _ in range(rng.randrange(4))]
    if rng.random() < 0.1:
        chosen = value(rng, extra)

    def find() -> None:
        try:
            resolve(chosen)
        except TabletopError as error:
            raise type(error)("refused") from None  # it may repeat the user's input

    return lambda: accepts(find)


_PHRASES = (
    "a desk with", "a mug", "two books", "on", "in", "next to", "left of", "a red", "and", ",",
    "of", "the", "table", "200", "a 30 cm", "99999999999999999999", "x", "1e309 cm", "0 cm",
    "a stack of", "a pile of", "no", "without", "(", ")", ";", ".", "\n", "\x00", "机",
    "\ud800", "ﬁ", "½", "٣", "²", "round", "wooden", "of of of", "in the in the", "a-b-c", "%s",
)  # fmt: skip


def texts(rng: random.Random, folder: Path) -> Run:
    """Texts for the planner, and plans in JSON."""
    words = [rng.choice(_PHRASES) for _ in range(rng.choice((1, 5, 20, 100)))]
    asked = " ".join(words)
    if rng.random() < 0.3:
        asked = (rng.choice(_PHRASES) + rng.choice(("", " ", ", "))) * rng.choice((10, 100, 400))
    if rng.random() < 0.1:
        asked = text(rng)
    seed: Any = rng.choice((0, number(rng)))
    built = rng.random() < 0.01

    def plan() -> None:
        planned = EmbeddedReasoner().plan_scene(asked, 0)
        assert isinstance(planned, ScenePlan)

    calls: list[Callable[[], Any]] = [plan]
    if built:
        calls.append(lambda: compose(asked, seed))
    return lambda: accepts(*calls)


def papers(rng: random.Random, folder: Path) -> Run:
    """The paper's JSON of rotations and alignments."""
    rotations: Any = {"toy car_1": 29.7, "mug_1": 0.0}
    placed: Any = {
        "anchor_object": "mug_1",
        "objects": {"toy car_1": {"scale": [10, 5, 4], "translation": [1, 2, 75]},
                    "mug_1": {"scale": [8, 8, 9], "translation": [5, -2, 75]}},
    }  # fmt: skip
    both = mutate([rotations, placed], rng, ("mug_1", "toy car_1"))
    both = json.loads(json.dumps(both))
    if not isinstance(both, list) or len(both) < 2:
        both = [both, both]
    return lambda: accepts(lambda: from_paper(both[0], both[1]))
