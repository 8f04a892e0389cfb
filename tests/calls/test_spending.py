"""The cost of a scene's calls persists across runs."""

import os
import sqlite3
import subprocess
import sys
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from bounded import at_once, running, until
from paid_server import KEY, PRICES, Asked, Says, ask, serving, session

from generator.calls import Session
from generator.calls.money.budget import SharedBudget
from generator.calls.money.database import FILE, LOCAL
from generator.calls.money.entries import Entry
from generator.calls.money.ledger import Account
from generator.calls.money.prices import Price, Prices
from generator.calls.money.scene_cost import Spending
from generator.calls.store import CallStore
from generator.errors import BudgetError, InputError, StorageError

MOST = 0.04004
"""What a call of the tests may cost at most."""


def run(folder: Path, **settings: Any) -> Session:
    """A run of the scene with responses and spending in ``folder``."""
    made = session(store=CallStore(folder), **settings)
    made.resume("scene")
    return made


def test_a_run_knows_what_those_before_spent(tmp_path: Path) -> None:
    with serving([Says()]) as server:
        first = run(tmp_path)
        for text in "ab":
            ask(first, server.url, text)
        second = run(tmp_path)
        assert second.account.money == first.account.money == pytest.approx(0.042)
        for text in "abc":
            ask(second, server.url, text)
        assert len(server.asked) == 3
    assert second.account.money == pytest.approx(0.063)
    (plan,) = second.account.summary()
    assert (plan.calls, plan.cached) == (3, 2)
    assert second.account.notes == ("Of this, 0.0420 was spent by earlier runs of the same scene.",)
    facts = second.account.facts(PRICES)
    assert facts["money"] == pytest.approx(0.063)
    assert [call["earlier"] for call in facts["calls"]] == [True, True, False, False, False]
    assert run(tmp_path).account.money == second.account.money, "entered once"


def test_a_budget_is_for_all_runs_of_a_scene(tmp_path: Path) -> None:
    with serving([Says()]) as server:
        ask(run(tmp_path, budget=0.06), server.url, "a")
        again = run(tmp_path, budget=0.06)
        ask(again, server.url, "a")
        with pytest.raises(BudgetError, match=r"0\.0210 of the budget of 0\.06 is spent"):
            ask(again, server.url, "b")
        other = session(store=CallStore(tmp_path), budget=0.06)
        other.resume("other")
        ask(other, server.url, "b")


CHILD = """
import sys
from pathlib import Path
from paid_server import ask
from test_spending import run
shared = run(Path(sys.argv[1]))
for text in "ab":
    ask(shared, sys.argv[2], text)
"""


@pytest.mark.slow
def test_a_killed_run_leaves_what_it_spent_and_may_have(tmp_path: Path) -> None:
    with serving(lambda asked, k: Says(delay=30.0 * k)) as server:
        path = os.pathsep.join([str(Path(__file__).parent), *sys.path])
        command = [sys.executable, "-c", CHILD, str(tmp_path), server.url]
        with running(*command, env={**os.environ, "PYTHONPATH": path}) as child:
            until(lambda: len(server.asked) >= 2 or child.poll() is not None)
    resumed = run(tmp_path)
    assert [e.outcome for e in resumed.account.entries] == ["answered", "failed"]
    assert resumed.account.money == pytest.approx(0.021 + MOST, abs=1e-4)


def test_each_call_has_the_key_of_its_answer_and_no_secret(tmp_path: Path) -> None:
    with serving([Says()]) as server:
        ask(run(tmp_path / "calls"), server.url)
    (answer,) = (tmp_path / "calls" / "answers").glob("*/*")
    raw = (tmp_path / "calls" / FILE).read_bytes()
    assert answer.name.encode() in raw and KEY.encode() not in raw
    assert (tmp_path / "calls" / FILE).stat().st_mode & 0o077 == 0
    assert (tmp_path / "calls").stat().st_mode & 0o077 == 0


