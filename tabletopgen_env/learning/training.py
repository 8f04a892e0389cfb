"""Training with a recipe: environments, demonstrations, cloning, learning and evaluations."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import ExitStack, closing, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import gymnasium as gym
import numpy as np
import torch
from stable_baselines3 import SAC
from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.off_policy_algorithm import OffPolicyAlgorithm
from stable_baselines3.common.type_aliases import TrainFreq

from generator.errors import InputError, TabletopError
from generator.threads import torch_threads

from ..detection.detector import read_detector
from ..scenes import FreshScenes, SceneSource
from ..scenes.source import close
from ..tasks.registry import task_named
from .algorithms.learner import Learner
from .algorithms.sb3 import Sb3Learner
from .demonstrations.cloning import CloningConfig, Round, clone
from .demonstrations.demos import CHUNK, GraspShowing, gather
from .demonstrations.grasp_lessons import teach_head
from .demonstrations.replay import fill
from .demonstrations.rounds import RoundsFolder
from .interrupt import StopAsked, heeding
from .networks.look_extractor import LookExtractor
from .policies import policy_bytes, policy_from
from .ppo.batches import batch_config
from .ppo.training import learn_in_batches, new_ppo
from .progress import Pauses, Progress, Say, Tracker, TrainingPlan, logger_of
from .recipes import Recipe
from .runs import ROUNDS, Run, begin, differences, open_run
from .setup import blank_model, count_shared, many_envs, new_model, single_env, source_of

EVER_NEW = 1_000_000
"""Number of fresh tables for grasp demonstrations, training and held-out tables together."""


@dataclass(frozen=True)
class Trained:
    """The result of a training run; ``interrupted`` is true after Ctrl-C."""

    run: Run
    steps: int
    interrupted: bool


def train(
    recipe: Recipe,
    out: str | Path,
    plan: TrainingPlan | None = None,
    resume: bool = False,
    say: Say = print,
) -> Trained:
    """Train a policy and write all results into a folder; see ``runs``.

    The first Ctrl-C ends the training after the current rollout, demonstration or cloning round,
    with a checkpoint to resume from; a second one ends it at once.

    Args:
        recipe: the recipe.
        out: the folder, created if it is missing.
        plan: further settings.
        resume: resume the run in ``out``, up to the recipe's number of steps.
        say: receives progress messages, one line each.

    Raises:
        InputError: ``out`` already holds a run or, with ``resume``, holds no run of this recipe and
            seed.
        BundleError: the scenes do not exist.
        SceneError: the scenes have no valid task, or none that the expert can solve.
        StorageError: the folder cannot be written.
    """
    out, plan = Path(out), plan or TrainingPlan()
    with ExitStack() as last:
        task = task_named(recipe.task, recipe.env.get("preset"))
        scenes = source_of(recipe.scenes, "train", recipe.variants, task)
        last.callback(close, scenes)
        held_out = source_of(recipe.held_out, "held_out", recipe.variants, task)
        last.callback(close, held_out)
        both = count_shared(scenes, held_out)
        if both:
            say(f"{both} of the held-out scenes are also training scenes.")
        trials = single_env(recipe.task, recipe.env, held_out)
        last.callback(trials.close)
        _check(recipe, trials)
        there = out.exists()
        run = _resume(out, recipe, plan.seed) if resume else begin(out, recipe, plan.seed)
        last.enter_context(torch_threads(1))  # faster for small networks
        stop = last.enter_context(heeding(say))
        logger = logger_of(run, say)
        last.callback(logger.close)
        tracker = Tracker(run, plan, trials, stop, logger, say)
        learn = {"clone": _clone_alone, "ppo-batch": learn_in_batches}.get(recipe.algorithm, _learn)
        try:
            return Trained(run, learn(tracker, scenes), stop.is_set())
        except TabletopError:
            if not (resume or tracker.learned or run.kept):
                logger.close()
                run.take_back(folder_too=not there)
            raise


def _check(recipe: Recipe, env: gym.Env[Any, np.ndarray]) -> None:
    """Check a recipe's settings, so that errors are raised before anything is written."""
    cloning_config(recipe)
    batch_config(recipe)
    env.reset(seed=0)
    policy_bytes(policy_from(_blank_learner(recipe, env), recipe, 0))


