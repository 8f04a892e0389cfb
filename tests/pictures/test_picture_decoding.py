"""Pictures are decoded in a child process with limits; every failure is one error."""

import contextlib
import io
import random
import resource
import threading

import numpy as np
import pytest
from hostile_pictures import (
    animated,
    encoded,
    mutated_tiff,
    noise,
    overlapping_exif,
    png_chunk,
    repeated_scans,
)
from PIL import Image

from generator.backends.cloud.drawing.pictures import decode_answer
from generator.errors import BundleError, InputError, UnusableError
from generator.method.reference import read_image
from generator.pictures import PictureLimits, decode, decode_png

LIMITS = PictureLimits()


def tagged_tiff() -> bytes:
    """A TIFF with texts, fractions and an orientation among its tags."""
    exif = Image.Exif()
    exif[0x0112], exif[0x010F], exif[0x0132], exif[0x011A] = 6, "maker", "2020", 72.0
    return encoded(noise(64, 64), "TIFF", exif=exif)


def cpu_seconds() -> float:
    used = [resource.getrusage(w) for w in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(u.ru_utime + u.ru_stime for u in used)


@pytest.mark.slow
def test_a_child_returns_what_this_process_would(monkeypatch: pytest.MonkeyPatch) -> None:
    raw = encoded(noise(300, 200), "PNG")
    apart = decode(raw, "The picture", InputError, LIMITS, "rgb", 100)
    monkeypatch.setattr("generator.sandbox.runner.is_inside", lambda: True)
    here = decode(raw, "The picture", InputError, LIMITS, "rgb", 100)
    np.testing.assert_array_equal(apart.pixels, here.pixels)
    assert (apart.width, apart.height, apart.mode) == (here.width, here.height, here.mode)
    assert not apart.pixels.flags.writeable


@pytest.mark.usefixtures("inline")
@pytest.mark.parametrize("mode", ["RGB", "L", "P", "RGBA", "1", "CMYK", "I;16"])
@pytest.mark.parametrize("kind", ["PNG", "JPEG", "WEBP", "BMP", "TIFF", "GIF", "TGA"])
def test_pixels_are_pillow_s(kind: str, mode: str) -> None:
    picture = noise(130, 70).convert("I" if mode == "I;16" else mode).convert(mode)
    try:
        raw = encoded(picture, kind)
    except (OSError, ValueError):
        pytest.skip(f"Pillow writes no {kind} of mode {mode}")
    limits = PictureLimits(formats=(*LIMITS.formats, "TGA"))
    found = decode(raw, "The picture", InputError, limits, "rgba").pixels
    with Image.open(io.BytesIO(raw)) as opened:
        np.testing.assert_array_equal(found, np.asarray(opened.convert("RGBA")))


@pytest.mark.usefixtures("inline")
def test_the_first_frame_of_an_animation_is_read() -> None:
    for kind in ("GIF", "PNG", "TIFF"):
        np.testing.assert_array_equal(
            read_image(animated(kind, 3)), read_image(animated(kind, 1)), err_msg=kind
        )


def test_scans_by_the_thousand_take_no_time() -> None:
    raw, began = repeated_scans(20_000, 640, 480), cpu_seconds()
    for read, error in ((read_image, InputError), (decode_answer, UnusableError)):
        with pytest.raises(error, match="scans"):
            read(raw)
    assert cpu_seconds() - began < 2


@pytest.mark.slow
def test_a_child_over_its_time_is_one_error() -> None:
    raw = repeated_scans(15_000, 640, 480)
    limits = PictureLimits(cpu_seconds=0.5, max_scans=10**6)
    with pytest.raises(UnusableError, match=r"^the picture takes more than 0.5 s of CPU time\.$"):
        decode(raw, "the picture", UnusableError, limits, "rgba")


@pytest.mark.slow
def test_a_child_over_its_memory_is_one_error() -> None:
    raw = encoded(Image.new("RGB", (4900, 4900)), "PNG")
    with pytest.raises(UnusableError, match=r"^the picture takes more than 0.0625 GiB of memory"):
        decode(raw, "the picture", UnusableError, PictureLimits(memory=2**26), "rgba")


@pytest.mark.slow
def test_tags_that_share_their_bytes_stay_within_limits() -> None:
    began = cpu_seconds()
    with contextlib.suppress(InputError):
        read_image(overlapping_exif(60_000, 30_000_000))
    assert cpu_seconds() - began < 15


@pytest.mark.slow
def test_a_cancelled_decode_is_an_error() -> None:
    cancelled = threading.Event()
    cancelled.set()
    with pytest.raises(InputError, match="was cancelled"):
        read_image(encoded(noise(200, 200), "JPEG"), cancelled=cancelled)


@pytest.mark.slow
def test_tags_of_other_types_and_counts_are_one_error() -> None:
    """In a child each, as for users: Pillow raises TypeError and OverflowError for these."""
    rng, sound = random.Random(11), tagged_tiff()
    for _ in range(8):
        try:
            read_image(mutated_tiff(rng, sound))
        except InputError as error:
            assert "picture" in str(error)


@pytest.mark.usefixtures("inline")
def test_tags_of_every_type_and_count_are_one_error() -> None:
    rng, sound = random.Random(7), tagged_tiff()
    refused, causes = 0, set()
    for _ in range(600):
        try:
            read_image(mutated_tiff(rng, sound))
        except InputError as error:
            refused += 1
            causes.add(type(error.__cause__.__cause__ if error.__cause__ else None))
    assert 100 < refused < 600
    assert causes & {TypeError, OverflowError}, "they no longer reach what Pillow trips over"


def test_pngs_of_bundles_are_decoded_here() -> None:
    limits = PictureLimits(formats=("PNG",))
    raw = encoded(noise(64, 64), "PNG")
    found = decode_png(raw, "x.png", BundleError, limits, "rgb")
    np.testing.assert_array_equal(found.pixels, np.asarray(noise(64, 64)))
    tiny = raw[:-12] + png_chunk(b"tEXt", b"") * 500_000 + raw[-12:]
    began = cpu_seconds()
    bitmap = encoded(noise(9, 9), "BMP")
    for bad, said in ((tiny, "chunks"), (raw[:-40], "damaged"), (bitmap, "PNG")):
        with pytest.raises(BundleError, match=f"x.png.*{said}"):
            decode_png(bad, "x.png", BundleError, limits, "rgb")
    assert cpu_seconds() - began < 2
