"""``tabletopgen doctor``: what it tells, and what it never does."""

import json
import tomllib
from pathlib import Path
from typing import Any

import pytest
from command import Shell

from generator.backends.cloud.server import configuration
from generator.backends.embedded.eye import weights
from generator.backends.modelers import ai3d
from generator.cli import machine_facts as facts
from generator.cli.doctor import describe
from generator.cli.machine_facts import Probe

PROJECT = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text())["project"]
SECRET = "sk-Zq7\x1b[31mvery-secret"


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """Probes without processes, and caches in a temporary folder."""
    monkeypatch.setattr(
        facts, "probe_rendering", lambda name: Probe(name == "egl", "llvm\x1b[2Jpipe")
    )
    monkeypatch.setattr(facts, "probe_cuda", lambda: Probe(False, "no device"))
    for name in ("TABLETOPGEN_CACHE", "TABLETOPGEN_CALLS", "TABLETOPGEN_MODELS"):
        monkeypatch.setenv(name, str(tmp_path / f"{name}\x1b[2J"))
    for name in facts.KEYS:
        monkeypatch.delenv(name, raising=False)
    return tmp_path


def told(shell: Shell, *words: str) -> str:
    shown = shell("doctor", *words)
    assert shown.err == ""
    assert "\x1b" not in shown.out
    return shown.out


def test_it_tells_what_there_is(quick: Path, shell: Shell) -> None:
    text, found = told(shell), json.loads(told(shell, "--json"))
    assert set(found) == {"python", "packages", "rendering", "cuda", "extras", "models", "keys",
                          "caches"}  # fmt: skip
    assert found["packages"]["numpy"] in text
    assert found["rendering"]["egl"] == {"works": True, "said": "llvm\x1b[2Jpipe"}
    assert "MUJOCO_GL=osmesa: does not work" in text and "torch: does not work (no device)" in text
    assert set(found["extras"]) == set(PROJECT["optional-dependencies"]) - {"dev"}
    assert found["models"]["embedded"] == {"eye.safetensors": True, "judge.safetensors": True}


def test_extras_that_are_missing_come_with_the_line_that_installs_them(
    quick: Path, monkeypatch: pytest.MonkeyPatch, shell: Shell
) -> None:
    installed = facts.version
    monkeypatch.setattr(facts, "version", lambda p: None if p == "minari" else installed(p))
    line = "record: missing minari; pip install 'tabletopgen[record]'"
    assert line in told(shell)
    monkeypatch.setattr(facts, "version", lambda p: None if p == "numpy" else installed(p))
    assert "numpy: missing, reinstall tabletopgen" in told(shell)


@pytest.mark.parametrize("words", [(), ("--json",)])
def test_the_value_of_a_key_never_shows(
    words: tuple[str, ...], quick: Path, monkeypatch: pytest.MonkeyPatch, shell: Shell
) -> None:
    without = told(shell, *words)
    for name in facts.KEYS:
        monkeypatch.setenv(name, SECRET)
    shown = told(shell, *words)
    assert SECRET[:6] not in shown and "secret" not in shown
    monkeypatch.setenv(facts.KEYS[0], SECRET * 9)
    assert told(shell, *words) == shown != without, "neither its length"
    monkeypatch.setenv(facts.KEYS[0], " ")
    assert told(shell, *words) != shown, "blanks are no key"


def test_every_key_that_backends_read_is_asked_for() -> None:
    cloud = {"TABLETOPGEN_CLOUD_KEY", "TABLETOPGEN_CLOUD_IMAGE_KEY"}
    cloud |= {variable for _, variable in configuration._PROVIDERS.values()}
    assert set(facts.KEYS) == {*cloud, ai3d.SECRET_ID, ai3d.SECRET_KEY, "HF_TOKEN"}
    assert set(facts.EYE) == {weights.PATH.name, weights.JUDGE_PATH.name}


def test_caches_are_measured_and_links_not_followed(quick: Path) -> None:
    folder = quick / "sizes"
    (folder / "inner").mkdir(parents=True)
    (folder / "inner" / "a").write_bytes(bytes(1000))
    (folder / "loop").symlink_to(folder)
    (quick / "large").write_bytes(bytes(10**6))
    (folder / "link").symlink_to(quick / "large")
    assert 1000 <= facts.size(folder) < 2000
    assert facts.size(quick / "none") == 0


def test_what_is_installed_says_the_same_as_the_checkout(monkeypatch: pytest.MonkeyPatch) -> None:
    wanted = facts.requirements()
    lines = [*PROJECT["dependencies"]]
    for extra, entries in PROJECT["optional-dependencies"].items():
        lines += [f'{entry}; extra == "{extra}"' for entry in entries]
    monkeypatch.setattr(facts, "project", dict)
    monkeypatch.setattr(facts.metadata, "requires", lambda name: lines)
    assert facts.requirements() == wanted
    assert "httpx2" in wanted["cloud"] and "numpy" in wanted[""] and "dev" not in wanted


@pytest.mark.parametrize(
    ("code", "works", "said"),
    [
        ("print('first'); print('a card')", True, "a card"),
        ("raise SystemExit('no card')", False, "no card"),
        ("import os; os.abort()", False, "crashed with signal 6"),
        ("import time; time.sleep(60)", False, "no result within"),
        ("import os; raise SystemExit(os.environ['MUJOCO_GL'])", False, "osmesa"),
    ],
)
def test_a_probe_that_crashes_or_hangs_takes_nothing_down(code, works, said) -> None:
    found = facts.run(code, 5.0 if "sleep" not in code else 0.5, MUJOCO_GL="osmesa")
    assert found.works is works and said in found.said


@pytest.mark.slow
def test_the_probes_find_what_can_be_found() -> None:
    drawn = [facts.probe_rendering(name) for name in facts.GL_BACKENDS]
    assert all(probe.said for probe in (*drawn, facts.probe_cuda()))
    found: dict[str, Any] = facts.facts()
    assert describe(found)
