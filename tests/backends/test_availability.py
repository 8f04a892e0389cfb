"""Availability of backends: all of the table, and their missing requirements."""

from pathlib import Path

import pytest

from generator.backends.availability import BackendStatus, list_backends
from generator.backends.select import TABLE

VARIABLES = (
    "TABLETOPGEN_ASSETS", "TABLETOPGEN_HUNYUAN3D_URL", "TENCENTCLOUD_SECRET_ID",
    "TENCENTCLOUD_SECRET_KEY", "TABLETOPGEN_CLOUD_KEY", "OPENAI_API_KEY", "TABLETOPGEN_SAM3D",
    "TABLETOPGEN_CLOUD_BASE_URL",
)  # fmt: skip


@pytest.fixture(autouse=True)
def bare(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """An environment without settings and weights."""
    for name in VARIABLES:
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("TABLETOPGEN_MODELS", str(tmp_path / "models"))


def found() -> dict[str, BackendStatus]:
    return {backend.name: backend for backend in list_backends()}


def test_every_backend_is_listed_with_its_roles() -> None:
    assert {name: set(b.roles) for name, b in found().items()} == {
        name: set(answers) for name, answers in TABLE.items()
    }


def test_where_nothing_is_set_the_embedded_ones_alone_answer() -> None:
    assert [name for name, backend in found().items() if not backend.lacks] == ["embedded"]
    assert [name for name, backend in found().items() if backend.charges] == ["tencent", "cloud"]


@pytest.mark.parametrize(("name", "variables"), [
    ("cloud", {"TABLETOPGEN_CLOUD_KEY": "sk-hidden-hidden"}),
    ("hunyuan3d", {"TABLETOPGEN_HUNYUAN3D_URL": "http://127.0.0.1:8080"}),
    ("tencent", {"TENCENTCLOUD_SECRET_ID": "AKIDhidden", "TENCENTCLOUD_SECRET_KEY": "hidden"}),
    ("folder", {"TABLETOPGEN_ASSETS": "."}),
])  # fmt: skip
def test_what_is_set_is_not_lacking_and_not_repeated(
    monkeypatch: pytest.MonkeyPatch, name: str, variables: dict[str, str]
) -> None:
    assert any(variable in found()[name].lacks for variable in variables)
    for variable, value in variables.items():
        monkeypatch.setenv(variable, value)
    assert found()[name].lacks == ""
    assert "hidden" not in str(list_backends())


def test_a_folder_that_is_none_is_said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("TABLETOPGEN_ASSETS", str(tmp_path / "none"))
    assert "not a folder" in found()["folder"].lacks


@pytest.mark.usefixtures("tiny_models")
def test_pulled_weights_are_found(monkeypatch: pytest.MonkeyPatch, tiny_models: Path) -> None:
    monkeypatch.setenv("TABLETOPGEN_MODELS", str(tiny_models))
    assert found()["huggingface"].lacks == ""
