"""The environment, which combines scenes, a robot, a task, actions, observations and a reward."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, Unpack

import gymnasium as gym
import numpy as np
from jaxtyping import UInt8
from numpy.typing import ArrayLike

from generator.errors import (
    BundleError,
    InputError,
    SceneError,
    choices,
    require_known,
    require_seed,
)

from .actions import ActionMode, check_action
from .certificates.instances import sample_episode
from .goals.goal import SPOT, Goal
from .observations.bounds import Noise
from .observations.flat_state import FlatState
from .observations.grasp_hint import grasp_hint_of
from .observations.height_map import HeightLook
from .observations.instructions import show_instruction
from .observations.modes import observation_space, slot_order
from .observations.proprioception import feel
from .parallel.core.vectors import agreement, goal_terms
from .randomization import Randomizer
from .rendering.config import RENDER_MODES, CameraName
from .rendering.drawer import drawer
from .rendering.kinds import Drawer, Profile
from .rendering.point_cloud import point_cloud
from .rendering.views import CAMERAS, camera_calibration, pictures
from .rendering.window import Window
from .scenes import STARTER, SceneChoice, SceneRef, resolve
from .scenes.fixed import is_there
from .scenes.source import close, record
from .settings import Settings, read_settings
from .tasks.pick_place import PickPlace
from .tasks.registry import task_named
from .tasks.task import GOAL_WEIGHTS, Episode, Task, first_open
from .world.composition import FRONT_CAMERA
from .world.world import World

OPTIONS = ("scene", "target", "goal")
"""The ``options`` of ``TabletopEnv.reset``."""

DRAWS = 25
"""Maximum number of scenes that a reset draws in search of one with a valid task."""


class TabletopEnv(gym.Env[Any, np.ndarray]):
    """An environment with a Panda at generated tables.

    Args:
        scenes: the source of tables; see ``scenes.resolve``.
        task: the task; None for ``PickPlace()``. See ``tasks``.
        settings: ``reward``, ``randomization``, ``certified`` and the groups of
            ``settings.EnvConfig``. A group is passed as a whole
            (``observation=ObservationConfig("pixels", image_size=64)``) or by its fields as
            separate keywords:

            - ``observation`` (the mode; "goal" requires a ``GoalTabletopEnv``, see ``make_env``),
              ``cameras``, ``kinds``, ``image_size``, ``points``, ``grasp_hint``, ``geometry``,
              ``instruction``, ``target_mark``, ``calibration``;
            - ``action`` (the mode), ``gripper``, ``control_hz``;
            - ``render`` (a ``RenderConfig``): ``render_mode``, ``render_size``, ``renderer``;
            - ``worlds`` (a ``WorldConfig``): ``robot``, ``cache``, ``masters``.

            ``reward`` is "dense" or "sparse", ``infos`` "all" or "numbers".

    Raises:
        InputError: a setting is unknown or invalid, or a group and one of its fields are both set.
        BundleError: no bundle matches ``scenes``.

    ``reset`` accepts ``options``: "scene" (any value of ``scenes``), "target" (the name of an
    object) and "goal" (the name of an object, "spot", or a point in the world frame; see the task's
    page). They need not be certified. A certificate applies to the original arrangement of the
    table: if ``randomization`` has moved objects, or if the certificate does not cover the task,
    targets and goals are drawn freely. A scene whose certificate lists only instances that the
    expert failed has no valid task.

    ``info`` holds "reward_terms" by name, "success" (and "is_success", the name that SB3 expects),
    "instruction", "scene", "target" (of the active goal; None for the tool), "goal" (the object
    that carries the active goal, "spot" for a marked spot on the table, else None), "goals" (the
    index of the active goal and the number of goals), "certified" (whether the episode was drawn
    from certified instances), "off_table" (the objects that fell off the table) and, if
    observations have pictures or points, "cameras" (the "intrinsics" and "extrinsics" of each, see
    ``rendering.views.camera_calibration``). The ``info`` of ``reset`` also holds the drawn
    "randomization". With ``infos="numbers"`` it holds only numbers: the reward terms as
    "reward_<name>", "success", "is_success" and "certified".

    An episode never terminates, because the dense reward is highest while the task remains solved;
    the time limit truncates it.

    A copy (``pickle``, ``copy.deepcopy``) has the same settings and random state, and therefore the
    same next ``reset``, but no episode, compiled world or window. Call ``reset`` before using it.
    """

    def __init__(
        self,
        scenes: SceneChoice = STARTER,
        *,
        task: Task | None = None,
        **settings: Unpack[Settings],
    ) -> None:
        self._config = config = read_settings(settings)
        self.task = task or PickPlace()
        self.source = resolve(scenes, self.task.needs, self.task.scenes)
        self._closes_source = self.source is not scenes  # otherwise others may draw from it, too
        self._randomizer = Randomizer(config.randomization)
        self._views = config.observation
        self.hint = grasp_hint_of(config.observation.grasp_hint)
        self._heights = HeightLook() if config.observation.looks else None
        self.observation_space = observation_space(config.observation, self.task.most)
        self.action_mode: ActionMode = config.action.mode
        self.controller = config.action.controller()
        self.action_space = self.controller.space
        rate = config.action.control_hz
        self.metadata = {"render_modes": list(RENDER_MODES), "render_fps": rate}
        self.reward = config.reward
        self.render_mode = config.render.mode
        self._worlds = config.worlds.worlds()
        self._drawers: dict[tuple[Profile, tuple[int, int], int], Drawer] = {}
        self._window = Window(1 / rate)
        self._world: World | None = None
        self._episode: Episode | None = None
        self._certified = False
        self._instruction = ""
        self._active = 0
        self._ref: SceneRef | None = None  # the scene of the episode, if the source drew it
        self._succeeded: bool | None = None  # None before the first step of an episode
        self._order: list[str] = []
        self._state: FlatState | None = None

    # ---------------------------------------------------------------------------------- gymnasium

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Any, dict[str, Any]]:
        """Draw a scene, a target and a goal, and start an episode.

        Steps:

        1. The scene source receives the outcome of the last episode that it drew (``scenes/``).
        2. Up to ``DRAWS`` times, until a scene has a valid task: the source draws a scene, or
           ``options`` name it; its world is compiled or taken from the cache (``world/``);
           ``Randomizer.begin`` reverts the previous randomisation of that world and draws a new one
           (``randomization/``); an episode is sampled, from the certified ones if there are any
           (``certificates/``, ``tasks/``).
        3. ``Randomizer.finish`` perturbs the start and removes distractors.
        4. The controller is reset (``actions/``).
        5. The first observation is read (``observations/``).

        After a failed reset there is no episode, and ``step`` raises until the next reset.

        Raises:
            InputError: an option is unknown or names nothing in the scene, ``options`` is not a
                dict, or ``seed`` is invalid.
            SceneError: none of the drawn scenes has a valid task.
            BundleError: a scene or its certificate is damaged.
        """
        options = as_options(options)
        if seed is not None:
            require_seed(seed)
            seed = int(seed)
        try:
            super().reset(seed=seed)
            return self._begin(options)
        except BaseException:
            self._world = self._episode = None
            raise

    def step(self, action: ArrayLike) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Apply an action for ``1 / control_hz`` seconds, by default 50 ms.

        Raises:
            InputError: the action has the wrong shape or contains NaN, or ``reset`` was not called
                or failed.
        """
        world = self.world
        wanted = check_action(action, self.controller.space)
        if self.task.closed:
            wanted[-1] = -1.0
        command = self._randomizer.delay(wanted)
        if command is not None:
            self.controller.apply(world, command)
        world.step(self.controller.servos.substeps)
        achieved, desired, terms = self._look()
        if self.render_mode == "human":
            self.render()
        reward = self._weigh(terms)
        self._succeeded = bool(terms["success"])
        info = self._info(terms)
        return self._observe(achieved, desired), float(reward), False, False, info

    def render(self) -> Any:
        """Return the picture for ``render_mode``, or show it in a window ("human")."""
        if self.render_mode is None:
            return None
        if self.render_mode == "human":
            return self._window.show(self.world)
        if self.render_mode == "rgb_array":
            return self.picture("front")
        return self._drawer(self._config.render.shape, "full").depth(self.world, FRONT_CAMERA)

    def picture(self, camera: CameraName) -> UInt8[np.ndarray, "h w 3"]:
        """Return a camera's current picture for human viewers, at the size used by ``render``."""
        require_known(camera, CAMERAS, "Unknown camera")
        return self._drawer(self._config.render.shape, "full").rgb(self.world, CAMERAS[camera])

    def close(self) -> None:
        """Close renderers and windows and stop processes of ``scenes``; repeated calls are allowed.

        A ``SceneSource`` that was passed in remains open; the caller closes it.
        """
        if self._closes_source:
            close(self.source)
        for held in self._drawers.values():
            held.close()
        self._drawers.clear()
        self._window.close()

    def __getstate__(self) -> dict[str, Any]:
        """Return the state for copying, without the episode, worlds, renderers and windows."""
        return {
            **self.__dict__,
            "_drawers": {},
            "_window": Window(1 / self.controller.servos.hz),
            "_world": None,
            "_episode": None,
            "_state": None,
            "_ref": None,
            "_succeeded": None,
        }

    # ------------------------------------------------------------------------------------- parts

    @property
    def world(self) -> World:
        """The world of the current episode; raises InputError if no episode has begun."""
        if self._world is None:
            raise InputError("Call reset() before stepping, rendering or accessing the world.")
        return self._world

    @property
    def episode(self) -> Episode:
        """The goals of the current episode; raises InputError if no episode has begun."""
        if self._episode is None:
            raise InputError("Call reset() before accessing the episode.")
        return self._episode

    @property
    def goal(self) -> Goal:
        """The goal that the state describes: the first unmet goal of the episode."""
        return self.episode.goals[self._active]

    @property
    def active(self) -> int:
        """The index of the first unmet goal in the episode."""
        return self._active

    @property
    def order(self) -> list[str]:
        """The names of the objects in the order of their slots in the state."""
        return self._order

    @property
    def shows_goals(self) -> bool:
        """Whether observations are dicts with goal vectors."""
        return self._views.mode == "goal"

    def follow(self, active: int, terms: Mapping[str, float]) -> dict[str, Any]:
        """Adopt the result of a step that was simulated elsewhere; return the info of the step.

        ``active`` is the index of the first unmet goal, ``terms`` are the reward terms.
        """
        if active != self._active:
            self._activate(active)
        self._succeeded = bool(terms["success"])
        return self._info(terms)

    def give_up(self) -> None:
        """Discard the current episode without reporting its outcome to the scene source."""
        self._ref = None

    def _begin(self, options: dict[str, Any]) -> tuple[Any, dict[str, Any]]:
        """Start an episode and return the result of ``reset``."""
        for key in options:
            require_known(key, OPTIONS, "Unknown reset option")
        if self._ref is not None and self._succeeded is not None:  # the source drew its scene
            record(self.source, self._ref, self._succeeded)
        self._ref = self._succeeded = None
        ref, self._world, self._episode, self._certified = self._draw(options)
        self._instruction = self.task.instruction(self._world, self._episode.goals)
        self._ref = None if "scene" in options else ref
        self._active = -1
        self.controller.reset(self._world)
        achieved, desired, terms = self._look()
        if self.render_mode == "human":
            self.render()
        info = self._info(terms)
        if self._config.infos == "all":
            info["randomization"] = self._randomizer.drawn
        return self._observe(achieved, desired), info

    def _look(self) -> tuple[np.ndarray, np.ndarray, dict[str, float]]:
        """Return the achieved and desired goal vectors and reward terms; update the active goal."""
        world, episode = self.world, self.episode
        desired = self.task.desired_goal(world, episode)
        achieved = self.task.achieved_goal(world, episode, desired)
        gaps = self.task.gaps(achieved, desired)
        if (active := first_open(gaps)) != self._active:
            self._activate(active)
        return achieved, desired, self.task.terms(world, episode, gaps)

    def _activate(self, index: int) -> None:
        """Make the goal with the given index the active one."""
        self._active, world, goal = index, self.world, self.episode.goals[index]
        self._order = slot_order(world, goal)
        bare, hinted = self._views.mode == "goal", self.hint is not None
        self._state = FlatState(world, goal, self._order, bare, hinted)
        if self.hint is not None:
            self.hint.begin(world, goal)
        world.show_marker(goal.spot, self.task.marker_radius, self.task.marker_shape)

    def _draw(self, options: dict[str, Any]) -> tuple[SceneRef, World, Episode, bool]:
        """Draw scenes until one has a valid task; return whether the episode is certified."""
        source = self.source
        if "scene" in options:
            source = resolve(options["scene"], self.task.needs, self.task.scenes)
        tried: set[str] = set()
        seen: set[str] = set()
        self._randomizer.restart(self.np_random)
        for _ in range(DRAWS):
            ref = source.draw(self.np_random)
            seen.add(ref.key)
            try:
                world = self._worlds.get(ref, self._forget)
                self._randomizer.begin(world)
                certified = self._config.certified and not self._randomizer.rearranged
                episode, known = sample_episode(
                    self.task, world, self.np_random, options, certified
                )
                return ref, world, self._randomizer.finish(world, episode), known
            except (SceneError, BundleError) as error:
                if isinstance(error, BundleError) and is_there(ref):
                    raise  # else a pool dropped the scene between its draw and its loading
                tried.add(str(error))
        drawn = "the one scene drawn" if len(seen) == 1 else f"{len(seen)} drawn scenes"
        raise SceneError(f"There is no valid task in {drawn}. " + " ".join(sorted(tried)[:3]))

    def _forget(self, world: World) -> None:
        for held in self._drawers.values():
            held.forget(world)

    @property
    def weights(self) -> Mapping[str, float]:
        """The weights of the reward terms if the reward is dense, or None otherwise."""
        return self.task.weights

    def _weigh(self, terms: Mapping[str, Any]) -> Any:
        """Return the reward that results from ``terms``, which are numbers or arrays."""
        if self.reward == "sparse":
            return terms["success"] - 1.0
        return sum(weight * terms[name] for name, weight in self.weights.items())

    def _observe(self, achieved: np.ndarray, desired: np.ndarray) -> Any:
        mode, noise = self._views.mode, self._randomizer.noise()
        if mode == "goal":
            vectors = {"achieved_goal": achieved, "desired_goal": desired}
            return {"observation": self._read_state(noise), **vectors}
        shapes: dict[str, Any] = {}
        if self._heights is not None:
            shapes["height_map"] = self._heights.maps(self.world, self.goal, noise)
        if mode == "state":
            state = self._read_state(noise)
            return {"state": state, **shapes} if shapes else state
        seen = {**self._see(), **shapes}
        if mode.endswith("+state"):
            seen["state"] = self._read_state(noise)
        elif mode.endswith("+proprio"):
            seen["proprio"] = feel(self.world, noise)
        return seen

    def _see(self) -> dict[str, Any]:
        """Return the camera observation and, if requested, the instruction."""
        views, world, drawers = self._views, self.world, self._drawer
        if views.mode.startswith("pixels"):
            seen: dict[str, Any] = pictures(views, world, drawers, self._order, self.goal.target)
        else:
            seen = point_cloud(views, world, drawers, self._order)
        assert views.instruction is not None
        if views.instruction != "none":
            seen["instruction"] = show_instruction(views.instruction, self._instruction)
        return seen

    def _read_state(self, noise: Noise | None) -> np.ndarray:
        """Return the current flat state, with the grasp hint if there is one."""
        assert self._state is not None
        hint = None if self.hint is None else self.hint.entries(self.world, self.goal)
        return self._state.read(noise, hint)

    def _info(self, terms: Mapping[str, float]) -> dict[str, Any]:
        goal, success = self.goal, bool(terms["success"])
        judged = {"success": success, "is_success": success}
        if self._config.infos == "numbers":
            parts = {f"reward_{name}": value for name, value in terms.items()}
            return {**parts, **judged, "certified": self._certified}
        marked = goal.spot is not None and goal.target is not None
        views = self._views
        cameras = {} if views.is_flat else {"cameras": camera_calibration(views, self.world)}
        return {
            **cameras,
            "reward_terms": terms,
            **judged,
            "instruction": self._instruction,
            "scene": self.world.scene.name,
            "target": goal.target,
            "goal": goal.reference or (SPOT if marked else None),
            "goals": (self._active, len(self.episode.goals)),
            "certified": self._certified,
            "off_table": self.world.off_table(),
        }

    def _drawer(self, size: tuple[int, int], profile: Profile = "fast") -> Drawer:
        """Return the renderer for a picture size, created on first use and again after a fork."""
        key = profile, size, os.getpid()
        if key not in self._drawers:
            self._drawers[key] = drawer(self._config.render.renderer, *size, profile)
        return self._drawers[key]


