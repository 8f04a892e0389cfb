import dataclasses
import errno
import hashlib
import json
import os
from pathlib import Path

import mujoco
import numpy as np
import pytest
from forging import refused, rewrite
from toy import toy_scene

from generator import bundle
from generator.bundle.decoder import decode_scene
from generator.bundle.encoder import dumps, encode_scene
from generator.errors import BundleError, SceneError, StorageError
from generator.physics.gate import judge
from generator.scene import (
    Edit,
    Failure,
    PlannedObject,
    PlannedTable,
    Provenance,
    Relation,
    Report,
    Scene,
    ScenePlan,
)

PREVIEW = np.arange(48, dtype=np.uint8).reshape(4, 4, 3)


@pytest.fixture(scope="module")
def scene() -> Scene:
    plan = ScenePlan(
        "a cube beside a can",
        PlannedTable("round", color="red"),
        (
            PlannedObject(
                "cube_1", "cube", "toy_block", {"color": "red"}, (Relation("on"),), (1, 2, 3)
            ),
        ),
        warnings=("made up",),
    )
    provenance = Provenance(
        "text", 3, "a cube", backends={"reasoner": {"class": "Toy"}}, warnings=("one", "two")
    )
    made = toy_scene().replace(plan=plan, provenance=provenance)
    return made.replace(report=judge(made))


@pytest.fixture
def path(scene: Scene, tmp_path: Path) -> Path:
    return bundle.save(scene, tmp_path / "store", images={"preview": PREVIEW})


def tree(folder: Path) -> dict[str, bytes]:
    return {
        p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()
    }


# ------------------------------------------------------------------------------------ round trips
@pytest.mark.slow
def test_a_scene_comes_back(scene: Scene, path: Path) -> None:
    again = bundle.load(path)
    assert again.name == scene.name
    assert again.plan == scene.plan
    assert again.provenance == scene.provenance
    assert again.report == scene.report
    assert again.view == scene.view
    np.testing.assert_allclose(again.table.outline, scene.table.outline, atol=1e-7)
    assert [o.name for o in again.objects] == [o.name for o in scene.objects]
    for a, b in zip(again.objects, scene.objects, strict=True):
        np.testing.assert_allclose(a.pose.position, b.pose.position, atol=1e-8)
        np.testing.assert_allclose(a.inertia, b.inertia, rtol=1e-6)
        np.testing.assert_allclose(a.model.mesh.vertices, b.model.mesh.vertices, atol=1e-6)
        np.testing.assert_array_equal(a.model.mesh.texture, b.model.mesh.texture)
        assert a.mass == pytest.approx(b.mass)
        assert a.model.physics == b.model.physics
        assert len(a.parts) == len(b.parts)


def test_saving_again_gives_the_same_bytes(scene: Scene, path: Path, tmp_path: Path) -> None:
    other = bundle.save(scene, tmp_path / "a", images={"preview": PREVIEW})
    loaded = bundle.save(bundle.load(path), tmp_path / "b", images={"preview": PREVIEW})
    assert path.name == other.name == loaded.name
    assert tree(path) == tree(other) == tree(loaded)


def test_edits_come_back_and_are_not_written_where_there_are_none(
    scene: Scene, path: Path, tmp_path: Path
) -> None:
    assert "edits" not in json.loads((path / "scene.json").read_bytes())["provenance"]
    edit = Edit("0" * 64, "swap", ("can_1", "cup_1"), "a cup", 3, {"imager": {"class": "Toy"}})
    past = dataclasses.replace(scene.provenance, edits=(edit, edit))
    edited = bundle.save(scene.replace(provenance=past), tmp_path)
    assert bundle.load(edited).provenance.edits == (edit, edit)


def test_pictures_fingerprint_and_report_are_read_alone(path: Path) -> None:
    assert bundle.load_pictures(path) == {"preview": (path / "preview.png").read_bytes()}
    assert bundle.load_fingerprint(path)[:12] == path.name[-12:]
    report, scene = bundle.load_report(path), bundle.load(path)
    assert scene.report is not None
    assert report["penetration"] == scene.report.penetration
    assert report["objects"] == len(scene.objects)


def test_the_folder_is_named_by_the_digest_of_scene_json(path: Path) -> None:
    digest = hashlib.sha256((path / "scene.json").read_bytes()).hexdigest()
    assert path.name == f"toy-{digest[:12]}"


