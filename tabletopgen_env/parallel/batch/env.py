"""Many worlds as one Gymnasium vector environment on torch tensors, a different table in each."""

from __future__ import annotations

from dataclasses import fields
from typing import Any, Unpack

import numpy as np
import torch
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from jaxtyping import Bool, Float, Int
from torch import Tensor

from generator.errors import InputError, require_known, require_number, require_seed

from ...env import played_at
from ...observations.modes import observation_space
from ...rendering.views import SLOTS
from ...scenes import SceneChoice
from ...settings import Settings, read_settings
from ...tasks.task import GOAL_WEIGHTS, Task
from ..core import rewards
from ..core.arrays import take_rows
from ..core.controls import Commands, RobotPose, advance, restart, start_commands
from ..core.flat_states import flat_states, slot_orders
from ..core.goal_rows import goal_vectors
from ..core.readings import Readings
from ..core.vectors import Agreement, agreement
from .arguments import check_actions, check_mask, check_numbers
from .bank import MOST_OBJECTS, SceneBank
from .batch_world import BatchWorld
from .choice import EpisodeChoice, sampler_of
from .decks import Deck, DeckConfig, DeckOrder, DeckPlan
from .engine import find_device
from .episodes import EpisodeTable
from .limits import BatchLimits
from .pictures import BatchPictures

_DECK = DeckConfig()