class GoalTabletopEnv(TabletopEnv):
    """An environment with dict observations; the reward depends only on their two goal vectors.

    Hindsight replay (SB3's ``HerReplayBuffer``) calls ``compute_reward`` with relabelled goals.
    """

    @property
    def weights(self) -> Mapping[str, float]:
        """The weights of the reward terms that the goals determine."""
        return GOAL_WEIGHTS

    def compute_reward(self, achieved_goal: np.ndarray, desired_goal: np.ndarray, info: Any) -> Any:
        """Return the reward for ``achieved_goal`` given ``desired_goal``.

        Vectorised: goals of shape (8,) or (n, 8) give a float or (n,). ``info`` is not used.
        """
        if np.ndim(achieved_goal) == 1 == np.ndim(desired_goal):
            gaps = self.task.gaps(np.asarray(achieved_goal), np.asarray(desired_goal))
            return float(self._weigh(self.task.goal_terms(gaps)))
        both = np.broadcast_arrays(achieved_goal, desired_goal)
        achieved, desired = (goal.astype(np.float64) for goal in both)
        aside = self.task.aside
        return self._weigh(goal_terms(agreement(achieved, desired, aside), aside))


def as_options(options: Any) -> dict[str, Any]:
    """Return the options of a reset as a new dict, which is empty for None.

    Raises:
        InputError: the options are not a dict.
    """
    if options is None:
        return {}
    if not isinstance(options, Mapping):
        raise InputError(f"options must be a dict, got {options!r}." + choices("", OPTIONS))
    return dict(options)


def make_env(
    scenes: SceneChoice | None = None,
    *,
    task: Task | str = "PickPlace",
    preset: str | None = None,
    **settings: Unpack[Settings],
) -> TabletopEnv:
    """Create the environment that fits ``observation``; the registered ids call this function.

    Args:
        scenes: the source of tables; None for the default of the task (``Task.scenes``).
        task: a task or its name.
        preset: a key of ``tasks.sequence.PRESETS``, for the task "Sequence".
        settings: as for ``TabletopEnv``.

    Raises:
        InputError: a setting is unknown or invalid.
    """
    config = read_settings(settings)
    kind = GoalTabletopEnv if config.observation.mode == "goal" else TabletopEnv
    scenes, task = played_at(scenes, task, preset)
    return kind(scenes, task=task, **settings)


def played_at(
    scenes: SceneChoice | None, task: Task | str, preset: str | None
) -> tuple[SceneChoice, Task]:
    """Return the scenes and the task that the arguments of ``make_env`` select.

    Raises:
        InputError: the task or preset is unknown.
    """
    if isinstance(task, str):
        task = task_named(task, preset)
    return (task.scenes if scenes is None else scenes), task