def test_a_scene_and_its_bundle_have_one_digest_whatever_they_are_called(
    scene: Scene, path: Path
) -> None:
    renamed = scene.replace(name="other", report=None, provenance=Provenance("manual", 8))
    assert bundle.load_digest(path) == bundle.digest(scene) == bundle.digest(renamed)
    assert len(bundle.digest(scene)) == 12
    fewer = scene.replace(objects=scene.objects[1:])
    assert bundle.digest(fewer) != bundle.digest(scene)


def test_kinds_are_read_without_meshes(scene: Scene, path: Path) -> None:
    for mesh in (path / "meshes").iterdir():
        mesh.unlink()
    kinds = bundle.load_kinds(path)
    assert kinds == [(o.model.category, o.model.label) for o in scene.objects]
    assert bundle.load_digest(path) == bundle.digest(scene)


@pytest.mark.parametrize("read", [bundle.load_kinds, bundle.load_digest])
def test_digest_and_kinds_of_no_or_a_damaged_bundle(path: Path, read) -> None:
    with pytest.raises(BundleError, match="no bundle at"):
        read(path.parent / "nothing")
    forged = rewrite(path, lambda payload: payload.pop("objects"))
    with pytest.raises(BundleError, match="objects"):
        read(forged)


def test_any_difference_gives_another_bundle(scene: Scene, path: Path, tmp_path: Path) -> None:
    assert bundle.save(scene, tmp_path / "store").name != path.name
    renamed = bundle.save(scene.replace(name="other"), tmp_path / "store")
    assert renamed.name.startswith("other-")


def test_publishing_twice_keeps_the_first(scene: Scene, path: Path, tmp_path: Path) -> None:
    before = (path / "scene.json").stat().st_ino
    assert bundle.save(scene, tmp_path / "store", images={"preview": PREVIEW}) == path
    assert (path / "scene.json").stat().st_ino == before


def test_publishing_over_a_damaged_bundle_mends_it(scene, path: Path, tmp_path: Path) -> None:
    (path / "scene.xml").unlink()
    assert bundle.save(scene, tmp_path / "store", images={"preview": PREVIEW}) == path
    assert bundle.verify(path) == []
    assert len(list(path.parent.iterdir())) == 1


def test_the_xml_loads_in_plain_mujoco_wherever_the_folder_is(path: Path, tmp_path: Path) -> None:
    moved = path.rename(tmp_path / "moved")
    model = mujoco.MjModel.from_xml_path(str(moved / "scene.xml"))
    assert model.nbody == len(bundle.load(moved).objects) + 2


def test_no_path_or_clock_time_is_kept(path: Path, tmp_path: Path) -> None:
    text = (path / "scene.json").read_text() + (path / "scene.xml").read_text()
    assert str(tmp_path) not in text
    assert str(Path.home()) not in text


# ------------------------------------------------------------------------------------ publication
OVERLAP = Failure("overlap", ("cube_1", "can_1"), 0.1, 5e-4)
TURNED = Failure("turned", ("can_1",), 0.2, 0.03, 5.0, leaning=True)


def test_a_scene_that_failed_is_not_published(scene: Scene, tmp_path: Path) -> None:
    failed = scene.replace(report=Report(0.1, 0, 0, failures=(OVERLAP,)))
    with pytest.raises(SceneError, match="cube_1 overlaps can_1"):
        bundle.save(failed, tmp_path)
    with pytest.raises(SceneError, match="has no report"):
        bundle.save(scene.replace(report=None), tmp_path)
    assert not list(tmp_path.iterdir())
    assert bundle.load(bundle.save(failed, tmp_path, allow_failed=True)).report == failed.report


def test_failures_are_kept_as_sentences_and_as_values(scene: Scene, tmp_path: Path) -> None:
    report = Report(0.1, 0, 0, failures=(OVERLAP, TURNED))
    path = bundle.save(scene.replace(report=report), tmp_path, allow_failed=True)
    written = json.loads((path / "scene.json").read_text())["report"]
    assert written["failures"] == [
        "cube_1 overlaps can_1 by 100.0 mm", "can_1 turned 11.5° in 5 s on a leaning table"
    ]  # fmt: skip
    assert bundle.load(path).report == report
    passing = bundle.save(scene.replace(report=Report(0.0, 0, 0)), tmp_path)
    assert "failure_values" not in json.loads((passing / "scene.json").read_text())["report"]


