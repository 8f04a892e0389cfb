"""Retry delays grow with a bound; a circuit breaker stops calls to failing servers."""

from datetime import UTC, datetime

import pytest

from generator.calls.http.retries import Breaker, RetryPolicy, retry_after
from generator.errors import BackendError, InputError


def test_waits_double_up_to_the_longest() -> None:
    policy = RetryPolicy(first=1.0, longest=10.0)
    assert [policy.pause(k, 1.0) for k in range(5)] == [1.0, 2.0, 4.0, 8.0, 10.0]
    assert [policy.pause(k, 0.0) for k in range(5)] == [0.5, 1.0, 2.0, 4.0, 5.0]
    assert policy.pause(10**6, 1.0) == 10.0


def test_waits_are_drawn() -> None:
    drawn = {RetryPolicy().draw(0) for _ in range(8)}
    assert len(drawn) > 1 and all(0.5 <= wait <= 1.0 for wait in drawn)


def test_impatience_is_refused() -> None:
    with pytest.raises(InputError, match="factor"):
        RetryPolicy(factor=0.5)
    with pytest.raises(InputError, match="failures"):
        RetryPolicy(failures=0)


NOW = datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC)


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        (None, None), ("7", 7.0), ("0.5", 0.5), ("Fri, 02 Jan 2026 03:04:35 GMT", 30.0),
        ("Fri, 02 Jan 2026 03:04:00 GMT", 0.0), ("Fri, 02 Jan 2026 03:04:35 -0000", 30.0),
        ("-3", None), ("nan", None), ("inf", None), ("soon", None),
    ],
)  # fmt: skip
def test_retry_after_is_a_number_or_a_date(text: str | None, seconds: float | None) -> None:
    assert retry_after(text, NOW) == seconds


def test_a_breaker_opens_rests_and_lets_one_try() -> None:
    now = [0.0]
    breaker = Breaker("maker", RetryPolicy(failures=2, rest=10.0), lambda: now[0])
    line = breaker.line()
    breaker.record_failure("It is down.", line)
    breaker.check("a call")
    breaker.record_failure("It is down.", line)
    now[0] = 4.0
    with pytest.raises(
        BackendError, match=r"a call.* maker failed 2 .* It is down\. .* another 6 s"
    ):
        breaker.check("a call")
    now[0] = 10.0
    breaker.check("the trial")
    with pytest.raises(BackendError, match="another 10 s"):
        breaker.check("a call beside it")
    breaker.record_failure("Still down.", breaker.line())
    now[0] = 19.0
    with pytest.raises(BackendError, match="Still down"):
        breaker.check("a call")
    now[0] = 20.0
    breaker.check("the trial")
    breaker.record_success()
    breaker.check("a call")


def test_an_answer_in_between_starts_the_count_again() -> None:
    breaker = Breaker("maker", RetryPolicy(failures=2))
    line = breaker.line()
    for _ in range(3):
        breaker.record_failure("It is down.", line)
        breaker.record_success()
    breaker.check("a call")


def test_calls_that_fail_beside_each_other_count_once() -> None:
    breaker = Breaker("maker", RetryPolicy(failures=3))
    beside = [breaker.line() for _ in range(8)]
    for _ in range(2):
        for line in beside:
            breaker.record_failure("It is down.", line)
            breaker.check("a call")
    with pytest.raises(BackendError, match="failed 3 times"):
        breaker.record_failure("It is down.", breaker.line())  # after them
        breaker.check("a call")
