"""The instances a bundle keeps: flattened, written, verified, read back."""

from pathlib import Path

import numpy as np
import pytest
from toy import toy_scene

from generator import bundle
from generator.bundle.segments import PATH, Segments, decode_segments, encode_segments
from generator.errors import BundleError, InputError
from generator.physics.gate import judge
from generator.scene import Instance


def instance(name: str, rows: slice, columns: slice) -> Instance:
    mask = np.zeros((6, 8), bool)
    mask[rows, columns] = True
    box = np.array([columns.start, rows.start, columns.stop, rows.stop], float)
    return Instance(name, name.split("_")[0], box, mask, np.zeros((2, 2, 4), np.uint8), box)


@pytest.fixture
def segments() -> Segments:
    return Segments.of(
        (
            instance("apple_1", slice(1, 2), slice(1, 2)),
            instance("plate_1", slice(1, 4), slice(1, 5)),
            instance("table", slice(0, 5), slice(0, 8)),
        )
    )


def test_the_table_is_behind_and_the_smallest_in_front(segments: Segments) -> None:
    assert segments.names == ("table", "apple_1", "plate_1")
    assert segments.labels == ("table", "apple", "plate")
    assert segments.mask("apple_1").sum() == 1
    assert segments.mask("plate_1").sum() == 11
    assert segments.mask("table").sum() == 40 - 12
    assert not segments.mask("pear_1").any()


def test_what_is_written_is_read_back(segments: Segments) -> None:
    entries, raw = encode_segments(segments)
    again = decode_segments(entries, raw)
    assert (again.names, again.labels) == (segments.names, segments.labels)
    assert np.array_equal(again.index, segments.index)
    assert encode_segments(segments)[1] == raw


def test_more_colours_than_names_are_refused(segments: Segments) -> None:
    entries, raw = encode_segments(segments)
    with pytest.raises(BundleError, match="does not match"):
        decode_segments(entries[:2], raw)
    with pytest.raises(BundleError, match="must be a string"):
        decode_segments([{"name": 3, "label": "x"}], raw)
    with pytest.raises(BundleError, match="PNG"):
        decode_segments(entries, raw[:40])


def test_instances_are_counted() -> None:
    with pytest.raises(InputError, match="1 to 255"):
        Segments.of(())


@pytest.mark.slow
def test_a_bundle_keeps_and_verifies_them(segments: Segments, tmp_path: Path) -> None:
    scene = toy_scene()
    scene = scene.replace(report=judge(scene))
    picture = np.full((6, 8, 3), 90, np.uint8)
    path = bundle.save(scene, tmp_path, images={"reference": picture}, segments=segments)
    assert bundle.verify(path) == []
    kept = bundle.load_segments(path)
    assert kept is not None
    assert np.array_equal(kept.index, segments.index)
    shown = bundle.load_picture(path, "reference")
    assert shown is not None
    assert np.array_equal(shown, picture)
    assert bundle.load_picture(path, "preview") is None
    content = bytearray((path / PATH).read_bytes())
    content[-20] ^= 1
    (path / PATH).write_bytes(bytes(content))
    assert "was changed" in bundle.verify(path)[0]
    with pytest.raises(BundleError, match="was changed"):
        bundle.load_segments(path)


@pytest.mark.slow
def test_a_bundle_without_them_says_so(tmp_path: Path) -> None:
    scene = toy_scene()
    path = bundle.save(scene.replace(report=judge(scene)), tmp_path)
    assert bundle.load_segments(path) is None
