"""Driving by hand: what is asked for, who acts, and a page that nobody else drives."""

import json
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import closing, suppress
from dataclasses import replace
from typing import Any

import gymnasium as gym
import numpy as np
import pytest
from gymnasium.wrappers import TimeLimit
from toy import toy_scene

from generator.errors import BackendError, InputError, SceneError
from tabletopgen_env.env import make_env
from tabletopgen_env.recording.config import RecordConfig
from tabletopgen_env.recording.formats.about import describe_dataset
from tabletopgen_env.recording.recorder import write_dataset
from tabletopgen_env.teleoperation import command
from tabletopgen_env.teleoperation.command import play
from tabletopgen_env.teleoperation.inputs import SLOWLY, VIEWS, HumanInput, Operator
from tabletopgen_env.teleoperation.page import MOST_BYTES, TeleopPage, read_input
from tabletopgen_env.teleoperation.session import TeleopSession, TeleopStatus
from tabletopgen_env.teleoperation.window import TeleopWindow
from tabletopgen_env.world.composition import FRONT_CAMERA, SIDE_CAMERA, TOP_CAMERA

REST = HumanInput()


def keys(*names: str) -> HumanInput:
    return HumanInput(frozenset(names))


# --------------------------------------------------------------------------------------- inputs
@pytest.mark.parametrize(
    ("view", "camera"), [("front", FRONT_CAMERA), ("side", SIDE_CAMERA), ("top", TOP_CAMERA)]
)
def test_right_is_right_in_the_picture(view, camera) -> None:
    env = make_env(toy_scene())
    env.reset(seed=0)
    axes = env.world.data.cam_xmat[env.world.model.camera(camera).id].reshape(3, 3)
    in_base = env.world.base_rotation.T @ axes
    right, away = VIEWS[view]
    assert in_base[:2, 0] @ right > 0.99
    up_or_away = in_base[:2, 1] if view == "top" else -in_base[:2, 2]
    assert up_or_away @ away > 0.8


def test_keys_and_sticks_ask_for_the_same() -> None:
    by_keys = Operator("top").read(keys("w", "d", "r", "q"))
    by_stick = Operator("top").read(HumanInput(axes=(1.0, -1.0, -1.0, -1.0)))
    assert np.array_equal(by_keys.action, by_stick.action)
    assert by_keys.action.tolist() == [1.0, -1.0, 1.0, 1.0, 1.0] and by_keys.acts
    slow = Operator("top").read(keys("w", "shift"))
    assert slow.action[0] == np.float32(SLOWLY)
    assert not Operator("top").read(HumanInput(axes=(0.1, -0.1, 0.05, 0.0))).acts
    assert not Operator("top").read(keys("a", "d")).acts  # they cancel


def test_the_gripper_turns_over_once_a_press() -> None:
    operator = Operator("front")
    closed = [operator.read(given).action[4] for given in (keys("space"),) * 3]
    assert closed == [-1, -1, -1]
    assert operator.read(REST).action[4] == -1
    assert operator.read(HumanInput(buttons=frozenset({0}))).action[4] == 1


def test_events_count_when_keys_go_down() -> None:
    operator = Operator("front")
    assert operator.read(keys("enter", "p")).events == {"keep", "policy"}
    assert operator.read(keys("enter", "p")).events == frozenset()
    assert operator.read(HumanInput(buttons=frozenset({8}))).events == {"drop"}


# -------------------------------------------------------------------------------------- session
class Still:
    """A policy that lowers the hand with a closed gripper."""

    def predict(self, observation: Any, *, deterministic: bool) -> tuple[np.ndarray, None]:
        return np.array([0, 0, -0.2, 0, -1], np.float32), None


@pytest.fixture
def env() -> Iterator[gym.Env]:
    made = TimeLimit(make_env(toy_scene(), task="Reach"), 12)
    yield made
    made.close()


def test_a_person_plays_and_keeps_an_episode(env) -> None:
    session = TeleopSession(env, "front")
    session.begin(3)
    for _ in range(4):
        assert session.advance(keys("a")) is None
    assert session.status.by == "human" and session.status.step == 4
    kept = session.advance(keys("enter"))
    assert kept is not None and kept != "dropped"
    assert len(kept.actions) == 4 == len(kept.rewards) == len(kept.observations) - 1
    assert kept.by_human == [True] * 4 and kept.seed == 3 and not kept.solved
    assert session.kept == 1
    again = env.reset(seed=3)[0]
    assert np.array_equal(again, kept.observations[0])
    for k, action in enumerate(kept.actions):  # what was done gives the same again
        assert np.array_equal(env.step(action)[0], kept.observations[k + 1])


