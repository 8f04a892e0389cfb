"""``tabletopgen objects``: tables, pictures, exports and reports; bad words, seeds and folders."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import mujoco
import numpy as np
import pytest
from command import Shell
from PIL import Image

import tabletop_objects.catalogue as catalogue
from generator.objects.checks import mass_of
from tabletop_objects import CATEGORIES, build

ROOT = Path(__file__).parents[2]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_list_prints_a_table_or_json(shell: Shell) -> None:
    text = shell("objects", "list", "--theme", "tea").out
    rows = shell("objects", "list", "--theme", "tea", "--json").facts
    assert rows and all("tea" in row["themes"] for row in rows)
    assert all(row["key"][:6] in text for row in rows) and f"{len(rows)} objects" in text
    assert {"key", "noun", "size_m", "mass_kg", "aliases"} <= {*rows[0]}
    both = shell("objects", "list", "--theme", "tea", "--role", "container", "--json").facts
    assert 0 < len(both) < len(rows) and all("container" in row["roles"] for row in both)
    assert len(shell("objects", "list", "--json").facts) == len(CATEGORIES)


def test_search_prints_the_best_match_first(shell: Shell) -> None:
    rows = shell("objects", "search", "screw driver", "--json").facts
    assert rows[0]["key"] == "screwdriver"
    assert "screwdriver" in shell("objects", "search", "screw driver", "--limit", "1").out


@pytest.mark.parametrize(
    ("words", "parts"),
    [
        (("search", "zzqx"), ("No object matches 'zzqx'", "nearest names", "objects list")),
        (("search", " "), ("The search word is empty",)),
        (("search", "mug", "--limit", "0"), ("--limit",)),
        (("list", "--theme", "kichen"), ("Did you mean 'kitchen'",)),
        (("list", "--role", "bowl"), ("Unknown role", "container")),
        (("show", "mugg"), ("Unknown object 'mugg'", "'mug'")),
        (("check", "mugg"), ("Unknown object 'mugg'", "'mug'")),
        (("show", "mug", "--seed", "-1"), ("whole number",)),
        (("export", "mugg", "--to", "glb"), ("Unknown object 'mugg'",)),
        (("export", "mug", "--to", "glb", "--seed", "-1"), ("whole number",)),
        (("page", "--out", "page", "--theme", "kichen"), ("Did you mean 'kitchen'",)),
        (("page", "--out", "page", "--workers", "0"), ("--workers",)),
    ],
)
def test_bad_words_and_numbers_are_refused(
    words: tuple[str, ...], parts: tuple[str, ...], shell: Shell, folder: Path
) -> None:
    error = shell("objects", *words, code=2).err
    assert all(part in error for part in parts)
    assert len(error) < 800 and not [*folder.iterdir()]


@pytest.mark.parametrize(
    "words", [("show", "mug"), ("check", "mug"), ("export", "mug", "--to", "glb"), ("page",)]
)
def test_folders_that_cannot_be_written_are_refused(
    words: tuple[str, ...], shell: Shell, folder: Path
) -> None:
    (folder / "file").write_text("")
    error = shell("objects", *words, "--out", "file/below/x", code=5).err
    assert "is not a folder" in error


@pytest.mark.slow
def test_show_prints_facts_and_draws_looks(shell: Shell, folder: Path) -> None:
    text = shell("objects", "show", "coffee mug", "--seed", "2").out
    assert "mug: mug" in text and "tabletop_objects/objects/office/cups.py:" in text
    with Image.open(folder / "mug.png") as picture:
        assert picture.width == 5 * 240
        cells = np.split(np.asarray(picture)[:240], 5, axis=1)
    assert all((cell.min(axis=2) < 200).mean() > 0.02 for cell in cells)
    facts = shell("objects", "show", "mug", "--out", "it.png", "--json").facts
    assert facts["picture"] == "it.png" and facts["key"] == "mug" and facts["mass_kg"] == 0.3
    path, _, line = facts["source"].partition(":")
    source = Path(catalogue.__file__).parents[1] / path
    assert '"mug"' in source.read_text().splitlines()[int(line) - 1]


def drop(path: Path) -> tuple[mujoco.MjModel, mujoco.MjData]:
    """Simulate a document for a second."""
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    for _ in range(500):
        mujoco.mj_step(model, data)
    return model, data


@pytest.mark.slow
def test_an_exported_object_stands_in_plain_mujoco(shell: Shell, folder: Path) -> None:
    said = shell("objects", "export", "mug", "--seed", "3", "--to", "mjcf", "--out", "made").out
    assert said.strip() == "made/mug-mjcf"
    model, data = drop(folder / "made/mug-mjcf/scene.xml")
    built = build("mug", 3)
    assert model.nbody == 2 and model.njnt == 1
    assert model.body("mug").mass[0] == pytest.approx(mass_of(built), rel=1e-4)
    touching = model.geom_contype > 0
    assert model.geom_friction[touching, 0] == pytest.approx(built.physics.friction)
    assert model.geom_bodyid[touching].tolist().count(0) == 1, "one floor"
    assert data.body("mug").xpos == pytest.approx([0, 0, built.size[2] / 2], abs=1e-3)


@pytest.mark.slow
def test_check_prints_a_report_and_draws_four_sides(shell: Shell, folder: Path) -> None:
    text = shell("objects", "check", "fork").out
    assert "all checks passed" in text and "nominal size" in text and "fork-check.png" in text
    with Image.open(folder / "fork-check.png") as picture:
        assert picture.width == 2 * 280
    facts = shell("objects", "check", "fork", "--json").facts
    assert all(check["passed"] for check in facts["checks"])


NEW = '''"""Whistles (sports)."""

from ...kit.shapes import Shape, category, put_down
from ...kit.solids import block
from ...kit.surfaces import Look, plain


@category(
    "test_whistle",
    size=(0.05, 0.02, 0.02),
    mass=MASS,
    material="plastic",
    themes=("sports",),
)
def test_whistle(look: Look) -> Shape:
    """A box."""
    body = block(0.05, 0.02, 0.02, 0.004)
    return put_down([(body, plain(look.color("red", "green", "blue")))],
                    factor=look.between(0.8, 1.2))
'''


@pytest.mark.slow
def test_an_object_that_is_not_in_the_index_is_checked(folder: Path) -> None:
    """In a copy of the package, which is first on the path."""
    copy = folder / "tabletop_objects"
    shutil.copytree(Path(catalogue.__file__).parent, copy)
    (copy / "objects/sports/whistles_of_test.py").write_text(NEW.replace("MASS", "0.01"))
    done = subprocess.run(
        [sys.executable, "-m", "generator", "objects", "check", "test_whistle", "--json"],
        capture_output=True, text=True, cwd=folder, timeout=240,
        env={**os.environ, "PYTHONPATH": f"{folder}{os.pathsep}{ROOT}"},
    )  # fmt: skip
    assert done.returncode == 1, done.stderr
    report = json.loads(done.stdout)
    failed = {c["name"]: c["detail"] for c in report["checks"] if not c["passed"]}
    assert [*failed] == ["index"]
    assert "python -m tabletop_objects.index" in failed["index"]
    assert report["source"].endswith("sports/whistles_of_test.py:8")


def test_help_of_the_group_loads_no_object() -> None:
    code = (
        "import sys; from generator.cli import objects; print('generator.objects' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=120
    )
    assert done.stdout.strip() == "False"
