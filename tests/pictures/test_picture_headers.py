"""Headers of pictures agree with Pillow's, and count frames and scans."""

import random
import time
import zlib

import pytest
from hostile_pictures import (
    animated,
    chained_tiff,
    encoded,
    jpeg_segments,
    mutated_gif,
    mutated_jpeg,
    mutated_png,
    mutated_tiff,
    mutated_webp,
    noise,
    png_chunk,
    repeated_scans,
)

from generator.errors import BundleError, InputError
from generator.pictures import Format, PictureHeader, PictureLimits, format_of, read_header

EVERY = PictureLimits(formats=("PNG", "JPEG", "WEBP", "BMP", "TIFF", "GIF", "TGA"))


def header(raw: bytes, limits: PictureLimits = EVERY) -> PictureHeader:
    return read_header(raw, "The picture", InputError, limits)


@pytest.mark.parametrize("kind", EVERY.formats)
@pytest.mark.parametrize("mode", ["RGB", "L", "P", "RGBA", "1", "CMYK", "I;16"])
@pytest.mark.parametrize("size", [(130, 70), (1, 300)])
def test_sizes_are_pillow_s(kind: Format, mode: str, size: tuple[int, int]) -> None:
    try:
        raw = encoded(noise(*size).convert("I" if mode == "I;16" else mode).convert(mode), kind)
    except (OSError, ValueError):
        pytest.skip(f"Pillow writes no {kind} of mode {mode}")
    assert header(raw) == PictureHeader(kind, *size)


@pytest.mark.parametrize(
    ("kind", "options"),
    [
        ("WEBP", {"lossless": True}), ("WEBP", {"exif": b"Exif\0\0II*\0\x08\0\0\0\0\0"}),
        ("TIFF", {"big_tiff": True}), ("JPEG", {"quality": 100, "comment": b"\xff\xda" * 500}),
    ],
)  # fmt: skip
def test_other_writings_have_the_same_header(kind: Format, options: dict) -> None:
    assert header(encoded(noise(130, 70), kind, **options)) == PictureHeader(kind, 130, 70)


@pytest.mark.parametrize("kind", ["GIF", "WEBP", "PNG", "TIFF"])
def test_frames_are_counted(kind: Format) -> None:
    raw = animated(kind, 5)
    assert header(raw).frames == 5
    with pytest.raises(InputError, match="more than 4 frames"):
        header(raw, PictureLimits(max_frames=4))


def test_frames_that_lead_back_to_the_first_end() -> None:
    assert header(chained_tiff(7)).frames == 7


def test_scans_are_counted() -> None:
    plain = encoded(noise(64, 64), "JPEG", progressive=True)
    scans = sum(part[1] == 0xDA for part in jpeg_segments(plain))
    assert header(plain).scans == scans > 5
    assert header(repeated_scans(40)).scans == scans + 39
    with pytest.raises(InputError, match="more than 100 scans"):
        header(repeated_scans(100))


def test_scans_of_a_thumbnail_are_not_the_picture_s() -> None:
    thumbnail = repeated_scans(90)
    exif = b"\xff\xe1" + (len(thumbnail) + 2).to_bytes(2, "big") + thumbnail
    raw = encoded(noise(64, 64), "JPEG")
    assert raw.count(b"\xff\xda") == header(raw[:2] + exif + raw[2:]).scans == 1


@pytest.mark.parametrize("kind", ["PNG", "GIF", "JPEG", "WEBP"])
def test_files_of_tiny_pieces_are_refused(kind: Format) -> None:
    raw = animated(kind, 2) if kind == "WEBP" else encoded(noise(64, 64), kind)
    piece, at = {
        "PNG": (png_chunk(b"tEXt", b""), 33), "GIF": (b"\x21\xfe\1x\0", raw.index(b"\x2c")),
        "JPEG": (b"\xff\xfe\0\2", 2), "WEBP": (b"XMP \0\0\0\0", 12),
    }[kind]  # fmt: skip
    with pytest.raises(InputError, match="more than"):
        header(raw[:at] + piece * 100_000 + raw[at:])


