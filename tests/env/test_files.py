"""Files are written atomically, and JSON is validated value by value."""

from pathlib import Path

import pytest

from generator.errors import StorageError
from generator.io.files import write_whole
from tabletopgen_env.files import check_type


def test_what_cannot_be_written_leaves_the_old_file_and_no_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "{a}.txt"
    write_whole(path, "old ü", "The text", "")
    assert path.read_bytes() == "old ü".encode() and path.stat().st_mode & 0o777 == 0o644

    def full(self: Path, other: Path) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(StorageError, match=r"The text .*\{a\}.txt: No space left .* Make room"):
        write_whole(path, b"new", "The text", "Make room.")
    assert path.read_bytes() == "old ü".encode() and list(tmp_path.iterdir()) == [path]


def test_values_are_of_exactly_one_type() -> None:
    assert check_type(3, int) == 3
    for value, kind in ((True, int), (3, float), ("a", list), (None, str)):
        with pytest.raises(TypeError, match=f"of type {kind.__name__}"):
            check_type(value, kind)
