"""The commands ``train``, ``enjoy`` and ``plot``."""

from __future__ import annotations

import dataclasses
import sys
from collections.abc import Mapping
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from tyro.conf import OmitArgPrefixes, Positional, arg

from generator.errors import InputError, TabletopError, escape, require_number, require_seed
from generator.io.files import check_folder, check_target
from generator.jobs.pools import PoolOptions

from .extra import need_sb3

if TYPE_CHECKING:
    from ..scenes import SceneSource
    from .evaluation import Predicts


@dataclass(frozen=True, eq=False)
class _Loaded:
    """A policy with its task, the settings of its environment and its training scenes."""

    actor: Predicts
    task: str
    env: Mapping[str, Any]
    scenes: tuple[str, ...]


@dataclass(frozen=True)
class CheckOptions:
    """Evaluation of the policy during training.

    Attributes:
        evaluate_every: Steps between evaluations, each followed by a checkpoint.
        episodes: Episodes per evaluation.
    """

    evaluate_every: int = 10_000
    episodes: int = 20


@dataclass(frozen=True)
class FileOptions:
    """Files kept by a run, and files shared between runs.

    Attributes:
        keep_replay: Keep the replay buffer in checkpoints.
        showings: Folder for the expert's grasp demonstrations, shared between runs.
    """

    keep_replay: bool = True
    showings: Path | None = None


_CHECKS, _FILES, _POOL = CheckOptions(), FileOptions(), PoolOptions()


def train(
    recipe: Annotated[Positional[str], arg(metavar="RECIPE")],
    /,
    *,
    scenes: tuple[str, ...] = (),
    held_out: tuple[str, ...] = (),
    seed: int = 0,
    steps: int | None = None,
    out: Path | None = None,
    resume: bool = False,
    checks: OmitArgPrefixes[CheckOptions] = _CHECKS,
    changes: Annotated[tuple[str, ...], arg(name="set")] = (),
    files: OmitArgPrefixes[FileOptions] = _FILES,
) -> int:
    """Train a policy with a recipe.

    reach-sac (minutes) · lift-clone --scenes fresh · pickplace-clone --set cloning.rounds=4

    Use --resume to continue a run after Ctrl-C.

    Args:
        recipe: Name of a recipe, or the path of your own TOML file. Recipes: reach-sac, reach-ppo,
            reach-td3, reach-clone, reach-sight, lift-sac, lift-sac-demos, lift-ppo, lift-ppo-batch,
            lift-clone, lift-clone-planned, lift-clone-plain, lift-look, lift-sight,
            pickplace-clone, pickplace-clone-planned, pickplace-look, pickplace-sac-her,
            push-sac-her.
        scenes: Training scenes, by default the recipe's: names, globs or paths of bundles;
            "starter:train" (shipped training tables), "fresh[:TEXT]" (new tables generated on
            demand), "refreshing[:TEXT]" (a pool renewed in the background) or "curriculum[:SCENES]"
            (tables of the difficulty at which the policy currently learns most).
        held_out: Evaluation scenes, in the same forms.
        seed: Random seed; runs with equal seeds train identical policies (except with "refreshing",
            which depends on timing).
        steps: Total environment steps, by default the recipe's. For clone recipes set the number of
            rounds instead: --set cloning.rounds=4.
        out: Folder of the run; runs/RECIPE-SEED by default.
        resume: Resume the run in that folder.
        checks: Evaluation of the policy during training.
        changes: Changes to the recipe's settings, as KEY=VALUE: options.gamma=0.9.
        files: Files kept by the run, and files shared between runs.
    """
    from .recipes import recipe as named

    chosen = named(recipe, changes)  # fails on unknown names before the heavy imports
    need_sb3()
    from .progress import TrainingPlan
    from .training import train as trained

    if steps is not None and chosen.algorithm == "clone":
        raise InputError(
            f"--steps does not apply to {chosen.name}, whose length is set by its rounds; use, "
            "for example, --set cloning.rounds=4."
        )
    given = {"scenes": _one(scenes), "held_out": _one(held_out), "steps": steps}
    chosen = dataclasses.replace(chosen, **{k: v for k, v in given.items() if v not in (None, ())})
    folder = out or Path("runs") / f"{Path(chosen.name).name}-{seed}"
    check_folder(folder)
    plan = TrainingPlan(
        seed,
        checks.evaluate_every,
        checks.episodes,
        files.keep_replay,
        sys.stdout.isatty(),
        files.showings,
    )
    done = trained(chosen, folder, plan, resume, _say)
    _say(f"completed {done.steps:,} steps of {chosen.name} in {folder}")
    return 130 if done.interrupted else 0


