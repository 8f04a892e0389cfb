"""Progress of a training run: evaluations, policies, checkpoints and curves."""

from __future__ import annotations

import dataclasses
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.logger import Logger, configure

from generator.errors import require, require_seed

from .algorithms.learner import Counts, Learner
from .algorithms.sb3 import Sb3Learner
from .evaluation import PolicyEvaluation, evaluate
from .extra import PIP, tensorboard_there
from .interrupt import StopAsked
from .policies import policy_from, save_policy
from .recipes import as_texts
from .runs import BEST, LATEST, Run

Say = Callable[[str], None]


@dataclass(frozen=True)
class TrainingPlan:
    """Settings of a training run other than its recipe.

    Attributes:
        seed: seed of weights, environments and exploration.
        evaluate_every: steps between evaluations, each with a checkpoint. Cloning evaluates after
            each round.
        episodes: episodes per evaluation.
        keep_replay: keep the replay buffer in checkpoints.
        bar: show a progress bar.
        showings: folder for the expert's grasp demonstrations (``demonstrations``), shared with
            other runs; None for the run's own folder.

    Raises:
        InputError: a number is out of range.
    """

    seed: int = 0
    evaluate_every: int = 10_000
    episodes: int = 20
    keep_replay: bool = True
    bar: bool = False
    showings: Path | None = None

    def __post_init__(self) -> None:
        require_seed(self.seed, 2**31 - 1)
        require(self, "evaluate_every", "episodes", minimum=1, integer=True)


@dataclass
class Tracker:
    """A training run in progress, with its files, evaluation environment and counts.

    ``learned`` is true once a training step or a round of cloning has been completed.
    """

    run: Run
    plan: TrainingPlan
    trials: Any
    stop: threading.Event
    logger: Logger
    say: Say
    counts: Counts = field(default_factory=Counts)
    learned: bool = False
    _evaluated: int | None = None
    _since: float = field(default_factory=time.monotonic)

    def evaluate(self, learner: Learner, steps: int) -> None:
        """Evaluate a learner after ``steps`` steps; record the result and save the policy."""
        recipe, seed = self.run.recipe, self.run.seed
        policy = policy_from(learner, recipe, seed)
        seen = evaluate(self.trials, policy, self.plan.episodes)
        better = seen.share > self.counts.best
        self._count(learner, steps)
        self._evaluated = steps
        self.counts = dataclasses.replace(self.counts, best=max(self.counts.best, seen.share))
        self._keep(learner, seen, better)
        self.run.add(steps, self.counts.seconds, seen)
        self.logger.record("held_out/success_rate", seen.share)
        self.logger.record("held_out/mean_reward", seen.reward)
        self.logger.record("held_out/mean_steps", seen.steps)
        self.logger.dump(steps)
        self.say(f"{steps:,} steps, {self.counts.seconds / 60:.1f} min, held-out: {seen}")

    def checkpoint(self, learner: Learner, steps: int) -> None:
        """Save a checkpoint after ``steps`` steps, and the policy unless it was just evaluated."""
        if steps != self._evaluated:
            self._count(learner, steps)
            self._keep(learner, None, better=False)
        self.run.save(learner, self.counts, self.plan.keep_replay)

    def is_finished(self) -> bool:
        """Return whether all steps of the recipe are done; if so, print a message."""
        done, path = self.counts.steps, self.run.path
        if done < self.run.recipe.steps:
            return False
        self.say(f"{path} has completed its {done:,} steps; raise --steps to continue.")
        return True

    def end(self, learner: Learner, steps: int) -> None:
        """Evaluate a learner if it has new steps and Ctrl-C was not pressed; save a checkpoint."""
        if steps > self.counts.steps:
            if not self.stop.is_set():
                self.evaluate(learner, steps)
            self.checkpoint(learner, steps)

    def heed(self) -> None:
        """Raise ``StopAsked`` if Ctrl-C has been pressed."""
        if self.stop.is_set():
            raise StopAsked

    def _count(self, learner: Learner, steps: int) -> None:
        now = time.monotonic()
        self.counts = dataclasses.replace(
            self.counts, steps=steps, updates=learner.updates,
            episodes=learner.episodes, seconds=self.counts.seconds + now - self._since,
        )  # fmt: skip
        self._since = now

    def _keep(self, learner: Learner, seen: PolicyEvaluation | None, better: bool) -> None:
        figures = {} if seen is None else {
            "solved": seen.solved, "episodes": seen.episodes, "tables": seen.tables,
            "scenes": ", ".join(as_texts(self.run.recipe.held_out)),
        }  # fmt: skip
        policy = policy_from(learner, self.run.recipe, self.run.seed, figures, self.counts.steps)
        save_policy(policy, self.run.path / LATEST)
        if better:
            save_policy(policy, self.run.path / BEST)


class Pauses:
    """A schedule of evaluations and checkpoints between rollouts, with a progress bar."""

    def __init__(self, tracker: Tracker) -> None:
        self._tracker = tracker
        self._every = tracker.plan.evaluate_every
        self._next = (tracker.counts.steps // self._every + 1) * self._every
        self._bar = bar(tracker.run.recipe.steps) if tracker.plan.bar else None

    def pause(self, learner: Learner, steps: int) -> bool:
        """Evaluate and save a checkpoint if due after ``steps`` steps; return whether it was due.

        Raises:
            StopAsked: after Ctrl-C.
        """
        if self._bar is not None:
            self._bar(steps)
        self._tracker.heed()
        if steps < self._next:
            return False
        self._tracker.evaluate(learner, steps)
        self._tracker.checkpoint(learner, steps)
        self._next = (steps // self._every + 1) * self._every
        return True

    def close(self) -> None:
        """Remove the progress bar."""
        if self._bar is not None:
            self._bar(None)


class Progress(BaseCallback):
    """A callback that calls ``Pauses.pause`` between the rollouts of a Stable-Baselines3 model."""

    def __init__(self, tracker: Tracker, pauses: Pauses) -> None:
        super().__init__()
        self._tracker, self._pauses = tracker, pauses

    def _on_rollout_start(self) -> None:
        learner = Sb3Learner(self.model, self._tracker.run.recipe.network)
        self._pauses.pause(learner, self.model.num_timesteps)

    def _on_step(self) -> bool:
        self._tracker.learned = True
        return True


def logger_of(run: Run, say: Say) -> Logger:
    """Return the logger of a run's curves; print a message if TensorBoard is missing."""
    there = tensorboard_there()
    if not there:
        say(f"TensorBoard is not installed; no curves are written ({PIP}).")
    return configure(str(run.curves), ["tensorboard"] if there else [])


def bar(total: int) -> Callable[[int | None], None]:
    """Return a function that moves a progress bar to a number of steps; None closes the bar."""
    from rich.progress import BarColumn, MofNCompleteColumn, TimeRemainingColumn
    from rich.progress import Progress as Bars

    shown = Bars(BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(), transient=True)
    task = shown.add_task("steps", total=total)
    shown.start()

    def move(steps: int | None) -> None:
        if steps is None:
            shown.stop()
        else:
            shown.update(task, completed=steps)

    return move
