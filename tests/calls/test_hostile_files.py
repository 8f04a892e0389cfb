"""Spending records, cached responses and prices written by others."""

import contextlib
import hashlib
import json
import os
import sqlite3
import struct
from collections.abc import Iterable
from pathlib import Path

import pytest

from generator.calls.money.budget import SharedBudget
from generator.calls.money.database import FILE, LOCAL
from generator.calls.money.entries import Entry
from generator.calls.money.ledger import Account
from generator.calls.money.prices import Prices
from generator.calls.money.scene_cost import Spending
from generator.calls.store import CallStore, StoredAnswer
from generator.errors import InputError, StorageError

ANSWER = StoredAnswer(200, "application/json", b"{}")
KEY = "ab" + "0" * 62
SPENDER = "0123456789abcdef"
HUGE = "1" + "0" * 400


@pytest.fixture
def kept(tmp_path: Path) -> Path:
    """A file of another user."""
    (tmp_path / "precious.lock").write_text("precious")
    return tmp_path / "precious.lock"


# ------------------------------------------------------------------------------------ the sum spent
def database(folder: Path, *statements: str, values: Iterable[tuple[object, ...]] = ()) -> Path:
    """Create a folder's database with a budget, and apply changes by another user."""
    folder.mkdir(exist_ok=True)
    SharedBudget.open(folder, "USD")
    with contextlib.closing(sqlite3.connect(folder / FILE)) as changed, changed:
        changed.execute("UPDATE spent SET mark = 'm'")
        for statement in statements:
            changed.execute(statement)
        if values:
            changed.executemany("INSERT INTO held (owner, money) VALUES (?, ?)", values)
    return folder


@pytest.mark.parametrize(
    "name",
    ["../../precious", "../precious", "", ".", "a", "held\0", "x" * 16, "A" * 16, "0" * 65,
     "0123456789abcde\n", "/tmp/precious"],
    ids=repr,
)  # fmt: skip
def test_only_hex_digits_are_a_spender(tmp_path: Path, kept: Path, name: str) -> None:
    folder = database(tmp_path / "place", values=[(name, 0.5)])
    with pytest.raises(StorageError, match="16 hex digits") as caught:
        SharedBudget(folder, "m").total()
    assert str(caught.value).isprintable()
    assert kept.read_text() == "precious"
    assert {p.name for p in folder.iterdir()} == {FILE}


def test_what_a_dead_spender_held_is_spent(tmp_path: Path) -> None:
    folder = database(
        tmp_path / "place", "UPDATE spent SET money = 1.0",
        values=[(SPENDER, 0.5), (SPENDER, 0.25), ("f" * 16, None)],
    )  # fmt: skip
    (folder / "spenders").mkdir()
    spent = SharedBudget(folder, "m").total()
    assert (spent.money, spent.held, spent.unpriced) == (1.75, 0.0, 1)
    assert list((folder / "spenders").iterdir()) == []


def test_many_spenders_are_dead_at_once_and_too_many_are_refused(tmp_path: Path) -> None:
    folder = database(tmp_path / "place", values=[(f"{k:016x}", 0.25) for k in range(1024)])
    (folder / "spenders").mkdir()
    assert SharedBudget(folder, "m").total().money == 256
    database(folder, values=[(f"{k:016x}", 0.25) for k in range(10_001)])
    with pytest.raises(StorageError, match="10001 calls in flight"):
        SharedBudget(folder, "m").total()


def test_spenders_elsewhere_are_refused(tmp_path: Path) -> None:
    folder = database(tmp_path / "place", values=[(SPENDER, 0.5)])
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / f"{SPENDER}.lock").write_text("precious")
    (folder / "spenders").symlink_to(tmp_path / "other")
    with pytest.raises(StorageError, match="is a link"):
        SharedBudget(folder, "m").total()
    with pytest.raises(StorageError, match="is a link"), LOCAL.owning(folder):
        pass
    assert (tmp_path / "other" / f"{SPENDER}.lock").read_text() == "precious"