@pytest.mark.parametrize("kind", EVERY.formats)
def test_headers_that_are_cut_off_are_refused_or_read(kind: Format) -> None:
    raw = encoded(noise(130, 70), kind)
    for length in range(len(raw)):
        try:
            found = header(raw[:length])
        except InputError:
            continue
        assert (found.width, found.height) == (130, 70)


@pytest.mark.slow
def test_mutated_headers_end_in_one_error() -> None:
    rng = random.Random(3)
    sound = {kind: encoded(noise(64, 64), kind) for kind in ("TIFF", "JPEG", "PNG")}
    refused = 0
    for _ in range(400):
        raw = rng.choice((
            lambda: mutated_tiff(rng, sound["TIFF"]), lambda: mutated_jpeg(rng, sound["JPEG"]),
            lambda: mutated_png(rng, sound["PNG"]), lambda: mutated_gif(rng),
            lambda: mutated_webp(rng),
        ))()  # fmt: skip
        try:
            header(raw)
        except InputError:
            refused += 1
    assert 40 < refused < 360


def test_the_first_bytes_say_the_format() -> None:
    for kind in EVERY.formats:
        raw = encoded(noise(64, 64), kind)
        assert format_of(raw, EVERY.formats) == kind
        assert format_of(raw, [other for other in EVERY.formats if other != kind]) is None
    for raw in (b"", b"<svg/>", b"%!PS", b"\x89PNG"):
        assert format_of(raw, EVERY.formats) is None


@pytest.mark.parametrize(
    ("brand", "name"), [(b"heic", "HEIC"), (b"mif1", "HEIC"), (b"avif", "AVIF")]
)
def test_common_formats_that_are_not_read_are_named(brand: bytes, name: str) -> None:
    raw = b"\0\0\0\x18ftyp" + brand + b"\0\0\0\0mif1heic" + bytes(200)
    with pytest.raises(InputError, match=rf"{name} is not supported\. Convert it to JPEG or PNG"):
        read_header(raw, "The picture", InputError, PictureLimits())


def test_limits_are_said_with_the_caller_s_error() -> None:
    raw = encoded(noise(130, 70), "PNG")
    for limits, said in (
        (PictureLimits(max_pixels=130 * 70 - 1), "130 x 70 pixels .*at most 9,099 are allowed"),
        (PictureLimits(min_side=71), "each side must be at least 71 pixels"),
        (PictureLimits(max_ratio=1.5), "at most 1.5 times"),
        (PictureLimits(max_bytes=10), "at most 10 are allowed"),
        (PictureLimits(formats=("JPEG", "WEBP")), r"not supported \(use JPEG or WebP\)"),
    ):
        with pytest.raises(BundleError, match=f"^The picture .*{said}"):
            read_header(raw, "The picture", BundleError, limits)


def test_padding_of_a_jpeg_takes_linear_time() -> None:
    raw = b"\xff\xd8" + b"\xff" * 2_000_000 + b"\0"
    before = time.process_time()
    with pytest.raises(InputError):
        header(raw)
    assert time.process_time() - before < 5


def test_scans_behind_many_segments_are_counted_or_refused() -> None:
    plain = encoded(noise(64, 64), "JPEG", progressive=True)
    start = plain.index(b"\xff\xda")
    comments = b"\xff\xfe\0\2" * 30_000
    with pytest.raises(InputError, match=r"segments|scans"):
        header(plain[:start] + comments + plain[start:-2] + plain[start:])


def test_a_png_has_one_colour_profile() -> None:
    plain = encoded(noise(64, 64), "PNG")
    end = plain.index(b"IDAT") - 4
    profile = png_chunk(b"iCCP", b"name\0\0" + zlib.compress(bytes(1000)))
    assert header(plain[:end] + profile + plain[end:]).format == "PNG"
    with pytest.raises(InputError, match="colour profile"):
        header(plain[:end] + 2 * profile + plain[end:])
