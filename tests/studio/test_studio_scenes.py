"""Scenes: found by id alone, shown, kept, removed; damaged ones are listed with what is wrong."""

import json
import os
import shutil
from pathlib import Path

import pytest
from starlette.testclient import TestClient
from studio_clients import open_client

import assets_cache
from generator.bundle import load
from generator.editing import remove
from tabletopgen_web.page.rows import theme_of

SHIPPED = next(p for p in assets_cache.find("office-desk"))


@pytest.fixture
def workspace(client: TestClient, tmp_path: Path) -> Path:
    """The workspace of the client's studio, with a bundle."""
    folder = tmp_path / "studio" / "scenes"
    own = next(p for p in assets_cache.find("lab"))
    shutil.copytree(own, folder / own.name, ignore=shutil.ignore_patterns("certificate.json"))
    return folder


def rows(client: TestClient) -> dict[str, dict]:
    return {row["id"]: row for row in client.get("/api/scenes").json()["scenes"]}


def test_the_shipped_scenes_are_listed(client: TestClient) -> None:
    found = rows(client)
    row = found[SHIPPED.name]
    assert (row["in"], row["name"], row["theme"]) == ("shipped", "office-desk", "office")
    assert row["digest"] == SHIPPED.name[-12:] and row["gate"]["passed"] and row["editable"]
    assert row["error"] is None and row["parent"] is None
    assert (row["saved"], row["edits"], row["last_edit"]) == (False, 0, "")
    assert isinstance(row["seed"], int)
    assert found[next(id for id in found if id.startswith("office-round"))]["theme"] == "office"
    assert len(row["things"]) == 6
    assert ("mug_1", "mug") in {(thing["name"], thing["label"]) for thing in row["things"]}
    assert row["table"]["size"] == [1.2, 0.624, 0.74]
    assert client.get(row["thumbnail"]).content.startswith(b"\x89PNG")
    assert client.get(f"/api/scenes/{SHIPPED.name}").json() == row
    assert len(found) == 23


def test_a_scene_is_shown_file_by_file(client: TestClient) -> None:
    base = f"/api/scenes/{SHIPPED.name}"
    view = client.get(f"{base}/view.json").json()
    assert view["row"]["id"] == SHIPPED.name
    for name, path in view["scene"]["files"].items():
        assert client.get(f"{base}/{path}").content == (SHIPPED / name).read_bytes()
    for name in ("..%2f..%2fjobs.sqlite3", "%2e%2e/x", "bundle", "x%00",
                 "bundle/scene.json/", "/etc/passwd", "bundle//scene.xml"):  # fmt: skip
        assert client.get(f"{base}/{name}").status_code == 404, name


@pytest.mark.parametrize("scene", [
    "..", "office-desk", "*", "x" * 300, "office-desk-000000000000", "../starter/office-desk",
    "a%00-000000000000", f"..%2f..%2f{SHIPPED.name}", SHIPPED.name.upper(),
])  # fmt: skip
def test_other_ids_are_nothing(client: TestClient, scene: str) -> None:
    for path in ("", "/view.json", "/history", "/thumbnail.png"):
        assert client.get(f"/api/scenes/{scene}{path}").status_code == 404
    assert client.delete(f"/api/scenes/{scene}").status_code in (404, 405)


def test_a_scene_of_the_workspace_is_saved_and_removed(
    client: TestClient, workspace: Path, store: Path
) -> None:
    (own,) = workspace.iterdir()
    path = f"/api/scenes/{own.name}"
    assert rows(client)[own.name]["in"] == "workspace"
    assert client.get(f"{path}/view.json").status_code == 200
    saved = client.post(f"{path}/save", json={})
    assert saved.status_code == 201 and saved.json()["in"] == "store"
    assert rows(client)[own.name]["saved"] and client.get(path).json()["saved"]
    assert load(store / own.name).name == "lab"
    assert client.delete(path).status_code == 204
    assert not own.exists() and not (workspace.parent / "views" / own.name).exists()
    assert rows(client)[own.name]["in"] in ("store", "shipped")
    assert client.delete(path).status_code == 409
    assert client.post(f"{path}/save", json={}).status_code == 409
    assert client.delete(f"/api/scenes/{SHIPPED.name}").status_code == 409
    assert SHIPPED.is_dir()


