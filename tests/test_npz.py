"""Arrays of files that are not trusted: read whole, or refused before they take room."""

import os
import struct
import zipfile
from pathlib import Path

import numpy as np
import pytest

from generator.errors import InputError
from generator.io.bounded import read_arrays


def read(path: Path, max_bytes: int = 2**16) -> dict[str, np.ndarray]:
    return read_arrays(path, "The file", InputError, max_bytes=max_bytes)


@pytest.mark.parametrize("save", [np.savez, np.savez_compressed])
def test_what_is_written_is_read(tmp_path: Path, save) -> None:
    given = {"a": np.arange(6.0).reshape(2, 3), "b": np.array(["x", "yz"]), "c": np.zeros((0, 2))}
    given["d"] = np.asfortranarray(np.arange(6).reshape(2, 3))
    save(tmp_path / "x.npz", **given)
    found = read(tmp_path / "x.npz")
    assert list(found) == list(given)
    for name, array in given.items():
        np.testing.assert_array_equal(found[name], array)
        assert found[name].dtype == array.dtype


def claiming(path: Path, shape: str, kind: str = "'<f8'") -> Path:
    head = f"{{'descr': {kind}, 'fortran_order': False, 'shape': {shape}, }}".encode()
    head += b" " * (-(len(head) + 11) % 64) + b"\n"
    with zipfile.ZipFile(path, "w") as packed:
        body = b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head + bytes(80)
        packed.writestr("a.npy", body)
    return path


@pytest.mark.parametrize(
    ("shape", "kind"),
    [
        ("(99999999999,)", "'<f8'"), ("(-1,)", "'<f8'"), ("(9,)", "'<f8'"), ("(10,)", "'|O'"),
        ("(1,)", "'<U999999999'"), ("(10,)", "[('a', '<f8', (2**40,))]"), ("x", "'<f8'"),
    ],
)  # fmt: skip
def test_headers_that_lie_are_refused(tmp_path: Path, shape: str, kind: str) -> None:
    with pytest.raises(InputError, match="not a valid npz file"):
        read(claiming(tmp_path / "x.npz", shape, kind))
    assert read(claiming(tmp_path / "y.npz", "(10,)"))["a"].shape == (10,)


@pytest.mark.parametrize("how", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_only_what_numpy_writes_is_unpacked(tmp_path: Path, how: int) -> None:
    np.savez(tmp_path / "x.npz", a=np.arange(6.0))
    with zipfile.ZipFile(tmp_path / "x.npz") as plain:
        body = plain.read("a.npy")
    with zipfile.ZipFile(tmp_path / "y.npz", "w", how) as packed:
        packed.writestr("a.npy", body)
    with pytest.raises(InputError, match="NumPy never writes"):
        read(tmp_path / "y.npz")


def test_small_files_of_large_arrays_are_refused(tmp_path: Path) -> None:
    np.savez_compressed(tmp_path / "x.npz", a=np.zeros(2**20))
    with pytest.raises(InputError, match="limit of 65536 bytes"):
        read(tmp_path / "x.npz")


def test_what_is_no_file_of_arrays_is_refused(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "text").write_text("x")
    for name in ("pipe", "text", "none", "."):
        with pytest.raises(InputError):
            read(tmp_path / name)
