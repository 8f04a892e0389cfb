"""The subject and the maximum cost of a request, derived from the request alone."""

from typing import Any

import httpx2
import pytest

from generator.calls.money.prices import Price, Prices
from generator.calls.question import Usage, failed, question, usage

PRICES = Prices(
    models={
        "m": Price(input=1e6, output=1e6),
        "eye": Price(input=1e6, picture=50_000),
        "i": Price(image=1.0),
        "@box": Price(call=0.5),
    }
)


def most(model: str = "m", **payload: Any) -> float:
    request = httpx2.Request("POST", "https://host/v1", json={"model": model, **payload})
    found = question(request, "cloud", PRICES).most
    assert found is not None
    return found


def test_longer_texts_and_answers_may_cost_more() -> None:
    short = most(max_tokens=10, prompt="a cup")
    assert most(max_tokens=20, prompt="a cup") == short + 10
    assert most(max_tokens=10, prompt="a cup " * 100) > short + 150
    assert most(max_tokens=10, prompt="杯" * 6000) > short + 5900  # a token a character
    assert most(prompt="a cup") > short + 1000  # an answer without a bound
    assert most(messages=["a cup"]) > 100_000  # which may think as long as it likes


@pytest.mark.parametrize("size", [90, 900_000])
def test_a_picture_is_no_text(size: int) -> None:
    url = "data:image/png;base64," + "A" * size
    shown = {"max_tokens": 10, "messages": [{"content": [{"image_url": {"url": url}}] * 2}]}
    assert 2 * 16_384 < most(**shown) < 2 * 16_384 + 100
    assert 2 * 50_000 < most("eye", **shown) < 2 * 50_000 + 100


def test_a_picture_of_the_cheapest_eye_costs_no_more_than_thought() -> None:
    # 8 tiles of 5667 tokens, and 2833: https://platform.openai.com/docs/guides/images-vision
    price = Prices.default().models["gpt-4o-mini"]
    assert price.picture >= 8 * 5667 + 2833


def test_a_server_of_ones_own_has_a_price() -> None:
    request = httpx2.Request("POST", "http://box:8081/generate", json={})
    assert question(request, "hunyuan3d", PRICES).most == 0.5


def test_each_picture_asked_for_may_cost() -> None:
    assert most("i", n=3) == 3.0
    assert most("i") == 1.0
    assert most("i", n="no number") == 1.0


def test_what_has_no_price_has_no_most() -> None:
    request = httpx2.Request("POST", "https://host/v1", json={"model": "other"})
    found = question(request, "cloud", PRICES)
    assert (found.price, found.most, found.money(usage({}))) == (None, None, None)


@pytest.mark.parametrize(
    ("told", "sums"),
    [
        ({"usage": {"input_tokens": 3, "output_tokens": 4}}, (3, 4, 0)),
        ({"usage": {"prompt_tokens": "3", "completion_tokens": None}}, (3, 0, 0)),
        (
            {"usage": {"prompt_tokens": 20, "completion_tokens": 198, "total_tokens": 623}},
            (20, 603, 0),
        ),
        ({"usage": {"prompt_tokens": 21, "completion_tokens": 0, "total_tokens": 81}}, (21, 60, 0)),
        ({"usage": {"prompt_tokens": 5, "completion_tokens": 2, "total_tokens": "?"}}, (5, 2, 0)),
        ({"usage": [1], "data": {"url": "x"}}, (0, 0, 0)),
        ({"data": [{"embedding": [1.0]}, "x", {"url": "y"}]}, (0, 0, 1)),
        ([1, 2], (0, 0, 0)),
    ],
)
def test_what_an_answer_took_is_read_where_it_is_told(told: Any, sums: tuple) -> None:
    read = usage(told)
    assert (read.tokens_in, read.tokens_out, read.images) == sums


@pytest.mark.parametrize(
    ("tokens", "price", "known"),
    [
        ((3, 4), Price(1.0, 2.0), True),
        ((3, 0), Price(1.0, 2.0), False),
        ((0, 4), Price(1.0, 2.0), False),
        ((0, 4), Price(output=2.0), True),
        ((0, 0), Price(image=1.0), True),
    ],
)
def test_an_answer_that_hides_what_it_took_costs_the_most(
    tokens: tuple[int, int], price: Price, known: bool
) -> None:
    request = httpx2.Request("POST", "https://host/v1", json={"model": "m", "messages": []})
    asked = question(request, "cloud", Prices(models={"m": price}))
    money = asked.money(Usage(*tokens))
    assert money == (price.of(*tokens, 0) if known else asked.most)


def test_errors_in_answers_are_known() -> None:
    assert failed({"error": {"code": 1}}) and failed({"Response": {"Error": {"Code": "x"}}})
    assert not failed({"error": None}) and not failed({"Response": {"JobId": "1"}})
    assert not failed([{"error": 1}])
