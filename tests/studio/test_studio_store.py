"""The database of jobs: its schema, its bounds, and what is left of what is over."""

import sqlite3
from pathlib import Path

import pytest

from generator.errors import StorageError
from tabletopgen_web.studio.contracts import JobResult
from tabletopgen_web.studio.folder import StudioFolder
from tabletopgen_web.studio.queue import jobs
from tabletopgen_web.studio.queue.jobs import JobStore

JOB = {"kind": "compose", "text": "a mug", "seed": 3}


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "jobs.sqlite3"


def test_what_was_queued_is_there_again(path: Path) -> None:
    first = JobStore(path)
    done, waiting = first.add(JOB), first.add({**JOB, "seed": 4})
    assert first.take().id == done.id
    first.finish(done.id, "done", result=JobResult("a-mug-000000000000", facts={"x": 1}))
    first.close()
    again = JobStore(path)
    assert again.get(done.id).result == JobResult("a-mug-000000000000", facts={"x": 1})
    assert again.recover() == []
    assert again.take().id == waiting.id and again.take() is None
    assert again.last_event == 6
    assert path.stat().st_mode & 0o777 == 0o600


def test_numbers_of_events_are_never_used_again(path: Path) -> None:
    store = JobStore(path)
    job = store.add(JOB).id
    store.take()
    store.finish(job, "failed", "no mug")
    before = store.last_event
    store.delete(job)
    store.close()
    again = JobStore(path)
    again.add(JOB)
    assert [e.seq for e in again.events(0)] == [before + 1, before + 2]


@pytest.mark.parametrize("version", [0, 2, 99])
def test_another_schema_is_refused(path: Path, version: int) -> None:
    with sqlite3.connect(path) as database:
        database.execute("CREATE TABLE other (x)")
        database.execute(f"PRAGMA user_version = {version}")
    database.close()
    with pytest.raises(StorageError, match=f"schema {version}"):
        JobStore(path)


@pytest.mark.parametrize("content", [b"no database " * 500, b"SQLite format 3\0" + b"\xff" * 4000])
def test_a_damaged_file_is_left_as_it_is(path: Path, content: bytes) -> None:
    path.write_bytes(content)
    with pytest.raises(StorageError, match="damaged"):
        JobStore(path)
    assert path.read_bytes() == content


def test_a_link_is_not_followed(path: Path, tmp_path: Path) -> None:
    path.symlink_to(tmp_path / "elsewhere")
    with pytest.raises(StorageError, match="regular"):
        JobStore(path)
    assert not (tmp_path / "elsewhere").exists()


def test_old_jobs_and_removals_make_way(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jobs, "_MAX_JOBS", 5)
    monkeypatch.setattr(jobs, "_MAX_DELETED", 3)
    store = JobStore(path)
    for _ in range(20):
        job = store.add(JOB).id
        store.take()
        store.finish(job, "done")
    assert len(store.list_jobs()) == 5
    told = store.events(0, 1000)
    assert sum(e.data.get("state") == "deleted" for e in told) == 3
    assert {e.job for e in told} >= {row.id for row in store.list_jobs()}


def test_a_folder_is_one_studios(tmp_path: Path) -> None:
    folder = StudioFolder(tmp_path / "studio")
    with folder.locking():
        folder.announce("http://127.0.0.1:8123/")
        with pytest.raises(StorageError, match=r"at http://127\.0\.0\.1:8123/.*--folder"), \
                folder.locking():  # fmt: skip
            pass
    with folder.locking():
        pass
    (tmp_path / "file").write_text("")
    with pytest.raises(StorageError, match="--folder"), StudioFolder(tmp_path / "file").locking():
        pass
    assert folder.root.stat().st_mode & 0o077 == 0
