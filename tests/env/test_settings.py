"""Settings as groups and as keywords give the same environments, with one default each."""

import json
import pickle
from dataclasses import fields
from typing import Any

import gymnasium as gym
import pytest
from toy import toy_scene

from generator.errors import InputError
from tabletopgen_env.env import make_env
from tabletopgen_env.learning.recipes import env_keywords
from tabletopgen_env.parallel.vector import TabletopVectorEnv
from tabletopgen_env.rendering.config import MODES
from tabletopgen_env.settings import (
    KEYWORDS,
    ActionConfig,
    EnvConfig,
    ObservationConfig,
    RenderConfig,
    WorldConfig,
    read_settings,
)
from tabletopgen_env.settings.keywords import GROUPS, keywords_of

ID = "tabletopgen_env:TabletopGen/PickPlace-v0"

FLAT: dict[str, dict[str, Any]] = {
    "observation": {"observation": "pixels+state", "cameras": ("top",), "kinds": ("depth",),
                    "image_size": 16, "points": 64, "grasp_hint": "planned",
                    "geometry": "height_map", "instruction": "tokens", "target_mark": "mask",
                    "calibration": True},
    "action": {"action": "joint_delta", "gripper": "binary", "control_hz": 50},
    "render": {"render_mode": "rgb_array", "render_size": (24, 32), "renderer": "software"},
    "worlds": {"robot": None, "cache": 2, "masters": None},
}  # fmt: skip
WHOLE: dict[str, Any] = {
    "observation": ObservationConfig(
        "pixels+state",
        ("top",),
        ("depth",),
        16,
        64,
        "planned",
        "height_map",
        "tokens",
        "mask",
        True,
    ),
    "action": ActionConfig("joint_delta", "binary", 50),
    "render": RenderConfig("rgb_array", (24, 32), "software"),
    "worlds": WorldConfig(cache=2),
}


def test_every_field_has_one_keyword_and_every_keyword_a_field() -> None:
    grouped = [name for group in GROUPS for name in keywords_of(group)]
    single = [field.name for field in fields(EnvConfig)]
    assert len(set(grouped)) == len(grouped)
    assert {*grouped, *single} == KEYWORDS
    assert {name: set(flat) for name, flat in FLAT.items()} == {
        group: set(keywords_of(group)) for group in GROUPS
    }


@pytest.mark.parametrize("group", GROUPS)
def test_a_group_and_its_keywords_mean_the_same(group: str) -> None:
    assert read_settings(FLAT[group]) == read_settings({group: WHOLE[group]})
    assert read_settings({}) == EnvConfig() == read_settings({group: GROUPS[group]()})


@pytest.mark.parametrize("group", GROUPS)
def test_both_ways_at_once_are_refused(group: str) -> None:
    for name, value in FLAT[group].items():
        if name != group:
            with pytest.raises(InputError, match=f"{group} is given, so {name} cannot"):
                read_settings({group: WHOLE[group], name: value})
    for wrong in (None, 3, "x"):
        with pytest.raises(InputError):
            read_settings({group: wrong})


def test_an_environment_is_the_same_whichever_way_it_is_made() -> None:
    flat = {name: value for group in FLAT.values() for name, value in group.items()}
    one = gym.make(ID, scenes=toy_scene(), **flat)
    other = gym.make(ID, scenes=toy_scene(), **WHOLE)
    several = gym.make_vec(ID, num_envs=1, scenes=toy_scene(), **WHOLE)
    assert isinstance(several, TabletopVectorEnv)
    assert one.observation_space == other.observation_space == several.single_observation_space
    assert one.action_space == other.action_space and other.render_mode == "rgb_array"
    seen = [env.reset(seed=3)[0] for env in (one, other)]
    assert all((seen[0][key] == seen[1][key]).all() for key in seen[0])
    assert other.render().shape == (24, 32, 3)  # type: ignore[union-attr]
    for env in (one, other, several):
        env.close()


def test_specs_are_kept_as_they_were_given() -> None:
    flat = {**FLAT["action"], "observation": "goal", "randomization": "starts"}
    whole = {"action": WHOLE["action"], "observation": ObservationConfig("goal")}
    for given in (flat, whole):
        env = gym.make(ID, scenes="starter", **given)
        assert env.spec is not None
        assert pickle.loads(pickle.dumps(env.spec)).kwargs == {
            "task": "PickPlace", "scenes": "starter", **given,
        }  # fmt: skip
        kept = gym.envs.registration.EnvSpec.from_json(env.spec.to_json())
        assert json.loads(json.dumps(kept.kwargs))["scenes"] == "starter"
        again = gym.make(kept)
        assert again.action_space == env.action_space
        assert again.observation_space == env.observation_space


@pytest.mark.parametrize("mode", MODES)
def test_every_mode_can_be_asked_for_as_a_whole(mode) -> None:
    env = make_env(toy_scene(), observation=ObservationConfig(mode, image_size=16, points=8))
    assert env.observation_space == make_env(
        toy_scene(), observation=mode, image_size=16, points=8
    ).observation_space  # fmt: skip


def test_a_group_as_a_dict_has_its_fields_alone() -> None:
    assert read_settings({"action": {"gripper": "binary"}}).action.gripper == "binary"
    with pytest.raises(
        InputError, match=r"RenderConfig has no setting 'render_mode'.*Available: mode"
    ):
        read_settings({"render": {"render_mode": "human"}})


def test_recipes_name_no_renderer_and_no_worlds() -> None:
    assert {"observation", "action", "preset", "certified"} < env_keywords()
    assert not env_keywords() & {"render", "render_mode", "worlds", "cache", "scenes", "task"}
