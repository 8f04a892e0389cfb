"""Removing by name: what is not a plain name inside the folder stays."""

from pathlib import Path

import pytest

from generator.errors import StorageError
from generator.io.files import is_plain_name, remove_file, remove_tree

PATHS = ["", ".", "..", "../kept", "own/../../kept", "a/b", "a\\b", "a\0b", "x" * 256, "\ud800", 5]


@pytest.mark.parametrize("name", PATHS, ids=repr)
@pytest.mark.parametrize("remove", [remove_tree, remove_file])
def test_only_plain_names_are_removed(tmp_path: Path, remove, name):
    for folder in ("own", "kept"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "file").write_text("x")
    assert not is_plain_name(name)
    for given in (name, str(tmp_path / "kept")):
        with pytest.raises(StorageError, match="must be the name of an entry"):
            remove(tmp_path / "own", given)
    assert (tmp_path / "own/file").exists() and (tmp_path / "kept/file").exists()


def test_a_folder_goes_and_what_it_links_to_stays(tmp_path: Path):
    (tmp_path / "kept").mkdir()
    (tmp_path / "kept/file").write_text("x")
    (tmp_path / "own/gone").mkdir(parents=True)
    (tmp_path / "own/gone/link").symlink_to(tmp_path / "kept")
    (tmp_path / "own/link").symlink_to(tmp_path / "kept")
    remove_tree(tmp_path / "own", "gone")
    remove_tree(tmp_path / "own", "gone")  # there is none now
    with pytest.raises(StorageError, match="cannot be removed"):
        remove_tree(tmp_path / "own", "link")
    remove_file(tmp_path / "own", "link")
    remove_file(tmp_path / "own", "link")
    assert [p.name for p in (tmp_path / "own").iterdir()] == []
    assert (tmp_path / "kept/file").read_text() == "x"


def test_a_file_is_no_tree_and_a_folder_no_file(tmp_path: Path):
    (tmp_path / "file").write_text("x")
    (tmp_path / "folder").mkdir()
    with pytest.raises(StorageError, match="cannot be removed"):
        remove_tree(tmp_path, "file")
    with pytest.raises(StorageError, match="cannot be removed"):
        remove_file(tmp_path, "folder")
    assert (tmp_path / "file").exists() and (tmp_path / "folder").exists()
