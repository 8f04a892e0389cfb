"""The response cache: atomic, bounded, shared, and never blocking."""

import hashlib
import os
import subprocess
import sys
import threading
from functools import partial
from pathlib import Path

import pytest
from bounded import LONG, at_once, line_of, running

from generator.calls.store import MOST_ANSWER_BYTES, CallStore, StoredAnswer
from generator.errors import InputError, StorageError

ANSWER = StoredAnswer(200, "application/json", b'{"a": 1}\n\x00\xff')


def key(name: str) -> str:
    return hashlib.sha256(name.encode()).hexdigest()


def files(folder: Path) -> list[Path]:
    return sorted(p for p in (folder / "answers").rglob("*") if p.is_file())


def test_an_answer_comes_back_as_it_was(tmp_path: Path) -> None:
    CallStore(tmp_path / "calls").put(key("q"), ANSWER)
    store = CallStore(tmp_path / "calls")
    assert store.get(key("q")) == ANSWER
    assert store.get(key("other")) is None
    assert len(store) == 1
    store.forget(key("q"))
    assert store.get(key("q")) is None
    store.forget(key("q"))


def test_looking_makes_no_folder(tmp_path: Path) -> None:
    assert CallStore(tmp_path / "calls").get(key("q")) is None
    assert not (tmp_path / "calls").exists()


def test_only_the_owner_may_look(tmp_path: Path) -> None:
    CallStore(tmp_path / "deep" / "calls").put(key("q"), ANSWER)
    assert (tmp_path / "deep" / "calls").stat().st_mode & 0o777 == 0o700
    (kept,) = files(tmp_path / "deep" / "calls")
    assert kept.stat().st_mode & 0o777 == 0o600


@pytest.mark.parametrize("place", ["checksum", "facts", "body", "end", "all"])
def test_a_damaged_answer_is_dropped(tmp_path: Path, place: str) -> None:
    store = CallStore(tmp_path)
    store.put(key("q"), ANSWER)
    (path,) = files(tmp_path)
    raw = bytearray(path.read_bytes())
    spot = {"checksum": 20, "facts": raw.index(b"200"), "body": len(raw) - 3}.get(place)
    if spot is not None:
        raw[spot] ^= 1
    path.write_bytes({"end": raw[:-1], "all": b""}.get(place, bytes(raw)))
    assert store.get(key("q")) is None
    assert files(tmp_path) == []


def test_an_answer_under_another_key_is_none(tmp_path: Path) -> None:
    store = CallStore(tmp_path)
    store.put(key("q"), ANSWER)
    (path,) = files(tmp_path)
    other = tmp_path / "answers" / key("r")[:2] / key("r")
    other.parent.mkdir(exist_ok=True)
    path.rename(other)
    assert store.get(key("r")) is None


def test_what_was_not_asked_for_the_longest_goes_first(tmp_path: Path) -> None:
    store = CallStore(tmp_path, most_bytes=3500)
    for age, name in ((30, "a"), (20, "b"), (10, "c")):
        store.put(key(name), StoredAnswer(200, "", bytes(1000)))
        path = tmp_path / "answers" / key(name)[:2] / key(name)
        os.utime(path, (path.stat().st_mtime - age,) * 2)
    assert store.get(key("a")) is not None  # asked for: now the newest
    store.put(key("d"), StoredAnswer(200, "", bytes(1000)))
    there = [n for n in "abcd" if store.get(key(n)) is not None]
    assert there == ["a", "c", "d"]
    assert store.size() <= 3500


