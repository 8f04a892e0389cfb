"""A budget shared by processes: never overdrawn, even if processes die."""

import os
import pickle
import random
import signal
import subprocess
import sys
import threading
import time
from contextlib import ExitStack
from functools import partial
from pathlib import Path

import pytest
from bounded import LONG, at_once, line_of, running
from paid_server import PRICES, Says, ask, serving, session

from generator.calls.money.budget import SharedBudget
from generator.calls.money.database import FILE
from generator.calls.money.entries import Entry
from generator.calls.money.ledger import Account
from generator.errors import BudgetError, InputError, StorageError

HOLDS = """
import sys, time
from generator.calls.money.budget import SharedBudget
with SharedBudget.open(sys.argv[1], "USD").spending() as spender:
    one, other = spender.reserve(0.25, 1.0, "a call"), spender.reserve(0.25, 1.0, "another")
    assert one and other
    spender.settle(one, 0.125)
    print("held", flush=True)
    time.sleep(60)
"""


def test_many_spenders_never_overdraw_it(tmp_path: Path) -> None:
    shared, sent, refused = SharedBudget.open(tmp_path, "USD"), [], []
    gate = threading.Barrier(6)

    def call() -> None:
        with shared.spending() as spender:
            account = Account(spender)
            gate.wait(LONG)
            try:
                with account.reserving(0.25, 1.0, "a call") as enter:
                    sent.append(shared.total())
                    enter(Entry("s", "q", money=0.25))
            except BudgetError as error:
                refused.append(str(error))

    at_once(*[call] * 6)
    assert (len(sent), len(refused)) == (4, 2)
    assert all(s.money + s.held <= 1.0 for s in sent)
    assert (shared.total().money, shared.total().held) == (1.0, 0.0)
    assert "1.0000 of the budget of 1 for all scenes is spent" in refused[0]


def test_it_is_there_in_the_next_run(tmp_path: Path) -> None:
    for run, kept in enumerate((True, False)):
        with SharedBudget.open(tmp_path, "USD").spending() as spender:
            if kept:
                spender.settle(spender.reserve(0.75, 1.0, "a call"), 0.5)
            else:
                with pytest.raises(BudgetError, match=r"0\.5000 of the budget"):
                    spender.reserve(0.75, 1.0, "a call")
                call = spender.reserve(0.75, 2.0, "a call")  # with a larger budget
                spender.settle(call, 0.25)
        assert SharedBudget.open(tmp_path, "USD").total().money == 0.5 + 0.25 * run
    assert list(tmp_path.glob("*/*.lock")) == []


def test_no_budget_is_kept_while_earlier_calls_have_no_price(tmp_path: Path) -> None:
    shared = SharedBudget.open(tmp_path, "USD")
    with shared.spending() as spender:
        spender.settle(spender.reserve(0.25, None, "a call"), None)
        with pytest.raises(BudgetError, match="1 calls of earlier runs in this folder have no"):
            spender.reserve(0.25, 5.0, "a call")
        assert spender.reserve(0.0, 5.0, "free") is not None
        assert spender.reserve(0.25, None, "no budget")
    assert SharedBudget.open(tmp_path, "USD").total().unpriced == 1


def test_who_lives_is_waited_for_and_what_costs_nothing_is_not_stopped(tmp_path: Path) -> None:
    shared = SharedBudget.open(tmp_path, "USD")
    with shared.spending() as one, shared.spending() as two:
        call = one.reserve(0.75, 1.0, "one")
        assert call and two.reserve(0.5, 1.0, "two") is None
        one.settle(call, 0.25)
        other = two.reserve(0.5, 1.0, "two")
        assert other
        two.settle(other, 1.0)
        before = (tmp_path / FILE).read_bytes()
        one.settle(one.reserve(0.0, 1.0, "free"), 0.0)
        assert (tmp_path / FILE).read_bytes() == before


@pytest.mark.skipif(os.name == "nt", reason="kills by signal")
def test_what_a_killed_process_had_under_way_is_spent(tmp_path: Path) -> None:
    process = subprocess.Popen(
        [sys.executable, "-c", HOLDS, str(tmp_path)], stdout=subprocess.PIPE,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )  # fmt: skip
    assert line_of(process) == b"held\n" and process.stdout is not None
    shared = SharedBudget.open(tmp_path, "USD")
    assert (shared.total().money, shared.total().held) == (0.125, 0.25)
    process.send_signal(signal.SIGKILL)
    process.wait(LONG)
    process.stdout.close()
    assert (shared.total().money, shared.total().held) == (0.375, 0.0)


