"""The bounded readers: what they refuse, with which error, and that they end."""

import json
import os
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from generator.errors import BackendError, BundleError, InputError
from generator.io.bounded import (
    parse_json,
    parse_object,
    parse_toml,
    printable,
    read_regular,
    split_url,
)

TEXTS = st.text(st.characters(exclude_categories=("Cs",)))
VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False)
    | TEXTS,
    lambda inner: st.lists(inner) | st.dictionaries(TEXTS, inner),
    max_leaves=20,
)  # fmt: skip


@pytest.mark.slow
@settings(derandomize=True, deadline=None)
@given(VALUES, st.booleans())
def test_what_json_writes_is_read(value, escaped):
    assert parse_json(json.dumps(value, ensure_ascii=escaped), "It", InputError) == value


@pytest.mark.slow
@settings(derandomize=True, deadline=None, max_examples=300)
@given(st.text() | st.binary())
def test_any_text_is_read_or_refused(raw):
    try:
        raw = raw.encode() if isinstance(raw, str) else raw
    except UnicodeEncodeError:
        return
    try:
        expected = json.loads(raw.decode("utf-8-sig"))
    except ValueError:
        with pytest.raises(InputError, match="It is not valid JSON"):
            parse_json(raw, "It", InputError)
    else:
        if expected == expected and expected not in (float("inf"), -float("inf")):
            assert parse_json(raw, "It", InputError) == expected


@pytest.mark.parametrize(
    "raw",
    [
        b"[" * 10**6,
        b'{"a":' * 10**5 + b"1" + b"}" * 10**5,
        b"[" * 65 + b"]" * 65,
        "[" * 70 + '"]]]]]]]]]]]]"' + "]" * 70,
    ],
    ids=["open", "objects", "one too deep", "brackets in a string"],
)
@pytest.mark.parametrize("error", [BundleError, InputError])
def test_deep_texts_are_refused(raw, error):
    with pytest.raises(error, match=r"^It nests lists or objects deeper than 64 levels"):
        parse_json(raw, "It", error)


def test_texts_of_too_many_values_are_refused():
    with pytest.raises(InputError, match=r"^It exceeds the limit of 4000000 values"):
        parse_json(b"[" + b"[]," * 3_000_000 + b"1]", "It", InputError)


def test_depth_counts_no_brackets_in_strings():
    deep = "[" * 64 + "]" * 64
    assert parse_json(deep, "It", InputError)
    assert parse_json(json.dumps({"a": "[" * 500, "b": '\\"[{' * 99}), "It", InputError)


@pytest.mark.slow
@pytest.mark.parametrize("piece", [b'"', b'\\"', b'"\\', b'["\\"', b"\\"], ids=str)
def test_strings_without_an_end_cost_linear_time(piece):
    with pytest.raises(InputError):
        parse_json(b'"' + piece * (4 * 2**20 // len(piece)) + b"\\", "It", InputError)


@pytest.mark.parametrize(
    "raw",
    ["NaN", "[Infinity]", "-Infinity", "1e999", "[1e400]", '"\\ud800"', '{"\\udfff": 1}', b"\xff",
     b'"\xed\xa0\x80"', '"a"'.encode("utf-16"), "9" * 5000, "", "{", "{'a': 1}"],
    ids=repr,
)  # fmt: skip
def test_no_number_and_no_text_is_refused(raw):
    with pytest.raises(BackendError, match="It is not valid JSON"):
        parse_json(raw, "It", BackendError)


def test_sizes_and_kinds_are_checked():
    with pytest.raises(InputError, match="11 bytes of JSON; the limit is 10"):
        parse_json(b" " * 10 + b"1", "It", InputError, max_bytes=10)
    with pytest.raises(InputError, match="must be a JSON object, not list"):
        parse_object("[]", "It", InputError)


@pytest.mark.parametrize(
    "url",
    ["http://[::1", "https://a℀b/x", "ftp://a/b", "https:///x", "https://a:99999/", "//a/b", "",
     "https://a:0/", "https://a b/", "https://a/\x1b[2J", None, 5, "https://a/" + "b" * 9000,
     "https://a\n/", "http://a:b/"],
    ids=lambda url: repr(url)[:20],
)  # fmt: skip
def test_urls_that_are_none_are_refused(url):
    with pytest.raises(BackendError, match=r"^The link"):
        split_url(url, "The link", BackendError)


def test_urls_are_split():
    parts = split_url("https://[::1]:8443/a?b=c", "The link", BackendError)
    assert (parts.hostname, parts.port, parts.query) == ("::1", 8443, "b=c")


def test_only_regular_files_of_a_size_are_read(tmp_path: Path):
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "file").write_bytes(b"12345")
    (tmp_path / "link").symlink_to("file")
    for name in ("pipe", ".", "/dev/zero", "/dev/null"):
        with pytest.raises(InputError, match="not a regular file"):
            read_regular(tmp_path / name, "It", InputError, max_bytes=10)
    for name in ("none", "a\0b", "x" * 300):
        with pytest.raises(InputError, match="cannot be read"):
            read_regular(str(tmp_path / name), "It", InputError, max_bytes=10)
    with pytest.raises(InputError, match="larger than the limit of 4 bytes"):
        read_regular(tmp_path / "link", "It", InputError, max_bytes=4)
    assert read_regular(tmp_path / "link", "It", InputError, max_bytes=5) == b"12345"


@pytest.mark.parametrize("text", ["\x1b[2J", "a\nb", "a\x00", "\u202eabc", "\ud800", 5, "x" * 201])
def test_names_that_cannot_be_shown_are_refused(text):
    with pytest.raises(BundleError, match=r"^The label"):
        printable(text, "The label", BundleError)
    assert printable("café au lait 3", "The label", BundleError) == "café au lait 3"


def test_toml_is_read():
    raw = b'a.b = [0.1, 0.2]\n[c]\n"d.e" = {f = "x.y", g = [[1]]}\nlong = "' + b"a." * 500 + b'"'
    read = parse_toml(raw, "It", InputError)
    assert read["a"] == {"b": [0.1, 0.2]} and read["c"]["d.e"]["g"] == [[1]]
    assert len(read["c"]["long"]) == 1000
    many = b"x = [" + b"0.1, " * 5000 + b"]"
    assert len(parse_toml(many, "It", InputError)["x"]) == 5000


@pytest.mark.parametrize(
    "raw",
    [
        b"a." * 100_000 + b"b = 1", b"[" + b"a." * 1000 + b"b]", b"a = " + b"[" * 100_000,
        b"a = {" * 500, b"a = 1\na = 2", b"\xff", b'a = "\\ud800"', b'"a" . ' * 90 + b"b = 1",
        b"a" * 2**20,
    ],
    ids=range(9),
)  # fmt: skip
def test_toml_that_is_none_or_too_deep_is_refused(raw):
    with pytest.raises(InputError, match=r"It nests|It is not valid TOML"):
        parse_toml(raw, "It", InputError)


def test_a_file_known_to_be_too_large_is_not_read(tmp_path: Path):
    with (tmp_path / "sparse").open("wb") as file:
        file.truncate(2**40)
    with pytest.raises(InputError, match="larger than the limit of 1048576"):
        read_regular(tmp_path / "sparse", "It", InputError, max_bytes=2**20)
