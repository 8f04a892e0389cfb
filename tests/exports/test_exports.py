"""Exports read by other programs: equal bodies, masses, poses, extents and collision parts."""

import dataclasses
import importlib.util
import sys
from pathlib import Path

import mujoco
import numpy as np
import pytest
from command import Shell, command
from imported import READERS, Found, settle_drift
from shipped_bundles import BUNDLES, PART
from toy import toy_object, toy_scene

import assets_cache
from generator.bundle import load
from generator.errors import InputError, StorageError
from generator.exports import ALONE, WRITERS, export
from generator.exports.bodies import RESERVED, ExportBody, bodies_of, legal_names
from generator.scene import Scene

HERE = "pxr" if importlib.util.find_spec("pxr") else ""
TOLERANCE = 1e-4


@pytest.fixture(scope="module")
def scene() -> Scene:
    (path,) = assets_cache.find("coffee-square")
    return load(path)


def check(found: dict[str, Found], bodies: tuple[ExportBody, ...]) -> None:
    """Check that the read content matches the scene, to 1e-4."""
    assert set(found) == {body.name for body in bodies}
    for body in bodies:
        read = found[body.name]
        near = {"atol": TOLERANCE, "rtol": 0, "err_msg": body.name}
        np.testing.assert_allclose(read.position, body.position, **near)
        assert abs(read.quaternion @ body.quaternion) > 1 - 1e-8
        if not body.fixed:
            assert read.mass == pytest.approx(body.mass, rel=TOLERANCE)
            np.testing.assert_allclose(read.com, body.com, **near)
            scale = np.abs(body.inertia).max()
            np.testing.assert_allclose(read.inertia / scale, body.inertia / scale, **near)
        assert read.drawn is not None
        drawn = [body.vertices.min(0), body.vertices.max(0)]
        np.testing.assert_allclose(read.drawn, drawn, **near)
        assert len(read.parts) == len(body.pieces)
        for points, piece in zip(read.parts, body.pieces, strict=True):
            np.testing.assert_allclose(points.min(0), piece.center - piece.half, **near)
            np.testing.assert_allclose(points.max(0), piece.center + piece.half, **near)


def needs(to: str) -> None:
    if to.startswith("usd"):
        pytest.importorskip("pxr")


@pytest.mark.parametrize("to", WRITERS)
def test_others_read_what_the_scene_holds(to: str, scene: Scene, tmp_path: Path) -> None:
    needs(to)
    found = READERS[to](export(scene, to, tmp_path))
    bodies = bodies_of(scene)
    check(found, bodies)
    if to not in ("urdf", "sdf"):  # which have coefficients for each engine
        assert {n: b.friction for n, b in found.items()} == pytest.approx(
            {body.name: body.friction for body in bodies}
        )


@pytest.mark.slow
@pytest.mark.parametrize("to", WRITERS)
def test_the_same_scene_gives_the_same_bytes(to: str, scene: Scene, tmp_path: Path) -> None:
    needs(to)
    first, second = (contents(export(scene, to, tmp_path / k)) for k in ("a", "b"))
    assert first == second and first


def contents(path: Path) -> dict[str, bytes]:
    if path.is_file():
        return {path.name: path.read_bytes()}
    return {str(p.relative_to(path)): p.read_bytes() for p in path.rglob("*") if p.is_file()}


@pytest.mark.slow
def test_each_object_has_a_urdf_of_its_own(scene: Scene, tmp_path: Path) -> None:
    folder = export(scene, "urdf", tmp_path)
    for thing in scene.objects:
        model = mujoco.MjModel.from_xml_path(str(folder / "objects" / f"{thing.name}.urdf"))
        assert model.body_mass.sum() == pytest.approx(thing.mass, rel=TOLERANCE)


def test_names_become_identifiers_and_stay_apart() -> None:
    asked = ["mug", "Käse-Glocke", "Käse Glocke", "2 eggs", "world", "茶", "mug_2", "table"]
    made = legal_names(asked)
    assert made[0] == "mug" and made[6] == "mug_2"
    assert made[1:3] == ["Kase_Glocke", "Kase_Glocke_2"]
    assert all(name.isidentifier() and name.isascii() for name in made)
    assert len({*made}) == len(asked) and not {*made} & {*RESERVED}