def test_what_is_free_is_not_written_down(tmp_path: Path) -> None:
    with serving([Says()]) as server:
        ask(run(tmp_path, prices=Prices()), server.url)
    assert not (tmp_path / FILE).exists()


def test_what_nobody_knows_the_price_of_stays_so(tmp_path: Path) -> None:
    spending = Spending(tmp_path, "a")
    spending.write("k", Entry("s", "q", money=None))
    account = Account()
    account.resume(spending)
    assert (account.money, account.unpriced) == (0.0, 1)


def unpriced(folder: Path, *entries: Entry) -> None:
    """Record calls of a run without a budget at an unknown price."""
    for entry in entries:
        Spending(folder, "scene").write("k", entry)


def test_answers_are_priced_as_soon_as_their_model_is(tmp_path: Path) -> None:
    unpriced(tmp_path, Entry("s", "q", "m", tokens_in=1_000, tokens_out=2_000, money=None))
    assert run(tmp_path, prices=Prices()).account.unpriced == 1
    resumed = run(tmp_path, budget=0.06)
    assert (resumed.account.money, resumed.account.unpriced) == (pytest.approx(0.021), 0)
    with serving([Says()]) as server, pytest.raises(BudgetError, match=r"0\.0210 of the budget"):
        ask(run(tmp_path, budget=0.06), server.url)
    assert server.asked == []


def test_calls_of_a_server_of_ones_own_are_priced_by_its_host(tmp_path: Path) -> None:
    unpriced(tmp_path, Entry("hunyuan3d", "model", money=None, at="box:8081"))
    with serving([Says()]) as server, pytest.raises(BudgetError, match=r'\[models\."@box:8081"\]'):
        ask(run(tmp_path, budget=5.0), server.url)
    prices = Prices(models={"@box": Price(call=0.5)})
    assert run(tmp_path, prices=prices).account.money == 0.5


def test_a_shared_budget_is_of_its_own_calls_alone(tmp_path: Path) -> None:
    """Earlier calls of the scene belong to another folder."""
    unpriced(tmp_path, Entry("s", "q", "m", "failed", money=None))
    with serving([Says()]) as server, SharedBudget.open(tmp_path, "USD").spending() as spender:
        shared = run(tmp_path, budget=5.0, account=Account(spender))
        assert ask(shared, server.url).status_code == 200


@pytest.mark.parametrize(
    "entry",
    [
        Entry("s", "q", "other", tokens_in=1_000, money=None),
        Entry("s", "q", "m", "failed", money=None),  # nobody knows what it took
        Entry("s", "q", "m", money=None),
        Entry("s", "q", money=None),
    ],
    ids=lambda entry: f"{entry.model or 'no model'}, {entry.outcome}",
)
def test_no_budget_is_kept_while_earlier_calls_have_no_price(tmp_path: Path, entry: Entry) -> None:
    unpriced(tmp_path, entry, Entry("s", "q", "m", money=0.25))
    with serving([Says()]) as server:
        with pytest.raises(BudgetError, match="1 calls whose price is not known") as refused:
            ask(run(tmp_path, budget=5.0), server.url)
        assert FILE in str(refused.value)
        assert (f'[models."{entry.model}"]' in str(refused.value)) == bool(entry.model)
        assert server.asked == []
        free = run(tmp_path, budget=5.0, prices=Prices(models={"m": Price()}))
        assert ask(free, server.url, "what costs nothing").status_code == 200
        assert "1 of their calls have no known price" in run(tmp_path).account.notes[0]
        assert ask(run(tmp_path), server.url).status_code == 200  # without a budget


