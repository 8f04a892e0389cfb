"""A page of two files, and applications that respond in this process."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from starlette.testclient import TestClient
from studio_clients import open_client

from tabletopgen_web.studio.queue import process


@pytest.fixture
def static(tmp_path: Path) -> Path:
    """A minimal built page."""
    folder = tmp_path / "static"
    (folder / "assets").mkdir(parents=True)
    (folder / "studio.html").write_text("<!doctype html><title>Studio</title>")
    (folder / "assets" / "studio.js").write_text("export {}")
    (folder / "assets" / "mujoco.wasm").write_bytes(b"\0asm")
    (folder / "secret").symlink_to("/etc/passwd")
    return folder


@pytest.fixture
def client(tmp_path: Path, static: Path, store: Path) -> Iterator[TestClient]:
    """A client with the token for a studio with real jobs."""
    with open_client(tmp_path / "studio", static) as client:
        yield client


@pytest.fixture
def fake(
    tmp_path: Path, static: Path, store: Path, monkeypatch: pytest.MonkeyPatch
) -> Iterator[TestClient]:
    """A client with the token for a studio with the jobs of ``fake_job``."""
    monkeypatch.setattr(process, "MODULE", "fake_job")
    monkeypatch.setattr(process, "GRACE", 0.3)
    with open_client(tmp_path / "studio", static) as client:
        yield client
