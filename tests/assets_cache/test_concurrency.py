"""Concurrent saving, removal and reading of one store: bundles are published or absent."""

import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from extent import count
from toy import toy_object, toy_scene

import assets_cache
from generator import bundle
from generator.bundle import publication
from generator.errors import MissingError
from generator.scene import Scene

ROOT = Path(__file__).parents[2]


@pytest.fixture
def scene() -> Scene:
    return toy_scene((toy_object("cube_1", (0.05,) * 3, (0.0, 0.0)),), name="toy")


def put(scene: Scene, folder: Path) -> Path:
    return bundle.save(scene, folder, allow_failed=True)


READERS = {
    "load": bundle.load,
    "check": bundle.check,
    "load_fingerprint": bundle.load_fingerprint,
    "load_digest": bundle.load_digest,
    "load_kinds": bundle.load_kinds,
    "load_report": bundle.load_report,
    "load_pictures": bundle.load_pictures,
}


@pytest.mark.parametrize("read", READERS.values(), ids=READERS)
def test_what_is_removed_while_it_is_read_is_missing_and_not_damaged(
    scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, read
) -> None:
    path, real = put(scene, tmp_path), bundle.folder.read_inside

    def read_inside(folder: Path, name: str, limit: int) -> bytes:
        publication.discard(path)
        return real(folder, name, limit)

    monkeypatch.setattr("generator.bundle.folder.read_inside", read_inside)
    with pytest.raises(MissingError, match="There is no bundle at"):
        read(path)


