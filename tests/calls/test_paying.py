"""Commands with paid calls: the ledger, the budget, the dry run, the response cache."""

import errno
import json
import shutil
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from command import Shell, Shown
from paid_server import KEY, Says, Served, ask, remote_backend, serving
from toy import toy_scene

from generator import bundle
from generator.backends import select
from generator.calls.money.database import FILE
from generator.physics.gate import judge
from generator.scene import Scene

TEXT = "a desk with a mug"


@pytest.fixture(scope="module")
def scene() -> Scene:
    made = toy_scene()
    return made.replace(report=judge(made))


@pytest.fixture
def server(scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Served]:
    """A server, a backend "remote" with one request per scene, and a price table."""
    remote_backend(monkeypatch, tmp_path)
    monkeypatch.setenv("TABLETOPGEN_CACHE", str(tmp_path / "scenes"))
    monkeypatch.setenv("TABLETOPGEN_CALLS", str(tmp_path / "usual"))
    with serving([Says()]) as served:

        def generate(source: str, backends: Any, *rest: Any, **others: Any) -> Any:
            assert backends.imager.session is backends.modeler.session
            ask(backends.modeler.session, served.url, source)
            return SimpleNamespace(
                scene=scene,
                seconds={},
                match=None,
                save=lambda folder, allow_failed: bundle.save(scene, folder),
            )

        monkeypatch.setattr("generator.pipeline.generate", generate)
        yield served


@pytest.fixture
def generate(tmp_path: Path, shell: Shell) -> Shell:
    """The command with the backend "remote" at the test prices."""
    return shell.of(
        "generate", TEXT, "--backend", "remote", "--prices", str(tmp_path / "prices.toml")
    )


@pytest.mark.slow
def test_what_was_paid_is_printed_and_lies_beside_the_bundle(
    server: Served, generate: Shell
) -> None:
    first, *_, head, row, total = generate().out.splitlines()
    assert head.split()[-1] == "EUR"
    assert row.split()[:3] == ["cloud", "plan_scene", "m"]
    assert total.split()[0] == "total" and total.split()[-1] == "0.0200"
    ledger = Path(first) / "ledger.json"
    assert json.loads(ledger.read_text())["money"] == 0.02
    assert KEY not in ledger.read_text()
    assert bundle.verify(first) == []


def test_the_second_time_is_free_and_says_so(server: Served, generate: Shell) -> None:
    path = Path(generate("--json").facts["bundle"])
    told = generate("--json", "--budget", "0").facts["ledger"]
    assert [call["outcome"] for call in told["calls"]] == ["answered", "cached"]
    assert [call["earlier"] for call in told["calls"]] == [True, False]
    assert told["money"] == 0.02 and "0.0200 was spent by earlier runs" in told["notes"][0]
    assert len(server.asked) == 1
    kept = json.loads((path / "ledger.json").read_text())
    assert [call["outcome"] for call in kept["calls"]] == ["answered"]  # what the bundle cost


def test_answers_are_kept_where_asked(server: Served, generate: Shell, tmp_path: Path) -> None:
    generate("--calls", str(tmp_path / "mine"))
    assert (tmp_path / "mine").is_dir() and not (tmp_path / "usual").exists()
    generate()
    assert (tmp_path / "usual").is_dir() and len(server.asked) == 2


def test_a_budget_ends_the_command_before_the_call(server: Served, generate: Shell) -> None:
    assert "budget of 0.01" in generate("--budget", "0.01", code=3).err
    assert server.asked == []


def test_a_dry_run_prints_the_calls_and_sends_none(
    server: Served, generate: Shell, tmp_path: Path
) -> None:
    *roles, call, rest = generate("--dry-run").out.splitlines()
    assert roles[0].split() == ["reasoner", "remote"] and len(roles) == 5
    assert call.startswith("Would call cloud, plan_scene (m), for at most 0.0400 EUR")
    assert "Nothing was sent" in rest
    told = generate("--dry-run", "--json").facts
    assert told["dry_run"] == [call]
    assert told["backends"] == {role: {"name": "remote"} for role in select.PROTOCOLS}
    assert server.asked == [] and not (tmp_path / "scenes").exists()


def test_a_dry_run_says_what_each_role_is(server: Served, generate: Shell) -> None:
    more = ("--segmenter", "embedded", "--modeler", "remote", "--encoder", "huggingface")
    roles = generate("--dry-run", *more).out.splitlines()[:5]
    assert [line.split()[:2] for line in roles] == [
        ["reasoner", "remote"], ["imager", "remote"], ["segmenter", "embedded"],
        ["modeler", "remote"], ["encoder", "huggingface"],
    ]  # fmt: skip
    assert "weights=dinov2" in roles[4]


@pytest.fixture
def failed(server: Served, generate: Shell, monkeypatch: pytest.MonkeyPatch) -> Shown:
    """A run whose bundle cannot be written, after its calls were paid for."""

    def full(*given: object, **more: object) -> Path:
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patched:
        patched.setattr("generator.bundle.folder.publish", full)
        return generate(code=5)


def test_a_failure_after_a_paid_call_says_what_it_cost(failed: Shown, tmp_path: Path) -> None:
    told = failed.err
    assert "plan_scene" in told and "0.0200" in told and "kept" in told
    path = tmp_path / "usual" / FILE
    assert str(path) in told and b'"money": 0.02' in path.read_bytes()
    assert told.splitlines()[-1].startswith("error: ")


@pytest.mark.slow
def test_a_run_that_failed_counts_for_the_next_ones_budget_and_ledger(
    generate: Shell, failed: Shown, tmp_path: Path
) -> None:
    for answer in (tmp_path / "usual" / "answers").glob("*/*"):
        answer.unlink()  # so that it has to be paid for again
    assert "0.0200 of the budget of 0.05 is spent" in generate("--budget", "0.05", code=3).err
    path = Path(generate("--budget", "0.06").out.splitlines()[0])
    assert json.loads((path / "ledger.json").read_text())["money"] == 0.04
    generate("--seed", "1", "--budget", "0.05")  # another scene


def test_what_a_failed_run_had_answered_is_in_the_next_ones_ledger(
    server: Served, generate: Shell, failed: Shown
) -> None:
    path = Path(generate().out.splitlines()[0])
    assert len(server.asked) == 1
    assert json.loads((path / "ledger.json").read_text())["money"] == 0.02


def test_a_wrong_price_table_is_bad_input(server: Served, generate: Shell, tmp_path: Path) -> None:
    (tmp_path / "prices.toml").write_text("modles = 1")
    generate(code=2)
    assert server.asked == []


def test_a_dry_run_that_needs_no_call_makes_nothing(
    server: Served, generate: Shell, tmp_path: Path
) -> None:
    generate()  # its answer is kept
    shutil.rmtree(tmp_path / "scenes")
    for names in ((), ("--backend", "embedded")):
        assert "No server would be called. Nothing was made" in generate("--dry-run", *names).out
    told = generate("--dry-run", "--json", "--figures", str(tmp_path / "figures"))
    assert told.facts["dry_run"] == []
    assert not (tmp_path / "scenes").exists() and not (tmp_path / "figures").exists()
    assert len(server.asked) == 1
