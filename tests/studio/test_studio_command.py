"""The command: what it says, and what it refuses before it begins."""

import sys
from pathlib import Path

import pytest
from command import Shell, command

from tabletopgen_web import frontend
from tabletopgen_web.studio.server import listener


@pytest.fixture
def serving(monkeypatch: pytest.MonkeyPatch, static: Path) -> list[tuple]:
    """Return the application of the command without serving it."""
    served: list[tuple] = []
    monkeypatch.setattr(frontend, "static_folder", lambda: static)
    monkeypatch.setattr(listener, "serve", lambda *told: served.append(told))
    return served


def test_it_listens_on_this_machine_alone(serving: list, tmp_path: Path, shell: Shell) -> None:
    shown = shell("studio", "--folder", str(tmp_path / "own"), "--no-browser")
    ((_, socket, access, browse, _),) = serving
    link = access.link
    assert link.startswith("http://127.0.0.1:") and len(link.partition("?token=")[2]) >= 32
    assert not browse and shown.err == ""
    assert link.partition("?token=")[2] not in (tmp_path / "own" / "studio.json").read_text()
    assert socket.fileno() == -1, "closed again"


def test_another_host_is_warned_of(serving: list, tmp_path: Path, shell: Shell) -> None:
    shown = shell("studio", "--folder", str(tmp_path / "own"), "--host", "0.0.0.0")
    assert "warning: 0.0.0.0 accepts unencrypted connections" in shown.err
    assert serving[0][3], "a browser is opened"


@pytest.mark.parametrize("options", [
    ("--port", "70000"), ("--port", "-1"), ("--workers", "0"), ("--workers", "65"), ("--host", " "),
])  # fmt: skip
def test_settings_out_of_range_are_refused(
    serving: list, tmp_path: Path, options: tuple[str, ...]
) -> None:
    assert command("studio", "--folder", str(tmp_path / "own"), *options) == 2
    assert not serving and not (tmp_path / "own").exists()


def test_a_host_of_another_machine_is_refused(serving: list, tmp_path: Path, shell: Shell) -> None:
    shown = shell("studio", "--folder", str(tmp_path / "own"), "--host", "192.0.2.1", code=3)
    assert "192.0.2.1" in shown.err and shown.err.count("\n") <= 2


def test_a_missing_package_is_named(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, shell: Shell
) -> None:
    monkeypatch.setitem(sys.modules, "uvicorn", None)
    shown = shell("studio", "--folder", str(tmp_path / "own"), code=3)
    assert "uvicorn" in shown.err and "pip install 'tabletopgen[studio]'" in shown.err
    assert not (tmp_path / "own").exists()