def test_what_is_removed_and_saved_again_while_it_is_read_is_whole(
    scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, real, raced = put(scene, tmp_path), bundle.folder.read_inside, []

    def read_inside(folder: Path, name: str, limit: int) -> bytes:
        if raced or name != "scene.xml":
            return real(folder, name, limit)
        raced.append(publication.discard(path))
        try:
            return real(folder, name, limit)
        finally:
            put(scene, tmp_path)

    monkeypatch.setattr("generator.bundle.folder.read_inside", read_inside)
    assert bundle.load(path).name == "toy"
    assert raced == [True]


def test_a_damaged_bundle_is_still_damaged(
    scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("assets_cache.store._SHIPPED", ())
    path = put(scene, tmp_path)
    (path / "scene.xml").unlink()
    assert "scene.xml is missing" in bundle.verify(path)[0]
    assert "scene.xml is missing" in assets_cache.verify(tmp_path)[path.name][0]


def test_a_save_outlives_removals_between_any_two_of_its_steps(
    scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = Path.replace
    tries = []

    def replace(self: Path, target: Path) -> Path:
        """Simulate a faster saver, and a remover before this process checks again."""
        tries.append(target)
        if len(tries) > 3:
            return real(self, target)
        shutil.copytree(self, target)
        try:
            return real(self, target)
        finally:
            shutil.rmtree(target)

    monkeypatch.setattr(Path, "replace", replace)
    path = put(scene, tmp_path)
    assert len(tries) == 4
    assert bundle.verify(path) == []
    assert [p.name for p in tmp_path.iterdir()] == [path.name]


@pytest.mark.parametrize("damage", ["missing", "changed", "unlisted", "link", "file", "dangling"])
def test_what_is_damaged_makes_way_and_what_is_linked_stays(
    scene: Scene, tmp_path: Path, damage: str
) -> None:
    store, elsewhere = tmp_path / "store", tmp_path / "elsewhere"
    elsewhere.mkdir()
    (elsewhere / "file").write_text("precious")
    path = put(scene, store)
    if damage in ("missing", "link"):
        (path / "scene.xml").unlink()
    if damage == "changed":
        (path / "scene.xml").write_text("x" * (path / "scene.xml").stat().st_size)
    elif damage == "unlisted":
        (path / "more").symlink_to(elsewhere)
    elif damage == "link":
        (path / "scene.xml").symlink_to(elsewhere / "file")
    elif damage != "missing":
        shutil.rmtree(path)
        path.write_text("x") if damage == "file" else path.symlink_to(tmp_path / "nowhere")
    assert put(scene, store) == path
    assert bundle.verify(path) == []
    assert [p.name for p in store.iterdir()] == [path.name]
    assert (elsewhere / "file").read_text() == "precious"


def test_what_is_whole_stays_with_its_certificate(scene: Scene, tmp_path: Path) -> None:
    path = put(scene, tmp_path)
    (path / "certificate.json").write_text("{}")
    before = path.stat()
    assert put(scene, tmp_path) == path
    assert os.path.samestat(before, path.stat())
    assert (path / "certificate.json").exists()


def test_who_removes_second_is_told_that_it_is_gone(scene: Scene, tmp_path: Path) -> None:
    path = put(scene, tmp_path)
    assert publication.discard(path)
    assert not publication.discard(path)
    with pytest.raises(MissingError):
        assets_cache.remove(path, tmp_path)
    assert list(tmp_path.iterdir()) == []


DIES = """
import sys, time
from pathlib import Path
from generator.bundle.publication import staging_in
with staging_in(Path(sys.argv[1])) as staging:
    (staging / "half").write_text("x")
    print(staging.parent.name, flush=True)
    time.sleep(60)
"""


@pytest.mark.slow
def test_what_a_killed_saver_leaves_is_removed_and_what_a_live_one_needs_is_not(
    scene: Scene, tmp_path: Path
) -> None:
    command = [sys.executable, "-c", DIES, str(tmp_path)]
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=env) as other:
        try:
            assert other.stdout is not None
            staging = tmp_path / other.stdout.readline().strip()
            hour_ago = time.time() - 3600
            os.utime(staging, (hour_ago, hour_ago))
            put(scene, tmp_path)
            assert (staging / "new" / "half").exists(), "its maker is alive"
        finally:
            other.send_signal(signal.SIGKILL)
    os.utime(staging, None)
    assert assets_cache.clear(tmp_path) == 1
    assert staging.exists(), "it is new: its maker may be about to lock it"
    os.utime(staging, (hour_ago, hour_ago))
    assert assets_cache.clear(tmp_path) == 0
    assert list(tmp_path.iterdir()) == []


def test_only_staging_folders_are_swept(tmp_path: Path) -> None:
    kept = tmp_path / "kept"
    kept.mkdir()
    (kept / "file").write_text("x")
    hour_ago = time.time() - 3600
    (tmp_path / ".staging-abcdefgh").symlink_to(kept)
    (tmp_path / ".staging-notes").mkdir()
    (tmp_path / ".staging-abcd1234").write_text("a file")
    (tmp_path / ".staging-abcd_123").mkdir()
    (tmp_path / ".staging-releases").mkdir()  # another program's, with a name like ours
    (tmp_path / ".staging-releases" / "file").write_text("x")
    (tmp_path / ".staging-left_123" / "new").mkdir(parents=True)
    (tmp_path / ".staging-left_123" / ".tabletopgen-staging").touch()
    for path in tmp_path.iterdir():
        os.utime(path, (hour_ago, hour_ago), follow_symlinks=False)
    os.utime(kept, (hour_ago, hour_ago))
    publication.sweep(tmp_path)
    publication.sweep(tmp_path / "nowhere")
    names = {p.name for p in tmp_path.iterdir()}
    assert names == {
        "kept", ".staging-abcdefgh", ".staging-notes", ".staging-abcd1234", ".staging-releases",
    }  # fmt: skip
    assert (tmp_path / ".staging-releases" / "file").exists()
    assert (kept / "file").exists()


@pytest.mark.slow
def test_savers_removers_and_readers_at_once(tmp_path: Path) -> None:
    seconds = os.environ.get("TABLETOPGEN_TEST_RACE", str(count(6, 3)))
    script = ROOT / "benchmarks" / "concurrency.py"
    done = subprocess.run(
        [sys.executable, script, "--seconds", seconds, "--out", tmp_path],
        capture_output=True, text=True, timeout=240 + 2 * float(seconds),
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    assert "Broken: 0." in (tmp_path / "concurrency.md").read_text()