def test_a_person_takes_over_and_gives_back(env) -> None:
    session = TeleopSession(env, "front", Still())
    session.begin(0)
    for given in (REST, REST, keys("d"), REST, keys("p"), REST):
        session.advance(given)
    episode = session.advance(keys("enter"))
    assert episode is not None and episode != "dropped"
    assert episode.by_human == [False, False, True, True, False, False]
    assert episode.actions[3].tolist() == [0, 0, 0, 0, -1]  # the gripper as the policy left it


def test_time_ends_an_episode_that_waits_to_be_kept_or_dropped(env) -> None:
    session = TeleopSession(env, "front")
    session.begin(0)
    for _ in range(20):
        session.advance(REST)
    assert session.status.over == "time" and session.status.step == 12
    assert session.advance(keys("backspace")) == "dropped" and session.kept == 0
    session.begin(1)
    assert session.advance(keys("enter")) is None  # nothing was done yet


def test_only_ee_delta_is_driven() -> None:
    other = make_env(toy_scene(), action="joint_delta")
    with pytest.raises(InputError, match=r"ee_delta.*joint_delta"):
        TeleopSession(other, "front")
    with pytest.raises(InputError, match="begin"):
        _ = TeleopSession(make_env(toy_scene()), "front").status


# -------------------------------------------------------------------------------------- dataset
class Scripted:
    """A person who follows a script, then closes the window."""

    def __init__(self, script: list[HumanInput]) -> None:
        self._script = iter(script)
        self.shown: list[TeleopStatus] = []

    def read(self) -> HumanInput | None:
        return next(self._script, None)

    def show(self, picture: np.ndarray, status: TeleopStatus) -> None:
        assert picture.shape == (24, 32, 3)
        self.shown.append(status)


@pytest.mark.parametrize("format", ["npz", "hdf5", "lerobot"])
def test_what_is_kept_becomes_a_dataset_that_replays(format, tmp_path) -> None:
    pytest.importorskip({"hdf5": "h5py", "lerobot": "pyarrow"}.get(format, "numpy"))
    config = RecordConfig("Reach", scenes=("office-desk",), player="human")
    env = gym.make("tabletopgen_env:TabletopGen/Reach-v0", scenes="office-desk",
                   randomization="starts", render_mode="rgb_array", render_size=(24, 32),
                   renderer="software")  # fmt: skip
    script = [keys("a"), keys("a", "r"), REST, keys("enter"), keys("d"), keys("backspace"),
              keys("w"), keys("enter"), keys("s")]  # fmt: skip
    person = Scripted(script)
    session = TeleopSession(env, "front")
    made = list(play(session, person, env, "front", enumerate([5, 6, 7, 8])))
    assert [(e.number, len(e.actions)) for e in made] == [(0, 3), (2, 1)]
    assert len(person.shown) == len(script) and session.kept == 2
    assert made[0].facts["human_steps"] == 3 and made[0].infos["human"].all()
    path = write_dataset(config, env, lambda _: made, tmp_path / "set", format)
    assert path.exists()
    if format == "npz":
        kept = np.load(path / "episode_0.npz")
        told = json.loads((path / "dataset.json").read_text())
        assert told["player"] == "human" and told["episodes"][1]["seed"] == 7
        seen, _ = env.reset(seed=5)
        for k, action in enumerate(kept["actions"]):
            assert np.array_equal(seen, kept["observations"][k])
            seen = env.step(action)[0]
        assert kept["infos/human"].all()
    env.close()


class Leaving(Scripted):
    """A scripted operator's display, for the command."""

    def close(self) -> None:
        pass


@pytest.mark.slow
def test_a_policys_dataset_tells_what_was_made(tmp_path, monkeypatch) -> None:
    pytest.importorskip("stable_baselines3")
    person = Leaving([REST, keys("enter")])
    monkeypatch.setattr(command, "SIZE", (24, 32))
    monkeypatch.setattr(command, "_device", lambda *_: person)
    config = RecordConfig(scenes=("office-desk",), randomization="light", seed=1)
    command.teleop("reach-clone", config=config, out=tmp_path / "set")
    told = json.loads((tmp_path / "set" / "dataset.json").read_text())
    assert told["environment"]["id"] == "TabletopGen/Reach-v0"
    assert told["environment"]["kwargs"]["randomization"] == "light"
    assert told["player"] == "human and reach-clone"
    assert told["settings"] == {
        "task": "Reach", "preset": None, "scenes": ["office-desk"], "seed": 1, "cameras": [],
        "kinds": ["rgb"], "image_size": None, "observation": "pixels+state",
        "randomization": "light",
    }  # fmt: skip
    assert told["episodes"][0]["human_steps"] == 0


