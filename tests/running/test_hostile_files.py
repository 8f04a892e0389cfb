"""What was spent, answers and prices as somebody else may have written them."""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path

import pytest

from generator.calls.money.account import Account
from generator.calls.money.budget import FILE, Purse
from generator.calls.money.entries import Entry
from generator.calls.money.prices import Prices
from generator.calls.money.spending import Spending
from generator.calls.store import Answer, CallStore
from generator.errors import InputError, StorageError

ANSWER = Answer(200, "application/json", b"{}")
KEY = "ab" + "0" * 62
SPENDER = "0123456789abcdef"
HUGE = "1" + "0" * 400


@pytest.fixture
def kept(tmp_path: Path) -> Path:
    """Somebody's own file."""
    (tmp_path / "precious.lock").write_text("precious")
    return tmp_path / "precious.lock"


# ------------------------------------------------------------------------------------ the sum spent


def sum_file(folder: Path, **told: object) -> Path:
    folder.mkdir(exist_ok=True)
    text = json.dumps({"mark": "m", "currency": "USD", **told})
    (folder / FILE).write_text(text)
    return folder


@pytest.mark.parametrize(
    "name",
    ["../../precious", "../precious", "", ".", "a", "held\0", "x" * 16, "A" * 16, "0" * 17,
     "0123456789abcde\n", "/tmp/precious"],
    ids=repr,
)  # fmt: skip
def test_only_16_hex_digits_are_a_spender(tmp_path: Path, kept: Path, name: str) -> None:
    folder = sum_file(tmp_path / "place", held={name: [0.5]})
    with pytest.raises(StorageError, match="16 hex digits") as caught:
        Purse.open(folder, "USD")
    assert str(caught.value).isprintable()
    with pytest.raises(StorageError, match="16 hex digits"):
        Purse(folder, "m").sum()
    assert kept.read_text() == "precious"
    assert {p.name for p in folder.iterdir()} == {FILE, "spent.lock"}


def test_what_a_dead_spender_held_is_spent(tmp_path: Path) -> None:
    folder = sum_file(tmp_path / "place", held={SPENDER: [0.5, 0.25]}, money=1)
    (folder / "spenders").mkdir()
    assert (Purse(folder, "m").sum().money, Purse(folder, "m").sum().held) == (1.75, {})
    assert list((folder / "spenders").iterdir()) == []


def test_many_spenders_are_dead_at_once_and_too_many_are_refused(tmp_path: Path) -> None:
    held = {f"{k:016x}": [0.25] for k in range(1024)}
    folder = sum_file(tmp_path / "place", held=held)
    (folder / "spenders").mkdir()
    assert Purse(folder, "m").sum().money == 256
    sum_file(folder, held=held | {"f" * 16: [0.25]})
    with pytest.raises(StorageError, match="1025 spenders; at most 1024"):
        Purse(folder, "m").sum()


def test_spenders_elsewhere_are_refused(tmp_path: Path) -> None:
    folder = sum_file(tmp_path / "place", held={SPENDER: [0.5]})
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / f"{SPENDER}.lock").write_text("precious")
    (folder / "spenders").symlink_to(tmp_path / "other")
    with pytest.raises(StorageError, match="is a link"):
        Purse.open(folder, "USD")
    assert (tmp_path / "other" / f"{SPENDER}.lock").read_text() == "precious"


@pytest.mark.parametrize(
    "text",
    [
        "[" * 100_000,
        '{"mark": "m", "currency": "USD", "money": ' + HUGE + "}",
        '{"mark": "m", "currency": "USD", "money": true}',
        '{"mark": "m", "currency": "USD", "money": "1"}',
        '{"mark": "m", "currency": "USD", "money": -1}',
        '{"mark": "m", "currency": "USD", "unpriced": 1.5}',
        '{"mark": "m", "currency": "USD", "held": []}',
        '{"mark": "m", "currency": "USD", "held": {"0123456789abcdef": 1}}',
        '{"mark": "m", "currency": "USD", "held": {"0123456789abcdef": [NaN]}}',
        '{"mark": "m", "currency": "U\\u001b[2J"}',
        '{"mark": 1, "currency": "USD"}',
        '{"mark": "m", "currency": "USD", "held\\u0000": {}}',
        '{"mark": "m", "currency": "USD", "money": 5, "money": 0}',
        "\0",
    ],
    ids=lambda text: text[:60],
)
def test_a_hostile_sum_is_one_clear_error(tmp_path: Path, text: str) -> None:
    (tmp_path / FILE).write_text(text)
    with pytest.raises(StorageError, match="does not say what was spent") as caught:
        Purse.open(tmp_path, "USD")
    assert str(caught.value).isprintable() and len(str(caught.value)) < 1000


