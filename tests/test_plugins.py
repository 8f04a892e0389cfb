"""Commands of other packages: declared by them, imported when they are asked for."""

import subprocess
import sys
import textwrap
import tomllib
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest
from command import Shell, command
from tyro.extras import SubcommandApp

from generator.cli import plugins

ROOT = Path(__file__).parents[1]
OTHERS = (
    "bench", "certify", "enjoy", "grasps", "page", "plot", "record", "studio", "study", "teleop",
    "train",
)  # fmt: skip


def printed_by(code: str) -> str:
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(code)], capture_output=True, text=True, cwd=ROOT,
        check=True, timeout=300,
    )  # fmt: skip
    return done.stdout


def test_the_environments_commands_are_declared() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    declared = project["entry-points"][plugins.GROUP]
    assert tuple(sorted(declared)) == OTHERS
    found = plugins.find_commands()
    assert {name: found[name].value for name in OTHERS} == declared
    loaded = {name: plugins.load(found[name], True) for name in OTHERS}
    groups = {name for name, each in loaded.items() if isinstance(each, SubcommandApp)}
    assert groups == {"bench", "study"} and all(
        callable(loaded[name]) for name in {*loaded} - groups
    )
    assert plugins.purpose_of(found["bench"]).startswith("Play fixed suites")


def test_help_lists_them_and_loads_nothing_heavy() -> None:
    shown = printed_by("""
        import sys
        from generator import cli
        try:
            cli.run(["--help"])
        except SystemExit:
            pass
        print({"torch", "mujoco", "stable_baselines3", "matplotlib"} & set(sys.modules))
        """)
    assert all(f" {name} " in shown for name in (*OTHERS, "doctor", "generate"))
    assert shown.splitlines()[-1] == "set()"


def test_own_commands_load_none_of_them() -> None:
    code = "import sys; from generator import cli; cli.app('{}'); print({})"
    told = "'tabletopgen_env' in sys.modules, 'tabletopgen_env.recording' in sys.modules"
    assert printed_by(code.format("generate", told)).split() == ["False", "False"]
    assert printed_by(code.format("train", told)).split() == ["True", "False"]


def test_the_module_is_the_same_command() -> None:
    shown = [
        subprocess.run(
            [sys.executable, "-m", module, "train", "--help"], capture_output=True, text=True,
            cwd=ROOT, check=True, timeout=300,
        ).stdout
        for module in ("generator.cli", "tabletopgen_env")
    ]  # fmt: skip
    assert shown[0] == shown[1] and "--evaluate-every" in shown[0]


@pytest.mark.parametrize("text", ["", "[", "[project]\nname = 'other'", "project = 3"])
def test_without_a_checkout_only_what_is_installed_counts(
    text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "pyproject.toml").write_text(text)
    monkeypatch.setattr(plugins, "CHECKOUT", tmp_path)
    entry = EntryPoint("wash", "wash:up", plugins.GROUP)
    monkeypatch.setattr(plugins, "entry_points", lambda group: [entry])
    assert plugins.find_commands() == {"wash": entry}


def test_a_command_that_does_not_load_spoils_no_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, shell: Shell
) -> None:
    broken = EntryPoint("wash\x1b[2J", "no_such_module:up", plugins.GROUP)
    shadowing = EntryPoint("doctor", "no_such_module:up", plugins.GROUP)
    monkeypatch.setattr(plugins, "CHECKOUT", tmp_path)
    monkeypatch.setattr(plugins, "entry_points", lambda group: [broken, shadowing])
    shown = shell("--help")
    assert "generate" in shown.out and "cannot be loaded" in shown.err
    assert "\x1b[2J" not in shown.out + shown.err
    assert "error: The command wash" in shell(broken.name, code=2).err
    assert command("doctor", "--help") == 0
