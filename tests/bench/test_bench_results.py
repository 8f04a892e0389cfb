"""Results: strict reading, paired comparison, and the leaderboard."""

import dataclasses
import html
import json
from pathlib import Path

import pytest
from command import Shell

from generator.errors import InputError
from generator.scene.provenance import versions
from tabletopgen_env.bench import comparison, leaderboard, results
from tabletopgen_env.bench.episode import SuiteOutcome
from tabletopgen_env.bench.instances import Suite
from tabletopgen_env.bench.players import SIMPLE, PlayerFacts
from tabletopgen_env.bench.run import PACKAGES
from tabletopgen_env.bench.suites import canonical_digest, find_suite, tasks
from tabletopgen_env.statistics import newcombe_paired

ROOT = Path(__file__).parents[2]


def result_of(suite: Suite, path: Path, name: str, solved: set[int]) -> results.BenchResult:
    """Write and read the result of a player that solved the episodes with these numbers."""
    done, failed = SuiteOutcome(True, 20, 0.6), SuiteOutcome(False, suite.of.time_limit, 0.25)
    rows = [
        results.row_of(episode, done if k in solved else failed)
        for k, episode in enumerate(suite.episodes())
    ]
    facts = PlayerFacts(name, name if name in SIMPLE else "function")
    results.write_result(path, results.head_of(suite, facts, versions(PACKAGES)), rows)
    return results.read_result(path)


@pytest.fixture
def toy(suite_file: Path) -> Suite:
    return find_suite(f"{suite_file}:test")


def test_a_result_is_read_as_it_was_written(toy: Suite, tmp_path: Path) -> None:
    read = result_of(toy, tmp_path / "a.json", "random", {0, 3})
    assert (read.suite, read.version, read.solved, read.share) == ("reach-test", "tiny", 2, 0.5)
    assert read.of_level("easy") == read.of_level("hard") == (1, 2)
    low, high = read.interval
    assert low < 0.5 < high


@pytest.mark.parametrize("change", [
    {"solved": 4}, {"suite": "lift-test"}, {"versions": {}}, {"more": 1}, {"episodes": []},
])  # fmt: skip
def test_an_edited_result_is_refused(toy: Suite, tmp_path: Path, change: dict) -> None:
    path = tmp_path / "a.json"
    result_of(toy, path, "random", {0})
    path.write_text(json.dumps(json.loads(path.read_text()) | change))
    with pytest.raises(InputError, match="edited or truncated"):
        results.read_result(path)


def test_a_cut_or_newer_result_is_refused(toy: Suite, tmp_path: Path) -> None:
    path = tmp_path / "a.json"
    result_of(toy, path, "random", {0})
    text = path.read_text()
    path.write_text(text[:-20])
    with pytest.raises(InputError, match="not valid JSON"):
        results.read_result(path)
    path.write_text(json.dumps(json.loads(text) | {"schema": 2}))
    with pytest.raises(InputError, match=r"schema 2.*Install a newer"):
        results.read_result(path)
    with pytest.raises(InputError, match="cannot be read"):
        results.read_result(tmp_path / "none.json")


@pytest.mark.parametrize(("change", "why"), [
    (lambda p: p.update(schema=0), "schema is 0"),
    (lambda p: p.update(solved=3), "totals"),
    (lambda p: p["episodes"][0].update(solved=1), "bool"),
    (lambda p: p["episodes"][0].update(table="x/../y"), "table"),
    (lambda p: p["episodes"][0].update(reward=[1]), "reward"),
    (lambda p: p["episodes"][0].pop("seed"), "keys"),
    (lambda p: p["episodes"][1].update(p["episodes"][0]) or p.update(solved=2), "twice"),
    (lambda p: p["player"].update(name="\x1b[2J"), "printed"),
    (lambda p: p["player"].update(digest="zz"), "digest"),
    (lambda p: p["player"].update(settings={"a": {"b": None}}), "setting"),
    (lambda p: p.update(versions={"a": 1}), "version"),
])  # fmt: skip
def test_a_result_whose_digest_was_made_to_fit_is_checked(
    toy: Suite, tmp_path: Path, change, why: str
) -> None:
    path = tmp_path / "a.json"
    result_of(toy, path, "random", {0})
    payload = json.loads(path.read_text())
    payload.pop("digest")
    change(payload)
    path.write_text(json.dumps({**payload, "digest": canonical_digest(payload)}))
    with pytest.raises(InputError, match=why):
        results.read_result(path)


def test_results_are_compared_in_pairs(toy: Suite, tmp_path: Path, shell: Shell) -> None:
    one = result_of(toy, tmp_path / "a.json", "random", {0, 1})
    two = result_of(toy, tmp_path / "b.json", "expert", {1, 2, 3})
    found = comparison.difference(two, one)
    assert (found.gained, found.lost, found.share) == (2, 1, 0.25)
    assert found.interval == newcombe_paired(1, 2, 1, 0)
    shown = shell("bench", "compare", str(tmp_path / "a.json"), str(tmp_path / "b.json")).out
    assert "2 of 4" in shown and "+25.0" in shown and "2 of 2" in shown
    rows = comparison.compare([one, two])
    assert [len(row) for row in rows] == [len(rows[0])] * 3 and rows[1][-4:] == ("",) * 4