@pytest.mark.parametrize("to", [to for to in WRITERS if to != "mjcf"])  # which keeps names
def test_names_that_the_export_uses_itself_take_no_objects_place(to: str, tmp_path: Path) -> None:
    needs(to)
    names = ["mug", "mug_collision", "mug_part_0", "y_up", "y_up_collision", "PhysicsScene", "sun"]
    size = (0.03, 0.04, 0.05)
    things = [toy_object(n, size, (k / 10 - 0.3, 0.0)) for k, n in enumerate(names)]
    scene = toy_scene(tuple(things))
    check(READERS[to](export(scene, to, tmp_path)), bodies_of(scene))


@pytest.mark.slow
@pytest.mark.parametrize("to", [to for to in WRITERS if to != "mjcf"])  # which keeps names
def test_any_name_can_be_exported(to: str, scene: Scene, tmp_path: Path) -> None:
    needs(to)
    names = iter(["世界", 'a<b>&"c"', "scene", "floor"])
    renamed = [
        dataclasses.replace(o, name=n, placement=dataclasses.replace(o.placement, name=n))
        for o in scene.objects
        if (n := next(names, o.name))
    ]
    odd = scene.replace(objects=tuple(renamed), plan=None, report=None)
    check(READERS[to](export(odd, to, tmp_path)), bodies_of(odd))


@pytest.mark.slow
def test_what_is_there_makes_way_for_a_whole_export(scene: Scene, tmp_path: Path) -> None:
    for to in ("mjcf", "glb"):
        path = export(scene, to, tmp_path)
        whole = contents(path)
        place = path if path.is_file() else path / "scene.xml"
        place.write_bytes(b"half")
        assert contents(export(scene, to, tmp_path)) == whole
    assert {p.name for p in tmp_path.iterdir()} == {"coffee-square-mjcf", "coffee-square.glb"}


@pytest.mark.parametrize("to", ["mjcf", "glb"])
def test_a_folder_that_cannot_be_written_is_told(to: str, scene: Scene, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(StorageError, match="file"):
        export(scene, to, tmp_path / "file" / "below")


def test_an_unknown_format_names_those_there_are(scene: Scene, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"'obj'.*glb.*usdz"):
        export(scene, "obj", tmp_path)
    assert not [*tmp_path.iterdir()]


def test_without_usd_core_it_says_what_to_install(
    scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pxr", None)
    with pytest.raises(InputError, match=r"tabletopgen\[usd\]"):
        export(scene, "usd", tmp_path)
    assert not [*tmp_path.iterdir()]


@pytest.mark.slow
def test_the_command_exports_bundles_in_formats(tmp_path: Path, shell: Shell) -> None:
    said = shell("export", "coffee-square", "--to", "glb", "urdf", "--out", str(tmp_path)).out
    written = [Path(line) for line in said.splitlines()]
    assert [path.suffix or path.name[-4:] for path in written] == [".glb", "urdf"]
    assert all(path.exists() for path in written)
    assert command("export", "coffee-square", "--to", "obj", "--out", str(tmp_path)) == 2


@pytest.mark.slow
@pytest.mark.parametrize("name", PART)
def test_every_shipped_bundle_comes_back_and_stays(name: str, tmp_path: Path) -> None:
    """All formats agree to 1e-4; in MuJoCo, 2 s later, nothing has moved by a millimetre."""
    scene = load(BUNDLES[name])
    bodies = bodies_of(scene)
    for to in WRITERS:
        if to.startswith("usd") and not HERE:
            continue
        written = export(scene, to, tmp_path)
        assert written.is_file() == (to in ALONE)
        found = READERS[to](written)
        check(found, bodies)
        assert settle_drift(found) < 1e-3, to


@pytest.mark.slow
def test_usd_is_valid(scene: Scene, tmp_path: Path) -> None:
    pytest.importorskip("pxr")
    from pxr import Usd, UsdValidation

    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    assert len(validators) > 20
    context = UsdValidation.ValidationContext(validators)
    crate = export(scene, "usd", tmp_path) / "scene.usdc"
    for path in (crate, export(scene, "usdz", tmp_path)):
        errors = context.Validate(Usd.Stage.Open(str(path)))
        assert [e.GetMessage() for e in errors] == []
