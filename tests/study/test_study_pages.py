"""The page and its key: what is in them, what is not, and what cannot be made one of."""

import base64
import hashlib
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tiny_studies as tiny
import toy

from generator.bundle import save
from generator.errors import BundleError, InputError, StorageError
from generator.io.pictures import write_picture
from generator.scene import Scene
from tabletopgen_web.study import page as pages
from tabletopgen_web.study.collection import collect
from tabletopgen_web.study.design import Drawing, StudyOptions, is_post_path
from tabletopgen_web.study.key import read_key


def data_of(page: str) -> dict[str, Any]:
    found = re.search(r'<script id="study" type="application/json">(.*?)</script>', page)
    assert found
    return json.loads(found[1])


def test_a_page_names_no_method_and_no_scene(tmp_path: Path) -> None:
    methods = ("TabletopGen", "MIDI (2025)")
    page = tiny.small_study(tmp_path, methods, ("kitchen-by-midi", "desk")).page
    text = re.sub(r"base64,[A-Za-z0-9+/=]+", "", page).casefold()
    assert [word for word in ("tabletopgen", "midi", "kitchen", "desk", str(tmp_path)) if
            word in text] == []  # fmt: skip
    pictures = b"".join(base64.b64decode(p) for p in re.findall(r"base64,([\w+/=]+)", page))
    assert pictures.count(b"JFIF") == 6
    assert b"Exif" not in pictures


def test_the_key_tells_whose_each_result_is(tmp_path: Path) -> None:
    files = tiny.small_study(tmp_path)
    out, key_path = pages.write_study(files, tmp_path / "made" / "study.html")
    key = read_key(key_path)
    assert key == files.key
    shown = data_of(out.read_text())
    assert [scene["id"] for scene in shown["scenes"]] == list(key.scenes)
    assert sorted(s.name for s in key.scenes.values()) == list(tiny.SCENES)
    columns = set()
    for scene in shown["scenes"]:
        methods = [key.scenes[scene["id"]].results[one["id"]] for one in scene["results"]]
        columns.add(tuple(methods))
        for one, method in zip(scene["results"], methods, strict=True):
            shade = _mean_colour(one["views"][0])
            name = key.scenes[scene["id"]].name
            there = tiny.picture(100 * (1 + tiny.METHODS.index(method)) + int(name[-1]))
            assert np.abs(shade - there.mean((0, 1))).max() < 2
    assert len(columns) == 1  # so that the page can balance positions


def _mean_colour(url: str) -> np.ndarray:
    import io

    from PIL import Image

    raw = base64.b64decode(url.partition(",")[2])
    return np.asarray(Image.open(io.BytesIO(raw))).mean((0, 1))


def test_codes_and_columns_depend_on_the_seed(tmp_path: Path) -> None:
    made = [tiny.small_study(tmp_path / str(k), seed=k) for k in range(8)]
    first = {next(iter(files.key.scenes)) for files in made}
    orders = {tuple(next(iter(files.key.scenes.values())).results.values()) for files in made}
    assert (len(first), len(orders)) == (8, 2)


def test_the_same_study_has_the_same_bytes(tmp_path: Path) -> None:
    one, two = tiny.small_study(tmp_path / "a"), tiny.small_study(tmp_path / "b")
    assert (one.page, one.key.text()) == (two.page, two.key.text())
    other = tiny.small_study(tmp_path / "c", attention=2)
    assert other.key.study != one.key.study


def test_the_policy_allows_the_page_s_own_code_and_no_network(tmp_path: Path) -> None:
    page = tiny.small_study(tmp_path).page
    found = re.search(r'http-equiv="Content-Security-Policy" content="(.*?)"', page)
    assert found
    policy = dict(part.strip().split(" ", 1) for part in found[1].split(";"))
    code = base64.b64encode(hashlib.sha256(b"let a = 1;").digest()).decode()
    assert policy["script-src"] == f"'sha256-{code}'"
    assert policy["default-src"] == policy["connect-src"] == "'none'"
    assert "unsafe" not in found[1]
    served = tiny.small_study(tmp_path, post="/api/studies/{study}/answers")
    assert "connect-src 'self'" in served.page
    assert data_of(served.page)["post"] == f"/api/studies/{served.key.study}/answers"


def test_nothing_in_the_title_is_markup(tmp_path: Path) -> None:
    page = tiny.small_study(tmp_path, title="</script><b>bold</b>").page
    assert "<b>" not in page
    assert data_of(page)["title"] == "</script><b>bold</b>"


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"title": "Is Other better?"}, "name of the method 'other'"),
        ({"scenes": 7}, "must be at most 6"),
        ({"scenes": 2, "attention": 3}, "at most 2"),
        ({"seed": -1}, "seed"),
        ({"post": "//evil.example/x"}, "must be a path"),
        ({"min_seconds": float("nan")}, "min-seconds"),
        ({"title": "a\nb"}, "title"),
    ],
)
def test_options_that_do_not_fit_are_refused(
    tmp_path: Path, options: dict[str, Any], said: str
) -> None:
    with pytest.raises(InputError, match=said):
        tiny.small_study(tmp_path, **options)


@pytest.mark.parametrize(
    ("path", "fine"),
    [
        ("/api/studies/{study}/answers", True), ("/a", True), ("a", False), ("/", False),
        ("/a/../b", False), ("//host/a", False), ("/a?b=c", False), ("/a\\b", False),
        ("http://host/a", False), ("/{other}", False),
    ],
)  # fmt: skip
def test_posting_stays_on_the_page_s_server(path: str, fine: bool) -> None:
    assert is_post_path(path) is fine


