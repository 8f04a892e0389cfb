"""Consistent bundles with hostile values: loading, display, compilation and simulation."""

import copy
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest
from command import Shell, command
from forging import derive, put, refused, rewrite
from toy import toy_object, toy_scene

import assets_cache
from generator import bundle
from generator.bundle import derived
from generator.bundle.encoder import dumps
from generator.bundle.fields import numbers
from generator.bundle.segments import Segments
from generator.errors import BundleError, InputError, SceneError
from generator.physics.gate import judge
from generator.physics.mjcf import document
from generator.physics.spec import compile_spec, scene_spec
from generator.scene import Provenance, View

ESCAPE = "\x1b[2J\x1b[Hx"


@pytest.fixture
def path(tmp_path: Path) -> Path:
    made = toy_scene((toy_object("cube_1", (0.05, 0.05, 0.05), (0, 0)),))
    return bundle.save(made.replace(report=judge(made)), tmp_path / "store")


def put_in(*keys: Any, value: Any) -> Callable[[dict[str, Any]], None]:
    def change(payload: dict[str, Any]) -> None:
        holder: Any = payload
        for key in keys[:-1]:
            holder = next(iter(holder.values())) if key is None else holder[key]
        holder[keys[-1]] = value

    return change


VALUES = {
    "mass": put_in("objects", 0, "mass", value=1e-320),
    "no mass": put_in("objects", 0, "mass", value=1e-12),
    "true mass": put_in("objects", 0, "mass", value=True),
    "inertia": put_in("objects", 0, "inertia", 0, 0, value=1e308),
    "text": put_in("objects", 0, "com", 0, value="0"),
    "ragged": put_in("objects", 0, "com", value=[0, [0], 0]),
    "failures": put_in("report", "failures", value=5),
    "failure": put_in("report", "failures", value=[5]),
    "misfit": put_in("report", "misfit", value=[1]),
    "penetration": put_in("report", "penetration", value=None),
    "drift": put_in("report", "drift", value=10**400),
    "outline": put_in("table", "outline", 0, 1, value=1e308),
    "flat outline": put_in("table", "outline", value=[[0, 0], [1, 0], [2, 0]]),
    "clockwise": lambda p: p["table"]["outline"].reverse(),
    "table friction": put_in("table", "friction", value=1e308),
    "position": put_in("objects", 0, "pose", "position", 0, value=1e300),
    "far": put_in("objects", 0, "pose", "position", 0, value=1e6),
    "scale": put_in("objects", 0, "placement", "scale", 0, value=1e-320),
    "yaw": put_in("objects", 0, "placement", "yaw", value=1e308),
    "fov": put_in("view", "fov", value=1e-300),
    "wide": put_in("view", "fov", value=3.1415926),
    "azimuth": put_in("view", "azimuth", value=1e300),
    "axis": put_in("table", "parts", 0, "axis", value=False),
    "opacity": put_in("models", None, "opacity", value=1e308),
    "container": put_in("models", None, "container", value="yes"),
    "seed": put_in("provenance", "seed", value=2**70),
    "warnings": put_in("provenance", "warnings", value="one"),
    "backends": put_in("provenance", "backends", value=[]),
    "edits": put_in("provenance", "edits", value=[{"kind": "burn"}]),
    "kind": put_in("provenance", "kind", value="guess"),
    "plan": put_in("plan", value={"prompt": 5}),
    "unknown": put_in("unknown", value=5),
    "name": put_in("objects", 0, "name", value="other"),
    "on itself": put_in("objects", 0, "placement", "on", value="cube_1"),
    "called floor/x": put_in("objects", 0, "name", value="floor/x"),
    "scene": put_in("name", value="../up"),
    "long": put_in("models", None, "label", value="x" * 5000),
    "schema": put_in("schema", value=True),
    "float schema": put_in("schema", value=1.0),
}


@pytest.mark.slow
@pytest.mark.parametrize("change", VALUES.values(), ids=VALUES.keys())
def test_values_out_of_bounds_or_of_another_type_are_refused(
    path: Path, change: Callable[[dict[str, Any]], None]
) -> None:
    refused(rewrite(path, change), "forged")


def test_a_long_text_among_many_numbers_takes_no_memory() -> None:
    """An array of strings would allocate a million characters for each of 100,000 entries."""
    with pytest.raises(BundleError, match="lists of numbers"):
        numbers(["x" * 10**6, *[""] * 10**5], "outline")
    with pytest.raises(BundleError, match="lists of numbers"):
        numbers([[True, 1.0]], "outline")
    assert numbers([[1, 2.5], [3, 4]], "outline").tolist() == [[1.0, 2.5], [3.0, 4.0]]


