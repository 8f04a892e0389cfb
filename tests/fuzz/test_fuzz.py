"""Hostile input of every kind gives a result or an error of the package, within limits.

A failure names the case; ``benchmarks/fuzz.py --kind K --case N --seed S`` runs it again.
"""

from collections.abc import Iterator

import pytest
from extent import count
from hostile.harness import Worker, report, run_cases
from hostile.targets import KINDS

CASES = count(300, 60)
IN_CHILDREN = count(30, 8)
"""Cases of kinds of which each starts a child process, for about a second."""

KINDS_IN_CHILDREN = (
    "mjcf", "glb-scene", "poses", "limited-model", "tencent-answer", "hunyuan3d-answer",
)  # fmt: skip


@pytest.fixture(scope="module")
def worker() -> Iterator[Worker]:
    with Worker() as started:
        yield started


@pytest.mark.slow
@pytest.mark.timeout(1200)
@pytest.mark.parametrize("kind", KINDS)
def test_hostile_input_ends_well(worker: Worker, kind: str) -> None:
    cases = IN_CHILDREN if kind in KINDS_IN_CHILDREN else CASES
    said = report(run_cases(worker, kind, 0, range(cases)))
    assert not said, said
