"""Episodes drawn beforehand: what a world of a batch is started with.

They are drawn by ``TabletopEnv`` itself, so targets, goals, certificates and starts are those of
the single environment.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, fields

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from generator.errors import InputError, SceneError
from generator.geometry import turned_quaternion
from generator.scene import Scene

from ...env import TabletopEnv
from ...scenes import FixedScenes, SceneRef, difficulty
from ...world.world import World
from ..core.goal_rows import GoalRows
from .bank import LeftOut, SceneBank
from .engine import to_device


@dataclass(frozen=True, eq=False)
class DrawnEpisode:
    """One episode of a scene, objects in the scene's own order.

    ``seed`` draws the same one by ``TabletopEnv.reset``; ``goals`` is one row; ``arm`` are the
    joints (rad), ``ctrl`` the commands, ``poses`` the objects' positions and quaternions in the
    base frame, ``spot`` what the first goal marks (base frame, below the floor where it marks
    nothing), ``instruction`` what is asked for, ``difficulty`` how hard the scene is to work at,
    with the things that are to be moved (``scenes.difficulty``).
    """

    seed: int
    goals: GoalRows
    arm: Float[np.ndarray, "7"]
    ctrl: Float[np.ndarray, "8"]
    poses: Float[np.ndarray, "k 7"]
    spot: Float[np.ndarray, "3"]
    names: tuple[str, ...]
    instruction: str
    difficulty: float


class EpisodeDraw:
    """Draws episodes of scenes, and keeps them by the scene's place among those drawn.

    Args:
        env: whose task, settings and certificates decide.
        per_scene: episodes of each scene.
        seed: of all draws.

    Attributes:
        episodes: of each scene that offers something to do, in order.
        left_out: the scenes that do not.
    """

    def __init__(self, env: TabletopEnv, per_scene: int, seed: int) -> None:
        self._env, self._per_scene = env, per_scene
        self._seeds = np.random.default_rng((seed, 7))
        self.episodes: list[list[DrawnEpisode]] = []
        self.left_out: list[LeftOut] = []
        self._scene: Scene | None = None
        self._known: dict[str | None, float] = {}

    def worlds(self, refs: Iterable[SceneRef]) -> Iterator[World]:
        """Yield the world of each scene after its episodes are drawn."""
        for number, ref in enumerate(refs):
            scene = ref.load()
            seeds = self._seeds.integers(2**31, size=self._per_scene)
            try:
                drawn = [self._draw(int(seed), ref) for seed in seeds]
            except SceneError as error:
                self.left_out.append(LeftOut(number, scene.name, str(error)))
                continue
            self.episodes.append(drawn)
            yield self._env.world

    def explain(self, error: InputError) -> InputError:
        """Return the error of a bank that has no scene, with why scenes offer nothing to do."""
        if not self.left_out:
            return error
        first = self.left_out[0]
        count = len(self.left_out)
        return InputError(f"{error} {count} offered nothing to do, {first.name!r}: {first.reason}")

    def _draw(self, seed: int, ref: SceneRef) -> DrawnEpisode:
        env = self._env
        env.reset(seed=seed, options={"scene": FixedScenes((ref,))})
        world, episode = env.world, env.episode
        goals = GoalRows.blank(1, env.task.most, np.float32)
        goals.write(0, world, episode)
        state, yaw = world.state, -world.mount.yaw
        quaternions = [turned_quaternion(world.data.xquat[body], yaw) for body in world.bodies]
        poses = np.column_stack([world.to_base(state.positions), np.reshape(quaternions, (-1, 4))])
        spot = episode.goals[0].spot
        return DrawnEpisode(
            seed,
            goals,
            state.joints.copy(),
            np.concatenate([state.servos, state.gripper]),
            poses,
            np.array([0.0, 0.0, -5.0]) if spot is None else world.to_base(spot),
            world.names,
            env.task.instruction(world, episode.goals),
            float(np.mean([self._rate(world.scene, goal.target) for goal in episode.goals])),
        )

    def _rate(self, scene: Scene, target: str | None) -> float:
        """Return how hard a scene is with a target, each found out once."""
        if self._scene is not scene:
            self._scene, self._known = scene, {}
        if target not in self._known:
            self._known[target] = difficulty(scene, target)
        return self._known[target]


@dataclass(frozen=True, eq=False)
class EpisodeTable:
    """Episodes of a bank's scenes on a device, a row each (e); float32.

    Attributes:
        scene: number of the scene in the bank.
        qpos: everything at the start, as the union model orders it.
        ctrl: the commands at the start.
        goals: with slots in place of rows of objects.
        spot: what the first goal marks, base frame, metres.
        instructions: what is asked for.
        seeds: of ``TabletopEnv.reset`` that draw the same episodes at the same scenes.
        difficulty: how hard each is, in [0, 1], on the host.
    """

    scene: Int[Tensor, "e"]
    qpos: Float[Tensor, "e nq"]
    ctrl: Float[Tensor, "e 8"]
    goals: GoalRows
    spot: Float[Tensor, "e 3"]
    instructions: tuple[str, ...]
    seeds: tuple[int, ...]
    difficulty: Float[np.ndarray, "e"]

    @classmethod
    def of(
        cls, bank: SceneBank, episodes: Sequence[Sequence[DrawnEpisode]], device: torch.device
    ) -> EpisodeTable:
        """Return the episodes of a bank's scenes among those of all worlds it was made of."""
        pairs = [(k, one) for k, source in enumerate(bank.sources) for one in episodes[source]]
        blank = GoalRows.blank(len(pairs), pairs[0][1].goals.kind.shape[1], np.float32)
        scene = np.array([k for k, _ in pairs])
        qpos = np.array(bank.rows["qpos"][scene], np.float32)
        at = bank.union.addresses
        for row, (k, one) in enumerate(pairs):
            slots = np.array([bank.slot(k, name) for name in one.names], int)
            for field in fields(GoalRows):
                getattr(blank, field.name)[row] = getattr(one.goals, field.name)[0]
            for numbers in (blank.target, blank.reference):
                some = numbers[row] >= 0
                numbers[row][some] = slots[numbers[row][some]]
            qpos[row, at.arm_qpos] = one.arm
            qpos[row, at.slot_qpos].reshape(-1, 7)[slots] = one.poses

        goals = {f.name: to_device(getattr(blank, f.name), device) for f in fields(GoalRows)}
        return cls(
            to_device(scene, device),
            to_device(qpos, device),
            to_device(np.array([one.ctrl for _, one in pairs]), device),
            GoalRows(**goals),
            to_device(np.array([one.spot for _, one in pairs]), device),
            tuple(one.instruction for _, one in pairs),
            tuple(one.seed for _, one in pairs),
            np.array([one.difficulty for _, one in pairs]),
        )

    def take_goals(self, rows: Int[Tensor, "k"]) -> GoalRows:
        """Return a copy of the goals of some episodes."""
        return GoalRows(**{f.name: getattr(self.goals, f.name)[rows] for f in fields(GoalRows)})

    def __len__(self) -> int:
        return len(self.instructions)