@pytest.mark.parametrize(
    "statement",
    [
        "UPDATE spent SET money = 9e999",
        "UPDATE spent SET money = 'much'",
        "UPDATE spent SET money = NULL",
        "UPDATE spent SET money = -1",
        "UPDATE spent SET money = x'00'",
        "UPDATE spent SET unpriced = 1.5",
        "UPDATE spent SET unpriced = 'one'",
        "UPDATE spent SET currency = char(27) || '[2J'",
        "UPDATE spent SET currency = x'05'",
        "UPDATE spent SET mark = x'00'",
        "UPDATE spent SET mark = CAST(x'ff' AS TEXT)",
        f"UPDATE spent SET mark = '{'m' * 1000}'",
        "INSERT INTO spent VALUES ('m', 'USD', 0.0, 0)",
        f"INSERT INTO held (owner, money) VALUES ('{SPENDER}', 'much')",
        f"INSERT INTO held (owner, money) VALUES ('{SPENDER}', -1)",
        f"INSERT INTO held (owner, money) VALUES ('{SPENDER}', 9e999)",
        "INSERT INTO held (owner, money) VALUES (NULL, 1)",
        "INSERT INTO held (owner, money) VALUES (x'00', 1)",
        "CREATE TRIGGER free AFTER UPDATE ON spent BEGIN UPDATE spent SET money = 0.0; END",
        "CREATE VIEW other AS SELECT * FROM spent",
        "CREATE TABLE other (a)",
        "DROP TABLE held",
        "ALTER TABLE spent ADD COLUMN a",
    ],
)
def test_a_hostile_sum_is_one_clear_error(tmp_path: Path, statement: str) -> None:
    database(tmp_path, statement)
    before = (tmp_path / FILE).read_bytes()
    with pytest.raises(StorageError, match="is not a valid spending database") as caught:
        SharedBudget.open(tmp_path, "USD")
    assert str(caught.value).isprintable() and len(str(caught.value)) < 1000
    assert (tmp_path / FILE).read_bytes() == before


