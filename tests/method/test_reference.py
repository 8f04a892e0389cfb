import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from generator.errors import InputError
from generator.method.reference import ReferenceConfig, is_picture_name, read_image, refer
from generator.scene import PlannedTable, ScenePlan


class Artist:
    """Plans and draws without input; only the stage is tested."""

    def plan_scene(self, prompt: str, seed: int) -> ScenePlan:
        return ScenePlan(prompt, PlannedTable(), ())

    def draw(self, plan: ScenePlan, seed: int) -> np.ndarray:
        return np.full((80, 100, 3), seed, np.uint8)


def encode(image: Image.Image, kind: str = "PNG", **options) -> bytes:
    buffer = io.BytesIO()
    image.save(buffer, kind, **options)
    return buffer.getvalue()


def picture(mode: str = "RGB", size: tuple[int, int] = (120, 90)) -> Image.Image:
    return Image.new("RGB", size, (200, 100, 50)).convert(mode)


def test_a_text_becomes_plan_and_drawing() -> None:
    reference = refer("a mug on a desk", Artist(), Artist(), 7)  # type: ignore[arg-type]
    assert reference.prompt == "a mug on a desk"
    assert reference.plan is not None
    assert (reference.image == 7).all()


def test_a_picture_passes_through(tmp_path: Path) -> None:
    path = tmp_path / "desk.png"
    picture().save(path)
    for source in (path, str(path), path.read_bytes(), np.asarray(picture())):
        reference = refer(source, Artist(), Artist(), 0)  # type: ignore[arg-type]
        assert reference.plan is None
        assert np.array_equal(reference.image, np.asarray(picture()))


def test_exif_orientation_is_applied() -> None:
    image = picture()
    exif = image.getexif()
    exif[0x0112] = 6  # turned by 90 degrees
    assert read_image(encode(image, "JPEG", exif=exif)).shape == (120, 90, 3)


def test_alpha_is_flattened_onto_white() -> None:
    clear = Image.new("RGBA", (80, 80), (10, 20, 30, 0))
    assert (read_image(encode(clear)) == 255).all()
    rgba = np.zeros((80, 80, 4), np.uint8)
    assert (read_image(rgba) == 255).all()


@pytest.mark.parametrize(("mode", "kind"), [("L", "PNG"), ("CMYK", "JPEG"), ("P", "PNG")])
def test_other_colour_modes_become_rgb(mode: str, kind: str) -> None:
    image = read_image(encode(picture(mode), kind))
    assert image.shape == (90, 120, 3)
    assert image.dtype == np.uint8


def test_sixteen_bits_keep_their_greys() -> None:
    ramp = np.linspace(0, 65535, 100 * 100).reshape(100, 100).astype(np.uint16)
    image = read_image(encode(Image.fromarray(ramp)))
    np.testing.assert_allclose(image[..., 0], ramp / 257, atol=2)


def test_large_pictures_are_shrunk() -> None:
    assert read_image(encode(picture(size=(2600, 1300)))).shape == (640, 1280, 3)


@pytest.mark.parametrize(
    ("source", "message"),
    [
        (b"", "bytes"),
        (b"not a picture at all", "format is not supported"),
        (encode(picture(size=(400, 400)))[:600], "truncated"),
        (encode(picture(size=(1, 1))), "at least"),
        (encode(picture("L", (6000, 5000))), "megapixels"),
        (np.zeros((90, 90, 3), float), "uint8"),
        (np.zeros((90, 90, 7), np.uint8), "channels"),
        ("nowhere/desk.png", "No picture"),
    ],
)
def test_bad_pictures_get_one_clear_error(source, message: str) -> None:
    with pytest.raises(InputError, match=message):
        read_image(source)


def test_a_file_too_large_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "desk.png"
    picture().save(path)
    with pytest.raises(InputError, match="larger"):
        read_image(path, ReferenceConfig(max_bytes=10))


def test_texts_are_not_taken_for_files() -> None:
    assert not is_picture_name("a desk with a mug")
    assert not is_picture_name("")
    assert is_picture_name("photos/my desk.JPG")
    assert is_picture_name("my desk.HEIC")
