"""A picture with a depth map: validation and scaling."""

import io

import numpy as np
import pytest
from PIL import Image

from generator.errors import InputError
from generator.io.pictures import encode_png
from generator.method.reference import ReferenceConfig, refer
from generator.scene import Intrinsics, Reference

CAMERA = Intrinsics(120.0, 121.0, 60.0, 44.0)
PICTURE = np.full((90, 120, 3), 128, np.uint8)
DEPTH = np.full((90, 120), 0.8, np.float32)


def taken(depth=DEPTH, intrinsics=CAMERA, source=PICTURE, config=None) -> Reference:
    nobody = None
    return refer(source, nobody, nobody, 0, config, depth=depth, intrinsics=intrinsics)  # type: ignore[arg-type]


def test_metres_millimetres_and_a_file_mean_the_same(tmp_path):
    millimetres = np.full((90, 120), 800, np.uint16)
    path = tmp_path / "depth.png"
    path.write_bytes(encode_png(millimetres))
    for depth in (DEPTH, DEPTH.astype(float), millimetres, path, str(path), path.read_bytes()):
        reference = taken(depth)
        assert reference.depth is not None and reference.intrinsics == CAMERA
        np.testing.assert_allclose(reference.depth, 0.8, atol=1e-6)


def test_nan_and_infinity_are_unknown():
    depth = DEPTH.copy()
    depth[0, 0], depth[0, 1] = np.nan, np.inf
    shown = taken(depth).depth
    assert shown is not None and shown[0, 0] == 0 == shown[0, 1] and shown[0, 2] > 0


def test_depth_and_intrinsics_shrink_with_the_picture():
    depth = np.where(np.arange(120) < 60, 0.5, 1.5).astype(np.float32) * np.ones((90, 1))
    small = taken(depth, config=ReferenceConfig(work_side=60))
    assert small.image.shape == (45, 60, 3)
    assert small.depth is not None and small.intrinsics is not None
    assert set(np.unique(small.depth)) == {0.5, 1.5}  # nothing in between is invented
    camera = small.intrinsics
    assert (camera.fx, camera.fy) == (60.0, 60.5)
    assert camera.cx + 0.5 == (CAMERA.cx + 0.5) / 2 and camera.cy + 0.5 == (CAMERA.cy + 0.5) / 2


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"intrinsics": None}, "needs its intrinsics"),
        ({"depth": None}, "needs its depth map"),
        ({"source": "a mug on a desk"}, "can only be given with a picture"),
        ({"depth": DEPTH[:80]}, "aligned with the picture"),
        ({"depth": np.zeros_like(DEPTH)}, "Only 0%"),
        ({"depth": -DEPTH}, "negative"),
        ({"depth": 1000 * DEPTH}, "metres"),
        ({"depth": np.ones((90, 120), np.int64)}, "int64"),
        ({"depth": encode_png(PICTURE)}, "16-bit grey PNG"),
        ({"depth": b"nonsense"}, "The depth map cannot be read"),
        ({"depth": "missing.png"}, "missing.png"),
        ({"intrinsics": Intrinsics(120, 240, 60, 45)}, "square"),
        ({"intrinsics": Intrinsics(120, 120, 400, 45)}, "outside"),
        ({"intrinsics": Intrinsics(1, 1, 60, 45)}, "focal length"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_refused(changes, message):
    with pytest.raises(InputError, match=message):
        taken(**changes)


def test_a_picture_stored_turned_is_refused():
    exif = Image.Exif()
    exif[0x0112] = 6
    buffer = io.BytesIO()
    Image.fromarray(PICTURE).save(buffer, "JPEG", exif=exif)
    with pytest.raises(InputError, match="EXIF"):
        taken(source=buffer.getvalue())


@pytest.mark.parametrize("numbers", [(0, 1, 2, 3), (1, -1, 2, 3), (1, 1, np.nan, 3)])
def test_intrinsics_are_finite_and_positive(numbers):
    with pytest.raises(InputError, match="Intrinsics"):
        Intrinsics(*numbers)


def test_a_reference_holds_both_or_neither():
    with pytest.raises(InputError, match="both depth and intrinsics, or neither"):
        Reference(PICTURE, depth=DEPTH)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [(["--intrinsics", "1,2,3"], "four numbers"), (["--intrinsics", "120,120,60,45"], "depth map")],
)
def test_the_command_line_says_what_is_wrong(tmp_path, shell, arguments, message):
    path = tmp_path / "table.png"
    path.write_bytes(encode_png(PICTURE))
    assert message in shell("generate", str(path), *arguments, code=2).err
