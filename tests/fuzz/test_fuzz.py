"""Hostile input of every kind gives a result or an error of the package, within limits.

A failure names the case; ``benchmarks/fuzz.py --kind K --case N --seed S`` runs it again.
"""

from collections.abc import Iterator

import pytest
from hostile.harness import Worker, report, run_cases
from hostile.targets import KINDS

CASES = 300
IN_CHILDREN = {"mjcf": 30, "glb-scene": 30, "poses": 30, "limited-model": 30}
"""Cases of kinds of which each starts a child process, for about a second."""


@pytest.fixture(scope="module")
def worker() -> Iterator[Worker]:
    with Worker() as started:
        yield started


@pytest.mark.slow
@pytest.mark.timeout(1200)
@pytest.mark.parametrize("kind", KINDS)
def test_hostile_input_ends_well(worker: Worker, kind: str) -> None:
    said = report(run_cases(worker, kind, 0, range(IN_CHILDREN.get(kind, CASES))))
    assert not said, said