def test_settings_are_those_of_the_environment_that_was_made() -> None:
    config = RecordConfig("Lift", scenes=("office-desk",), player="human")
    own = {"observation": "pixels+proprio", "cameras": ["top"], "kinds": ["depth"],
           "image_size": {"top": 16}, "randomization": "none"}  # fmt: skip
    with closing(gym.make("tabletopgen_env:TabletopGen/Lift-v0", scenes="office-desk", **own)) as e:
        settings = describe_dataset(config, e)["settings"]
    assert {name: settings[name] for name in own} == own
    assert settings["scenes"] == ("office-desk",)


@pytest.mark.slow
def test_what_a_policy_decides_is_not_asked_for(tmp_path) -> None:
    pytest.importorskip("stable_baselines3")
    cases = (
        ("reach-clone", {"cameras": ("front",), "image_size": 64}, "--cameras, --image-size"),
        ("reach-clone", {"task": "Lift", "kinds": ("depth",)}, "the task .Reach.* --task, --kinds"),
        ("reach-clone", {"preset": "kitchen", "observation": "pixels+proprio"}, "--preset, --obs"),
        ("lift-sight", {"randomization": "strong"}, "Omit --randomization, or"),
    )
    for policy, given, reason in cases:
        config = replace(RecordConfig(scenes=("office-desk",)), **given)
        with pytest.raises(InputError, match=reason):
            command.teleop(policy, config=config, out=tmp_path / "set")
    with pytest.raises(InputError, match=r"Unknown task 'Lif'.*'Lift'"):
        command.teleop(config=RecordConfig("Lif"), out=tmp_path / "set")


@pytest.mark.parametrize("env", [{"observation": "goal"}, {"geometry": "height_map"}])
def test_policies_of_what_no_dataset_holds_are_refused(env, tmp_path, monkeypatch) -> None:
    pytest.importorskip("stable_baselines3")
    acting = command._load("reach-clone")
    other = replace(acting, card=replace(acting.card, env=env))
    monkeypatch.setattr(command, "_load", lambda _: other)
    with pytest.raises(InputError, match="which datasets do not support"):
        command.teleop("mine", config=RecordConfig(), out=tmp_path / "set")


def test_seeds_with_nothing_to_do_are_passed_over(env, monkeypatch) -> None:
    session, begin = TeleopSession(env, "front"), TeleopSession.begin

    def fail(self: TeleopSession, seed: int) -> None:
        if seed > 1:
            raise SceneError(f"nothing to do with {seed}")
        begin(self, seed)

    monkeypatch.setattr(TeleopSession, "begin", fail)
    monkeypatch.setattr(type(env.unwrapped), "picture", lambda *_: np.zeros((24, 32, 3), np.uint8))
    person = Scripted([keys("a"), keys("enter"), keys("a"), keys("enter")])
    made = play(session, person, env, "front", enumerate([0, 2, 1, *[3] * 50]))
    assert [next(made).number, next(made).number] == [0, 2]
    with pytest.raises(SceneError, match=r"50 consecutive seeds .* nothing to do with 3"):
        next(made)


def test_nothing_kept_is_no_dataset(tmp_path) -> None:
    with pytest.raises(InputError, match="No episode was kept"):
        write_dataset(RecordConfig("Reach"), make_registered(), lambda _: [], tmp_path / "set",
                      "npz")  # fmt: skip
    assert not any(tmp_path.iterdir())


def make_registered() -> gym.Env:
    return gym.make("tabletopgen_env:TabletopGen/Reach-v0", scenes="office-desk")


# ----------------------------------------------------------------------------------------- page
@pytest.fixture
def page() -> Iterator[TeleopPage]:
    pytest.importorskip("websockets")
    with closing(TeleopPage()) as served:
        yield served


def fetch(url: str, **headers: str) -> tuple[int, str, dict[str, str]]:
    request = urllib.request.Request(url, headers=headers)
    try:
        with urllib.request.urlopen(request, timeout=10) as answer:
            return answer.status, answer.read().decode(), dict(answer.headers)
    except urllib.error.HTTPError as error:
        return error.code, error.read().decode(), {}


