"""Valid forms of ``scenes``, and errors for all others."""

import pickle
from pathlib import Path

import numpy as np
import pytest
from toy import toy_scene

import assets_cache
from generator.errors import BundleError, InputError, TabletopError
from generator.language.distribution import SceneDistribution
from tabletopgen_env.env import make_env
from tabletopgen_env.parallel.vector import TabletopVectorEnv
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.scenes import (
    FixedScenes,
    FreshScenes,
    RefreshingScenes,
    SceneRecipe,
    SceneSource,
    resolve,
    split,
)
from tabletopgen_env.tasks.registry import task_named
from tabletopgen_env.tasks.tidy import Tidy
from tabletopgen_env.world.world import World


def keys(source: SceneSource) -> list[str]:
    assert isinstance(source, FixedScenes)
    return [ref.key for ref in source.refs]


def test_the_starters_and_their_two_sides() -> None:
    starters = keys(resolve("starter"))
    train, held_out = keys(resolve("starter:train")), keys(resolve("starter:held_out"))
    assert len(starters) == len(assets_cache.find("starter"))
    assert train and held_out
    assert sorted([*train, *held_out]) == sorted(starters)


def test_fresh_and_refreshing_with_and_without_a_prompt() -> None:
    assert resolve("fresh") == FreshScenes(SceneDistribution())
    assert resolve("fresh:an office desk") == FreshScenes(("an office desk",))
    assert resolve("fresh: an office desk ") == FreshScenes("an office desk")
    starters, prompted = resolve("refreshing"), resolve("refreshing:a tea table")
    assert isinstance(starters, RefreshingScenes) and isinstance(prompted, RefreshingScenes)
    assert starters.fresh == FreshScenes() and isinstance(starters.initial, FixedScenes)
    assert keys(starters.initial) == keys(resolve("starter"))
    assert prompted.fresh == FreshScenes("a tea table") and prompted.initial is None
    assert not starters.pids and not starters.refs  # nothing begins before the first draw


def test_fresh_tables_hold_what_the_task_needs_and_a_text_what_it_says() -> None:
    tidy = FreshScenes(SceneDistribution(needs=Tidy.needs))
    assert make_env("fresh", task="Tidy").source == tidy
    several = TabletopVectorEnv(scenes="fresh", task="Tidy")
    drawn = [source.draw(np.random.default_rng(0)).key for source in (several._source, tidy)]
    assert drawn[0] == drawn[1]
    several.close()
    assert Tidy.needs and resolve("fresh:a desk", Tidy.needs) == FreshScenes("a desk")
    assert make_env("fresh", task="Reach").source == FreshScenes()
    asked = SceneDistribution(("lab",))
    assert make_env(FreshScenes(asked), task="Tidy").source == FreshScenes(asked)


def test_a_refreshing_pool_begins_with_the_tables_of_the_task() -> None:
    source = make_env("refreshing", task="Tidy").source
    assert isinstance(source, RefreshingScenes) and isinstance(source.initial, FixedScenes)
    assert source.fresh == FreshScenes(SceneDistribution(needs=Tidy.needs))
    assert keys(source.initial) == keys(resolve("tidy-task-*"))


def test_a_side_with_none_of_the_first_tables_begins_with_new_ones() -> None:
    sides = [split("refreshing", side, start="tidy-task-*") for side in ("train", "held_out")]
    assert [getattr(s, "initial", 0) is None for s in sides].count(True) == 1


def test_needs_tell_tables_apart_and_none_leave_them_what_they_were() -> None:
    plain = SceneRecipe(SceneDistribution(), 5)
    assert plain.identity == (
        'fresh:5:{"themes": [], "objects": [4, 8], "tables": [], "styles": ["plain"]}'
    )
    needing = SceneRecipe(SceneDistribution(needs=Tidy.needs), 5)
    assert needing.identity != plain.identity
    for recipe in (plain, needing):
        assert pickle.loads(pickle.dumps(recipe)) == recipe


@pytest.mark.slow
@pytest.mark.parametrize("name", ["Tidy", "Swap", "Stack"])
def test_tables_drawn_for_a_task_offer_something(name: str) -> None:
    task = task_named(name)
    ref = resolve("fresh", task.needs).draw(np.random.default_rng(0))
    world = World(ref.load(), Panda())
    assert task.sample(world, np.random.default_rng(0)).goals


def test_a_source_is_taken_as_it_is_and_a_side_of_the_starters_in_a_list() -> None:
    source = FreshScenes("a desk")
    assert resolve(source) is source
    both = keys(resolve(["starter:held_out", toy_scene()]))
    assert both[:-1] == keys(resolve("starter:held_out"))


def test_one_scene_in_memory_is_one_scene() -> None:
    scene = toy_scene()
    assert keys(resolve(scene)) == keys(resolve(scene)) != keys(resolve(toy_scene()))


@pytest.mark.parametrize(
    ("scenes", "message"),
    [
        ("startr", "Did you mean scenes='starter'"),
        ("Fresh", "Did you mean scenes='fresh'"),
        ("refresh", "Did you mean scenes='(fresh|refreshing)'"),
        ("starter:heldout", "Did you mean 'starter:held_out'"),
        ("starter:trian", "Did you mean 'starter:train'"),
        ("frsh:a desk", "Did you mean 'fresh:PROMPT'"),
        ("refreshng: a desk", "Did you mean 'refreshing:PROMPT'"),
        ("kitchens:a desk", "Available: curriculum, .*fresh:PROMPT.*starter:train"),
        ("no_such_desk", "Besides bundles, scenes can be 'starter', .*'refreshing:PROMPT'"),
        ("fresh:", "lacks a prompt.*'fresh:an office desk', or just 'fresh'"),
        ("refreshing: ", "lacks a prompt"),
        ("fresh:42", "no words"),
        ("refreshing:ein Tisch mit einer Tasse und einem Buch", "English"),
        (["fresh:a desk"], "'fresh:a desk' is not a fixed scene and cannot be part of a list"),
        (["starter", "refreshing"], "'refreshing' is not a fixed scene"),
        ([], "list of scenes must not be empty"),
        (5, "scenes has type int; pass .*'starter:train'"),
        ([5], "cannot contain an item of type int"),
    ],
)
def test_what_is_no_scene_is_explained(scenes, message) -> None:
    with pytest.raises(TabletopError, match=message) as raised:
        make_env(scenes)
    assert isinstance(raised.value, InputError | BundleError)


def test_a_path_with_a_colon_is_a_path(tmp_path: Path) -> None:
    path = assets_cache.add(toy_scene(), tmp_path / "odd:place", allow_failed=True)
    assert keys(resolve(str(path))) == [f"bundle:{path.resolve()}"]
    with pytest.raises(BundleError, match="No bundle matches"):
        resolve(str(tmp_path / "odd:place" / "other*"))


def test_the_forms_say_what_a_split_says() -> None:
    held_out = keys(resolve("starter:held_out"))
    assert held_out == keys(split("starter", "held_out"))
