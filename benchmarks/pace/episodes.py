"""Time random actions in one environment of any package; prints one line of JSON.

    python benchmarks/pace/episodes.py MODULE ID STEPS [KEYWORDS-AS-JSON]

Requires only gymnasium, numpy and the environment's package, since it runs in the virtual
environments of other packages. Steps and resets are timed separately; the first tenth of the steps
is for warm-up.
"""

from __future__ import annotations

import importlib
import json
import sys
import time
from typing import Any


def time_steps(module: str, name: str, steps: int, keywords: dict[str, Any]) -> dict[str, float]:
    """Return wall-clock and CPU seconds per step, and the median seconds of a reset."""
    import gymnasium

    importlib.import_module(module)
    env = gymnasium.make(f"{module}:{name}", **keywords)
    env.action_space.seed(0)
    env.reset(seed=0)
    actions = [env.action_space.sample() for _ in range(steps)]
    wall = cpu = 0.0
    resets = []
    warm = steps // 10
    for k, action in enumerate(actions):
        clock, used = time.perf_counter(), time.process_time()
        _, _, terminated, truncated, _ = env.step(action)
        if k >= warm:
            wall += time.perf_counter() - clock
            cpu += time.process_time() - used
        if terminated or truncated:
            clock = time.perf_counter()
            env.reset()
            resets.append(time.perf_counter() - clock)
    env.close()
    timed_steps = steps - warm
    resets.sort()
    middle = resets[len(resets) // 2] if resets else float("nan")
    return {"wall": wall / timed_steps, "cpu": cpu / timed_steps, "reset": middle}


if __name__ == "__main__":
    given = sys.argv[1:]
    words = json.loads(given[3]) if len(given) > 3 else {}
    print(json.dumps(time_steps(given[0], given[1], int(given[2]), words)))