def test_another_study_s_key_is_never_overwritten(tmp_path: Path) -> None:
    out = tmp_path / "study.html"
    pages.write_study(tiny.small_study(tmp_path), out)
    pages.write_study(tiny.small_study(tmp_path), out)  # the same one again
    before = sorted((p.name, p.read_bytes()) for p in tmp_path.glob("study.*"))
    with pytest.raises(InputError, match="key of another study"):
        pages.write_study(tiny.small_study(tmp_path, seed=1), out)
    assert sorted((p.name, p.read_bytes()) for p in tmp_path.glob("study.*")) == before


def test_a_page_that_cannot_be_written_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write = pages.write_whole

    def full(path: Path, content: str, what: str, advice: str) -> None:
        if path.suffix == ".html":
            raise StorageError("The disk is full.")
        write(path, content, what, advice)

    monkeypatch.setattr(pages, "write_whole", full)
    files = tiny.small_study(tmp_path / "pictures")
    with pytest.raises(StorageError, match="full"):
        pages.write_study(files, tmp_path / "out" / "study.html")
    assert list((tmp_path / "out").iterdir()) == []


# ------------------------------------------------------------------------------- methods' results
def bundle(folder: Path, name: str, reference: np.ndarray | None, shift: float = 0.0) -> Path:
    thing = toy.toy_object("mug_1", (0.1, 0.1, 0.1), (shift, 0.0))
    scene: Scene = toy.toy_scene((thing,), name=name)
    images = {} if reference is None else {"reference": reference}
    return save(scene, folder, images=images, allow_failed=True)


def test_bundles_are_matched_by_their_picture_and_drawn(tmp_path: Path) -> None:
    bundle(tmp_path / "a", "desk", tiny.picture(1))
    bundle(tmp_path / "b", "other-name", tiny.picture(1), 0.2)
    write_picture(tiny.picture(5), tmp_path / "c" / "desk.png")
    write_picture(tiny.picture(6), tmp_path / "c" / "desk.above.png")
    folders = {name: tmp_path / name for name in "abc"}
    (scene,), ignored = collect(folders, None, Drawing(above=True, side=256))
    assert (scene.name, ignored) == ("desk", [])
    assert [len(scene.results[m]) for m in "abc"] == [2, 2, 2]
    assert len({raw for views in scene.results.values() for raw in views}) == 6


def test_an_input_picture_matches_what_bundles_kept_of_it(tmp_path: Path) -> None:
    for name in "ab":
        bundle(tmp_path / name, "desk", tiny.picture(1))
    write_picture(tiny.picture(1), tmp_path / "inputs" / "photo.png")
    write_picture(tiny.picture(2), tmp_path / "inputs" / "unused.png")
    (tmp_path / "a" / "summary.json").write_text("{}")
    folders = {name: tmp_path / name for name in "ab"}
    (scene,), ignored = collect(folders, tmp_path / "inputs", Drawing(side=128))
    assert scene.name == "photo"
    assert [Path(text.split(" ")[0]).name for text in ignored] == ["summary.json", "unused"]


def test_results_that_do_not_fit_are_refused(tmp_path: Path) -> None:
    folders = tiny.write_pictures(tmp_path)
    inputs = tmp_path / "inputs"

    def refused(said: str, where: Path | None = inputs, **drawing: Any) -> None:
        with pytest.raises((InputError, BundleError), match=said):
            collect(folders, where, Drawing(**drawing))

    refused("None of the results includes its input picture", None)
    refused("no picture from above.*scene-0.above.png", above=True)
    (folders["other"] / "scene-3.png").rename(tmp_path / "kept.png")
    refused("other lacks scene-3")
    write_picture(tiny.picture(9), folders["other"] / "scene-33.png")
    refused(r"scene-33.png.*no input picture fits. Did you mean 'scene-3'\?")
    (folders["other"] / "scene-33.png").unlink()
    (folders["other"] / "scene-3.png").write_bytes(b"no picture")
    refused("scene-3.png: The picture cannot be read: its format is not supported")
    (tmp_path / "kept.png").rename(folders["other"] / "scene-3.png")
    (folders["other"] / "scene-3.jpg").write_bytes((folders["ours"] / "scene-3.png").read_bytes())
    refused("other has two results for one input picture")
    (folders["other"] / "scene-3.jpg").unlink()
    write_picture(tiny.picture(0), inputs / "scene-9.png")
    refused("same picture as 'scene-0'")
    (inputs / "scene-9.png").unlink()
    assert len(collect(folders, inputs, Drawing())[0]) == 6
    folders["empty"] = tmp_path / "empty"
    refused("cannot be read: No such file")
    folders["empty"].mkdir()
    refused("contains no results")


@pytest.mark.parametrize("names", [("one",), ("a", "A"), ("a", "b|c"), ("a", "=b"), ("a", "")])
def test_methods_names_that_cannot_be_used_are_refused(tmp_path: Path, names: tuple[str, ...]):
    scenes, _ = collect(tiny.write_pictures(tmp_path), tmp_path / "inputs", Drawing())
    with pytest.raises(InputError, match=r"method"):
        pages.make_study(scenes, names, StudyOptions(), tiny.TEMPLATE)