def _blank_learner(recipe: Recipe, env: gym.Env[Any, np.ndarray]) -> Learner:
    if recipe.algorithm == "ppo-batch":
        return new_ppo(recipe, env, 0)
    return Sb3Learner(blank_model(recipe, env), recipe.network)


def _resume(out: Path, recipe: Recipe, seed: int) -> Run:
    run = open_run(out)
    changed = differences(run.recipe, recipe)
    if changed or run.seed != seed:
        what = ", ".join(changed) or "the seed"
        raise InputError(
            f"{out} is a run of {run.recipe.name} with seed {run.seed}; it differs in {what} "
            "from the given settings. Resume it with its original settings, or start another run "
            "with --out."
        )
    return replace(run, recipe=recipe)


def _learn(tracker: Tracker, scenes: SceneSource) -> int:
    """Train with Stable-Baselines3; return the total number of steps."""
    run, seed = tracker.run, tracker.plan.seed
    with closing(many_envs(run.recipe, scenes, seed)) as envs:
        model = new_model(run.recipe, envs, seed)
        model.set_logger(tracker.logger)
        learner = Sb3Learner(model, run.recipe.network)
        tracker.counts, replayed = run.restore(learner)
        begun = tracker.counts.steps
        if begun:  # a resumed run gets different tables and exploration than at its start
            model.set_random_seed(int(np.random.SeedSequence((seed, begun)).generate_state(1)[0]))
        if tracker.is_finished():
            return begun
        with suppress(StopAsked):
            refill = False
            if isinstance(model, OffPolicyAlgorithm) and not replayed:
                refill = begun > 0
                _demonstrate(tracker, learner, scenes)
            if not (run.recipe.cloning is None or tracker.counts.cloned or begun):
                _clone(tracker, model, scenes)
                tracker.counts = replace(tracker.counts, cloned=True)
                tracker.checkpoint(learner, begun)
            _go_on(tracker, model, refill)
        tracker.end(learner, model.num_timesteps)
        return model.num_timesteps


def _go_on(tracker: Tracker, model: BaseAlgorithm, refill: bool) -> None:
    with closing(Pauses(tracker)) as pauses:
        callback = Progress(tracker, pauses)
        if refill:
            assert isinstance(model, OffPolicyAlgorithm)
            tracker.say(
                "The replay buffer was not saved: the policy refills it before learning continues."
            )
            _refill(model, callback, tracker.run.recipe.steps)
        left = tracker.run.recipe.steps - model.num_timesteps
        model.learn(left, callback, reset_num_timesteps=False)


def _refill(model: OffPolicyAlgorithm, callback: Progress, maximum: int) -> None:
    """Fill the replay buffer with ``learning_starts`` steps of the policy, without learning."""
    until = min(model.num_timesteps + model.learning_starts, maximum)
    _, called = model._setup_learn(until, callback, reset_num_timesteps=False)
    assert model.env is not None and model.replay_buffer is not None
    assert isinstance(model.train_freq, TrainFreq)  # since _setup_learn
    while model.num_timesteps < until:
        model.collect_rollouts(
            model.env, called, model.train_freq, model.replay_buffer, model.action_noise,
            learning_starts=0,
        )  # fmt: skip


def _demonstrate(tracker: Tracker, learner: Sb3Learner, scenes: SceneSource) -> None:
    """Prefill the replay buffer with the recipe's demonstrations."""
    recipe, model = tracker.run.recipe, learner.model
    if not recipe.demonstrations:
        return
    assert isinstance(model, OffPolicyAlgorithm)
    with closing(single_env(recipe.task, recipe.env, scenes)) as env:
        assert model.replay_buffer is not None
        seed = tracker.plan.seed
        count = fill(model.replay_buffer, env, recipe.demonstrations, seed, tracker.heed)
    tracker.say(f"{count} demonstrations in the replay buffer")
    if not tracker.counts.steps:
        tracker.checkpoint(learner, 0)


