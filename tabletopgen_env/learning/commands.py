"""The commands of policies: ``train``, ``enjoy`` and ``plot``."""

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
    """A policy, its task, its environment's keywords, and where it was trained."""

    actor: Predicts
    task: str
    env: Mapping[str, Any]
    scenes: tuple[str, ...]


@dataclass(frozen=True)
class CheckOptions:
    """How often a policy in training is evaluated.

    Attributes:
        evaluate_every: Steps between evaluations, each with a checkpoint.
        episodes: Episodes of an evaluation.
    """

    evaluate_every: int = 10_000
    episodes: int = 20


@dataclass(frozen=True)
class FileOptions:
    """What of a run is kept, and what runs share.

    Attributes:
        keep_replay: Keep the replay buffer in checkpoints.
        showings: Folder for what the expert shows to a policy that looks, shared between runs.
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
    """Train a policy by a recipe.

    reach-sac (minutes) · lift-clone --scenes fresh · pickplace-clone --set cloning.rounds=4

    After Ctrl-C, --resume continues a run.

    Args:
        recipe: Name of a recipe, or the path of a TOML file of your own. The names: reach-sac,
            reach-ppo, reach-td3, reach-clone, reach-sight, lift-sac, lift-sac-demos, lift-ppo,
            lift-ppo-batch, lift-clone, lift-clone-planned, lift-clone-plain, lift-look,
            lift-sight, pickplace-clone, pickplace-clone-planned, pickplace-look,
            pickplace-sac-her, push-sac-her.
        scenes: Where it trains, by default where the recipe says: names, globs or paths of
            bundles; "starter:train" (shipped training tables), "fresh[:TEXT]" (new tables made on
            demand), "refreshing[:TEXT]" (a pool renewed in the background) or
            "curriculum[:SCENES]" (of these the difficulty at which most is learned now).
        held_out: Where it is evaluated; the same forms.
        seed: The same seed trains the same policy (not with "refreshing", which goes by the clock).
        steps: Total environment steps, by default the recipe's. Clone recipes have rounds instead:
            --set cloning.rounds=4.
        out: The run's folder; runs/RECIPE-SEED if left out.
        resume: Resume the run in that folder.
        checks: How often the policy is evaluated.
        changes: Settings in place of the recipe's, as KEY=VALUE: options.gamma=0.9.
        files: What of a run is kept, and what runs share.
    """
    from .recipes import recipe as named

    chosen = named(recipe, changes)  # before anything heavy is loaded
    need_sb3()
    from .progress import TrainingPlan
    from .training import train as trained

    if steps is not None and chosen.algorithm == "clone":
        raise InputError(
            f"{chosen.name} is as long as its rounds: change those, as in --set cloning.rounds=4."
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
    _say(f"{done.steps:,} steps of {chosen.name} in {folder}")
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
    """Run a trained policy and report how often it succeeds.

    Warns if it was trained at some of the tables.

    Args:
        policy: Name of a shipped policy (reach-clone, reach-sight, lift-clone, lift-sight,
            pickplace-clone), a policy file, a run's folder (its best policy), or a zip of
            Stable-Baselines3.
        scenes: Where; of those made on demand only the held-out side.
        episodes: How many.
        seed: The same seed plays the same episodes.
        pool: Who plays.
        render: Show it; needs a display.
        video_strip: Write pictures of the first episode to this PNG.
        trust: Load a zip, which unpickles it and may execute arbitrary code: only your own.
        recipe: What a zip was trained by, if it does not lie in its run's folder.
    """
    require_number("enjoy needs --episodes", episodes, minimum=1, integer=True)
    require_seed(seed)
    if render and video_strip:
        raise InputError("Choose --render or --video-strip, not both.")
    require_number("enjoy needs --workers", pool.workers, minimum=1, maximum=1024, integer=True)
    apart = pool.workers > 1 or pool.ray is not None
    if apart and (render or video_strip):
        raise InputError("Pictures are taken by one process: leave out --workers and --ray.")
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
    _say(f"{own.task} at {', '.join(scenes)}: {summarize(played)}")


def plot(
    runs: Annotated[Positional[tuple[Path, ...]], arg(metavar="RUN [RUN ...]")],
    /,
    *,
    out: Path = Path("success.png"),
    by: Literal["steps", "hours"] = "steps",
) -> None:
    """Draw learning curves: the success of runs in validation, with mean and range of each recipe.

    Args:
        runs: The runs' folders.
        out: The PNG to write.
        by: What is across: steps of the training environments (of cloning, the states in which the
            expert gave advice), or hours, evaluations included.
    """
    if not runs:
        raise InputError("Name at least one run's folder to plot.")
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
        _say(message + (f", {least:.0f} to {most:.0f} % of {band.runs} runs" * (band.runs > 1)))
    _say(f"drawn in {out}")


def _warn(trained: tuple[str, ...], source: SceneSource) -> None:
    """Say so if a policy is about to be judged at tables it was trained at."""
    from .setup import count_shared, source_of

    try:
        both = count_shared(source_of(_one(trained), "train"), source)
        if both:
            what = "1 of these tables was" if both == 1 else f"{both} of these tables were"
            print(f"{what} trained at: this says little of others.", file=sys.stderr)
    except TabletopError as error:
        message = escape(f"Whether it was trained at these tables cannot be told: {error}")
        print(message, file=sys.stderr)


def _load(name: str, trust: bool, recipe: str | None) -> _Loaded:
    """Return a policy with what is known of it."""
    from .policies import find_policy, load_policy

    path = Path(name)
    if path.suffix == ".zip" and not path.is_dir():
        return _load_zip(path, trust, recipe)
    path = find_policy(name)
    policy = load_policy(path)
    card, seen = policy.card, policy.card.validation
    message = (f"; validation: {seen['solved']} of {seen['episodes']} at {seen['scenes']} "
            f"(tables: {seen['tables']})") if seen else ""  # fmt: skip
    _say(f"{path.name}: {card.recipe}, seed {card.seed}, {card.steps:,} steps{message}")
    return _Loaded(policy, card.task, card.env, card.scenes)


def _load_zip(path: Path, trust: bool, recipe: str | None) -> _Loaded:
    """Return a model of a zip of Stable-Baselines3, if it is to be trusted."""
    from .recipes import as_texts
    from .recipes import recipe as named
    from .runs import open_run
    from .setup import load_zip

    if not trust:
        raise InputError(
            f"{path} is a zip of Stable-Baselines3, and loading one may execute arbitrary code. "
            "Pass --trust if it is your own."
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
