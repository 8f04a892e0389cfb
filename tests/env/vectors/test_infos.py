"""Infos sent between processes equal those of Gymnasium's vector environments."""

import pickle
from typing import Any

import numpy as np
import pytest
from rollouts import same

from tabletopgen_env.parallel.workers.infos import NUMBERS, InfoReader, InfoWriter, merge

PLAIN: dict[str, Any] = {
    "reward_terms": {"reach": 0.25, "success": 0.0}, "success": False, "goals": (0, 2),
    "target": None, "scene": "desk", "count": 3, "off_table": (),
}  # fmt: skip


def through(slots: list[list[dict[str, Any]]]) -> tuple[list[Any], list[Any], list[int]]:
    """Return the received and expected infos of each step, and the number of sent changes."""
    count = len(slots[0])
    numbers = np.zeros((NUMBERS, count))
    halves = [InfoWriter(numbers[:, :1], 0), InfoWriter(numbers[:, 1:], 1)]
    reader = InfoReader(numbers)
    read, expected, sent = [], [], []
    for infos in slots:
        changes = [halves[k > 0].write(max(0, k - 1), info) for k, info in enumerate(infos)]
        told = pickle.loads(pickle.dumps([change for change in changes if change is not None]))
        reader.take(told)
        read.append(reader.read_all())
        expected.append(merge(count, enumerate(infos)))
        sent.append(len(told))
    return read, expected, sent


def test_numbers_alone_send_nothing() -> None:
    steps = [
        [PLAIN | {"reward_terms": {"reach": 0.1 * t + k, "success": float(k)}, "count": t}
         for k in range(3)]
        for t in range(4)
    ]  # fmt: skip
    read, expected, sent = through(steps)
    assert same(read, expected) and sent == [3, 0, 0, 0]
    assert read[0]["count"].dtype == np.int64 and read[0]["success"].dtype == bool


@pytest.mark.parametrize(
    "change",
    [
        {"scene": "lab"}, {"goals": (1, 2)}, {"goals": (True, 2)}, {"target": "mug"}, {"more": 1},
        {"reward_terms": {"reach": 1.0}}, {"reward_terms": {}}, {"reward_terms": 0.5},
        {"success": 1}, {"count": 2**60}, {"count": np.int32(7)}, {"grid": np.arange(3.0)},
        {"list": ["a"]}, {"randomization": {"start": {"joints": [1.0], "moved": {}}}},
        {"final_obs": {"a": np.zeros(2)}, "final_info": {**PLAIN, "deep": {"x": {"y": -0.0}}}},
        {f"n{k}": float(k) for k in range(NUMBERS)},
    ],
    ids=str,
)  # fmt: skip
def test_what_changes_in_a_slot_arrives(change: dict[str, Any]) -> None:
    later = [PLAIN, PLAIN | change, PLAIN]
    read, expected, sent = through([[PLAIN] * 3, later, later, [PLAIN] * 3, [PLAIN] * 3])
    assert same(read, expected) and sent[1] == 1 and sent[4] == 0


def test_numbers_that_are_not_finite_or_not_exact_arrive() -> None:
    odd = [PLAIN | {"count": v, "x": x} for v, x in ((2**53, np.inf), (2**63 - 1, -1e300))]
    (read,), (expected,), _ = through([odd])
    assert same(read, expected)
    (read,), _, _ = through([[PLAIN | {"x": np.nan}] * 2])
    assert np.isnan(read["x"]).all()


def test_a_list_that_is_changed_in_place_is_sent_again() -> None:
    numbers, held = np.zeros((NUMBERS, 1)), ["a"]
    writer, reader = InfoWriter(numbers, 0), InfoReader(numbers)
    for _ in range(2):
        change = writer.write(0, {"list": held})
        assert change is not None
        reader.take([pickle.loads(pickle.dumps(change))])
        assert reader.read_all()["list"].tolist() == [held]
        held.append("b")


def test_what_was_read_is_not_written_to_again() -> None:
    numbers = np.zeros((NUMBERS, 1))
    writer, reader = InfoWriter(numbers, 0), InfoReader(numbers)
    change = writer.write(0, PLAIN)
    assert change is not None
    reader.take([change])
    first, second = reader.read_all(), reader.read_all()
    first["reward_terms"]["reach"][:] = first["_scene"][:] = 9
    first["scene"][:] = "no"
    writer.write(0, PLAIN | {"count": 4})
    assert second["count"] == 3 and second["scene"] == "desk" and second["_scene"].all()
    assert second["reward_terms"]["reach"] == 0.25
