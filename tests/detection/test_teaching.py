"""The training data of the detector, and its training."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch
from toy import toy_object, toy_scene

from generator.errors import BundleError
from research.grasps import training
from research.grasps.labels import COLUMNS, GraspLesson, lesson, lessons
from research.grasps.training import batch_of, evaluate, gather, loss_of, read, train
from tabletopgen_env.detection.detector import GraspDetector
from tabletopgen_env.detection.model import GraspNetwork
from tabletopgen_env.detection.network import PLACES, TURNS, Rated
from tabletopgen_env.expert.planning.grasps import plan_grasps
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.scenes import resolve
from tabletopgen_env.world.world import World

BOX = toy_object("box", (0.1, 0.04, 0.06), (0.1, 0.05), yaw=0.5)
PLAIN = np.ones((1, 2), int)


def world() -> World:
    made = World(toy_scene((BOX,)), Panda())
    made.reset()
    return made


def taught(aside: bool = False) -> GraspLesson:
    rng = np.random.default_rng(next(s for s in range(9) if (
        np.random.default_rng(s).random() < 0.5
    ) == aside))  # fmt: skip
    found = lesson(world(), "box", rng)
    assert found is not None
    return found


def test_a_lesson_has_the_planners_grasps() -> None:
    found, best = taught(), plan_grasps(world(), "box")[0]
    assert found.grasps.shape[1] == len(COLUMNS)
    assert (np.diff(found.grasps[:, -1]) <= 0).all(), "the best comes first"
    assert found.grasps[0, -1] == pytest.approx(best.score, abs=1e-4)
    assert best.point == pytest.approx(found.grasps[0, 1:4] + [0.1, 0.05, 0.74], abs=1e-4)


def test_every_other_lesson_is_seen_from_aside() -> None:
    assert taught().facing == pytest.approx(0.5)
    assert 0.5 < taught(aside=True).facing < 0.5 + np.pi / TURNS


def test_what_has_no_grasp_teaches_nothing() -> None:
    wide = World(toy_scene((toy_object("block", (0.1, 0.1, 0.1), (0.0, 0.0)),)), Panda())
    wide.reset()
    assert lesson(wide, "block", np.random.default_rng(0)) is None


def test_a_batch_says_where_the_best_grasps_are() -> None:
    one = taught()
    batch = batch_of([one], PLAIN)
    assert batch.share.sum() == pytest.approx(1.0, abs=1e-5)
    assert batch.possible.sum() > 3
    turn, i, _ = np.unravel_index(int(batch.share[0].argmax()), (TURNS, PLACES, PLACES))
    assert turn == one.grasps[0, 0]
    at = batch.grasp[0, int(batch.share[0].argmax())].numpy()
    angle = one.facing + turn * np.pi / TURNS
    back = at[0] * np.array([np.cos(angle), np.sin(angle)]) + at[1] * np.array(
        [-np.sin(angle), np.cos(angle)]
    )
    np.testing.assert_allclose(back, one.grasps[0, 1:3], atol=1e-4)
    assert abs(at[0] - (i - (PLACES - 1) / 2) * 0.01) <= 0.005 + 1e-6


def test_mirrored_lessons_have_mirrored_grasps() -> None:
    one = taught()
    plain, mirrored = batch_of([one], PLAIN), batch_of([one], np.array([[1, -1]]))
    assert torch.equal(mirrored.seen, plain.seen.flip(4))
    best = plain.grasp[0, int(plain.share.argmax())]
    other = mirrored.grasp[0, int(mirrored.share.argmax())]
    assert torch.allclose(best * torch.tensor([1, -1, 1, 1, 1.0]), other, atol=1e-6)


def test_the_loss_is_least_where_the_answer_is_right() -> None:
    batch = batch_of([taught()], PLAIN)
    rated = GraspNetwork()(batch.seen)
    shape = (1, TURNS, PLACES, PLACES)
    right = Rated(
        batch.share.clamp(min=1e-9).log().reshape(shape),
        (batch.possible * 20 - 10).reshape(shape),
        *(batch.grasp[..., k].reshape(shape) for k in range(5)),
    )
    least = float(loss_of(right, batch))
    assert least < float(loss_of(rated, batch).detach()) / 3
    assert least < float(loss_of(right._replace(width=right.width + 0.01), batch))
    assert least < float(loss_of(right._replace(best=-right.best), batch))


def detector_of(network: GraspNetwork) -> GraspDetector:
    return GraspDetector({k: v.float().numpy() for k, v in network.weights().items()})


@pytest.mark.slow
def test_it_learns_what_it_is_taught() -> None:
    network = train([taught(), taught(aside=True)], steps=240, seed=0, size=2)
    marks = evaluate(detector_of(network), [taught()])
    assert marks.objects == 1 and marks.found == 1.0 and marks.worse < 0.3
    assert evaluate(detector_of(GraspNetwork()), [taught()]).found == 0.0


@pytest.mark.slow
def test_the_same_seed_trains_the_same_network() -> None:
    one, two = (train([taught()], steps=2, seed=3, size=2).state_dict() for _ in range(2))
    assert all(torch.equal(one[key], two[key]) for key in one)


@pytest.mark.slow
def test_lessons_are_kept_and_found_again(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(training, "CHUNK", 2)
    monkeypatch.setattr(training, "split", lambda _, side: resolve("starter"))
    made = gather(tmp_path, "train", 0)
    assert made and not list(tmp_path.glob("*.part"))
    monkeypatch.setattr(training, "lessons", lambda *_: 1 / 0)
    again = gather(tmp_path, "train", 0)
    assert len(again) == len(made)
    assert all(np.array_equal(a.grasps, b.grasps) for a, b in zip(made, again, strict=True))
    assert all(np.array_equal(a.heights, b.heights) for a, b in zip(made, again, strict=True))


@pytest.mark.slow
def test_the_same_seed_gives_the_same_lessons() -> None:
    first, second = ([*lessons(resolve("starter"), 1, 5)] for _ in range(2))
    assert len(first) == 1 and len(first[0]) == len(second[0])
    for one, two in zip(first[0], second[0], strict=True):
        assert np.array_equal(one.grasps, two.grasps)


def test_damaged_lessons_say_so(tmp_path: Path) -> None:
    path = tmp_path / "train-000.npz"
    sound = {
        "heights": np.random.default_rng(0).integers(0, 255, (2, 2, 64, 64), np.uint8),
        "facing": np.zeros(2),
        "grasps": np.zeros((3, 7), np.float32), "counts": np.array([1, 2]),
    }  # fmt: skip
    np.savez_compressed(path, **sound)
    assert [len(one.grasps) for one in read(path)] == [1, 2]
    whole = path.read_bytes()
    for broken in (b"nothing", whole[:300], whole[:-30], whole[:5000] + b"?!?!" + whole[5004:]):
        path.write_bytes(broken)
        with pytest.raises(BundleError, match="Remove it"):
            gather(tmp_path, "train", 0)
    for wrong in (
        {"heights": np.zeros((2, 2, 8, 8), np.uint8)}, {"counts": np.array([4, -1])},
        {"counts": np.array([1, 1])}, {"grasps": np.full((3, 7), np.nan)}, {"facing": ["a", "b"]},
    ):  # fmt: skip
        np.savez(path, **{**sound, **wrong})
        with pytest.raises(BundleError, match="is not a file of lessons"):
            read(path)


def test_a_lessons_look_is_at_the_origin() -> None:
    one = taught()
    assert one.look.floor == 0 and not one.look.center.any()
    assert replace(one, facing=1.0).look.facing == 1.0