def connect(page: TeleopPage, origin: str | None = None, token: str | None = None) -> Any:
    from websockets.sync.client import connect as opened

    query = page.address.partition("?")[2] if token is None else f"token={token}"
    own = f"http://127.0.0.1:{page.port}" if origin is None else origin
    return opened(f"ws://127.0.0.1:{page.port}/drive?{query}", origin=own)  # type: ignore


def test_the_page_needs_its_token_and_its_host(page) -> None:
    status, text, headers = fetch(page.address)
    assert status == 200 and "<h1" in text and headers["Content-Type"].startswith("text/html")
    bare = page.address.partition("?")[0]
    assert fetch(bare)[0] == 403 and fetch(bare + "?token=guess")[0] == 403
    assert fetch(page.address, Host="evil.example")[0] == 403  # DNS rebinding
    assert fetch(page.address.replace("/?", "/../etc/passwd?"))[0] == 404


def test_other_sites_cannot_drive(page) -> None:
    from websockets.exceptions import InvalidStatus

    for origin, token in (("http://evil.example", None), (None, "guess"), ("null", None)):
        with pytest.raises(InvalidStatus, match="403"):
            connect(page, origin, token)
    assert page.read() is None


def test_what_is_held_down_arrives_and_pictures_go_out(page, env) -> None:
    session = TeleopSession(env, "front")
    session.begin(0)
    picture = np.zeros((24, 32, 3), np.uint8)
    page.show(picture, session.status)  # to nobody
    with connect(page) as browser:
        browser.send(json.dumps({"keys": ["a", "F13"], "axes": [0, 0.5, 0, 0], "buttons": [0]}))
        browser.send("{")
        assert "keys, axes and buttons" in json.loads(browser.recv(10))["error"]
        assert page.read() == HumanInput(frozenset("a"), (0, 0.5, 0, 0), frozenset({0}))
        page.show(picture, session.status)
        said, shown = json.loads(browser.recv(10)), browser.recv(10)
        assert said["instruction"] == session.status.instruction and shown[:2] == b"\xff\xd8"
        with connect(page) as other:  # the last one drives
            other.send(json.dumps({"keys": [], "axes": [], "buttons": []}))
            with suppress(Exception):
                browser.recv(10)
            assert page.read() is not None
    deadline = time.monotonic() + 10
    while page.read() is not None and time.monotonic() < deadline:
        time.sleep(0.01)
    assert page.read() is None


def test_a_short_press_is_not_missed(page) -> None:
    with connect(page) as browser:
        for held in (["space"], []):
            browser.send(json.dumps({"keys": held, "axes": [], "buttons": []}))
        browser.send("{")
        browser.recv(10)
        assert page.read() == HumanInput(frozenset({"space"}), ())
        assert page.read() == HumanInput(axes=())


@pytest.mark.parametrize(
    "message",
    [
        "", "[]", "null", "{}", '{"keys": "a", "axes": [], "buttons": []}',
        '{"keys": [1], "axes": [], "buttons": []}', '{"keys": [], "axes": [2], "buttons": []}',
        '{"keys": [], "axes": [NaN], "buttons": []}', '{"keys": [], "axes": [], "buttons": [1.5]}',
        '{"keys": [], "axes": [], "buttons": [99]}', "[" * 3000, b"\xff\xfe",
        json.dumps({"keys": ["a"] * 99, "axes": [], "buttons": []}),
        '{"keys": [], "axes": [true], "buttons": []}',
    ],
)  # fmt: skip
def test_hostile_messages_are_refused(message) -> None:
    with pytest.raises(InputError, match="keys, axes and buttons"):
        read_input(message)


def test_a_large_message_ends_the_connection_not_the_page(page) -> None:
    from websockets.exceptions import ConnectionClosed

    with connect(page) as browser:
        browser.send("x" * (2 * MOST_BYTES))
        with pytest.raises(ConnectionClosed):
            browser.recv(10)
    with connect(page) as browser:
        browser.send(json.dumps({"keys": ["w"], "axes": [], "buttons": []}))
        browser.send("{")
        browser.recv(10)
        assert page.read() == HumanInput(frozenset("w"), ())


def test_a_port_in_use_is_told(page) -> None:
    with pytest.raises(BackendError, match=f"Port {page.port}.*0 for any"):
        TeleopPage(page.port)


def test_without_a_display_the_page_is_named(monkeypatch) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    with pytest.raises(BackendError, match="--device page"):
        TeleopWindow(24, 32)
