"""The static page's files, without a browser: rows, scene folders, the site."""

import hashlib
import io
import json
import shutil
import struct
import zipfile
from pathlib import Path

import numpy as np
import pytest
from command import Shell

from assets_cache.store import find
from generator.bundle import load, read_files, verify
from generator.bundle.encoder import dumps
from generator.errors import BackendError, InputError, StorageError
from tabletopgen_web import frontend
from tabletopgen_web.page.episodes import record_play
from tabletopgen_web.page.options import FolderOptions
from tabletopgen_web.page.robot import robot_document
from tabletopgen_web.page.rows import read_row, read_whole_row
from tabletopgen_web.page.scene_folder import scene_folder
from tabletopgen_web.page.site import write_site

QUICK = FolderOptions(formats=(), episodes=0, robot=False)


@pytest.fixture(scope="module")
def bundle() -> Path:
    return find("kitchen-cutting")[0]


@pytest.fixture
def static(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A fake front end, so that nothing is built."""
    folder = tmp_path / "static"
    (folder / "assets").mkdir(parents=True)
    for name in frontend.PAGES:
        (folder / name).write_text(name)
    (folder / "assets" / "page.js").write_text("1")
    monkeypatch.setattr(frontend, "STATIC", folder)
    return folder


def test_a_row_says_what_a_bundle_holds(bundle: Path) -> None:
    row, scene = read_whole_row(bundle)
    assert scene is not None
    assert row.theme == "kitchen"
    assert [t.name for t in row.things] == [o.name for o in scene.objects]
    assert row.gate is not None
    assert row.gate.passed
    assert row.certificate is not None
    assert 0 < row.certificate.certified <= row.certificate.instances
    assert row.difficulty is not None
    assert 0 < row.difficulty < 1


def test_a_row_of_what_is_no_bundle_says_why(tmp_path: Path, bundle: Path) -> None:
    newer = tmp_path / bundle.name
    shutil.copytree(bundle, newer)
    truth = (newer / "scene.json").read_text().replace('"schema": 1', '"schema": 99')
    (newer / "scene.json").write_text(truth)
    row, scene = read_whole_row(newer)
    assert scene is None
    assert row.error is not None
    assert "schema 99" in row.error
    missing = read_row(tmp_path / "none-0123456789ab")
    assert missing.error is not None


def test_a_scene_folder_holds_the_bundle_and_downloads(bundle: Path, tmp_path: Path) -> None:
    made = scene_folder(bundle, FolderOptions(formats=("glb", "urdf"), episodes=1))
    again = scene_folder(bundle, FolderOptions(formats=("glb", "urdf"), episodes=1))
    assert dict(made.files) == dict(again.files)
    view = json.loads(made.files["view.json"])
    named = [
        view["scene"]["xml"], *view["scene"]["files"].values(), view["picture"]["file"],
        *(d["file"] for d in view["downloads"]), *(e["file"] for e in view["episodes"]),
        view["row"]["thumbnail"], view["arm"]["xml"],
    ]  # fmt: skip
    assert {*named} <= {*made.files}
    archive = zipfile.ZipFile(io.BytesIO(made.files[f"downloads/{bundle.name}.zip"]))
    archive.extractall(tmp_path)
    assert verify(tmp_path / bundle.name) == []
    assert load(tmp_path / bundle.name).name == "kitchen-cutting"


def test_a_bundle_brings_no_web_page(bundle: Path, tmp_path: Path) -> None:
    files, truth = read_files(bundle), json.loads((bundle / "scene.json").read_bytes())
    files.pop("certificate.json", None)
    script = b"<script xmlns='http://www.w3.org/1999/xhtml'>evil()</script>"
    foreign = ("a.html", "a.JS", "a.xml", "meshes/a.svg", "textures/a.xhtml", "stages/a")
    for name in foreign:
        files[name] = script
        truth["files"][name] = {
            "bytes": len(script), "sha256": hashlib.sha256(script).hexdigest()
        }  # fmt: skip
    files["scene.json"] = dumps(truth)
    own = tmp_path / f"evil-{hashlib.sha256(files['scene.json']).hexdigest()[:12]}"
    for name, content in files.items():
        (own / name).parent.mkdir(parents=True, exist_ok=True)
        (own / name).write_bytes(content)
    made = scene_folder(own, QUICK)
    assert made.row.error is None and "bundle/scene.xml" in made.files
    served = {name for name, content in made.files.items() if content == script}
    assert not served and not any(name in made.files["view.json"].decode() for name in foreign)
    with zipfile.ZipFile(io.BytesIO(made.files[f"downloads/{own.name}.zip"])) as held:
        assert held.read(f"{own.name}/a.html") == script, "the bundle itself is whole"


def test_an_episode_fits_the_model_with_the_robot(bundle: Path) -> None:
    import mujoco

    _, scene = read_whole_row(bundle)
    assert scene is not None
    files = read_files(bundle)
    text = robot_document(scene, frozenset(files))
    model = mujoco.MjModel.from_xml_string(text, dict(files))
    play = record_play(bundle, "PickPlace")
    assert play.success
    assert play.rows.shape[1] == model.nq + 3
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("home").id)
    assert np.abs(data.qpos - play.rows[0, :-3]).max() < 1e-5
    raw = play.to_bytes()
    (length,) = struct.unpack("<I", raw[:4])
    header = json.loads(raw[4 : 4 + length])
    assert (4 + length) % 4 == 0
    assert len(raw) - 4 - length == 4 * header["frames"] * (header["nq"] + 3)


def test_what_the_expert_cannot_do_is_an_error(bundle: Path) -> None:
    with pytest.raises(InputError, match="Unknown task 'Juggle'"):
        record_play(bundle, "Juggle")


def test_a_site_is_written_whole_and_replaces_only_a_site(
    bundle: Path, tmp_path: Path, static: Path
) -> None:
    out = tmp_path / "site"
    broken = tmp_path / "broken-0123456789ab"
    broken.mkdir()
    (broken / "scene.json").write_text("{")
    site = write_site([bundle, broken], out, "Mine", QUICK)
    assert {"index.html", "assets", "gallery.json", "scenes"} <= {p.name for p in out.iterdir()}
    assert (out / "index.html").read_text() == "page.html"
    gallery = json.loads((out / "gallery.json").read_text())
    assert gallery["title"] == "Mine"
    assert [s["error"] is None for s in gallery["scenes"]] == [True, False]
    assert (out / gallery["scenes"][0]["thumbnail"]).is_file()
    files = [p for p in out.rglob("*") if p.is_file() and p.name != ".tabletopgen-page"]
    assert abs(site.bytes - sum(p.stat().st_size for p in files)) < 100
    before = {p.relative_to(out): p.read_bytes() for p in files}
    write_site([bundle, broken], out, "Mine", QUICK)
    assert {p.relative_to(out): p.read_bytes() for p in files} == before
    foreign = tmp_path / "foreign"
    foreign.mkdir()
    (foreign / "thesis.tex").touch()
    with pytest.raises(InputError, match="contains files that do not belong to a page"):
        write_site([bundle], foreign, options=QUICK)
    assert (foreign / "thesis.tex").exists()
    with pytest.raises(InputError, match="Two bundles"):
        write_site([bundle, bundle], out, options=QUICK)


def test_the_command_says_one_where_there_is_one(
    static: Path, tmp_path: Path, shell: Shell
) -> None:
    page = shell.of("page", "--formats", "glb", "--episodes", "0", "--no-robot",
                    "--out", str(tmp_path / "site"))  # fmt: skip
    assert " 1 scene, " in page("kitchen-cutting").out
    assert " 2 scenes, " in page("kitchen-cutting", "coffee-oval").out


def test_a_site_that_fails_leaves_nothing(
    bundle: Path, tmp_path: Path, static: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object, **__: object) -> int:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(StorageError, match="No space left"):
        write_site([bundle], tmp_path / "site", options=QUICK)
    assert {p.name for p in tmp_path.iterdir()} == {"static"}


@pytest.mark.parametrize("checkout", [True, False])
def test_a_missing_front_end_says_what_is_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, checkout: bool
) -> None:
    source = tmp_path / "web"
    source.mkdir()
    if checkout:
        (source / "package-lock.json").touch()
    monkeypatch.setattr(frontend, "STATIC", tmp_path / "static")
    monkeypatch.setattr(frontend, "SOURCE", source)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(BackendError, match=r"Node\.js" if checkout else "Reinstall tabletopgen"):
        frontend.static_folder()
