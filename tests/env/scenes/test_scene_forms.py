"""What may be passed as ``scenes``, and what is said of anything else."""

from __future__ import annotations

from pathlib import Path

import pytest
from toy import toy_scene

import assets_cache
from generator.distribution import SceneDistribution
from generator.errors import BundleError, InputError, TabletopError
from tabletopgen_env.env import make_env
from tabletopgen_env.scenes import (
    FixedScenes,
    FreshScenes,
    RefreshingScenes,
    SceneSource,
    resolve,
    split,
)


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
        ("startr", "did you mean scenes='starter'"),
        ("Fresh", "did you mean scenes='fresh'"),
        ("refresh", "did you mean scenes='(fresh|refreshing)'"),
        ("starter:heldout", "Did you mean 'starter:held_out'"),
        ("starter:trian", "Did you mean 'starter:train'"),
        ("frsh:a desk", "Did you mean 'fresh:PROMPT'"),
        ("refreshng: a desk", "Did you mean 'refreshing:PROMPT'"),
        ("kitchens:a desk", "Available: fresh, fresh:PROMPT.*starter:train"),
        ("no_such_desk", "Besides bundles, scenes can be 'starter', .*'refreshing:PROMPT'"),
        ("fresh:", "lacks a prompt.*'fresh:an office desk', or just 'fresh'"),
        ("refreshing: ", "lacks a prompt"),
        ("fresh:42", "no words"),
        ("refreshing:ein Tisch mit einer Tasse und einem Buch", "English"),
        (["fresh:a desk"], "'fresh:a desk' is no fixed scene, and cannot be one of a list"),
        (["starter", "refreshing"], "'refreshing' is no fixed scene"),
        ([], "list is empty"),
        (5, "scenes is of type int; pass .*'starter:train'"),
        ([5], "holds a int"),
    ],
)
def test_what_is_no_scene_is_explained(scenes, message) -> None:
    with pytest.raises(TabletopError, match=message) as raised:
        make_env(scenes)
    assert isinstance(raised.value, InputError | BundleError)


def test_a_path_with_a_colon_is_a_path(tmp_path: Path) -> None:
    path = assets_cache.add(toy_scene(), tmp_path / "odd:place", allow_failed=True)
    assert keys(resolve(str(path))) == [f"bundle:{path.resolve()}"]
    with pytest.raises(BundleError, match="No bundle fits"):
        resolve(str(tmp_path / "odd:place" / "other*"))


def test_the_forms_say_what_a_split_says() -> None:
    held_out = keys(resolve("starter:held_out"))
    assert held_out == keys(split("starter", "held_out"))
