"""The default models: prices, options, and budgets."""

from collections.abc import Callable
from dataclasses import replace
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from openai_server import Running

from generator import generate
from generator.backends import Backends
from generator.backends.cloud.imager import CloudImager
from generator.backends.cloud.reasoner import CloudReasoner
from generator.backends.cloud.server.configuration import DEFAULTS, OPENAI
from generator.calls.money import prices
from generator.calls.money.prices import Prices
from generator.calls.question import question
from generator.calls.session import Session
from generator.calls.store import CallStore, StoredAnswer
from generator.errors import BudgetError

ENDED = {
    "gpt-image-1": date(2026, 10, 23), "gpt-image-1.5": date(2026, 12, 1),
    "gpt-image-1-mini": date(2026, 12, 1), "gpt-5": date(2026, 12, 11),
    "gpt-5-mini": date(2026, 12, 11), "gpt-4o": date(2027, 1, 14),
    "gpt-4o-mini": date(2027, 1, 14), "gpt-4.1": date(2027, 1, 14),
}  # fmt: skip
"""When OpenAI ends models, as its deprecations say."""


def test_the_defaults_have_prices_and_no_date_of_their_end() -> None:
    table = Prices.default()
    for model in DEFAULTS.values():
        assert model not in ENDED
        price = table.price(model, "api.openai.com")
        assert price is not None and price.output > 0
    shipped = date.fromisoformat(table.date)
    assert not [m for m, end in ENDED.items() if end < shipped and m in table.models]


@pytest.mark.parametrize(
    ("model", "taken"),
    [("gpt-image-2.6-sunburst", set()), ("gpt-image-2", set()),
     ("openai/gpt-image-2.5-flare", set()), ("gpt-image-1-mini", {"background"}),
     ("gpt-image-1.5", {"background", "input_fidelity"}),
     ("brush-1", {"background", "input_fidelity"})],
)  # fmt: skip
def test_an_edit_has_no_options_that_the_model_rejects(
    model: str, taken: set[str], server: Running, make_imager: Callable[..., CloudImager]
) -> None:
    server.script.paint = lambda request: np.full((200, 300, 3), 90, np.uint8)
    server.script.models = (model,)
    options = {"background", "input_fidelity"}
    server.script.unknown = options - taken
    painter = make_imager(model=model).painter
    painter.paint("complete", "a mug", 1.0, (np.zeros((64, 64, 3), np.uint8),), clear=True)
    (request,) = server.script.requests  # none was rejected
    assert {*request.body} & options == taken and request.body["model"] == model
    assert request.body.get("background", "transparent") == "transparent"


@pytest.mark.parametrize("role", ["reasoner", "imager"])
def test_a_budget_is_refused_before_any_call_if_a_price_is_unknown(
    role: str, server: Running, tmp_path: Path
) -> None:
    session = Session(budget=2.0)
    url = "http://models.invalid/v1"
    made = {
        "reasoner": CloudReasoner(base_url=url, model="glimpse-9", session=session),
        "imager": CloudImager(
            base_url=url, model="brush-9", chat_base_url=server.url, session=session
        ),
    }
    stages: list[str] = []
    with pytest.raises(BudgetError) as refused:
        generate(
            "a mug", Backends.select(**{role: made[role]}),
            progress=lambda stage, number, total: stages.append(stage),
        )  # fmt: skip
    name = "glimpse-9" if role == "reasoner" else "brush-9"
    said = str(refused.value)
    assert f'[models."{name}"]' in said and "--prices" in said and "budget of 2" in said
    assert str(prices.__file__).replace(".py", ".toml") in said
    assert not stages and not server.script.requests
    mine = tmp_path / "mine.toml"
    mine.write_text(f'[models."{name}"]\ninput = 1\noutput = 2\n')
    replace(made[role], session=Session(budget=2.0, prices=Prices.load(mine))).check()


def test_known_prices_servers_here_and_no_budget_are_not_refused(server: Running) -> None:
    CloudReasoner(base_url=OPENAI, model=DEFAULTS["chat"], session=Session(budget=1.0)).check()
    CloudReasoner(model="anything", session=Session(budget=1.0)).check()  # on this machine
    CloudReasoner(base_url="http://models.invalid/v1", model="anything").check()


def test_answers_that_are_kept_need_no_price(tmp_path: Path) -> None:
    session = Session(CallStore(tmp_path / "calls"), budget=2.0)
    url = "http://models.invalid/v1/chat/completions"
    reasoner = CloudReasoner("http://models.invalid/v1", "glimpse-9", session=session)

    def asked(text: str) -> dict[str, Any]:
        return {"model": "glimpse-9", "messages": [{"role": "user", "content": text}]}

    with pytest.raises(BudgetError):
        reasoner.check()  # all of it would have to be paid for
    with session.client("cloud/chat", "http://models.invalid/v1", timeout=5.0) as http:
        key = question(http.build_request("POST", url, json=asked("old")), "", Prices()).key
        assert session.store is not None
        session.store.put(key, StoredAnswer(200, "application/json", b'{"choices": []}'))
        reasoner.check()
        assert http.post(url, json=asked("old")).json() == {"choices": []}
        with pytest.raises(BudgetError, match=r'models\."glimpse-9"'):
            http.post(url, json=asked("new"))
    assert [entry.outcome for entry in session.account.entries] == ["cached"]