def test_a_write_that_was_killed_spoils_no_other(tmp_path: Path) -> None:
    spending = Spending(tmp_path, "a")
    spending.write("k", Entry("s", "q", money=0.25))
    writer = "import sys; from pathlib import Path; from test_spending import die; die(sys.argv[1])"
    path = os.pathsep.join([str(Path(__file__).parent), *sys.path])
    done = subprocess.run(
        [sys.executable, "-c", writer, str(tmp_path)],
        env={**os.environ, "PYTHONPATH": path},
        timeout=60,
    )
    assert done.returncode == 9 and (tmp_path / f"{FILE}-journal").stat().st_size > 0
    spending.write("k", Entry("s", "q", money=0.5))
    assert [entry.money for entry in spending.earlier()] == [0.25, 0.5]


def die(folder: str) -> None:
    """Exit within a transaction that is partly on the disk."""

    def half(database: sqlite3.Connection) -> None:
        database.execute("PRAGMA cache_size = 0")
        database.execute("PRAGMA cache_spill = 1")
        for _ in range(200):
            database.execute("INSERT INTO calls VALUES (NULL, 'a', ?)", ("x" * 5000,))
        os._exit(9)

    LOCAL.transact(Path(folder), half)


def test_calls_of_many_at_once_are_whole(tmp_path: Path) -> None:
    def write(k: int) -> None:
        Spending(tmp_path, "a").write("k", Entry("s", f"{k} " + "q" * 500, money=1.0))

    at_once(*(partial(write, k) for k in range(16)))
    found = Spending(tmp_path, "a").earlier()
    assert {entry.question.split()[0] for entry in found} == {str(k) for k in range(16)}


def test_a_disk_that_refuses_loses_no_answer_and_says_so(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("no folder")
    shared = run(tmp_path / "calls")
    shared.account.resume(Spending(tmp_path / "file" / "calls", "a"))
    with serving([Says()]) as server:
        assert ask(shared, server.url).status_code == 200
    assert "The spending database cannot be read or written" in shared.account.notes[0]


def test_with_a_budget_nothing_is_sent_that_cannot_be_written_down(tmp_path: Path) -> None:
    budget = SharedBudget.open(tmp_path, "USD")
    (tmp_path / "file").write_text("no folder")
    with serving([Says()]) as server, budget.spending() as spender:
        shared = session(budget=1.0, account=Account(spender))
        shared.account.resume(Spending(tmp_path / "file" / "calls", "a"))
        with pytest.raises(StorageError, match=r"not sent, .* cannot be read or written"):
            ask(shared, server.url)
        assert server.asked == []
    assert budget.total().money == shared.account.money == 0.0


def test_an_answer_under_a_budget_outlives_a_disk_that_refuses_late(tmp_path: Path) -> None:
    shared = run(tmp_path, budget=1.0)

    def spoil(asked: Asked, k: int) -> Says:
        (tmp_path / FILE).unlink()
        (tmp_path / FILE).mkdir()
        return Says()

    with serving(spoil) as server:
        assert ask(shared, server.url).status_code == 200
    assert "is not a regular file" in shared.account.notes[0]


@pytest.mark.parametrize(
    ("folder", "told"),
    [(FILE, "not a regular file"), ("spending", "spending was written by an older version")],
)
def test_what_cannot_be_read_is_not_taken_for_nothing(
    tmp_path: Path, folder: str, told: str
) -> None:
    (tmp_path / folder).mkdir()
    with pytest.raises(StorageError, match=told):
        Account().resume(Spending(tmp_path, "a"))


def test_money_of_another_kind_is_not_added_up(tmp_path: Path) -> None:
    Spending(tmp_path, "a", "EUR").write("k", Entry("s", "q", money=0.25))
    with pytest.raises(InputError, match="in 'EUR', but the price table is in USD"):
        Account().resume(Spending(tmp_path, "a", "USD"))


def test_a_call_that_was_given_up_is_written_down_with_the_most(tmp_path: Path) -> None:
    shared = run(tmp_path, attempts=1, prices=Prices(models={"m": Price(call=0.4)}))
    with serving([Says(status=504)]) as server, pytest.raises(Exception, match="504"):
        ask(shared, server.url)
    assert run(tmp_path).account.money == 0.4