def test_a_sum_is_a_regular_file(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / FILE)
    with pytest.raises(StorageError, match="not a regular file"):
        Purse.open(tmp_path, "USD")
    (tmp_path / FILE).unlink()
    (tmp_path / FILE).symlink_to("nowhere")
    with pytest.raises(StorageError, match="cannot be read"):
        Purse.open(tmp_path, "USD")
    assert (tmp_path / FILE).is_symlink(), "a sum that cannot be read is not taken for nothing"


# ------------------------------------------------------------------------ what a scene's calls cost


LINE = {"call": "1", "key": KEY, "currency": "USD", "server": "s", "question": "q", "money": 0.5}


@pytest.mark.parametrize(
    "wrong",
    [{"model": 1.5}, {"tokens_in": "x"}, {"images": []}, {"seconds": "1"}, {"outcome": {}},
     {"seconds": 1e300}, {"tokens_out": -1}, {"tokens_in": True}, {"at": None}, {"earlier": "x"},
     {"outcome": "paid"}],
    ids=repr,
)  # fmt: skip
def test_money_counts_whatever_else_a_line_says(tmp_path: Path, wrong: dict[str, object]) -> None:
    spending = Spending(tmp_path / "a.jsonl", "USD")
    spending.path.write_text(json.dumps({**LINE, **wrong}) + "\n")
    account = Account()
    account.resume(spending, Prices.shipped())
    assert account.money == 0.5
    assert "0.5000" in account.text()
    json.dumps(account.facts(Prices.shipped()))


@pytest.mark.parametrize(
    "line",
    [b"[" * 100_000, json.dumps({**LINE, "server": []}).encode(), b"\xff", b"5", b"null",
     json.dumps({**LINE, "money": True}).encode(), json.dumps({**LINE, "call": 5}).encode(),
     json.dumps(LINE).replace("0.5", HUGE).encode()],
    ids=lambda line: repr(line[:40]),
)  # fmt: skip
def test_a_line_that_is_none_spoils_no_other(tmp_path: Path, line: bytes) -> None:
    spending = Spending(tmp_path / "a.jsonl", "USD")
    spending.path.write_bytes(line + b"\n")
    spending.write("two", KEY, Entry("s", "q", money=0.25))
    assert [told["money"] for told in spending.earlier()] == [0.25]


def test_a_currency_is_told_without_escapes(tmp_path: Path) -> None:
    spending = Spending(tmp_path / "a.jsonl", "USD")
    spending.path.write_text(json.dumps({**LINE, "currency": "\x1b[2J"}) + "\n")
    with pytest.raises(InputError) as caught:
        spending.earlier()
    assert str(caught.value).isprintable()


@pytest.mark.parametrize("kind", ["pipe", "folder", "link"])
def test_what_calls_cost_is_kept_in_a_regular_file(tmp_path: Path, kept: Path, kind: str) -> None:
    spending = Spending(tmp_path / "a.jsonl", "USD")
    if kind == "pipe":
        os.mkfifo(spending.path)
    elif kind == "folder":
        spending.path.mkdir()
    else:
        spending.path.symlink_to(kept)
    with pytest.raises(StorageError, match="cannot be written"):
        spending.write("one", KEY, Entry("s", "q", money=0.25))
    if kind != "link":
        with pytest.raises(StorageError, match="cannot be read"):
            spending.earlier()
    assert kept.read_text() == "precious"


# ------------------------------------------------------------------------------------- the answers


def forged(folder: Path, head: bytes) -> CallStore:
    """A store with an answer of right checksum."""
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