def test_a_damaged_page_is_one_clear_error(tmp_path: Path) -> None:
    database(tmp_path, values=[(SPENDER, 0.5)])
    whole = (tmp_path / FILE).read_bytes()
    for page in range(1, len(whole) // 4096):
        (tmp_path / FILE).write_bytes(whole[: 4096 * page] + b"\xff" * (len(whole) - 4096 * page))
        with pytest.raises(StorageError, match="is not a valid spending database"):
            SharedBudget.open(tmp_path, "USD")
            SharedBudget(tmp_path, "m").total()


@pytest.mark.parametrize("end", ["", "-journal"])
def test_a_sum_is_a_regular_file(tmp_path: Path, kept: Path, end: str) -> None:
    SharedBudget.open(tmp_path, "USD")
    place = tmp_path / f"{FILE}{end}"
    place.unlink(missing_ok=True)
    os.mkfifo(place)
    with pytest.raises(StorageError, match="not a regular file"):
        SharedBudget.open(tmp_path, "USD")
    for target in (kept, Path("nowhere")):
        place.unlink()
        place.symlink_to(target)
        with pytest.raises(StorageError, match="not a regular file"):
            SharedBudget.open(tmp_path, "USD")
    assert place.is_symlink(), "a sum that cannot be read is not taken for nothing"
    assert kept.read_text() == "precious"


def test_a_sum_is_bounded(tmp_path: Path) -> None:
    SharedBudget.open(tmp_path, "USD")
    os.truncate(tmp_path / FILE, 2**32)
    with pytest.raises(StorageError, match="4294967296 bytes; the limit is"):
        SharedBudget.open(tmp_path, "USD")


def test_a_journal_deletes_no_file(tmp_path: Path, kept: Path) -> None:
    """SQLite deletes the file named at the end of a journal after a rollback."""
    folder = database(tmp_path / "place")
    name = str(kept).encode()
    end = struct.pack(">II", len(name), sum(name)) + b"\xd9\xd5\x05\xf9\x20\xa1\x63\xd7"
    pages = (folder / FILE).stat().st_size // 4096
    head = b"\xd9\xd5\x05\xf9\x20\xa1\x63\xd7" + struct.pack(">IIIII", 0, 0, pages, 512, 4096)
    journal = folder / f"{FILE}-journal"
    page = struct.pack(">I", 2**31 // 4096 + 1 + 2**18)
    journal.write_bytes(head.ljust(512, b"\0") + page + name + end)
    with pytest.raises(StorageError, match="refers to another file"):
        SharedBudget(folder, "m").total()
    assert kept.read_text() == "precious" and journal.exists()


# ------------------------------------------------------------------------ what a scene's calls cost
CALL = {"key": KEY, "currency": "USD", "server": "s", "question": "q", "money": 0.5}


def spending(folder: Path, facts: object) -> Spending:
    """Return the calls of a scene: one modified by another user, and one of 0.25."""
    written = Spending(folder, "a")
    written.write(KEY, Entry("s", "q", money=0.25))
    with contextlib.closing(sqlite3.connect(written.path)) as changed, changed:
        changed.execute("INSERT INTO calls VALUES (NULL, 'a', ?)", (facts,))
    return written


@pytest.mark.parametrize(
    "wrong",
    [{"model": 1.5}, {"tokens_in": "x"}, {"images": []}, {"seconds": "1"}, {"outcome": {}},
     {"seconds": 1e300}, {"tokens_out": -1}, {"tokens_in": True}, {"at": None}, {"earlier": "x"},
     {"outcome": "paid"}],
    ids=repr,
)  # fmt: skip
def test_money_counts_whatever_else_a_call_says(tmp_path: Path, wrong: dict[str, object]) -> None:
    account = Account()
    account.resume(spending(tmp_path, json.dumps({**CALL, **wrong})), Prices.default())
    assert account.money == 0.75
    assert "0.7500" in account.text()
    json.dumps(account.facts(Prices.default()))


@pytest.mark.parametrize(
    "facts",
    ["[" * 100_000, json.dumps({**CALL, "server": []}), b"\xff", "5", None, 5,
     json.dumps({**CALL, "money": True}), json.dumps(CALL).replace("0.5", HUGE), "{}",
     "x" * 2**19],
    ids=lambda facts: repr(facts)[:40],
)  # fmt: skip
def test_a_call_that_is_none_is_not_taken_for_nothing(tmp_path: Path, facts: object) -> None:
    with pytest.raises(StorageError, match="is not a valid spending database") as caught:
        spending(tmp_path, facts).earlier()
    assert str(caught.value).isprintable() and len(str(caught.value)) < 1000


def test_a_currency_is_told_without_escapes(tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        spending(tmp_path, json.dumps({**CALL, "currency": "\x1b[2J"})).earlier()
    assert str(caught.value).isprintable()


@pytest.mark.parametrize("kind", ["pipe", "folder", "link"])
def test_what_calls_cost_is_kept_in_a_regular_file(tmp_path: Path, kept: Path, kind: str) -> None:
    found = Spending(tmp_path, "a")
    if kind == "pipe":
        os.mkfifo(found.path)
    elif kind == "folder":
        found.path.mkdir()
    else:
        found.path.symlink_to(kept)
    with pytest.raises(StorageError, match="not a regular file"):
        found.write(KEY, Entry("s", "q", money=0.25))
    with pytest.raises(StorageError, match="not a regular file"):
        found.earlier()
    assert kept.read_text() == "precious"


# ------------------------------------------------------------------------------------- the answers
def forged(folder: Path, head: bytes) -> CallStore:
    """A store with a response with a correct checksum."""
    content = head + b"\nbody"
    told = hashlib.sha256(KEY.encode() + b"\n" + content).hexdigest().encode()
    path = folder / "answers" / KEY[:2] / KEY
    path.parent.mkdir(parents=True)
    path.write_bytes(b"tabletopgen call 1 " + told + b"\n" + content)
    return CallStore(folder)


@pytest.mark.parametrize(
    "head",
    [b"", b"[" * 10_000, b"[]", b"{}", b"\xff", b'{"status": 200}', b'{"content_type": "a"}',
     b'{"status": "200", "content_type": "a"}', b'{"status": true, "content_type": "a"}',
     b'{"status": 99999, "content_type": "a"}', b'{"status": 200, "content_type": []}',
     b'{"status": 200, "content_type": "a\\r\\nb: c"}'],
    ids=lambda head: repr(head[:40]),
)  # fmt: skip
def test_an_answer_that_no_store_wrote_is_none(tmp_path: Path, head: bytes) -> None:
    store = forged(tmp_path, head)
    assert store.get(KEY) is None
    assert len(store) == 0
    store.put(KEY, ANSWER)
    assert store.get(KEY) == ANSWER


@pytest.mark.parametrize("kind", ["pipe", "link", "folder", "large"])
def test_an_answer_is_a_regular_file(tmp_path: Path, kept: Path, kind: str) -> None:
    store = CallStore(tmp_path / "calls", most_bytes=1000)
    path = tmp_path / "calls" / "answers" / KEY[:2] / KEY
    path.parent.mkdir(parents=True)
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "link":
        path.symlink_to(kept)
    elif kind == "folder":
        path.mkdir()
    else:
        path.write_bytes(b"x")
        os.truncate(path, 2**32)
    assert store.get(KEY) is None
    if kind != "folder":
        store.put(KEY, ANSWER)
        assert store.get(KEY) == ANSWER
    assert kept.read_text() == "precious"


def test_what_is_not_the_stores_is_never_dropped(tmp_path: Path) -> None:
    own, other = tmp_path / "calls", tmp_path / "other"
    other.mkdir()
    for place in (other / "thesis", other / ("cd" + "1" * 62), other / ".partial-x"):
        place.write_bytes(b"x" * 900)
        os.utime(place, (1, 1))
    (own / "answers" / "ab").mkdir(parents=True)
    (own / "answers" / "ab" / "notes").write_bytes(b"x" * 900)
    (own / "answers" / "cd").symlink_to(other)
    store = CallStore(own, most_bytes=400)
    for number in range(8):
        store.put(f"{number:064x}", ANSWER)
    assert store.size() <= 400
    assert {p.name for p in other.iterdir()} == {"thesis", "cd" + "1" * 62, ".partial-x"}
    assert (own / "answers" / "ab" / "notes").exists()


def test_a_lock_that_is_a_link_is_not_gone_through(tmp_path: Path, kept: Path) -> None:
    store = CallStore(tmp_path / "calls")
    (tmp_path / "calls" / "locks").mkdir(parents=True)
    (tmp_path / "calls" / "locks" / f"{KEY[:3]}.lock").symlink_to(kept)
    before = kept.stat()
    with store.holding(KEY):
        store.put(KEY, ANSWER)
    assert kept.read_text() == "precious" and kept.stat().st_mtime_ns == before.st_mtime_ns


# -------------------------------------------------------------------------------------- the prices
@pytest.mark.parametrize(
    "text",
    ["a = " + "[" * 100_000, f'[models."m"]\ninput = {HUGE}', 'currency = "\\u001b[2J"',
     "currency = 5", 'date = "\\u001b"', "models = 1" + "0" * 5000],
    ids=lambda text: text[:40],
)  # fmt: skip
def test_a_hostile_price_table_is_refused(tmp_path: Path, text: str) -> None:
    (tmp_path / "prices.toml").write_text(text)
    with pytest.raises(InputError) as caught:
        Prices.load(tmp_path / "prices.toml")
    assert len(str(caught.value)) < 1000


def test_a_price_table_is_a_regular_file(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for place in ("/dev/zero", tmp_path / "pipe", tmp_path):
        with pytest.raises(InputError, match="not a regular file"):
            Prices.load(place)