def test_a_store_is_looked_at_only_where_it_may_be_full(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    looks, look = [], CallStore._list_kept
    monkeypatch.setattr(CallStore, "_list_kept", lambda store: looks.append(1) or look(store))
    store = CallStore(tmp_path, most_bytes=1_000_000)
    for k in range(100):
        store.put(key(str(k)), StoredAnswer(200, "", bytes(3_000)))
    assert 8 <= len(looks) <= 12  # some 315,000 bytes, by 31,250 at a time
    assert len(CallStore(tmp_path)) == 100


@pytest.mark.slow
def test_stores_of_several_processes_are_bounded_together(tmp_path: Path) -> None:
    stores = [CallStore(tmp_path, most_bytes=320_000) for _ in range(3)]
    sizes = []
    for k in range(400):
        stores[k % 3].put(key(str(k)), StoredAnswer(200, "", bytes(2_000)))
        sizes.append(stores[0].size())
    assert max(sizes) <= 320_000 + 3 * 10_000
    assert min(sizes[200:]) >= 320_000 - 2 * 10_000 - 3_000  # no more is dropped than has to be
    assert stores[0].get(key("399")) is not None


def test_threads_that_write_at_once_stay_within_bounds(tmp_path: Path) -> None:
    shared, errors = CallStore(tmp_path, most_bytes=64_000), []
    stores = [shared, shared, CallStore(tmp_path, most_bytes=64_000), shared]

    def write(store: CallStore, k: int) -> None:
        try:
            for j in range(40):
                store.put(key(f"{k} {j}"), StoredAnswer(200, "", bytes(1_500)))
        except Exception as error:
            errors.append(error)

    at_once(*(partial(write, s, k) for k, s in enumerate(stores)))
    assert errors == []
    assert 50_000 <= shared.size() <= 64_000 + 2 * 2_000 + 4 * 1_700


def test_an_answer_larger_than_the_store_is_refused(tmp_path: Path) -> None:
    store = CallStore(tmp_path, most_bytes=300)
    with pytest.raises(StorageError, match="most_bytes"):
        store.put(key("q"), StoredAnswer(200, "", bytes(300)))
    store.put(key("r"), ANSWER)
    assert store.get(key("q")) is None and store.get(key("r")) == ANSWER
    with pytest.raises(InputError, match="most_bytes"):
        CallStore(tmp_path, most_bytes=0)


def test_one_answer_is_bounded_in_a_store_of_any_size(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A forged file must not be read into memory, even if the store may be that large."""
    store = CallStore(tmp_path)
    store.put(key("q"), ANSWER)
    (file,) = (tmp_path / "answers").glob("*/*")
    with file.open("r+b") as opened:
        opened.truncate(MOST_ANSWER_BYTES + 1)  # sparse
    refuse = lambda *_, **__: pytest.fail("it was read")  # noqa: E731
    monkeypatch.setattr("generator.io.bounded.open", refuse, raising=False)
    assert store.get(key("q")) is None and not file.exists()
    monkeypatch.setattr("generator.calls.store.MOST_ANSWER_BYTES", 300)
    with pytest.raises(StorageError, match="300 bytes per answer"):
        CallStore(tmp_path).put(key("q"), StoredAnswer(200, "", bytes(300)))


def test_a_disk_that_refuses_is_told_once(tmp_path: Path) -> None:
    (tmp_path / "calls").write_text("a file where the folder should be")
    store = CallStore(tmp_path / "calls")
    with pytest.raises(StorageError, match="cannot be written"):
        store.put(key("q"), ANSWER)
    store.put(key("q"), ANSWER)
    with store.holding(key("q")):
        assert store.get(key("q")) is None


def test_a_full_disk_leaves_nothing_behind(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(number: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    with pytest.raises(StorageError, match="No space left"):
        CallStore(tmp_path).put(key("q"), ANSWER)
    assert files(tmp_path) == []


def test_what_a_killed_writer_left_goes(tmp_path: Path) -> None:
    store = CallStore(tmp_path)
    store.put(key("q"), ANSWER)
    (path,) = files(tmp_path)
    left, running = path.with_name(".partial-old"), path.with_name(".partial-new")
    left.write_bytes(b"half")
    running.write_bytes(b"half")
    os.utime(left, (1, 1))
    assert len(store) == 1
    assert not left.exists() and running.exists()


def test_a_question_is_held_by_one_thread(tmp_path: Path) -> None:
    store, inside, most = CallStore(tmp_path), [], []

    def ask() -> None:
        with store.holding(key("q")):
            inside.append(1)
            most.append(len(inside))
            threading.Event().wait(0.01)
            inside.pop()

    at_once(*[ask] * 4)
    assert most == [1, 1, 1, 1]


HOLD = """
import sys
from generator.calls.store import CallStore
with CallStore(sys.argv[1]).holding(sys.argv[2]):
    print("held", flush=True)
    sys.stdin.read()
"""


@pytest.mark.parametrize("error", [KeyError, StorageError])  # one of them is an OSError
def test_another_process_holds_it_until_it_is_killed(error: type, tmp_path: Path) -> None:
    store = CallStore(tmp_path)

    def give_up() -> None:
        raise error(1, "gives up")

    with running(
        sys.executable, "-c", HOLD, tmp_path, key("q"),
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
    ) as other:  # fmt: skip
        assert line_of(other) == "held\n"
        with pytest.raises(error, match="gives up"), store.holding(key("q"), give_up):
            raise AssertionError
        other.kill()
        other.wait(LONG)
        with store.holding(key("q"), give_up):
            pass


WRITE = """
import os, sys, time
from generator.calls.store import StoredAnswer, CallStore

def slow(number):
    print("writing", flush=True)
    time.sleep(60)

os.fsync = slow
store = CallStore(sys.argv[1])
with store.holding(sys.argv[2]):
    store.put(sys.argv[2], StoredAnswer(200, "", b"half"))
"""


def test_who_asks_anew_clears_what_a_killed_writer_left(tmp_path: Path) -> None:
    store = CallStore(tmp_path)
    with running(
        sys.executable, "-c", WRITE, tmp_path, key("q"), stdout=subprocess.PIPE, text=True
    ) as other:
        assert line_of(other) == "writing\n"
        other.kill()
        other.wait(LONG)
    (left,) = files(tmp_path)
    beside = left.with_name(".partial-" + key("r") + "-1")
    beside.write_bytes(b"another's, who may be at work")
    with store.holding(key("q")):
        assert files(tmp_path) == [beside]
        store.put(key("q"), ANSWER)
    assert store.get(key("q")) == ANSWER
