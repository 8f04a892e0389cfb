"""Checks of certificates: consistency of the figures, and replays of some episodes."""

import json
import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from command import Shell
from toy import toy_object, toy_scene

from generator.bundle import save
from generator.cli import plugins
from generator.physics.gate import judge
from tabletopgen_env.certificates import replay as replaying
from tabletopgen_env.certificates.certificate import (
    Certificate,
    TaskInstance,
    Terms,
    read_certificate,
    write_certificate,
)
from tabletopgen_env.certificates.certify import certify
from tabletopgen_env.certificates.replay import check_certificate, doubts, replay

TERMS = Terms(("Reach", "Lift"), 3, 2)


@pytest.fixture(scope="module")
def certified(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A toy bundle, certified in three episodes an instance."""
    made = toy_scene((toy_object("cube_1", (0.04, 0.04, 0.04), (-0.1, 0.0)),))
    path = save(made.replace(report=judge(made)), tmp_path_factory.mktemp("bundles"))
    certify(path, TERMS)
    return path


def with_instances(path: Path, *instances: TaskInstance) -> Certificate:
    """Write other instances into a bundle's certificate."""
    found = read_certificate(path)
    assert found is not None
    changed = replace(found, instances=instances)
    write_certificate(path, changed)
    return changed


@pytest.mark.parametrize(("seen", "kind"), [
    ((3, 3), None), ((2, 3), None), ((0, 1), None),
    ((2, 2), "given up early"), ((1, 3), "played after a failure"), ((4, 4), "too many"),
    ((0, 0), "given up early"),
])  # fmt: skip
def test_figures_that_no_certification_gives_are_named(
    seen: tuple[int, int], kind: str | None
) -> None:
    made = Certificate("0", TERMS, {}, (TaskInstance("Lift", "cube_1", None, *seen),))
    assert [doubt.kind for doubt in doubts(made)] == ([kind] if kind else [])


def test_no_shipped_certificate_has_such_figures() -> None:
    import assets_cache

    for path in assets_cache.find("*"):
        found = read_certificate(path)
        assert found is None or doubts(found) == (), path.name


@pytest.mark.slow
def test_what_the_expert_did_it_does_again(certified: Path) -> None:
    found = read_certificate(certified)
    assert found is not None and {seen.task for seen in found.instances} == {"Reach", "Lift"}
    total = sum(seen.episodes for seen in found.instances)
    every = list(replay(certified, found, 100, 0))
    assert len(every) == total == check_certificate(certified, 100, 0)[0]
    assert all(again.solved == again.listed for again in every)
    some = [again.number for again in replay(certified, found, 2, 5)]
    assert some == [again.number for again in replay(certified, found, 2, 5)] and len(some) == 2


@pytest.mark.slow
def test_what_the_expert_did_not_do_is_found(
    certified: Path, tmp_path: Path, shell: Shell, monkeypatch: pytest.MonkeyPatch
) -> None:
    bundle = shutil.copytree(certified, tmp_path / certified.name)
    verify = shell.of("verify", str(bundle), "--replay", "3", "--seed", "1")
    assert f"{bundle.name}: valid, 3 episodes replayed" in verify().out
    counted = {"failures": [], "replayed": 3, "seed": 1}
    assert json.loads(verify("--json").out) == {bundle.name: counted}
    with_instances(bundle, TaskInstance("Lift", "cube_1", None, 0, 1))
    assert "valid, 1 episodes replayed" in verify().out, "it claims less than holds"
    with_instances(bundle, TaskInstance("Lift", "cube_1", None, 3, 3))
    with monkeypatch.context() as failing:
        failing.setattr(replaying, "has_solved", lambda *_: False)
        said = verify(code=1).out
    assert "Lift (target cube_1): episode 0 is not solved, but is listed as solved" in said
    with_instances(bundle, TaskInstance("Lift", "cube_1", None, 40, 40))
    assert "40 of 40 successful episodes is an impossible result (too many" in verify(code=1).out
    listed = json.loads(verify("--json", code=1).out)[bundle.name]
    assert len(listed["failures"]) == 1 and "impossible result" in listed["failures"][0]
    assert (listed["replayed"], listed["seed"]) == (0, 1)
    assert json.loads(shell("verify", str(bundle), "--json").out) == {bundle.name: []}


def test_a_bundle_without_a_certificate_has_nothing_to_play(tmp_path: Path, shell: Shell) -> None:
    made = toy_scene()
    path = save(made.replace(report=judge(made)), tmp_path)
    assert "valid, 0 episodes replayed" in shell("verify", str(path), "--replay", "2").out
    assert "episodes" not in shell("verify", str(path)).out
    assert "--replay" in shell("verify", str(path), "--replay", "-1", code=2).err


def test_where_nothing_plays_certificates_it_is_said(
    tmp_path: Path, shell: Shell, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = toy_scene()
    path = save(made.replace(report=judge(made)), tmp_path)
    monkeypatch.setattr(plugins, "project", dict)
    monkeypatch.setattr(plugins, "entry_points", lambda group: ())
    said = shell("verify", str(path), "--replay", "1", code=2).err
    assert "can replay certificates" in said