def test_every_model_is_used(path: Path) -> None:
    def add(payload: dict[str, Any]) -> None:
        payload["models"]["more"] = copy.deepcopy(next(iter(payload["models"].values())))

    refused(rewrite(path, add), "unused model")


@pytest.mark.parametrize("fov", [0.01, 3.13])
def test_what_loads_compiles_and_is_sound_for_verify(path: Path, fov: float) -> None:
    forged = derive(rewrite(path, put_in("view", "fov", value=fov)))
    assert bundle.verify(forged) == []
    scene = bundle.load(forged)
    assert compile_spec(scene_spec(scene), scene.name).nbody == 3


def test_a_hull_that_mujoco_cannot_build_does_not_load(path: Path) -> None:
    flat = [{"kind": "hull", "axis": 2, "vertices": [[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0]]}]
    refused(derive(rewrite(path, put_in("objects", 0, "parts", value=flat))), "cannot build")


def test_bodies_that_overlap_all_over_do_not_load(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    """MuJoCo lacks memory for so many contacts, and logs and raises its own error."""
    monkeypatch.chdir(tmp_path)
    cups = [
        toy_object(f"cup_{k}", (0.09, 0.09, 0.09), (0, 0), wall=0.006, mass=0.3) for k in range(20)
    ]
    path = bundle.save(toy_scene(tuple(cups)), tmp_path / "store", allow_failed=True)
    refused(path, "cannot simulate the scene")
    assert [p.name for p in tmp_path.iterdir()] == ["store"]
    assert capfd.readouterr().err == ""


def test_numbers_too_small_for_mujoco_are_zero() -> None:
    scene = toy_scene().replace(view=View(1e-320, 0.9, 0.6))
    assert compile_spec(scene_spec(scene), "toy").ncam == 2


# ------------------------------------------------------------------------------------------- texts
@pytest.mark.parametrize("character", ["\x1b", "\x00", "\r", "\x7f", "\x9b", "\u202e", "\u2028"])
def test_no_text_reaches_a_terminal_that_would_change_it(
    path: Path, character: str, shell: Shell
) -> None:
    text = f"a{character}b"
    places = (("models", None, "label"), ("provenance", "prompt"), ("name",), ("report", text),
              ("provenance", "config"))  # fmt: skip
    raw = (path / "scene.json").read_bytes()
    path = path.rename(path.parent / "forged")
    for keys in places:
        payload = json.loads(raw)
        put_in(*keys, value={text: 1} if keys[-1] == "config" else text)(payload)
        (path / "scene.json").write_bytes(dumps(payload))
        for read in (bundle.load, bundle.load_kinds, bundle.load_report, bundle.load_digest):
            with pytest.raises(BundleError) as caught:
                read(path)
            assert character not in str(caught.value)
    assert command("inspect", str(path)) == 4
    shown = shell("verify", str(path), code=1)
    assert character not in (shown.out + shown.err).replace("\r\n", "\n")


def test_a_backslash_before_a_letter_is_no_control(path: Path) -> None:
    text = "C:\\books \\u001b \\\\r line one\nline two\tß 机 🍎"
    forged = rewrite(path, put_in("provenance", "prompt", value=text))
    assert bundle.load(forged).provenance.prompt == text


def test_texts_of_ours_are_cleaned_as_they_are_saved(tmp_path: Path) -> None:
    scene = toy_scene()
    told = Provenance("text", 0, f"a\n{ESCAPE}", warnings=(ESCAPE,), config={ESCAPE: ESCAPE})
    saved = bundle.save(scene.replace(provenance=told), tmp_path, allow_failed=True)
    again = bundle.load(saved).provenance
    assert again.prompt == "a\n [2J [Hx"
    assert again.warnings == (" [2J [Hx",)


def test_what_is_saved_can_be_read(tmp_path: Path) -> None:
    made = toy_scene((toy_object("cube_1", (0.05, 0.05, 0.05), (0, 0)),))
    made = made.replace(report=judge(made))
    for picture in (np.zeros((4097, 4097, 3), np.uint8), b"no PNG"):
        with pytest.raises((SceneError, InputError)):
            bundle.save(made, tmp_path / "store", images={"reference": picture})
    assert not (tmp_path / "store").exists()
    found = Segments(("cube_1",), (f"a{ESCAPE}",), np.ones((4, 4), np.uint8))
    path = bundle.save(made, tmp_path / "store", segments=found)
    assert bundle.verify(path) == []


@pytest.mark.parametrize("change", [put_in("models", value=[]), put_in("objects", value=[{}, 5])])
def test_kinds_of_nothing_are_refused(path: Path, change: Callable[[dict[str, Any]], None]) -> None:
    with pytest.raises(BundleError):
        bundle.load_kinds(rewrite(path, change))


def test_names_of_objects_are_printable() -> None:
    with pytest.raises(InputError, match="cannot be printed"):
        toy_scene((toy_object(ESCAPE, (0.05, 0.05, 0.05), (0, 0)),))


# --------------------------------------------------------------------------------------- scene.xml
@pytest.mark.slow
@pytest.mark.parametrize(
    "change",
    [
        lambda xml: b'<mujoco><include file="/elsewhere.xml"/></mujoco>',
        lambda xml: b"garbage",
        lambda xml: b"",
        lambda xml: b"\xff",
        lambda xml: b"<a>" * 3000,
        lambda xml: xml * 3,
        lambda xml: xml.replace(b"<worldbody>", b'<worldbody><include file="/elsewhere.xml"/>'),
        lambda xml: xml.replace(b"<worldbody>", b"<worldbody>text"),
        lambda xml: xml.replace(b'timestep="0.002"', b'timestep="0.003"'),
        lambda xml: xml.replace(b'timestep="0.002"', b'timestep="0.0_02"'),
        lambda xml: xml.replace(b'timestep="0.002"', b'timestep="nan"'),
        lambda xml: xml.replace(b'contype="0"', b'contype="1e-13"'),
        lambda xml: xml.replace(b'contype="0"', b'contype="0.0"'),
        lambda xml: xml.replace(b'timestep="0.002"', b'timestep="0.002 0.002"'),
        lambda xml: xml.replace(b'timestep="0.002"', b""),
        lambda xml: xml.replace(b"<asset>", b"<!-- a --><asset>"),
        lambda xml: b'<!DOCTYPE m [<!ENTITY a "b">]>' + xml,
        lambda xml: b"<?xml version='1.0' encoding='utf-16'?>" + xml,
        lambda xml: xml.replace(b'file="meshes/', b'file="/meshes/', 1),
    ],
)
def test_an_xml_that_says_something_else_is_refused(
    path: Path, change: Callable[[bytes], bytes]
) -> None:
    refused(put(path, "scene.xml", change((path / "scene.xml").read_bytes())), r"scene\.xml")


def test_another_machines_last_digits_are_the_same_document(path: Path) -> None:
    xml = (path / "scene.xml").read_text()
    (pose,) = re.findall(r'<body name="cube_1" pos="([^"]*)"', xml)
    x, *rest = pose.split()
    assert float(x) == 0
    for word in ("4.440892e-16", "-0", "1e-10"):
        forged = put(path, "scene.xml", xml.replace(pose, " ".join([word, *rest]), 1).encode())
        assert bundle.verify(forged) == []
        path = forged


@pytest.mark.parametrize(
    ("key", "wanted", "found", "close"),
    [
        ("pos", "0 0.5", "4.440892e-16 0.5", True),
        ("pos", "4.440892e-16 0.5", "0 0.5", True),
        ("quat", "1 0 0 0", "0.9999999 1e-9 0 0", True),
        ("quat", "1 0 0 0", "0.9999 0 0 0", False),
        ("mass", "1e-9", "2e-9", False),
        ("mass", "0", "1e-300", False),
        ("fullinertia", "1.958e-7 1e-8", "-7.9e-7 1e-8", False),
        ("size", "0.1", "0_0.1", False),
        ("size", "0.1", "nan", False),
        ("size", "0.1 0.1", "0.1", False),
        ("contype", "1", "1.0000001", False),
        ("name", "100000", "1e5", False),
    ],
)
def test_only_computed_numbers_may_end_otherwise(
    key: str, wanted: str, found: str, close: bool
) -> None:
    assert derived._close(key, wanted, found) == close


def test_the_viewer_opens_what_was_checked(path: Path, monkeypatch) -> None:
    import mujoco.viewer as viewer

    opened: list[mujoco.MjModel] = []
    monkeypatch.setenv("DISPLAY", ":99")
    monkeypatch.setattr(viewer, "launch", opened.append)
    assert command("view", str(path)) == 0
    assert [model.nbody for model in opened] == [3]
    forged = put(path, "scene.xml", b"<mujoco/>")
    assert command("view", str(forged)) == 4
    assert len(opened) == 1


def test_a_shipped_document_is_what_is_written_today() -> None:
    """Byte-identical, so that equal scenes give equal bundles."""
    place = assets_cache.find("lab")[0]
    assert document(bundle.load_verified(place)).xml.encode() == (place / "scene.xml").read_bytes()
