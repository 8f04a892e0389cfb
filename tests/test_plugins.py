"""Commands of other packages: declared by them, imported when they are asked for."""

import py_compile
import subprocess
import sys
import textwrap
import tomllib
from importlib.metadata import EntryPoint
from pathlib import Path

import pytest
from command import Shell, command
from tyro.extras import SubcommandApp

from generator import cli
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
    loaded = {name: plugins.load(found[name]) for name in OTHERS}
    groups = {name for name, each in loaded.items() if isinstance(each, SubcommandApp)}
    assert groups == {"bench", "study"} and all(
        callable(loaded[name]) for name in {*loaded} - groups
    )
    assert str(plugins.summary_of(found["bench"])).startswith("Run fixed suites")


def test_summaries_are_first_paragraphs_of_docstrings() -> None:
    for entry in cli.commands().values():
        command = plugins.load(entry)
        group = isinstance(command, SubcommandApp)
        text = sys.modules[entry.module].__doc__ if group else command.__doc__
        assert text
        assert plugins.summary_of(entry) == " ".join(text.strip().partition("\n\n")[0].split())


HEAVY = {
    "cv2", "gymnasium", "matplotlib", "mujoco", "numpy", "scipy", "stable_baselines3", "torch",
    "trimesh",
}  # fmt: skip
_LISTING = """
    import resource, sys
    from generator import cli
    try:
        cli.run(["--help"])
    except SystemExit:
        pass
    print(*sorted(sys.modules))
    print(sum(resource.getrusage(resource.RUSAGE_SELF)[:2]))
    """


def test_help_lists_all_commands_and_loads_none() -> None:
    *shown, names, seconds = printed_by(_LISTING).splitlines()
    assert all(f" {name} " in "\n".join(shown) for name in (*OTHERS, *plugins.OWN))
    loaded = set(names.split())
    assert not HEAVY & loaded
    assert not {entry.module for entry in cli.commands().values()} & loaded
    assert not {"tabletopgen_env", "tabletopgen_web", "assets_cache"} & loaded
    assert float(seconds) < 1.5  # CPU seconds, about 0.2 on an idle machine


@pytest.mark.parametrize("name", ["compose", "generate", "explain", "studio"])
def test_help_of_a_command_loads_no_heavy_library(name: str) -> None:
    code = _LISTING.replace('["--help"]', f'["{name}", "--help"]')
    *_, names, _ = printed_by(code).splitlines()
    assert not (HEAVY - {"cv2", "gymnasium", "numpy"}) & set(names.split())


@pytest.mark.slow
@pytest.mark.parametrize("name", ["bench", "certify", "grasps", "record", "teleop", "train"])
def test_help_of_the_environments_commands_loads_no_simulator(name: str) -> None:
    code = _LISTING.replace('["--help"]', f'["{name}", "--help"]')
    *_, names, seconds = printed_by(code).splitlines()
    loaded = set(names.split())
    assert not (HEAVY - {"cv2", "gymnasium", "numpy"}) & loaded
    assert not {"tabletopgen_env.env", "tabletopgen_env.tasks.registry"} & loaded
    assert float(seconds) < 2.0  # CPU seconds, about 0.35 on an idle machine


@pytest.mark.parametrize(
    ("typed", "meant"), [("compos", "compose"), ("inpsect", "inspect"), ("bnech", "bench")]
)
def test_a_misspelt_command_proposes_the_one_that_is_meant(
    typed: str, meant: str, shell: Shell
) -> None:
    error = shell(typed, "a desk", code=2).err
    assert error.startswith(f"error: Unknown command '{typed}'. Did you mean '{meant}'?")
    assert "generate" in error


def test_an_unknown_command_lists_those_that_exist(shell: Shell) -> None:
    error = shell("xyzzy", code=2).err
    assert "Did you mean" not in error and all(name in error for name in (*OTHERS, *plugins.OWN))


def test_a_command_without_source_is_imported_for_its_summary(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    package = tmp_path / "bare_plugin"
    package.mkdir()
    (package / "__init__.py").write_text("")
    made = tmp_path / "source.py"
    made.write_text("def up():\n    '''Wash up.\n\n    All of it.\n    '''\n")
    py_compile.compile(str(made), cfile=str(package / "sink.pyc"))
    monkeypatch.syspath_prepend(tmp_path)
    entry = EntryPoint("wash", "bare_plugin.sink:up", plugins.GROUP)
    assert plugins.summary_of(entry) == "Wash up."


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
        for module in ("generator", "tabletopgen_env")
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