class TabletopBatchEnv(VectorEnv[Any, Any, Any]):
    """``num_envs`` worlds, each with a generated table of its own, stepped together on one device.

    What ``TabletopVectorEnv`` is for a CPU's cores, for a GPU: observations, rewards and flags are
    torch tensors on ``device``, and an episode that ends is followed by another one, at another
    table, within the same step (``AutoresetMode.SAME_STEP``): ``infos["final_obs"]`` is what was
    seen before, for the worlds of ``infos["_final_obs"]``. Every ``reset`` draws among
    ``deck.episodes`` episodes of each scene, which ``TabletopEnv`` drew beforehand.

    ``infos`` holds, as tensors with one row a world, "reward_terms" by name, "success" (and
    "is_success"), "goals" (the active goal's index, and how many there are), "episode_row" (its row
    in ``episodes``), and "failed": worlds that overflowed or diverged. Such a world's episode is
    truncated with the least reward, counted (``failures``) and followed by another; the others go
    on. In a step that ends episodes, "final_info" holds the same of these, all else is of those
    that have begun.

    A world simulates in single precision and without sleeping; otherwise it is ``TabletopEnv``'s.

    Args:
        num_envs: how many worlds.
        scenes: where tables come from, as for ``env.make_env``. Of a curriculum the deck is drawn
            from the source that it is one of, and episodes by their difficulty and by how others
            have ended (``sampler``).
        task: what to do; see ``env.make_env``.
        device: "cuda", "cuda:<number>" or "cpu" (slow, for tests).
        max_objects: scenes with more objects are left out; ``bank.left_out`` names them.
        deck: how many scenes and episodes are drawn beforehand.
        limits: how many contacts there is room for; None for ``BatchLimits.of`` the bank.
        max_episode_steps: the time limit; None for the task's.
        settings: those of ``TabletopEnv``, with ``observation`` "state", "goal", "pixels" or
            "pixels+state" without a hint, ``kinds`` ("rgb",), and ``randomization`` None or one of
            the start alone.

    Attributes:
        world: the simulated worlds, ``world.state`` as tensors.
        episodes: the episodes that resets draw from.
        sampler: success rates by difficulty, the curriculum's own if ``scenes`` is one, else of a
            single bin. Every episode that was drawn and has run to its time limit counts; a
            ``reset`` or a ``swap`` keeps the counts.
        idle: scenes that offer nothing to do.
        failures: how many episodes have failed.

    Raises:
        InputError: a setting is wrong or not for batches, no device, too little memory, the extra
            ``gpu`` is missing or of another version, or no scene is left.
        BundleError: no bundle fits ``scenes``.
    """

    def __init__(
        self,
        num_envs: int = 1,
        scenes: SceneChoice | None = None,
        task: Task | str = "PickPlace",
        device: str | torch.device = "cuda",
        *,
        max_objects: int = MOST_OBJECTS,
        deck: DeckConfig = _DECK,
        limits: BatchLimits | None = None,
        max_episode_steps: int | None = None,
        **settings: Unpack[Settings],
    ) -> None:
        for name, count in (("num_envs", num_envs), ("max_episode_steps", max_episode_steps)):
            if count is not None or name == "num_envs":
                require_number(f"TabletopBatchEnv needs {name}", count, minimum=1, integer=True)
        scenes, self.task = played_at(scenes, task, None)
        self._plan = DeckPlan(scenes, self.task, settings, max_objects, deck)
        config = read_settings(settings)
        self._weights = GOAL_WEIGHTS if config.observation.mode == "goal" else self.task.weights
        self._config, controller = config, config.action.controller()
        self._servos = controller.servos
        self._limit = max_episode_steps or time_limit(self.task)
        self.num_envs = num_envs
        self.metadata = {"autoreset_mode": AutoresetMode.SAME_STEP, "render_modes": []}
        self.single_observation_space = observation_space(config.observation, self.task.most)
        self.single_action_space = controller.space
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        find_device(device)
        made = self._plan.make(deck.seed)
        self.world = BatchWorld(made.bank, num_envs, device=device, limits=limits)
        self.device = self.world.device
        self._row = torch.zeros(num_envs, dtype=torch.long, device=self.device)
        self.sampler = sampler_of(scenes)
        self._choice = EpisodeChoice(self.sampler, num_envs, deck.seed)
        self._hold(made)
        self._coming: DeckOrder | None = None
        self.failures = 0
        self._steps = torch.zeros_like(self._row)
        self._active = torch.full_like(self._row, -1)
        self._order = torch.full((num_envs, SLOTS), -1, dtype=torch.long, device=self.device)
        self._commands: Commands | None = None
        self._shown: Any = None  # the last observation

    # ---------------------------------------------------------------------------------- gymnasium

    def reset(
        self,
        *,
        seed: int | list[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Any, dict[str, Any]]:
        """Start an episode in every world, or in those of the option "reset_mask".

        Args:
            seed: of the episodes drawn from now on; one for all worlds.
            options: "reset_mask", a tensor or an array of bools; "episodes", the rows of
                ``episodes`` to play, one a world; "steps", how many steps of its time limit each
                world is to have had already, so that they do not all end at once. Of worlds that
                are not reset the last two are not looked at.

        Raises:
            InputError: an unknown option, one of a wrong shape, type or range, several seeds, or
                some worlds before all have been reset. Nothing has changed then.
        """
        options = dict(options or {})
        mask = check_mask(options.pop("reset_mask", None), self.num_envs)
        if self._commands is None and not mask.all():
            raise InputError("Reset all worlds before some of them.")
        rows = check_numbers("episodes", options.pop("episodes", None), mask, len(self.episodes))
        steps = check_numbers("steps", options.pop("steps", None), mask, self._limit)
        for name in options:
            require_known(name, ("reset_mask", "episodes", "steps"), "Unknown reset option")
        if seed is not None:
            require_seed(seed)
            self._choice.restart(int(seed))  # type: ignore[arg-type]
        self._begin(mask, rows)
        if steps is not None:
            self._steps[mask.to(self.device)] = steps[mask].to(self.device)
            self._choice.forget(torch.nonzero(mask & (steps > 0))[:, 0].numpy())
        seen, found = self._look()
        self._shown = self._observe(seen)
        return self._shown, self._infos(found, self._terms(seen, found))

    def step(
        self, actions: Float[Tensor, "n a"] | np.ndarray
    ) -> tuple[Any, Float[Tensor, "n"], Bool[Tensor, "n"], Bool[Tensor, "n"], dict[str, Any]]:
        """Act in every world for 50 ms, or what ``control_hz`` makes of it.

        A world that fails gets the least reward, and its ``final_obs`` is what it showed before.

        Raises:
            InputError: actions of a wrong shape or with NaN (the message names the worlds); no
                ``reset`` before.
        """
        if self._commands is None:
            raise InputError("Call reset() before stepping a batch.")
        shape = self.num_envs, *(self.single_action_space.shape or ())
        wanted = check_actions(actions, shape, self.device)
        if self.task.closed:
            wanted[:, -1] = -1.0
        state = self.world.state
        pose = RobotPose(state.arm_qpos, state.tcp_pos, state.tcp_mat)
        self._commands, ctrl = advance(
            self._config.action.mode, self._servos, self._commands, pose, wanted
        )
        failed = self.world.step(ctrl, self._servos.substeps).clone()
        self._steps += 1
        seen, found = self._look()
        terms = {
            name: term.masked_fill(failed, 0.0) for name, term in self._terms(seen, found).items()
        }
        reward = rewards.weigh(terms, self._weights, self._config.reward == "sparse")
        infos = self._infos(found, terms) | {"failed": failed}
        observation = self._observe(seen)
        truncated = failed | (self._steps >= self._limit)
        if truncated.any():
            ended = torch.stack([truncated, failed, infos["success"]]).cpu()
            self.failures += int(ended[1].sum())
            self._choice.record((ended[0] & ~ended[1]).numpy(), ended[2].numpy())
            last = _choose(failed, self._shown, observation) if ended[1].any() else observation
            final = {"final_obs": last, "final_info": infos}
            self._begin(ended[0])
            seen, found = self._look()
            observation = self._observe(seen)
            infos = self._infos(found, self._terms(seen, found))
            infos |= final | {f"_{name}": truncated for name in final}
        self._shown = observation
        return observation, reward, torch.zeros_like(truncated), truncated, infos

    def close_extras(self, **kwargs: Any) -> None:
        """End the process that makes other scenes, if there is one."""
        del kwargs
        if (order := getattr(self, "_coming", None)) is not None:
            order.close()
            self._coming = None

    # ------------------------------------------------------------------------------------- scenes

    @property
    def bank(self) -> SceneBank:
        """The scenes; ``bank.left_out`` names those that are not there."""
        return self.world.bank

    def prepare(self, seed: int) -> None:
        """Have a process make other scenes and episodes of the same kind; ``seed`` is of its draws.

        Scenes for which this batch has no room are left out. Those that were in the making are
        given up.
        """
        require_seed(seed)
        self.close_extras()
        self._coming = DeckOrder(self._plan, seed, self.bank.union.shape)

    def swap(self, wait: bool = False) -> bool:
        """Take the scenes that were prepared, if they are ready, and tell whether that was done.

        Nothing is compiled. Every episode is over: call ``reset``.

        Args:
            wait: wait for them.

        Raises:
            InputError: nothing was prepared, or none of it fits.
            SceneError: the process has ended abruptly.
        """
        if self._coming is None:
            raise InputError("Call prepare() before swap().")
        if not (wait or self._coming.ready):
            return False
        order, self._coming = self._coming, None
        deck = order.result()
        self.world.swap(deck.bank)
        self._hold(deck)
        self._commands = None
        return True

    # -------------------------------------------------------------------------------------- parts

    def _hold(self, deck: Deck) -> None:
        self.episodes = EpisodeTable.of(deck.bank, deck.episodes, self.device)
        self._goals = self.episodes.take_goals(torch.zeros_like(self._row))
        self._choice.hold(self.episodes.difficulty)
        looks, config, count = deck.bank.looks, self._config.observation, self.num_envs
        self._pictures = looks and BatchPictures(looks, config, count, self.device, self.task)
        self.idle = deck.idle

    def _begin(self, mask: Bool[Tensor, "n"], rows: Int[Tensor, "n"] | None = None) -> None:
        """Start episodes in some worlds: drawn ones, or ``rows`` of ``episodes``.

        Both are on the host, so that nothing waits for the device but what made it.
        """
        here = torch.nonzero(mask)[:, 0]
        table = self.episodes
        if rows is None:
            drawn = torch.from_numpy(self._choice.draw(here.numpy()))
        else:
            drawn = rows[here]
            self._choice.forget(here.numpy())
        worlds, drawn = here.to(self.device), drawn.to(self.device)
        self._row[worlds] = drawn
        begun = table.take_goals(drawn)
        for f in fields(begun):  # in place: they are read several times a step, and large
            getattr(self._goals, f.name)[worlds] = getattr(begun, f.name)
        self._steps[worlds], self._active[worlds] = 0, -1
        self.world.load(worlds, table.scene[drawn], qpos=table.qpos[drawn], ctrl=table.ctrl[drawn])
        self.world.state.marker[worlds] = table.spot[drawn]
        joints = self.world.state.arm_qpos.clone()
        before = self._commands or start_commands(joints)
        self._commands = restart(before, joints, mask.to(self.device))

    def _look(self) -> tuple[Readings, Agreement]:
        """Return readings and how the goals agree; slots are ordered where a goal became active."""
        goals, state = self._goals, self.world.state
        touched = take_rows(state.touches, goals.target)
        seen = Readings(
            joints=state.arm_qpos,
            joint_velocities=state.arm_qvel,
            opening=state.finger_qpos.sum(1),
            servos=state.ctrl[:, :7],
            gripper=state.ctrl[:, 7],
            tool=state.tcp_pos,
            hand=state.tcp_mat,
            positions=state.slot_pos,
            rotations=state.slot_mat,
            linear=state.slot_qvel[..., :3],
            angular=state.slot_qvel[..., 3:],
            touched=touched & (goals.target >= 0)[..., None],
        )
        self._vectors = goal_vectors(goals, seen)
        found = agreement(*self._vectors, self.task.aside)
        changed = found.active != self._active
        if changed.any():
            order = slot_orders(goals, seen, found.active, state.filled)
            self._order = torch.where(changed[:, None], order, self._order)
        self._active = found.active
        return seen, found

    def _observe(self, seen: Readings) -> Any:
        mode = self._config.observation.mode
        pictures = self._pictures.draw(self.world.state) if self._pictures else {}
        if mode == "pixels":
            return pictures
        bare = mode == "goal"
        extents = self.world.state.half_extent
        states = flat_states(self._goals, seen, self._active, self._order, extents, bare)
        states = states.nan_to_num(0.0, 0.0, 0.0)  # of a world that has failed
        if not bare:
            return {**pictures, "state": states} if pictures else states
        achieved, desired = (v.nan_to_num(0.0, 0.0, 0.0) for v in self._vectors)
        return {"observation": states, "achieved_goal": achieved, "desired_goal": desired}

    def _terms(self, seen: Readings, found: Agreement) -> dict[str, Tensor]:
        return rewards.terms(self._goals, seen, found, self.task.aside)

    def _infos(self, found: Agreement, terms: dict[str, Tensor]) -> dict[str, Any]:
        success = terms["success"] > 0
        goals = torch.stack([self._active, found.used.sum(1)], 1)
        return {
            "reward_terms": terms,
            "success": success,
            "is_success": success,
            "goals": goals,
            "episode_row": self._row.clone(),
            "failed": torch.zeros_like(success),
        }


def _choose(mask: Bool[Tensor, "n"], one: Any, other: Any) -> Any:
    """Return observations with the rows of ``one`` where ``mask`` says so, else of ``other``."""
    if isinstance(other, dict):
        return {name: _choose(mask, one[name], part) for name, part in other.items()}
    return torch.where(mask.view(-1, *[1] * (other.dim() - 1)), one, other)


def time_limit(task: Task) -> int:
    """Return the time limit that a task, or the one that it is made from, is registered with.

    Raises:
        InputError: there is none.
    """
    from ... import STEPS

    for kind in type(task).__mro__:
        if kind.__name__ in STEPS:
            return STEPS[kind.__name__]
    raise InputError(
        f"No time limit is registered for {type(task).__name__}. Pass max_episode_steps, a number "
        "of steps."
    )