SPENDS = """
import sys
from generator.calls.money.budget import SharedBudget
from generator.errors import BudgetError
with SharedBudget.open(sys.argv[1], "USD").spending() as spender, open(sys.argv[2], "a") as log:
    print("begun", flush=True)
    while True:
        try:
            call = spender.reserve(0.25, 100.0, "a call")
        except BudgetError:
            break
        if call is not None:
            log.write("x")  # sent, and paid for
            log.flush()
            spender.settle(call, 0.125)
"""


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="kills by signal")
def test_whenever_processes_are_killed_no_call_is_forgotten_and_no_budget_exceeded(
    tmp_path: Path,
) -> None:
    log, rng = tmp_path / "log", random.Random(0)
    shared = SharedBudget.open(tmp_path / "budget", "USD")

    def killed(_: int) -> None:
        command = [sys.executable, "-c", SPENDS, str(tmp_path / "budget"), str(log)]
        path = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
        with running(*command, stdout=subprocess.PIPE, env=path) as process:
            assert line_of(process) == b"begun\n"
            time.sleep(rng.uniform(0.0, 0.2))

    for _ in range(3):
        at_once(*(partial(killed, k) for k in range(4)))
        spent, sent = shared.total(), log.stat().st_size
        assert 0.125 * sent <= spent.money <= 100.0
        assert spent.money <= 0.125 * sent + 0.25 * 12 and spent.held == 0.0


def test_a_call_that_broke_off_is_spent(tmp_path: Path) -> None:
    shared = SharedBudget.open(tmp_path, "USD")
    with shared.spending() as spender, ExitStack() as broken:
        broken.enter_context(pytest.raises(KeyboardInterrupt))
        broken.enter_context(Account(spender).reserving(0.25, 1.0, "a call"))
        raise KeyboardInterrupt
    assert shared.total().money == 0.25


def test_calls_of_sessions_are_paid_from_it(tmp_path: Path) -> None:
    shared = pickle.loads(pickle.dumps(SharedBudget.open(tmp_path, "USD")))
    with serving([Says()]) as server, ExitStack() as open_:
        first, second = (
            session(account=Account(open_.enter_context(shared.spending())), budget=0.07)
            for _ in range(2)
        )
        ask(first, server.url, "one")
        ask(second, server.url, "two")
        with pytest.raises(BudgetError, match=r"0\.0420 of the budget"):
            ask(first, server.url, "three")  # it may cost 0.04
    assert len(server.asked) == 2
    assert (first.account.money, shared.total().money) == (0.021, pytest.approx(0.042))


def test_another_folder_of_that_name_is_refused(tmp_path: Path) -> None:
    """As on a machine of a Ray cluster that does not share it."""
    elsewhere = "is not the folder in which the batch was started"
    shared = SharedBudget.open(tmp_path, "USD")
    (tmp_path / FILE).unlink()
    with pytest.raises(StorageError, match=elsewhere):
        shared.spending().__enter__()
    SharedBudget.open(tmp_path, "USD")
    with pytest.raises(StorageError, match=elsewhere):
        shared.spending().__enter__()
    with pytest.raises(StorageError, match=elsewhere):
        SharedBudget(tmp_path / "no", "m").total()
    assert not (tmp_path / "no").exists()


@pytest.mark.parametrize("text", ["", "{}", "SQLite format 3\0", "x" * 4096])
def test_a_damaged_sum_is_never_taken_for_nothing(tmp_path: Path, text: str) -> None:
    (tmp_path / FILE).write_text(text)
    with pytest.raises(StorageError, match="is not a valid spending database"):
        SharedBudget.open(tmp_path, "USD")
    assert (tmp_path / FILE).read_text() == text


@pytest.mark.parametrize("old", ["spent.json", "spending"])
def test_what_an_older_version_kept_is_not_taken_for_nothing(tmp_path: Path, old: str) -> None:
    (tmp_path / old).write_text('{"mark": "m", "currency": "USD", "money": 1.0}')
    for _ in range(2):
        with pytest.raises(
            StorageError, match=rf"{old} was written by an older version.*remove the file"
        ):
            SharedBudget.open(tmp_path, "USD")
    (tmp_path / old).unlink()
    assert SharedBudget.open(tmp_path, "USD").total().money == 0.0


def test_another_currency_is_refused(tmp_path: Path) -> None:
    SharedBudget.open(tmp_path, "USD")
    with pytest.raises(InputError, match="spending in USD, but the price table is in EUR"):
        SharedBudget.open(tmp_path, "EUR")


def test_a_disk_that_refuses_loses_no_answer(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*known: object) -> None:
        raise StorageError("full")

    monkeypatch.setattr(SharedBudget, "settle", full)
    shared = SharedBudget.open(tmp_path, "USD")
    with serving([Says()]) as server, shared.spending() as spender:
        asking = session(account=Account(spender))
        assert ask(asking, server.url).status_code == 200
        assert asking.account.notes == ("full",)
    assert shared.total().money > asking.account.money  # the most it can have cost


def test_prices_can_be_sent_to_processes() -> None:
    assert pickle.loads(pickle.dumps(PRICES)) == PRICES
    shipped = type(PRICES).default()
    assert pickle.loads(pickle.dumps(shipped)).models == dict(shipped.models)