@pytest.mark.parametrize("lean", [-1e-9, 0.7855, 1.0, 1e300])
def test_the_lean_of_a_report_is_bounded(scene: Scene, lean: float) -> None:
    payload, files = encode_scene(scene.replace(report=Report(0.0, 0, 0, lean=lean)))
    with pytest.raises(BundleError, match=r"lean must be an angle in \[0, 0.785398\]"):
        decode_scene(payload, files.__getitem__)
    for sound in (0.0, float(np.deg2rad(45))):
        payload["report"]["lean"] = sound
        report = decode_scene(payload, files.__getitem__).scene.report
        assert report is not None and report.lean == sound


def test_failures_without_values_keep_their_sentences(scene: Scene) -> None:
    """Earlier versions wrote only the messages."""
    said = "cube_1 overlaps can_1 by 100.0 mm"
    payload, files = encode_scene(scene.replace(report=Report(0.1, 0, 0, failures=(OVERLAP,))))
    del payload["report"]["failure_values"]
    report = decode_scene(payload, files.__getitem__).scene.report
    assert report is not None and not report.passed
    assert report.failures == (Failure("recorded", sentence=said),)
    assert report.failure_text == said
    payload["report"]["failure_values"] = []
    with pytest.raises(BundleError, match="as many entries as"):
        decode_scene(payload, files.__getitem__)


@pytest.mark.parametrize("name", ["", "../up", "a/b", ".hidden", "x" * 81])
def test_names_that_are_no_folder_names_are_refused(
    scene: Scene, tmp_path: Path, name: str
) -> None:
    with pytest.raises(SceneError, match="folder name"):
        bundle.save(scene.replace(name=name), tmp_path)


def test_pictures_cannot_leave_the_bundle(scene: Scene, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match="picture"):
        bundle.save(scene, tmp_path, images={"../preview": PREVIEW})


@pytest.mark.parametrize("after", [0, 2, 3, 5])
@pytest.mark.parametrize(
    ("trouble", "told"),
    [(OSError(errno.ENOSPC, "No space left on device"), StorageError), (None, KeyboardInterrupt)],
    ids=["full disk", "interrupt"],
)
def test_trouble_while_writing_leaves_nothing(
    scene: Scene, tmp_path: Path, monkeypatch, after: int, trouble, told
) -> None:
    written = []

    def write(self: Path, content: bytes) -> int:
        if len(written) == after:
            raise trouble or KeyboardInterrupt
        written.append(self)
        with self.open("wb") as out:
            return out.write(content)

    monkeypatch.setattr(Path, "write_bytes", write)
    with pytest.raises(told, match="No space left on device" if trouble else None):
        bundle.save(scene, tmp_path)
    assert len(written) == after
    assert not list(tmp_path.iterdir())


