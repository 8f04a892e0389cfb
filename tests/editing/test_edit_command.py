"""The ``tabletopgen edit`` command."""

import shutil
from pathlib import Path

import pytest
from command import Shell, command

import assets_cache
from generator import bundle
from generator.backends import Backends
from generator.errors import InputError

pytestmark = pytest.mark.usefixtures("store")


@pytest.mark.slow
def test_remove_move_and_replace(store: Path, tmp_path: Path, shell: Shell) -> None:
    (vanity,) = assets_cache.find("vanity")
    out = tmp_path / "out"
    first = Path(
        shell("edit", "vanity", "remove", "cream_jar_1", "--out", str(out), "--json").facts[
            "bundle"
        ]
    )
    assert first.parent == out
    assert vanity.is_dir()

    put = ("--to", "-0.1", "-0.15", "--turn", "30", "--replace", "--json")
    second = Path(shell("edit", str(first), "move", "lipstick_1", *put).facts["bundle"])
    assert list(out.iterdir()) == [second]
    lipstick = bundle.load(second).object("lipstick_1")
    assert lipstick.pose.position[:2] == pytest.approx([-0.1, -0.15], abs=2e-3)
    asked = [edit.asked for edit in bundle.load(second).provenance.edits]
    assert asked == ["cream_jar_1", "to -0.1 -0.15 m turned by 30 deg"]


@pytest.mark.slow
@pytest.mark.parametrize("backend", [(), ("--backend", "embedded")])
def test_a_dry_run_makes_and_removes_nothing(
    store: Path, tmp_path: Path, shell: Shell, backend: tuple[str, ...]
) -> None:
    (vanity,) = assets_cache.find("vanity")
    mine = tmp_path / "out" / vanity.name
    shutil.copytree(vanity, mine)
    edit = ("edit", str(mine), "remove", "cream_jar_1", "--dry-run", *backend)
    assert "No server would be called. Nothing was made" in shell(*edit, "--replace").out
    assert shell(*edit, "--json").facts["dry_run"] == []
    assert [p.name for p in mine.parent.iterdir()] == [vanity.name]
    assert bundle.verify(mine) == []
    assert not store.exists()


@pytest.mark.parametrize(
    ("args", "code", "words"),
    [
        (("vanity", "swap", "lipstick"), 2, 'swap NAME "a banjo"'),
        (("vanity", "swap", "lipstick", "a mug"), 2, "Did you mean 'lipstick_1'"),
        (("vanity", "add", "a mug", "--to", "0", "0"), 2, "--to and --turn require the action"),
        (("vanity", "move", "lipstick_1"), 2, "--to X Y"),
        (("vanity", "move", "lipstick_1", "on the mirror", "--to", "0", "0"), 2, "--to X Y"),
        (("vanity", "remove", "lipstick_1", "--replace"), 5, "only bundles in the store"),
        (("vanity", "swap", "lipstick_1", "a mug", "--backend", "clod"), 3, "cloud"),
        (("vanity", "swap", "lipstick_1", "a mug", "--imager", "hunyuan3d"), 3, "has no imager"),
        (("no-such", "remove", "mug_1"), 4, "no-such"),
        (("vanity", "polish", "mug_1"), 2, "polish"),
    ],
)
def test_a_wrong_edit_is_one_clear_line(
    store: Path, shell: Shell, args: tuple[str, ...], code: int, words: str
) -> None:
    assert words in shell("edit", *args, code=code).err
    assert not store.exists()


def test_one_role_named_is_enough_to_have_it_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []

    def swap(path: Path, name: str, words: str, seed: int, backends: Backends | None) -> None:
        asked.append(backends)
        raise InputError("enough")

    monkeypatch.setattr("generator.editing.actions.swap", swap)
    for more in ((), ("--modeler", "folder")):
        assert command("edit", "vanity", "swap", "lipstick_1", "a mug", *more) == 2
    nobody, drawn = asked
    assert nobody is None
    assert drawn.identity() == Backends.select("embedded", modeler="folder").identity()
