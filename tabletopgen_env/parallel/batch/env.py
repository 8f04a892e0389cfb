"""A Gymnasium vector environment that simulates many tables at once and returns torch tensors."""

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
    """A vector environment of ``num_envs`` worlds with generated tables, stepped on one device.

    It is the GPU counterpart of ``TabletopVectorEnv``. Observations, rewards and flags are torch
    tensors on ``device``. When an episode ends, another one starts on another table within the same
    step (``AutoresetMode.SAME_STEP``): ``infos["final_obs"]`` holds the last observations for the
    worlds of ``infos["_final_obs"]``. Every ``reset`` draws from the ``deck.episodes`` episodes per
    scene that ``TabletopEnv`` drew in advance.

    ``infos`` holds tensors with one row per world: "reward_terms" by name, "success" (and
    "is_success"), "goals" (index of the active goal, and number of goals), "episode_row" (row in
    ``episodes``), and "failed" (worlds that overflowed or diverged). The episode of a failed world
    is truncated with the minimum reward, counted in ``failures`` and followed by another one; other
    worlds continue. In a step that ends episodes, "final_info" holds the infos of the ended
    episodes, and the other entries those of the new ones.

    Worlds are simulated in single precision and without putting objects to sleep; otherwise they
    equal those of ``TabletopEnv``.

    Args:
        num_envs: number of worlds.
        scenes: source of the tables, as in ``env.make_env``. For a curriculum, the deck is drawn
            from the curriculum's own source, and episodes by difficulty and by earlier results
            (``sampler``).
        task: the task; see ``env.make_env``.
        device: "cuda", "cuda:<number>" or "cpu" (slow, for tests).
        max_objects: scenes with more objects are left out and listed in ``bank.left_out``.
        deck: number of scenes and episodes drawn in advance.
        limits: limits on contacts; None for ``BatchLimits.of`` the bank.
        max_episode_steps: the time limit; None for the task's.
        settings: settings of ``TabletopEnv``, with ``observation`` "state", "goal", "pixels" or
            "pixels+state" without a hint, ``kinds`` ("rgb",), and ``randomization`` None or limited
            to the start.

    Attributes:
        world: the simulated worlds, with ``world.state`` as tensors.
        episodes: the episodes that resets draw from.
        sampler: success rates by difficulty: the curriculum's own if ``scenes`` is one, otherwise a
            sampler with a single bin. Every drawn episode that reaches its time limit counts;
            ``reset`` and ``swap`` keep the counts.
        idle: scenes without a valid task.
        failures: number of failed episodes.

    Raises:
        InputError: a setting is invalid or not available for batches, the device does not exist,
            memory is insufficient, the extra ``gpu`` is missing or has the wrong version, or no
            scene is left.
        BundleError: no bundle matches ``scenes``.
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
                require_number(name, count, minimum=1, integer=True)
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
        """Start an episode in every world, or in those selected by the option "reset_mask".

        Args:
            seed: seed of the following draws, one for all worlds.
            options: "reset_mask", a tensor or array of bools; "episodes", the rows of ``episodes``
                to play, one per world; "steps", the number of elapsed steps that each world starts
                with, so that episodes do not all end at once. Entries of the last two are ignored
                for worlds that are not reset.

        Raises:
            InputError: an option is unknown or has the wrong shape, type or range, there are
                several seeds, or ``reset_mask`` is used before all worlds have been reset. The
                environment is then unchanged.
        """
        options = dict(options or {})
        mask = check_mask(options.pop("reset_mask", None), self.num_envs)
        if self._commands is None and not mask.all():
            raise InputError("Reset all worlds once before using reset_mask.")
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
        """Advance every world by 50 ms, or by the period set by ``control_hz``.

        A world that fails gets the minimum reward, and its ``final_obs`` is its previous
        observation.

        Raises:
            InputError: the actions have the wrong shape or contain NaN (the message names the
                worlds), or ``reset`` was not called before.
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
        """End the process that prepares new scenes, if there is one."""
        del kwargs
        if (order := getattr(self, "_coming", None)) is not None:
            order.close()
            self._coming = None

    # ------------------------------------------------------------------------------------- scenes

    @property
    def bank(self) -> SceneBank:
        """The bank of scenes; ``bank.left_out`` lists the excluded ones."""
        return self.world.bank

    def prepare(self, seed: int) -> None:
        """Start a background process that prepares other scenes and episodes, drawn with ``seed``.

        Scenes that do not fit this batch are left out. A preparation in progress is cancelled.
        """
        require_seed(seed)
        self.close_extras()
        self._coming = DeckOrder(self._plan, seed, self.bank.union.shape)

    def swap(self, wait: bool = False) -> bool:
        """Switch to the prepared scenes if they are ready; return whether they were.

        Nothing is recompiled. All episodes end, so call ``reset`` afterwards.

        Args:
            wait: wait until the scenes are ready.

        Raises:
            InputError: nothing was prepared, or no prepared scene fits.
            SceneError: the process ended unexpectedly.
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
        """Start the episodes in ``rows``, or else random ones, in the masked worlds.

        Both arguments are on the host, to avoid device synchronisation.
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
        for f in fields(begun):  # in place, since they are large and read several times per step
            getattr(self._goals, f.name)[worlds] = getattr(begun, f.name)
        self._steps[worlds], self._active[worlds] = 0, -1
        self.world.load(worlds, table.scene[drawn], qpos=table.qpos[drawn], ctrl=table.ctrl[drawn])
        self.world.state.marker[worlds] = table.spot[drawn]
        joints = self.world.state.arm_qpos.clone()
        before = self._commands or start_commands(joints)
        self._commands = restart(before, joints, mask.to(self.device))

    def _look(self) -> tuple[Readings, Agreement]:
        """Return the worlds' readings and ``Agreement`` with the goals; update the slot order."""
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
        states = states.nan_to_num(0.0, 0.0, 0.0)  # for a failed world
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
    """Return observations: rows of ``one`` where ``mask`` is true, and of ``other`` elsewhere."""
    if isinstance(other, dict):
        return {name: _choose(mask, one[name], part) for name, part in other.items()}
    return torch.where(mask.view(-1, *[1] * (other.dim() - 1)), one, other)


def time_limit(task: Task) -> int:
    """Return the registered time limit of a task, or of the task it is derived from.

    Raises:
        InputError: no time limit is registered.
    """
    from ... import STEPS

    for kind in type(task).__mro__:
        if kind.__name__ in STEPS:
            return STEPS[kind.__name__]
    raise InputError(
        f"No time limit is registered for {type(task).__name__}. Pass one as max_episode_steps."
    )