def _clone_alone(tracker: Tracker, scenes: SceneSource) -> int:
    """Clone the expert, evaluating after each round; return the number of labelled states."""
    run = tracker.run
    model = new_model(run.recipe, tracker.trials, tracker.plan.seed)
    learner = Sb3Learner(model, run.recipe.network)
    kept = RoundsFolder(run.path / ROUNDS)
    if run.checkpoint is not None and not kept.path.exists():
        tracker.say(f"{run.path} is already complete.")
        return run.rows()[-1].steps
    tracker.counts = run.restore_rounds(kept.done)
    with suppress(StopAsked):
        _clone(tracker, model, scenes, lambda r: tracker.evaluate(learner, r.states), kept)
    tracker.checkpoint(learner, tracker.counts.steps)
    if not tracker.stop.is_set():
        kept.remove()
    return tracker.counts.steps


def _clone(
    tracker: Tracker,
    model: BaseAlgorithm,
    scenes: SceneSource,
    then: Callable[[Round], None] | None = None,
    kept: RoundsFolder | None = None,
) -> None:
    """Train the model's actor to imitate the expert; ``then`` is called after each round."""
    recipe = tracker.run.recipe
    config = cloning_config(recipe)
    assert isinstance(model, SAC)

    def report(r: Round) -> None:
        tracker.learned = True
        tracker.say(
            f"round {r.number + 1}: {r.states:,} states, {100 * r.solved:.0f} % of its episodes "
            f"solved, loss {r.loss:.4f}"
        )
        if then is not None:
            then(r)
        if r.number + 1 < config.rounds:
            tracker.heed()

    if recipe.network.finds_grasps:
        _teach(tracker, model, scenes, kept or RoundsFolder(tracker.run.path / ROUNDS))
    with closing(single_env(recipe.task, recipe.env, scenes)) as env:
        clone(model, env, config, tracker.plan.seed, report, kept)


def _teach(tracker: Tracker, model: SAC, scenes: SceneSource, kept: RoundsFolder) -> None:
    """Train the model's grasp head, unless it is already trained."""
    config, extractor = cloning_config(tracker.run.recipe), model.actor.features_extractor
    assert isinstance(extractor, LookExtractor)
    head = extractor.head
    if kept.read_head(head):
        return
    if config.head_start == "detector":
        head.start_from(read_detector().weights)
    if config.head_steps:
        shown = _showings(tracker, scenes, config.tables, tracker.plan.showings or kept.path)
        generator = torch.Generator().manual_seed(tracker.plan.seed)

        def note(step: int, loss: float) -> None:
            tracker.say(f"head: {step:,} of {config.head_steps:,} steps, loss {loss:.3f}")
            tracker.heed()

        teach_head(head, shown, config.head_steps, generator, note)
    kept.keep_head(head)


def _showings(
    tracker: Tracker, scenes: SceneSource, tables: int, folder: Path
) -> list[GraspShowing]:
    """Return grasp demonstrations on at least ``tables`` tables, in chunks cached in ``folder``.

    Existing chunks are reused without checks, so a folder must only be shared by runs with the same
    scenes.
    """
    source = replace(scenes, variants=EVER_NEW) if isinstance(scenes, FreshScenes) else scenes
    shown: list[GraspShowing] = []
    for number in range(-(-tables // CHUNK)):
        shown += gather(source, number, folder, tracker.heed)
        tracker.say(
            f"grasp demonstrations for {len(shown):,} objects on {CHUNK * (number + 1):,} tables"
        )
    return shown


def cloning_config(recipe: Recipe) -> CloningConfig:
    """Return a recipe's cloning settings.

    Raises:
        InputError: a setting is unknown or out of range.
    """
    try:
        return CloningConfig(**(recipe.cloning or {}))
    except TypeError as error:
        raise InputError(f"{recipe.name}: cloning: {error}.") from error
