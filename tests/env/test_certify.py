"""Certificates: created by the expert, stored beside a bundle, rejected for other scenes."""

import itertools
import json
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command import Shell
from toy import toy_object, toy_scene

from generator.bundle import load, save, verify
from generator.cli import run
from generator.errors import BundleError, InputError
from generator.physics.gate import judge
from generator.scene import Scene
from tabletopgen_env.certificates import certify as certify_module
from tabletopgen_env.certificates.certificate import (
    FILE,
    STARTS,
    TaskInstance,
    Terms,
    read_certificate,
)
from tabletopgen_env.certificates.certify import DEFAULT, certify, is_certified, played_again
from tabletopgen_env.env import TabletopEnv, make_env


def scene() -> Scene:
    things = (
        toy_object("cube_1", (0.04, 0.04, 0.04), (-0.1, 0.0)),
        toy_object("board_1", (0.16, 0.16, 0.02), (0.15, 0.0), mass=1.0),
    )
    made = toy_scene(things)
    return made.replace(report=judge(made))


def certified_at(path: Path) -> tuple[TaskInstance, ...]:
    found = read_certificate(path)
    return () if found is None else found.certified


TERMS = Terms(("Stack", "Lift"), episodes=2, most=8, seed=3)


@pytest.fixture(scope="module")
def certified(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = save(scene(), tmp_path_factory.mktemp("store"))
    certify(path, TERMS)
    return path


@pytest.fixture
def bundle(certified: Path, tmp_path: Path) -> Path:
    """A copy of a bundle whose certificate may be damaged."""
    path = save(scene(), tmp_path)
    (path / FILE).write_bytes((certified / FILE).read_bytes())
    return path


@pytest.mark.slow
def test_it_lists_what_the_expert_did(certified: Path) -> None:
    found = read_certificate(certified)
    assert found is not None and found.terms == TERMS and "mujoco" in found.versions
    assert [(i.task, i.target, i.goal) for i in found.instances] == [
        ("Lift", "cube_1", None), ("Stack", "cube_1", "board_1"),
    ]  # fmt: skip
    assert all(i.episodes == 2 for i in found.instances)
    assert certified_at(certified) == (), "two starts are too few"


@pytest.mark.parametrize(
    ("solved", "starts", "counts"),
    [
        (STARTS, STARTS, True), (40, 40, True), (10, 10, False), (STARTS - 1, STARTS - 1, False),
        (STARTS - 1, STARTS, False), (99, 100, False), (0, 0, False),
    ],
)  # fmt: skip
def test_what_counts_is_solved_from_all_of_many_starts(
    bundle: Path, solved: int, starts: int, counts: bool
) -> None:
    payload = json.loads((bundle / FILE).read_text())
    (bundle / FILE).write_text(json.dumps(spoilt(payload, successes=solved, episodes=starts)))
    assert [i.task for i in certified_at(bundle)] == ["Lift"] * counts


def test_those_that_are_shipped_are_certified_from_enough_starts() -> None:
    assert DEFAULT.episodes >= STARTS
    assert 0.9**STARTS < 0.05, "what fails once in ten is hardly ever certified"


def test_the_first_start_is_the_scene_s_own_and_the_others_differ(
    bundle: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    starts: list[bytes] = []

    def solved(env: TabletopEnv, instance: TaskInstance, rng: np.random.Generator) -> bool:
        env.reset(seed=int(rng.integers(2**31)), options=instance.options)
        starts.append(env.world.data.qpos.tobytes())
        return True

    monkeypatch.setattr(certify_module, "has_solved", solved)
    certify(bundle, Terms(("Lift",), episodes=4))
    env = make_env(bundle, task="Lift", certified=False)
    env.reset(seed=5, options={"target": "cube_1"})
    assert starts[0] == env.world.data.qpos.tobytes()
    assert len(set(starts)) == 4


def test_instances_are_played_again_from_starts_of_another_seed(
    bundle: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    starts: list[int] = []

    def solved(env: Any, instance: TaskInstance, rng: np.random.Generator) -> bool:
        starts.append(int(rng.integers(2**31)))
        return len(starts) != 3

    monkeypatch.setattr(certify_module, "has_solved", solved)
    certify(bundle, replace(TERMS, episodes=4))
    certified, played = set(starts), read_certificate(bundle)
    starts.clear()
    assert played is not None
    found = list(played_again(bundle, played.instances, 5, seed=9))
    assert [(i.task, i.successes, i.episodes) for i in found] == [("Lift", 4, 5), ("Stack", 5, 5)]
    assert len(set(starts)) == 10 and not certified & set(starts), "none is given up, all are new"


def test_its_options_ask_for_the_instance(certified: Path) -> None:
    found = read_certificate(certified)
    assert found is not None
    instance = found.instances[1]
    env = make_env(certified, task=instance.task)
    _, info = env.reset(seed=0, options=instance.options)
    assert (info["target"], info["goal"]) == ("cube_1", "board_1")


@pytest.mark.slow
def test_the_same_seed_gives_the_same_certificate(certified: Path, bundle: Path) -> None:
    for workers in (1, 2):
        (bundle / FILE).unlink()
        certify(bundle, TERMS, workers)
        assert (bundle / FILE).read_bytes() == (certified / FILE).read_bytes()
    found = read_certificate(certified)
    assert found is not None
    assert certify(bundle, replace(TERMS, tasks=("Stack",))).instances == found.instances[1:]


def test_the_bundle_stays_sound_and_keeps_it(bundle: Path) -> None:
    assert verify(bundle) == []
    assert [o.name for o in load(bundle).objects] == ["cube_1", "board_1"]
    assert save(scene(), bundle.parent) == bundle
    assert (bundle / FILE).is_file(), "publishing again does not remove it"


def test_a_bundle_without_one_certifies_nothing(tmp_path: Path) -> None:
    path = save(scene(), tmp_path)
    assert read_certificate(path) is None


def spoilt(payload: dict[str, Any], **changes: Any) -> dict[str, Any]:
    first, *rest = payload["instances"]
    return payload | {"instances": [first | changes, *rest]}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("spoil", "reason"),
    [
        (lambda p: p | {"scene": "0" * 64}, "another scene"),
        (lambda p: p | {"schema": 5}, "schema is 5, not 4.*certify the bundle again"),
        (lambda p: p | {"schema": True}, "type int"),
        (lambda p: p | {"schema": 0}, "schema is 0"),
        (lambda p: p | {"versions": ["mujoco"]}, "type dict"),
        (lambda p: spoilt(p, successes=9), "9 of 2"),
        (lambda p: spoilt(p, successes=True), "type int"),
        (lambda p: spoilt(p, task="Juggle"), "Unknown task 'Juggle'"),
        (lambda p: spoilt(p, task="Push"), "Push, which the settings do not"),
        (lambda p: spoilt(p, preset="kitchen"), "Lift has no presets"),
        (lambda p: spoilt(p, task="Sequence", preset="kichen"), "no preset 'kichen'"),
        (lambda p: p | {"terms": p["terms"] | {"episodes": 0}}, "episodes must be a whole"),
        (lambda p: p | {"terms": p["terms"] | {"tasks": ["Juggle"]}}, "Unknown task 'Juggle'"),
        (lambda p: spoilt(p, goal=[0.1, 0.2]), "must be a string, not list"),
        (lambda p: spoilt(p, target="cube\x1b[2J"), "cannot be printed"),
        (lambda p: p | {"versions": {"mujoco": "3" * 500}}, "500 characters"),
        (lambda p: p | {"more": [[[[[[]]]]]]}, "deeper than 4"),
        (lambda p: p | {"instances": p["instances"] * 3000}, "too many|bytes|more than"),
    ],
)
def test_what_is_not_sound_is_refused(bundle: Path, spoil: Any, reason: str) -> None:
    payload = json.loads((bundle / FILE).read_text())
    (bundle / FILE).write_text(json.dumps(spoil(payload)))
    with pytest.raises(BundleError, match=reason):
        read_certificate(bundle)


def test_a_certificate_of_an_older_schema_certifies_nothing(bundle: Path) -> None:
    payload = json.loads((bundle / FILE).read_text())
    (bundle / FILE).write_text(json.dumps(payload | {"schema": 3}))
    assert read_certificate(bundle) is None


@pytest.mark.parametrize("raw", [b"{", b'{"schema": NaN}', b"\xff", b"[" * 5000])
def test_what_is_no_json_is_refused(bundle: Path, raw: bytes) -> None:
    (bundle / FILE).write_bytes(raw)
    with pytest.raises(BundleError, match="not a valid certificate"):
        read_certificate(bundle)


def test_a_link_is_not_followed(bundle: Path, tmp_path: Path) -> None:
    (bundle / FILE).rename(tmp_path / "elsewhere.json")
    (bundle / FILE).symlink_to(tmp_path / "elsewhere.json")
    with pytest.raises(BundleError, match="is a link"):
        read_certificate(bundle)


def test_wrong_requests_are_explained(bundle: Path, shell: Shell) -> None:
    with pytest.raises(InputError, match="Did you mean 'Stack'"):
        Terms(("Stak",))
    with pytest.raises(InputError, match="must be a whole number >= 1 and <= 10000, got 0"):
        Terms(episodes=0)
    with pytest.raises(InputError, match="at least one task"):
        Terms(())
    with pytest.raises(InputError, match="workers must be"):
        certify(bundle, TERMS, workers=0)
    told = shell("certify", str(bundle), "--tasks", "Lift", "--episodes", "0", code=2).err
    assert "error: Terms.episodes must" in told
    assert run(["certify", str(bundle.parent / "none")]) == 4


@pytest.mark.slow
def test_the_command_goes_on_where_it_was_interrupted(
    certified: Path, tmp_path: Path, shell: Shell
) -> None:
    done = shutil.copytree(certified, tmp_path / "a" / certified.name)
    left = save(scene().replace(name="left"), tmp_path / "a")
    other = json.loads((done / FILE).read_text())
    (left / FILE).write_text(json.dumps(other))  # made for another scene
    marked = other | {"versions": {"mujoco": "as it was"}}
    (done / FILE).write_text(json.dumps(marked))
    wanted = ["certify", str(tmp_path / "a"), "--tasks", "Lift", "Stack", "--most", "8"]
    told = shell(*wanted, "--episodes", "2", "--seed", "3").out
    assert "1 of 2 bundles are already certified" in told
    assert f"{left.name}: Lift (target cube_1): 2 of 2" in told and done.name not in told
    assert is_certified(left, TERMS) and json.loads((done / FILE).read_text()) == marked
    assert not is_certified(left, replace(TERMS, seed=4)), "it says something else"
    assert run([*wanted, "--episodes", "2", "--seed", "3", "--again"]) == 0
    assert (done / FILE).read_bytes() == (certified / FILE).read_bytes()


@pytest.mark.slow
def test_a_bad_bundle_does_not_end_the_others(tmp_path: Path, shell: Shell) -> None:
    paths = [save(scene().replace(name=name), tmp_path) for name in ("one", "two", "three")]
    bad = paths[1] / "scene.json"
    bad.write_text(bad.read_text().replace("cube_1", "cube_2"))
    told = shell("certify", *map(str, paths), "--tasks", "Lift", "--episodes", "1", code=4)
    assert all(f"{path.name}: Lift" in told.out for path in (paths[0], paths[2]))
    assert all(is_certified(path, Terms(("Lift",), 1)) for path in (paths[0], paths[2]))
    *_, line = told.err.splitlines()
    assert line.startswith(f"error: {paths[1].name} is not certified: ") and "scene.json" in line
    assert not (paths[1] / FILE).exists()
    with pytest.raises(BundleError, match=r"scene\.json"):
        certify(paths[1], TERMS)


def test_bad_bundles_are_named_also_when_the_rest_is_interrupted(
    tmp_path: Path, shell: Shell, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: Any) -> Any:
        yield tmp_path / "bad", BundleError("it is damaged")
        raise KeyboardInterrupt

    path = save(scene(), tmp_path)
    monkeypatch.setattr("tabletopgen_env.certificates.certify.certify_all", interrupted)
    assert "error: bad is not certified: it is damaged" in shell("certify", str(path), code=130).err


def test_a_certificate_that_cannot_be_written_does_not_end_the_others(
    tmp_path: Path, shell: Shell
) -> None:
    paths = [save(scene().replace(name=name), tmp_path) for name in ("one", "two")]
    (paths[0] / FILE).mkdir()
    told = shell("certify", *map(str, paths), "--tasks", "Reach", "--episodes", "1", code=5).err
    assert is_certified(paths[1], Terms(("Reach",), 1))
    assert f"error: {paths[0].name} is not certified: " in told


@pytest.mark.parametrize(
    ("failures", "successes", "episodes"),
    [((), 20, 20), ((4,), 4, 5), ((0, 1), 0, 1), ((19,), 19, 20)],
)
def test_what_fails_is_given_up(
    failures: tuple[int, ...], successes: int, episodes: int, bundle: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    played = itertools.count()
    monkeypatch.setattr(certify_module, "has_solved", lambda *_: next(played) not in failures)
    (seen,) = certify(bundle, Terms(("Lift",), episodes=20)).instances
    assert (seen.successes, seen.episodes) == (successes, episodes)


def test_terms_are_alike_however_they_are_given() -> None:
    terms = Terms(("Stack", "Lift", "Stack"), np.int64(2), most=8, seed=3)  # type: ignore[arg-type]
    assert terms == TERMS and type(terms.episodes) is int


def test_options_ask_for_the_instance() -> None:
    assert TaskInstance("Push", "a", "spot").options == {"target": "a", "goal": "spot"}
    assert TaskInstance("Reach", None, None).options == {}
