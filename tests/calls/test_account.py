"""The ledger: sums, unknown prices, and a thread-safe budget."""

import contextlib
import json
import threading
from pathlib import Path

import pytest
from bounded import LONG, at_once

from generator.calls.money.entries import Entry
from generator.calls.money.ledger import Account
from generator.calls.money.prices import Price, Prices
from generator.errors import BudgetError, InputError, StoppedError, StorageError

CALLS = (
    Entry("cloud", "plan_scene", "m", "failed", 1.0),
    Entry("cloud", "plan_scene", "m", "answered", 2.0, 100, 50, 0, 0.25),
    Entry("cloud", "complete", "i", "answered", 3.0, 0, 0, 1, 0.5),
    Entry("cloud", "plan_scene", "m", "cached"),
    Entry("maker", "model", "x", "answered", 4.0, money=None),
)


def filled() -> Account:
    account = Account()
    for entry in CALLS:
        account.add(entry)
    return account


def test_calls_add_up_by_question_and_model() -> None:
    plan, complete, model = filled().summary()
    assert (plan.question, plan.calls, plan.cached, plan.failed) == ("plan_scene", 1, 1, 1)
    assert (plan.seconds, plan.tokens_in, plan.tokens_out, plan.money) == (3.0, 100, 50, 0.25)
    assert (complete.images, complete.money, complete.unpriced) == (1, 0.5, 0)
    assert (model.money, model.unpriced) == (0.0, 1)
    assert (filled().money, filled().unpriced) == (0.75, 1)


def test_the_text_says_what_is_not_known() -> None:
    account = filled()
    account.note("the disk is full")
    account.note("the disk is full")
    head, *rows, total, note = account.text("EUR").splitlines()
    assert head.split()[0] == "server" and head.endswith("EUR")
    assert rows[2].endswith("1 unknown") and rows[0].endswith("0.2500")
    assert total.startswith("total") and total.endswith("0.7500 + 1 unknown")
    assert note == "note: the disk is full"
    assert Account().text() == ""


def test_it_is_written_beside_and_whole(tmp_path: Path) -> None:
    path = filled().save(tmp_path, Prices("2026-01-01", "EUR"))
    facts = json.loads(path.read_text())
    assert [path.name] == [p.name for p in tmp_path.iterdir()] == ["ledger.json"]
    assert (facts["currency"], facts["prices_of"]) == ("EUR", "2026-01-01")
    assert (facts["money"], facts["unpriced"]) == (0.75, 1)
    assert [c["outcome"] for c in facts["calls"]] == [e.outcome for e in CALLS]
    with pytest.raises(StorageError, match=r"ledger\.json"):
        filled().save(tmp_path / "missing", Prices())


def test_a_budget_is_kept_by_threads_together() -> None:
    account, sent, refused = Account(), [], []
    gate = threading.Barrier(8)

    def call() -> None:
        gate.wait(LONG)
        try:
            with account.reserving(0.3, 1.0, "a call") as enter:
                sent.append(1)
                enter(Entry("s", "q", money=0.3))
        except BudgetError as error:
            refused.append(str(error))

    at_once(*[call] * 8)
    assert (len(sent), len(refused)) == (3, 5)
    assert account.money == pytest.approx(0.9)
    assert "budget of 1" in refused[0] and "a call" in refused[0]


def test_calls_under_way_are_waited_for() -> None:
    account, looks = Account(), []

    def end_the_other() -> None:
        looks.append(1)
        if len(looks) == 2:
            threading.Thread(target=first.close).start()

    with contextlib.ExitStack() as first:
        enter = first.enter_context(account.reserving(0.9, 1.0, "one"))
        first.callback(enter, Entry("s", "q", money=0.1))
        with account.reserving(0.9, 1.0, "two", end_the_other):
            assert len(looks) >= 2
    assert account.money == 0.1


def test_waiting_for_calls_under_way_can_be_stopped() -> None:
    def stop() -> None:
        raise StoppedError("stopped")

    account = Account()
    with account.reserving(0.9, 1.0, "one"):
        waiting = account.reserving(0.2, 1.0, "two", stop)
        with pytest.raises(StoppedError):
            waiting.__enter__()
    with account.reserving(1.0, 1.0, "three"):
        pass


def test_a_budget_refuses_what_has_no_price() -> None:
    with pytest.raises(BudgetError, match="price table"), Account().reserving(None, 5.0, "a call"):
        raise AssertionError
    named = Account().reserving(None, 5.0, "a call", model="brush-9")
    with pytest.raises(BudgetError, match=r'add \[models\."brush-9"\]'), named:
        raise AssertionError
    with Account().reserving(None, None, "a call"):
        pass


def test_prices_are_found_under_dated_and_prefixed_names() -> None:
    prices = Prices(models={"m-1": Price(input=2.0, output=8.0), "p/m-1": Price(call=1.0)})
    assert prices.price("m-1") == prices.price("m-1-2026-01-31") == Price(2.0, 8.0)
    assert prices.price("other/m-1-260131") == Price(2.0, 8.0)
    assert prices.price("p/m-1") == Price(call=1.0)
    assert prices.price("m-1-mini") is None
    assert prices.price("") is None


def test_a_server_is_a_price_for_what_is_not_listed() -> None:
    prices = Prices(models={"m": Price(1.0), "@box": Price(), "@box:81": Price(call=2.0)})
    assert prices.price("other", "box:80") == prices.price("", "box") == Price()
    assert prices.price("other", "box:81") == Price(call=2.0)
    assert prices.price("m", "box:81") == Price(1.0)
    assert prices.price("other", "abox") is None


def test_a_price_is_of_tokens_images_and_calls() -> None:
    price = Price(input=2.0, output=8.0, image=0.5, call=0.25)
    assert price.of(1_000_000, 500_000, 2) == 2.0 + 4.0 + 1.0 + 0.25


def test_the_shipped_prices_are_dated() -> None:
    prices = Prices.default()
    assert prices.date.startswith("20") and prices.currency == "USD"
    free = {name for name, p in prices.models.items() if not p.of(1, 1, 1)}
    assert free == set()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("= 1", "is not valid TOML"),
        ("modles = 1", "Did you mean 'models'"),
        ("models = 1", "must be a table"),
        ('[models."m"]\nimput = 1', "Did you mean 'input'"),
        ('[models."m"]\ninput = "1"', "m: input must"),
        ('[models."m"]\ninput = -1', ">= 0"),
        ("[models]\nm = 2", "a price must be a table"),
    ],
)
def test_a_wrong_table_is_told(tmp_path: Path, text: str, words: str) -> None:
    (tmp_path / "prices.toml").write_text(text)
    with pytest.raises(InputError, match=words):
        Prices.load(tmp_path / "prices.toml")


def test_a_missing_table_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot be read"):
        Prices.load(tmp_path / "prices.toml")
