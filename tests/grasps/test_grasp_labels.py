"""Grasp labels: positions, trial results, and the file in the bundle."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from command import Shell
from toy import toy_object, toy_scene

import assets_cache
from generator.bundle import load_fingerprint, save, verify
from generator.errors import BundleError, InputError
from generator.geometry import quaternion_matrix
from generator.scene import Object, Pose
from tabletopgen_env.grasps import (
    GraspLabels,
    GraspTerms,
    label_bundle,
    read_grasps,
    sample_grasps,
    sampling,
)
from tabletopgen_env.grasps.labels import FILE, GraspFile, write_file
from tabletopgen_env.robot import franka

SIZE = (0.05, 0.03, 0.04)
FEW = GraspTerms(count=4, trials=2, directions=0)


@pytest.fixture(scope="module")
def box() -> Object:
    return toy_object("box_1", SIZE, (0.0, 0.0), mass=0.2)


@pytest.fixture(scope="module")
def sampled(box: Object) -> GraspLabels:
    return sample_grasps(box, FEW)


@pytest.fixture
def labels() -> GraspLabels:
    """Two grasps made by hand: from above, across the box's sides."""
    half = float(np.sqrt(0.5))
    hands = np.array([[0.0, 1.0, 0.0, 0.0], [0.0, half, half, 0.0]])
    places = np.array([[0.0, 0.0, 0.01], [0.0, 0.002, 0.01]])
    return GraspLabels(
        places, hands, np.array([0.03, 0.05]), np.array([0.05, 0.07]), np.array([1.0, 0.5]),
        np.ones(2),
    )  # fmt: skip


@pytest.fixture
def made(box: Object, tmp_path: Path) -> Path:
    """A bundle with a box that the fingers can hold and a cube that is too wide."""
    wide = toy_object("cube_1", (0.085, 0.085, 0.085), (0.3, 0.0))
    return save(toy_scene((box, wide)), tmp_path / "bundles", allow_failed=True)


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


@pytest.mark.slow
def test_a_box_is_held_across_its_sides(sampled: GraspLabels) -> None:
    assert 1 <= len(sampled) <= FEW.count
    for k in range(len(sampled)):
        hand = quaternion_matrix(sampled.quaternion[k])
        across = np.abs(hand[:, 1])
        assert across.max() > 0.99, "fingers close along an axis of the box"
        assert sampled.width[k] == pytest.approx(SIZE[int(across.argmax())], abs=0.004)
        assert sampled.width[k] < sampled.opening[k] <= 2 * franka.FINGER_STROKE
        assert (np.abs(sampled.position[k]) <= np.array(SIZE) / 2 + 0.01).all()
        outside = sampled.position[k] - 0.1 * hand[:, 2]
        assert (np.abs(outside) > np.array(SIZE) / 2).any(), "the hand comes from outside"
    assert (np.diff(sampled.quality) <= 0).all()
    assert sampled.quality.max() == 1.0
    assert (sampled.lifted >= sampled.quality).all()


@pytest.mark.slow
def test_what_is_too_heavy_or_too_wide_is_not_held() -> None:
    lead = toy_object("lead_1", SIZE, (0.0, 0.0), mass=60.0)
    assert sample_grasps(lead, GraspTerms(2, 2, 0)).quality.max() == 0
    wide = toy_object("cube_1", (0.085, 0.085, 0.085), (0.0, 0.0))
    found = sample_grasps(wide, FEW)
    assert len(found) == 0 and found.position.shape == (0, 3)


def test_labels_go_where_the_object_is(labels: GraspLabels) -> None:
    half = np.sqrt(0.5)
    pose = Pose(np.array([1.0, 2.0, 3.0]), np.array([half, 0.0, 0.0, half]))
    position, rotation = labels.poses_at(pose)
    turned = labels.position @ quaternion_matrix(pose.quaternion).T + pose.position
    np.testing.assert_allclose(position, turned)
    np.testing.assert_allclose(np.linalg.det(rotation), 1.0)
    own = quaternion_matrix(labels.quaternion[0])
    np.testing.assert_allclose(rotation[0], quaternion_matrix(pose.quaternion) @ own)


@pytest.mark.slow
def test_the_same_seed_gives_the_same_bytes(made: Path, sampled: GraspLabels) -> None:
    assert read_grasps(made) == {}
    label_bundle(made, FEW)
    first = (made / FILE).read_bytes()
    (made / FILE).unlink()
    label_bundle(made, FEW)
    assert (made / FILE).read_bytes() == first
    found = read_grasps(made)
    assert {name: len(each) > 0 for name, each in found.items()} == {"box_1": True, "cube_1": False}
    np.testing.assert_allclose(found["box_1"].position, sampled.position, atol=1e-6)
    np.testing.assert_array_equal(found["box_1"].quality, sampled.quality)
    assert verify(made) == []