def enjoy(
    policy: Annotated[Positional[str], arg(metavar="POLICY")],
    /,
    *,
    scenes: tuple[str, ...] = ("starter:held_out",),
    episodes: int = 20,
    seed: int = 0,
    pool: OmitArgPrefixes[PoolOptions] = _POOL,
    render: bool = False,
    video_strip: Path | None = None,
    trust: bool = False,
    recipe: str | None = None,
) -> None:
    """Run a trained policy and report its success rate.

    Warns if the policy was trained on some of the tables.

    Args:
        policy: Name of a shipped policy (reach-clone, reach-sight, lift-clone, lift-sight,
            pickplace-clone), a policy file, a run's folder (its best policy), or a
            Stable-Baselines3 zip file.
        scenes: Scenes to evaluate on. Only the held-out part of scenes generated on demand is used.
        episodes: Number of episodes.
        seed: Random seed; equal seeds give the same episodes.
        pool: Worker processes that run the episodes.
        render: Show the episodes in a window; needs a display.
        video_strip: Write pictures of the first episode to this PNG file.
        trust: Load a zip file. Loading unpickles it and can execute arbitrary code; only load your
            own files.
        recipe: Recipe of a zip file that is outside its run's folder.
    """
    require_number("--episodes", episodes, minimum=1, integer=True)
    require_seed(seed)
    if render and video_strip:
        raise InputError("Choose --render or --video-strip, not both.")
    require_number("--workers", pool.workers, minimum=1, maximum=1024, integer=True)
    apart = pool.workers > 1 or pool.ray is not None
    if apart and (render or video_strip):
        raise InputError(
            "--render and --video-strip work in one process only: remove --workers and --ray."
        )
    if video_strip:
        check_target(video_strip, "--video-strip")
    need_sb3()
    from ..scenes.source import close
    from .evaluation import seeds, summarize
    from .trial import PolicyTrial

    own = _load(policy, trust, recipe)
    trial = PolicyTrial(own.task, own.env, _one(scenes), own.actor)
    source, played = trial.source(), []
    try:
        _warn(own.scenes, source)
        numbers = seeds(seed, episodes)
        with closing(
            trial.play_apart(numbers, pool) if apart
            else trial.play_here(numbers, source, render, video_strip)
        ) as results:  # fmt: skip
            for done in results:
                played.append(done)
                how = "solved" if done.solved else "failed"
                _say(f"{how} in {done.steps:3d} steps: {done.instruction}")
    finally:
        close(source)
    _say(f"{own.task} on {', '.join(scenes)}: {summarize(played)}")


def plot(
    runs: Annotated[Positional[tuple[Path, ...]], arg(metavar="RUN [RUN ...]")],
    /,
    *,
    out: Path = Path("success.png"),
    by: Literal["steps", "hours"] = "steps",
) -> None:
    """Plot learning curves: validation success per recipe, with mean and range over runs.

    Args:
        runs: Folders of the runs.
        out: PNG file to write.
        by: Horizontal axis: steps of the training environments (for cloning, the number of states
            with expert advice), or hours, including evaluations.
    """
    if not runs:
        raise InputError("Specify the folder of at least one run to plot.")
    check_target(out)
    need_sb3()
    from generator.io.pictures import write_picture

    from .plots import bands, draw, number
    from .runs import open_run

    found = bands([open_run(path) for path in runs], by)
    write_picture(draw(found, by), out)
    for name, band in found.items():
        mean, least, most = (100 * v[-1] for v in (band.mean, band.least, band.most))
        message = f"{name}: {mean:.0f} % after {number(band.at[-1])} {by}"
        _say(message + (f", {least:.0f} to {most:.0f} % over {band.runs} runs" * (band.runs > 1)))
    _say(f"wrote {out}")


def _warn(trained: tuple[str, ...], source: SceneSource) -> None:
    """Print a warning if the policy was trained on some of the source's tables."""
    from .setup import count_shared, source_of

    try:
        both = count_shared(source_of(_one(trained), "train"), source)
        if both:
            what = "1 of these tables was" if both == 1 else f"{both} of these tables were"
            print(
                f"{what} used in training; the success rate says little about new tables.",
                file=sys.stderr,
            )
    except TabletopError as error:
        message = escape(f"Cannot check whether the policy was trained on these tables: {error}")
        print(message, file=sys.stderr)


def _load(name: str, trust: bool, recipe: str | None) -> _Loaded:
    """Load a policy and its metadata by name or path."""
    from .policies import find_policy, load_policy

    path = Path(name)
    if path.suffix == ".zip" and not path.is_dir():
        return _load_zip(path, trust, recipe)
    path = find_policy(name)
    policy = load_policy(path)
    card, seen = policy.card, policy.card.validation
    message = (f"; validation: {seen['solved']} of {seen['episodes']} on {seen['scenes']} (tables: "
               f"{seen['tables']})") if seen else ""  # fmt: skip
    _say(f"{path.name}: {card.recipe}, seed {card.seed}, {card.steps:,} steps{message}")
    return _Loaded(policy, card.task, card.env, card.scenes)


def _load_zip(path: Path, trust: bool, recipe: str | None) -> _Loaded:
    """Load a Stable-Baselines3 zip file, if ``trust`` allows it."""
    from .recipes import as_texts
    from .recipes import recipe as named
    from .runs import open_run
    from .setup import load_zip

    if not trust:
        raise InputError(
            f"{path} is a Stable-Baselines3 zip file, and loading it can execute arbitrary "
            "code. Pass --trust if it is your own."
        )
    if recipe is not None:
        own = named(recipe)
    else:
        folder = path.resolve().parent
        own = open_run(folder.parent if folder.name.startswith("checkpoint-") else folder).recipe
    return _Loaded(load_zip(path, own), own.task, own.env, as_texts(own.scenes))


def _one(scenes: tuple[str, ...]) -> str | tuple[str, ...]:
    return scenes[0] if len(scenes) == 1 else scenes


def _say(line: str) -> None:
    print(escape(line), flush=True)
