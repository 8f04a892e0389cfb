"""Baselines of TabletopBench: players without training, the shipped policies, and the leaderboard.

    python benchmarks/bench.py --workers 2                  # all, resumes
    python benchmarks/bench.py --player expert --suite lift-test

Each player runs the test suites of its tasks, with and without randomisation, as by ``tabletopgen
bench run PLAYER --suite SUITE``. Results are written to ``results/bench/``, one file each; a second
run resumes and repeats nothing. The leaderboard includes all results of test suites in that folder,
also those of others.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from generator.jobs.pools import PoolOptions
from tabletopgen_env.bench.leaderboard import page, read_results
from tabletopgen_env.bench.players import SIMPLE
from tabletopgen_env.bench.results import read_result
from tabletopgen_env.bench.run import BenchRun, run_suite
from tabletopgen_env.bench.suites import find_suite, names
from tabletopgen_env.learning.policies import load_policy, shipped_policies

RESULTS = Path(__file__).parent / "results"
PLAYERS = ("random", "expert", *shipped_policies())


def fits(player: str, suite: str) -> bool:
    """Return whether a player supports the task of a suite."""
    if player in SIMPLE:
        return True
    return load_policy(player).card.task.lower() == suite.partition("-")[0]


def main() -> None:
    tests = [name for name in names() if "-test" in name]
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument(
        "--player", action="append", choices=PLAYERS, help="a player; may be repeated"
    )
    parser.add_argument("--suite", action="append", choices=names(), help="may be repeated")
    parser.add_argument("--tables", type=Path, help="folder of the tables")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--out", type=Path, default=RESULTS)
    args = parser.parse_args()
    run = BenchRun(args.out / "bench", tables=args.tables, pool=PoolOptions(args.workers))
    for suite in args.suite or tests:
        for player in args.player or PLAYERS:
            if fits(player, suite):
                result = read_result(run_suite(find_suite(suite), player, run))
                print(f"{suite}, {player}: {result.solved} of {len(result.episodes)}", flush=True)
    text = page(r for r in read_results(args.out / "bench") if r.suite in tests)
    (args.out / "leaderboard.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