def test_an_interrupted_run_resumes(
    made: Path, monkeypatch: pytest.MonkeyPatch, labels: GraspLabels
) -> None:
    tried: list[str] = []

    def sample(thing: Object, terms: GraspTerms) -> GraspLabels:
        if len(tried) == 1:
            raise KeyboardInterrupt
        tried.append(thing.name)
        return labels

    (made / FILE).unlink(missing_ok=True)
    monkeypatch.setattr(sampling, "sample_grasps", sample)
    with pytest.raises(KeyboardInterrupt):
        label_bundle(made, FEW)
    assert not (made / FILE).exists(), "published whole or not at all"
    told: list[tuple[int, int, str]] = []
    tried[:] = []
    label_bundle(made, FEW, report=lambda *news: told.append(news))
    assert tried == ["cube_1"] and told == [(1, 2, ""), (2, 2, "cube_1")]
    assert {*read_grasps(made)} == {"box_1", "cube_1"}


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda d: d.update(schema=9), "schema is 9"),
        (lambda d: d.update(scene="0" * 64), "another scene"),
        (lambda d: d["objects"]["box_1"]["quality"].append(0.5), "shape"),
        (lambda d: d["objects"]["box_1"]["quality"].__setitem__(0, 1.5), "must be in"),
        (lambda d: d["objects"]["box_1"].update(extra=[]), "columns"),
        (lambda d: d["objects"]["box_1"]["quaternion"].__setitem__(0, [1, 1, 0, 0]), "length 1"),
        (lambda d: d["objects"]["box_1"]["position"].__setitem__(0, [0, "x", 0]), "a valid number"),
        (lambda d: d["objects"]["box_1"]["width"].__setitem__(0, 10**400), "a valid number"),
        (lambda d: d["terms"].update(count=0), "count"),
    ],
)
def test_damaged_labels_are_refused(change, said: str, made: Path, labels: GraspLabels) -> None:
    write_file(made, GraspFile(load_fingerprint(made), FEW, {"mujoco": "3"}, {"box_1": labels}))
    assert len(read_grasps(made)["box_1"]) == len(labels)
    file = made / FILE
    payload = json.loads(file.read_text())
    change(payload)
    file.write_text(json.dumps(payload))
    with pytest.raises(BundleError, match=said):
        read_grasps(made)
    assert not sampling.is_labelled(made, FEW)
    file.unlink()


def test_labels_that_are_a_link_or_no_json_are_refused(made: Path, tmp_path: Path) -> None:
    file = made / FILE
    file.unlink(missing_ok=True)
    file.symlink_to(tmp_path / "elsewhere")
    with pytest.raises(BundleError, match="link"):
        read_grasps(made)
    file.unlink()
    file.write_text("[NaN]")
    with pytest.raises(BundleError, match="no valid labels"):
        read_grasps(made)
    file.unlink()


@pytest.mark.parametrize("settings", [{"count": 0}, {"trials": 2.5}, {"seed": -1}])
def test_terms_out_of_range_are_refused(settings: dict) -> None:
    with pytest.raises(InputError):
        GraspTerms(**settings)


def test_shipped_bundles_are_not_written_to(
    made: Path, store: Path, monkeypatch: pytest.MonkeyPatch, labels: GraspLabels, shell: Shell
) -> None:
    monkeypatch.setattr(sampling, "sample_grasps", lambda thing, terms: labels)
    (made / FILE).unlink(missing_ok=True)
    (shipped,) = assets_cache.find("coffee-square")
    said = shell("grasps", str(made), "coffee-square", code=2).err
    assert "ships with the package" in said and "Copy its folder" in said
    assert not (made / FILE).exists(), "nothing is labelled before it is refused"
    with pytest.raises(InputError, match="ships with the package"):
        label_bundle(shipped, FEW)
    assert not (shipped / FILE).exists()
    copy = shutil.copytree(shipped, store / shipped.name)
    said = shell("grasps", str(copy), str(made)).out.splitlines()
    assert {str(copy / FILE), str(made / FILE)} <= {*said}
    assert read_grasps(copy)


@pytest.mark.slow
def test_workers_and_the_command(made: Path, tmp_path: Path, shell: Shell) -> None:
    (made / FILE).unlink(missing_ok=True)
    picture = tmp_path / "labels.png"
    words = ("grasps", str(made), "--count", "4", "--trials", "2", "--directions", "0")
    said = shell(*words, "--workers", "2", "--picture", str(picture)).out
    assert "box_1: 4 grasps" in said and "cube_1: 0 grasps" in said
    assert picture.read_bytes().startswith(b"\x89PNG")
    two = (made / FILE).read_bytes()
    assert "1 of 1 bundles are already labelled" in shell(*words).out
    shell(*words, "--again")
    assert (made / FILE).read_bytes() == two
    shell("grasps", "no-such-bundle", code=4)