def test_an_unwritable_folder_is_a_storage_error(scene: Scene, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    with pytest.raises(StorageError, match="cannot be written"):
        bundle.save(scene, tmp_path / "file")
    if os.geteuid():
        (tmp_path / "closed").mkdir(mode=0o500)
        with pytest.raises(StorageError, match="cannot be written"):
            bundle.save(scene, tmp_path / "closed")


# ---------------------------------------------------------------------------------------- bad input
def test_no_bundle(tmp_path: Path) -> None:
    refused(tmp_path / "nowhere", "There is no bundle")
    refused(tmp_path, r"scene\.json is missing")


def test_every_flipped_byte_is_noticed(path: Path) -> None:
    rng = np.random.default_rng(0)
    for name, content in tree(path).items():
        for at in {0, len(content) - 1, *rng.integers(0, len(content), 4).tolist()}:
            flipped = bytearray(content)
            flipped[at] ^= 0x01
            (path / name).write_bytes(flipped)
            assert bundle.verify(path), (name, at)
        (path / name).write_bytes(content)
    assert bundle.verify(path) == []


def test_every_missing_file_is_noticed(path: Path) -> None:
    for name, content in tree(path).items():
        (path / name).unlink()
        refused(path, f"{name} is missing")
        (path / name).write_bytes(content)


def test_a_truncated_and_a_grown_file(path: Path) -> None:
    content = (path / "preview.png").read_bytes()
    (path / "preview.png").write_bytes(content[:-7])
    refused(path, "changed")
    (path / "preview.png").write_bytes(content + b"\0" * 100)
    refused(path, r"preview\.png has \d+ bytes, not")


@pytest.mark.parametrize(
    "outside", ["../secret", "/etc/passwd", "meshes/../../secret", "a\\b", "C:x"]
)
def test_paths_that_leave_the_folder_are_not_opened(path: Path, outside: str, monkeypatch) -> None:
    secret = path.parent / "secret"
    secret.write_bytes(b"secret")
    entry = {"bytes": 6, "sha256": hashlib.sha256(b"secret").hexdigest()}
    forged = rewrite(path, lambda p: p["files"].update({outside: entry}))
    refused(forged, "leaves the bundle")


@pytest.mark.parametrize("name", ["preview.png", "meshes"])
def test_links_are_refused(path: Path, name: str) -> None:
    (path / name).rename(path.parent / "real")
    (path / name).symlink_to(path.parent / "real")
    refused(path, "is a link")


@pytest.mark.parametrize("number", ["NaN", "Infinity", "-Infinity", "1e999"])
def test_numbers_that_are_not_finite(path: Path, number: str) -> None:
    text = (path / "scene.json").read_text()
    forged = path.rename(path.parent / "forged")
    (forged / "scene.json").write_text(text.replace('"friction":0.6', f'"friction":{number}', 1))
    refused(forged, "not a finite number")


def test_a_future_schema(path: Path) -> None:
    refused(rewrite(path, lambda p: p.update(schema=2)), "schema 2; this version reads schema 1")


@pytest.mark.parametrize("raw", [b"", b"[]", b"{", b"\xff\xfe", b"[" * 100_000, b'"scene"'])
def test_what_is_not_json(path: Path, raw: bytes) -> None:
    (path / "scene.json").write_bytes(raw)
    refused(path, r"scene\.json")


def test_a_changed_value_is_noticed_by_the_folders_name(path: Path) -> None:
    payload = json.loads((path / "scene.json").read_text())
    payload["objects"][0]["mass"] = 2.0
    (path / "scene.json").write_bytes(dumps(payload))
    refused(path, "digest")


@pytest.mark.parametrize(
    "change",
    [
        lambda p: p.pop("objects"),
        lambda p: p["objects"].append(p["objects"][0]),
        lambda p: p["objects"][0].update(mass=-1),
        lambda p: p["objects"][0].update(model="none"),
        lambda p: p["objects"][0]["pose"].update(quaternion=[2, 0, 0, 0]),
        lambda p: p["objects"][0]["parts"][0].update(kind="plane"),
        lambda p: p["objects"][0]["parts"][0].update(vertices=[[0, 0]]),
        lambda p: p["view"].update(fov=99),
        lambda p: p["models"].popitem(),
        lambda p: p["report"].update(unknown=1),
        lambda p: p.update(table=None),
        lambda p: p.update(objects={"a": 1}),
        lambda p: p["files"].pop("scene.xml"),
        lambda p: p["files"].update({"scene.xml": "x"}),
        lambda p: p["files"]["scene.xml"].update(bytes=10**12),
        lambda p: p.update(files=[]),
    ],
)
def test_forged_values_are_one_clear_error(path: Path, change) -> None:
    refused(rewrite(path, change), "forged")


def test_an_unlisted_file_is_never_read_but_reported(path: Path) -> None:
    (path / "scene.pkl").write_bytes(b"cos\nsystem\n(S'false'\ntR.")
    assert bundle.load(path).name == "toy"
    assert "scene.pkl" in bundle.verify(path)[0]


def test_losing_a_race_is_fine(scene: Scene, tmp_path: Path, monkeypatch) -> None:
    """Another writer publishes between our staging and our rename."""
    real = Path.replace
    raced = []

    def replace(self: Path, target: Path) -> Path:
        if not raced:
            raced.append(bundle.save(scene, tmp_path))
        return real(self, target)

    def guarded(self: Path, target: Path) -> Path:
        monkeypatch.setattr(Path, "replace", real)
        return replace(self, target)

    monkeypatch.setattr(Path, "replace", guarded)
    assert bundle.save(scene, tmp_path) == raced[0]
    assert [p.name for p in tmp_path.iterdir()] == [raced[0].name]
