"""An environment uses only the calling thread and never wakes BLAS threads."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

PROBE = """
import json, os, time
from pathlib import Path

import numpy as np

from tabletopgen_env.env import make_env

def asleep():
    # Return the times each other thread has left its processor, once none runs any more.
    before = None
    while True:
        others = [t for t in Path("/proc/self/task").iterdir() if t.name != str(os.getpid())]
        now = {t.name: (t / "status").read_text().partition("voluntary")[2] for t in others}
        if now == before:
            return now
        before = now
        time.sleep(0.05)

env = make_env("dining-fruit")
start = asleep()
for seed in range(2):
    env.reset(seed=seed)
    for _ in range(5):
        env.step(env.action_space.sample())
acted = asleep()
np.ones((300, 300)) @ np.ones((300, 300))
print(json.dumps({"threads": len(start), "woken": acted != start, "tells": asleep() != acted}))
"""


@pytest.mark.skipif(not Path("/proc/self/task").is_dir(), reason="threads are told by Linux's proc")
def test_resets_and_steps_wake_no_thread_of_blas() -> None:
    two = os.environ | {"OPENBLAS_NUM_THREADS": "2", "OMP_NUM_THREADS": "2"}
    command = [sys.executable, "-c", PROBE]
    told = subprocess.run(
        command, capture_output=True, text=True, check=True, env=two, timeout=300
    ).stdout
    seen = json.loads(told)
    if not seen["tells"]:
        pytest.skip(f"numpy's BLAS has no threads of its own here ({seen['threads']} others)")
    assert not seen["woken"]
