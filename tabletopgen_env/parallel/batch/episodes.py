"""Episodes drawn in advance, used as initial states of a batch's worlds.

They are drawn by ``TabletopEnv``, so targets, goals, certificates and initial states equal those of
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
    """One episode of a scene, with objects in the scene's order.

    ``TabletopEnv.reset`` with ``seed`` draws the same episode. ``goals`` has one row; ``arm`` holds
    the joints (rad), ``ctrl`` the commands, ``poses`` the objects' positions and quaternions in the
    base frame, ``spot`` the position of the first goal's marker (base frame; below the floor if
    there is no marker), ``instruction`` the instruction's text, and ``difficulty`` the scene's
    difficulty with the episode's targets (``scenes.difficulty``).
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
    """Episodes drawn for scenes, stored by the scenes' indices.

    Args:
        env: environment whose task, settings and certificates are used.
        per_scene: number of episodes per scene.
        seed: seed of all draws.

    Attributes:
        episodes: episodes of each scene with a valid task, in order.
        left_out: the other scenes.
    """

    def __init__(self, env: TabletopEnv, per_scene: int, seed: int) -> None:
        self._env, self._per_scene = env, per_scene
        self._seeds = np.random.default_rng((seed, 7))
        self.episodes: list[list[DrawnEpisode]] = []
        self.left_out: list[LeftOut] = []
        self._scene: Scene | None = None
        self._known: dict[str | None, float] = {}

    def worlds(self, refs: Iterable[SceneRef]) -> Iterator[World]:
        """Yield the world of each scene after drawing its episodes."""
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
        """Return a bank's error; add the number and an example of scenes without a valid task."""
        if not self.left_out:
            return error
        first = self.left_out[0]
        count = len(self.left_out)
        return InputError(
            f"{error} {count} scenes had no valid task, for example {first.name!r}: {first.reason}"
        )

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
        """Return the difficulty of a scene for a given target object, cached per target."""
        if self._scene is not scene:
            self._scene, self._known = scene, {}
        if target not in self._known:
            self._known[target] = difficulty(scene, target)
        return self._known[target]


@dataclass(frozen=True, eq=False)
class EpisodeTable:
    """The episodes of a bank's scenes as float32 arrays on a device, with one row (e) per episode.

    Attributes:
        scene: index of the scene in the bank.
        qpos: initial joint positions, in the order of the union model.
        ctrl: initial commands.
        goals: goals, with slots in place of object rows.
        spot: position of the first goal's marker, base frame, metres.
        instructions: texts of the instructions.
        seeds: seeds with which ``TabletopEnv.reset`` draws the same episodes in the same scenes.
        difficulty: difficulty of each episode in [0, 1], on the host.
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
        """Create the table for a bank's scenes from the episodes drawn for all of its sources."""
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
        """Return a copy of the goals of the episodes in ``rows``."""
        return GoalRows(**{f.name: getattr(self.goals, f.name)[rows] for f in fields(GoalRows)})

    def __len__(self) -> int:
        return len(self.instructions)