def test_results_of_other_suites_are_not_compared(
    toy: Suite, suite_file: Path, tmp_path: Path
) -> None:
    one = result_of(toy, tmp_path / "a.json", "random", {0})
    other = find_suite(f"{suite_file}:test-random")
    two = result_of(other, tmp_path / "b.json", "random", {0})
    with pytest.raises(InputError, match="on the same suite"):
        comparison.difference(two, one)
    fewer = dataclasses.replace(one, episodes=one.episodes[:2])
    with pytest.raises(InputError, match="different episodes"):
        comparison.difference(fewer, one)
    with pytest.raises(InputError, match="at least one"):
        comparison.compare([])


def test_the_paired_interval_is_newcombes() -> None:
    low, high = newcombe_paired(36, 12, 2, 0)  # his table II
    assert (round(low, 4), round(high, 4)) == (0.0569, 0.3404)
    assert newcombe_paired(0, 0, 0, 0) == (-1.0, 1.0)
    low, high = newcombe_paired(0, 0, 0, 30)
    assert low == -high and 0 < high < 0.13
    assert newcombe_paired(5, 3, 1, 4)[0] == -newcombe_paired(5, 1, 3, 4)[1]


# ------------------------------------------------------------------------------------- leaderboard


@pytest.fixture(scope="module")
def lift() -> tuple[Suite, Suite]:
    """The shipped test suites of the first task."""
    task = tasks()[0].lower()
    return find_suite(f"{task}-test"), find_suite(f"{task}-test-random")


def test_the_page_has_a_row_for_each_policy(
    lift: tuple[Suite, Suite], tmp_path: Path, shell: Shell
) -> None:
    plain, random = lift
    every = set(range(len(random.episodes())))
    result_of(plain, tmp_path / "1.json", "random", set())
    result_of(random, tmp_path / "2.json", "random", {0})
    result_of(random, tmp_path / "3.json", "expert", every)
    out = tmp_path / "page.md"
    shell("bench", "leaderboard", str(tmp_path), "--out", str(out))
    rows = [line for line in out.read_text().splitlines() if line.startswith(("| exp", "| rand"))]
    assert len(rows) == 2 and rows[0].startswith("| expert | the world | – | **100.0**")
    assert rows[1].startswith("| random | nothing | **0.0**")
    assert shell("bench", "leaderboard", str(tmp_path)).out == out.read_text()


def test_results_of_other_suites_are_not_shown(
    toy: Suite, lift: tuple[Suite, Suite], tmp_path: Path
) -> None:
    with pytest.raises(InputError, match="contains no results"):
        leaderboard.read_results(tmp_path)
    other = result_of(toy, tmp_path / "a.json", "random", {0})
    with pytest.raises(InputError, match="different episodes"):
        leaderboard.page([other])
    own = result_of(lift[0], tmp_path / "b.json", "random", {0})
    with pytest.raises(InputError, match="two results of random"):
        leaderboard.page([own, own])
    with pytest.raises(InputError, match="different episodes"):
        leaderboard.page([dataclasses.replace(own, episodes=own.episodes[1:])])
    with pytest.raises(InputError, match="only accepts test suites"):
        leaderboard.page([dataclasses.replace(own, suite="lift-validation")])


def test_text_of_a_result_stays_in_its_cell(lift: tuple[Suite, Suite], tmp_path: Path) -> None:
    name = "x | **100.0** | <img src=x onerror=alert(1)> `[a](b)` &amp; \\"
    sees = {"observation": "state | <b>all</b>"}
    facts = PlayerFacts(name, "function", settings=sees)
    read = dataclasses.replace(result_of(lift[0], tmp_path / "a.json", "x", set()), player=facts)
    (row,) = (line for line in leaderboard.page([read]).splitlines() if line.startswith("| x"))
    cells = row.strip("| ").split(" | ")
    assert len(cells) == 4 + len(find_suite(lift[0].name).of.levels) + 2
    assert not set("<>`*[\\") & {*cells[0], *cells[1]}
    assert [html.unescape(cell) for cell in cells[:2]] == [name, sees["observation"]]


def test_the_committed_page_is_that_of_the_committed_results() -> None:
    folder = ROOT / "benchmarks" / "results"
    made = leaderboard.page(leaderboard.read_results(folder / "bench"))
    assert (folder / "leaderboard.md").read_text(encoding="utf-8") == made
    entries = {line.split(" | ")[0] for line in made.splitlines() if line.startswith("| ")}
    assert len(entries - {"| policy"}) >= 5