def damage_schema(bundle: Path) -> None:
    truth = json.loads((bundle / "scene.json").read_text())
    (bundle / "scene.json").write_text(json.dumps({**truth, "schema": 99}))


def damage_text(bundle: Path) -> None:
    (bundle / "scene.json").write_bytes(b"\xff\0 no JSON")


def damage_link(bundle: Path) -> None:
    (bundle / "scene.json").unlink()
    (bundle / "scene.json").symlink_to("/etc/passwd")


def damage_emptiness(bundle: Path) -> None:
    shutil.rmtree(bundle)
    bundle.mkdir()


@pytest.mark.parametrize(
    ("damage", "says"),
    [(damage_schema, "schema 99"), (damage_text, "JSON"), (damage_link, "link"),
     (damage_emptiness, "missing")],
)  # fmt: skip
def test_a_damaged_scene_is_listed_with_what_is_wrong(
    client: TestClient, workspace: Path, damage, says: str
) -> None:
    (own,) = workspace.iterdir()
    assert rows(client)[own.name]["error"] is None
    damage(own)
    row = rows(client)[own.name]
    assert says in row["error"] and row["things"] == [] and not row["editable"]
    path = f"/api/scenes/{own.name}"
    for answer in (
        client.get(f"{path}/view.json"),
        client.get(f"{path}/history"),
        client.get(f"{path}/thumbnail.png"),
        client.post(f"{path}/save", json={}),
    ):
        assert answer.status_code == 422, answer.text
    assert client.delete(path).status_code == 204


def test_a_changed_mesh_is_neither_shown_nor_saved(
    client: TestClient, workspace: Path, store: Path
) -> None:
    (own,) = workspace.iterdir()
    mesh = next((own / "meshes").iterdir())
    mesh.write_bytes(mesh.read_bytes() + b"\n")
    for answer in (client.get(f"/api/scenes/{own.name}/view.json"),
                   client.post(f"/api/scenes/{own.name}/save", json={})):  # fmt: skip
        assert answer.status_code == 422 and mesh.name in answer.json()["error"]
    assert not store.exists()


def test_the_history_begins_with_how_a_scene_was_made(client: TestClient) -> None:
    said = client.get(f"/api/scenes/{SHIPPED.name}/history").json()
    (step,) = said["steps"]
    assert (step["id"], step["kind"], step["exists"]) == (SHIPPED.name, "made", True)
    assert "laptop" in step["asked"] and said["later"] == []


def test_what_was_edited_last_comes_first(client: TestClient, tmp_path: Path) -> None:
    folder = tmp_path / "studio" / "scenes"
    first, second = (remove(SHIPPED, name).save(folder) for name in ("mug_1", "laptop_1"))
    for older, newer in ((first, second), (second, first)):
        os.utime(older, (1e9, 1e9))
        os.utime(newer, (2e9, 2e9))
        said = client.get(f"/api/scenes/{SHIPPED.name}/history").json()
        assert said["later"] == [newer.name, older.name]


def test_what_another_version_prepared_is_made_anew(tmp_path: Path, static: Path) -> None:
    view = f"/api/scenes/{SHIPPED.name}/view.json"
    kept = tmp_path / "studio" / "views" / SHIPPED.name / "view.json"
    for maker, stays in (("", False), ("0.0.0, schema 0", False), (None, True)):
        with open_client(tmp_path / "studio", static) as client:
            assert client.get(view).json()["schema"] == 1
        kept.write_text('{"schema": 1, "stale": true}')
        if maker is not None:
            (kept.parents[1] / "made-by").write_text(maker)
        with open_client(tmp_path / "studio", static) as client:
            assert ("stale" in client.get(view).json()) == stays


def test_themes_are_told_by_whole_words() -> None:
    assert theme_of("An office desk with a mug") == "office"
    assert theme_of("officers") == theme_of("") == ""
