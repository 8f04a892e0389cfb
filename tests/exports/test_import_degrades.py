"""A faulty object does not affect the others; the outcome reports each object."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from command import Shell
from foreign_meshes import MAKERS, box, heavy, in_millimetres, layer, sheet, write_meshes
from foreign_models import CUBE, TABLE, write
from toy import toy_scene

from generator import editing
from generator.bundle import BOUNDS, load, save
from generator.errors import BackendError, BundleError, InputError, SceneError
from generator.imports import ImportOptions, bodies, import_scene, list_outcomes
from generator.imports import folder as folders
from generator.imports import scene as scenes
from generator.imports.foreign import ImportOutcome, Refusals
from generator.imports.mjcf import compile_foreign, read_mjcf
from generator.imports.mjcf_bodies import MAX_REFUSED, compile_sound
from generator.imports.mjcf_files import GatheredModel, gather
from generator.meshes.reading.surface import ColoredSurface, read_surface, surface_of
from generator.meshes.repair import thicken
from generator.method.assembly import AssemblyConfig, reassemble
from generator.physics import decomposition
from generator.physics.gate import GateLimits, judge
from generator.sandbox import SandboxError

BROKEN = {"broken": b"this is not a GLB file at all"}
ONE, TWO = {"one": box}, {"one": box, "two": box}


def outcomes(source: Path, **options: object) -> dict[str, ImportOutcome]:
    scene = import_scene(source, ImportOptions(**options))  # type: ignore[arg-type]
    assert scene.report is not None and scene.report.passed, scene.report
    found = {outcome.name: outcome for outcome in list_outcomes(scene)}
    left = [name for name, o in found.items() if o.kind != "refused"]
    assert [o.name for o in scene.objects] == left
    return found


# ------------------------------------------------------------------------------------- by object


@pytest.mark.slow
def test_a_dozen_foreign_meshes_are_all_taken_beside_two_that_cannot_be(tmp_path: Path) -> None:
    makers = {**MAKERS, "millimetres": in_millimetres}
    found = outcomes(write_meshes(tmp_path, makers, BROKEN))
    kinds = {name: outcome.kind for name, outcome in found.items()}
    repaired = {"torn", "thin", "flat", "inside out"}
    assert kinds == {
        **dict.fromkeys(MAKERS, "taken"), **dict.fromkeys(repaired, "repaired"),
        "millimetres": "refused", "broken": "refused",
    }  # fmt: skip
    assert "is not a GLB file" in found["broken"].detail
    assert "90 m tall, try --scale 0.001" in found["millimetres"].detail
    assert "close holes" in found["torn"].detail
    assert found["thin"].detail == "thin sheet thickened to 0.4 mm"


@pytest.mark.slow
@pytest.mark.timeout(600)
def test_a_mesh_of_a_million_triangles_is_reduced(tmp_path: Path) -> None:
    found = outcomes(write_meshes(tmp_path, {**ONE, "heavy": heavy}))
    assert found["heavy"].kind == "repaired"
    assert "reduced from 1310720 to" in found["heavy"].detail


@pytest.mark.slow
def test_what_cannot_be_decomposed_collides_as_its_hull(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = decomposition.decompose

    def decompose(mesh, scale, **settings):
        if scale[2] > 0.1:
            raise SceneError("Convex decomposition takes too long.")
        return real(mesh, scale, **settings)

    monkeypatch.setattr(decomposition, "decompose", decompose)
    found = outcomes(write_meshes(tmp_path, {**ONE, "tall": lambda: box(0.06, 0.12, 0.05)}))
    assert found["one"].kind == "taken"
    assert found["tall"] == ImportOutcome("tall", "hull", "Convex decomposition takes too long.")


@pytest.mark.usefixtures("inline")
def test_nothing_left_is_an_error_with_every_reason(tmp_path: Path) -> None:
    broken = {"a": b"nothing", "b": b"nothing either"}
    with pytest.raises(InputError, match=r"None of the 2 objects .*a: .*not a GLB.*b: .*not a GLB"):
        import_scene(write_meshes(tmp_path, {}, broken))


@pytest.mark.slow
def test_the_command_prints_a_table_of_outcomes(tmp_path: Path, shell: Shell) -> None:
    source = write_meshes(tmp_path / "in", ONE, BROKEN)
    said = shell("import", str(source), "--out", str(tmp_path / "out")).out
    rows = [line.split() for line in said.splitlines()]
    assert ["one", "taken"] in rows and "refused" in said
    assert said.count("not a GLB file") == 1
    told = shell("import", str(source), "--out", str(tmp_path / "out"), "--json").out
    facts = json.loads(told)
    assert [o["kind"] for o in facts["outcomes"]] == ["taken", "refused"]
    kept = list_outcomes(load(facts["bundle"]))
    assert [outcome.kind for outcome in kept] == ["taken", "refused"]


TAKEN = {"name": "one", "kind": "taken", "detail": ""}


@pytest.mark.parametrize("listed", [
    None, 7, "taken", {"name": "one"}, [None], ["one"], [["one", "taken", ""]], [{}],
    [{"name": "one", "kind": "taken"}], [TAKEN | {"more": 1}], [TAKEN | {"kind": "stolen"}],
    [TAKEN | {"kind": ["taken"]}], [TAKEN | {"name": 1}], [TAKEN | {"detail": {"a": []}}],
    [TAKEN] * 10_001,
])  # fmt: skip
def test_outcomes_of_a_crafted_bundle_are_refused(listed: Any) -> None:
    scene = toy_scene()
    config = {**scene.provenance.config, "outcomes": listed}
    with pytest.raises(BundleError, match="outcomes"):
        list_outcomes(scene.replace(provenance=replace(scene.provenance, config=config)))


def test_a_scene_that_was_not_imported_has_no_outcomes() -> None:
    scene = toy_scene()
    assert list_outcomes(scene) == ()
    config = {"outcomes": [TAKEN]}
    imported = scene.replace(provenance=replace(scene.provenance, config=config))
    assert list_outcomes(imported) == (ImportOutcome("one"),)


@pytest.mark.slow
def test_a_file_that_breaks_its_reader_is_refused_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Files are read together in one child process, and separately if that one dies."""
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    monkeypatch.syspath_prepend(tmp_path)
    (tmp_path / "sitecustomize.py").write_text(
        "import os, trimesh\n"
        "load = trimesh.load_scene\n"
        "def load_scene(file, *args, **options):\n"
        "    found = load(file, *args, **options)\n"
        "    if max(g.bounds[1, 1] for g in found.geometry.values()) > 0.1:\n"
        "        os.abort()\n"
        "    return found\n"
        "trimesh.load_scene = load_scene\n"
    )
    found = outcomes(write_meshes(tmp_path / "in", {**ONE, "bad": lambda: box(0.1, 0.3, 0.1)}))
    assert found["one"].kind == "taken"
    assert found["bad"].kind == "refused" and "crashes its parser" in found["bad"].detail


# ------------------------------------------------------------------------------------------- MJCF

LID = """<body name="box" pos="1.2 2 .77"><freejoint/><geom type="box" size=".03 .03 .03"/>
  <body name="lid"><joint/><geom size=".01"/></body></body>"""


def test_a_body_with_joints_is_refused_and_the_others_stay(tmp_path: Path, read) -> None:
    found = read(write(tmp_path, TABLE + CUBE + LID))
    assert [body.name for body in found.objects] == ["cube"]
    (refused,) = found.refused
    assert refused.name == "box" and "other than free" in refused.detail


@pytest.mark.slow
def test_a_body_that_mujoco_refuses_does_not_lose_the_others(tmp_path: Path) -> None:
    (tmp_path / "flat.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    head = '<asset><mesh name="flat" file="flat.obj"/></asset>'
    bad = '<body name="bad" pos="1 2.2 .8"><freejoint/><geom type="mesh" mesh="flat"/></body>'
    motor = '</worldbody><sensor><framepos objtype="body" objname="bad"/></sensor><worldbody>'
    found = read_mjcf(write(tmp_path, TABLE + CUBE + bad + motor, head))
    assert [body.name for body in found.objects] == ["cube"]
    (refused,) = found.refused
    assert refused.name == "bad" and "MuJoCo rejects" in refused.detail


@pytest.mark.slow
@pytest.mark.parametrize(("bad", "kept"), [(3, True), (MAX_REFUSED, True), (400, False)])
def test_few_models_are_compiled_to_find_bodies_that_mujoco_refuses(
    bad: int, kept: bool, tmp_path: Path
) -> None:
    cubes = "".join(
        f'<body name="b{k}" pos="{k} 9 9"><freejoint/>'
        f'<geom type="box" size=".03 .03 {-1 if k < bad else 0.03}"/></body>'
        for k in range(400)
    )
    gathered, compiled = gather(write(tmp_path, TABLE + cubes)), 0

    def count(model: GatheredModel, what: str) -> object:
        nonlocal compiled
        compiled += 1
        return compile_foreign(model, what)

    refusals = Refusals()
    try:
        compile_sound(gathered, "it", refusals, count)  # type: ignore[arg-type]
    except InputError:
        assert not kept and not refusals.outcomes
    else:
        assert kept and [o.name for o in refusals.outcomes] == [f"b{k}" for k in range(bad)]
    assert compiled < 130


def test_a_single_body_without_joints_is_an_object(tmp_path: Path, read) -> None:
    mug = '<body name="mug"><geom size=".04 .05" type="cylinder" mass=".3"/></body>'
    found = read(write(tmp_path, mug + '<geom type="plane" size="1 1 1"/>'))
    assert found.table is None
    (body,) = found.objects
    assert body.name == "mug" and body.mass is not None
    assert body.mass.mass == pytest.approx(0.3)
    with pytest.raises(InputError, match="no free body"):
        read(write(tmp_path, mug.replace("mug", "side table")))


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["xml", "glb", "obj"])
def test_a_single_object_stands_on_a_plain_table(kind: str, tmp_path: Path) -> None:
    path = tmp_path / f"mug.{kind}"
    if kind == "xml":
        write(tmp_path, '<geom name="mug" type="box" size=".03 .03 .02"/>', name="mug.xml")
    else:
        box().export(path)
    scene = import_scene(path)
    (thing,) = scene.objects
    assert thing.name == "mug" and scene.report is not None and scene.report.passed
    np.testing.assert_allclose(thing.pose.position[:2], 0, atol=1e-3)


# ------------------------------------------------------------------------------------------- round

BALL = '<body name="ball" pos="1.2 2 .78"><freejoint/><geom type="sphere" size=".04"/></body>'


@pytest.mark.slow
@pytest.mark.usefixtures("inline")
def test_a_ball_is_judged_on_a_level_table_then_and_later(tmp_path: Path, shell: Shell) -> None:
    source = write(tmp_path, TABLE + CUBE + BALL)
    scene = import_scene(source)
    assert scene.report is not None and scene.report.passed and scene.report.lean == 0
    path = save(scene, tmp_path)
    kept = load(path)
    assert kept.report == scene.report
    assert judge(kept).passed and not judge(kept, GateLimits()).passed
    again = reassemble(kept, kept, ()).report
    assert again is not None and again.passed and again.lean == 0
    edited = editing.remove(path, "cube").scene.report
    assert edited is not None and edited.passed and edited.lean == 0
    assert "valid, gravity tilted by 0°" in shell("verify", str(path)).out
    leaned = import_scene(source, ImportOptions(lean=2.0))
    assert leaned.report is not None and leaned.report.lean is None
    assert [(f.kind, f.objects, f.leaning) for f in leaned.report.failures] == [
        ("turned", ("ball",), True)
    ]


# ------------------------------------------------------------------------------------------ scales


@pytest.mark.slow
def test_millimetres_are_read_with_a_scale(tmp_path: Path) -> None:
    source = write_meshes(tmp_path, {"can": in_millimetres})
    with pytest.raises(InputError, match=r"90 m tall, try --scale 0\.001"):
        import_scene(source)
    scene = import_scene(source, ImportOptions(scale=1e-3))
    np.testing.assert_allclose(scene.objects[0].scale, [0.08, 0.08, 0.09], atol=1e-3)


def test_a_model_in_millimetres_keeps_its_kilograms_and_its_densities(tmp_path: Path, read) -> None:
    text = (
        '<body name="table"><geom type="box" size="600 400 370" pos="0 0 370"/></body>'
        '<body name="dense" pos="0 0 780"><freejoint/><geom type="box" size="30 30 30"/></body>'
        '<body name="weighed" pos="200 0 780"><freejoint/>'
        '<geom type="box" size="30 30 30" mass=".2"/></body>'
    )
    found = read(write(tmp_path, text)).scale(1e-3)
    dense, weighed = (body.mass for body in found.objects)
    assert dense.mass == pytest.approx(1000 * 0.06**3)
    assert weighed.mass == pytest.approx(0.2)
    for mass in (dense, weighed):
        np.testing.assert_allclose(np.diag(mass.inertia), mass.mass * 0.06**2 / 6, rtol=1e-6)
    np.testing.assert_allclose(found.objects[1].position, [0.2, 0, 0.78])


@pytest.mark.parametrize("wrong", [{"scale": 0}, {"scale": float("nan")}, {"lean": 90}])
def test_options_out_of_range_are_refused(wrong: dict[str, float]) -> None:
    with pytest.raises(InputError, match=next(iter(wrong))):
        ImportOptions(**wrong)


# ------------------------------------------------------------------------------------------ sheets


def surface(mesh: trimesh.Trimesh) -> ColoredSurface:
    return surface_of([mesh], "The mesh")


def test_a_thin_sheet_gets_a_thickness_along_its_own_normal() -> None:
    turn = trimesh.transformations.rotation_matrix(0.4, (1, 2, 3))
    mesh = sheet()
    mesh.apply_transform(turn)
    made, thickness = thicken(surface(mesh))
    assert thickness == pytest.approx(4e-4)
    along = made.vertices @ turn[:3, 1]
    assert np.ptp(along) == pytest.approx(4e-4)


def test_a_single_layer_becomes_a_closed_solid() -> None:
    made, thickness = thicken(surface(layer()))
    solid = trimesh.Trimesh(made.vertices, made.faces)
    assert solid.is_watertight and solid.is_winding_consistent
    assert solid.volume == pytest.approx(0.2 * 0.15 * thickness)


@pytest.mark.parametrize("size", [(0.1, 0.002, 0.1), (0.001, 0.001, 0.001), (2e-4, 2e-4, 2e-4)])
def test_what_is_no_sheet_stays_as_it_is(size: tuple[float, float, float]) -> None:
    given = surface(box(*size))
    made, thickness = thicken(given)
    assert made is given and thickness == 0


@pytest.mark.usefixtures("inline")
def test_bodies_that_show_one_mesh_are_repaired_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[str] = []
    repair = bodies.repair_surface
    monkeypatch.setattr(
        bodies, "repair_surface", lambda *args: (calls.append(args[1]), repair(*args))[1]
    )
    names = ("one", "two", "three")
    scene = import_scene(write_meshes(tmp_path, dict.fromkeys(names, box)), ImportOptions())
    assert len(scene.objects) == len(names)
    assert len(calls) == 1


@pytest.mark.usefixtures("inline")
def test_bodies_with_collision_shapes_are_not_covered_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bodies, "body_parts", None)
    scene = import_scene(write(tmp_path, TABLE + CUBE))
    assert [o.name for o in scene.objects] == ["cube"]


@pytest.mark.usefixtures("inline")
def test_objects_beyond_the_budget_of_cuts_collide_as_their_hulls(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(scenes, "CutBudget", lambda: decomposition.CutBudget(1))
    meshes = {f"box {k}": lambda k=k: box(0.05 + k / 100) for k in range(3)}
    found = outcomes(write_meshes(tmp_path, meshes))
    assert [outcome.kind for outcome in found.values()] == ["taken", "hull", "hull"]
    assert "used all convex parts" in found["box 1"].detail


@pytest.mark.usefixtures("inline")
def test_objects_beyond_the_shapes_of_a_bundle_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Limits of a bundle are checked before objects are built, settled and checked."""
    build, built = scenes.build_object, list[str]()
    monkeypatch.setattr(
        scenes,
        "build_object",
        lambda body, name, *more: (built.append(name), build(body, name, *more))[1],
    )
    monkeypatch.setattr(scenes, "BOUNDS", replace(BOUNDS, all_parts=25))
    geoms = '<geom type="box" size=".01 .01 .01"/>' * 10
    many = "".join(
        f'<body name="b{k}" pos="{0.8 + k / 10} 2 .76"><freejoint/>{geoms}</body>' for k in range(3)
    )
    found = outcomes(write(tmp_path, TABLE + many))
    assert {name: o.kind for name, o in found.items()} == {
        "b0": "taken", "b1": "refused", "b2": "refused"
    }  # fmt: skip
    assert "at most 25" in found["b1"].detail
    assert built == ["b0"]


@pytest.mark.usefixtures("inline")
@pytest.mark.parametrize("kind", ["mjcf", "folder"])
def test_shapes_are_counted_as_a_bundle_counts_them(
    kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write(tmp_path, TABLE + CUBE) if kind == "mjcf" else write_meshes(tmp_path, TWO)
    scene = import_scene(path)
    payload = json.loads((save(scene, tmp_path / "out") / "scene.json").read_text())
    lists = [payload["table"], *payload["objects"], *payload["models"].values()]
    parts = [part for body in lists for part in body["parts"]]
    most = {"all_parts": len(parts), "all_part_vertices": sum(len(p["vertices"]) for p in parts)}
    for name, count in most.items():
        monkeypatch.setattr(scenes, "BOUNDS", replace(BOUNDS, **{name: count}))
        assert len(import_scene(path).objects) == len(scene.objects)
        monkeypatch.setattr(scenes, "BOUNDS", replace(BOUNDS, **{name: count - 1}))
        if kind == "mjcf":
            with pytest.raises(InputError, match=f"at most .*{count - 1} (?:parts|points)"):
                import_scene(path)
        else:
            assert len(import_scene(path).objects) == 1


@pytest.mark.usefixtures("inline")
def test_a_config_of_its_own_says_the_lean(tmp_path: Path) -> None:
    config = AssemblyConfig(limits=GateLimits(lean=float(np.deg2rad(1.5))))
    scene = import_scene(write(tmp_path), ImportOptions(lean=3.0), config)
    assert scene.report is not None and scene.report.lean == config.limits.lean
    assert scene.provenance.config["lean"] == pytest.approx(1.5)
    assert import_scene(write(tmp_path), ImportOptions(lean=3.0)).provenance.config["lean"] == 3.0


def test_a_body_of_too_many_collision_shapes_is_refused_alone(tmp_path: Path) -> None:
    geoms = '<geom type="box" size=".01 .01 .01"/>' * 1100
    many = f'<body name="many" pos="1.3 2 .8"><freejoint/>{geoms}</body>'
    found = outcomes(write(tmp_path, TABLE + CUBE + many))
    assert {name: o.kind for name, o in found.items()} == {"cube": "taken", "many": "refused"}
    assert "1100 collision shapes" in found["many"].detail


@pytest.mark.parametrize("error", [MemoryError(), ValueError("torn")])
def test_want_of_memory_is_no_damage(error: Exception, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr(trimesh, "load_scene", fail)
    wanted = MemoryError if isinstance(error, MemoryError) else BackendError
    with pytest.raises(wanted):
        read_surface(box().export(file_type="glb"), "The mesh", "glb")


def test_a_file_that_reaches_a_limit_is_read_once_and_others_go_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []

    def call(function: object, raw: bytes, what: str, *args: object, **_: object) -> ColoredSurface:
        asked.append(what)
        if b"slow" in raw:
            raise SandboxError("time", "takes more than 4 s of CPU time")
        return read_surface(raw, what, *args)  # type: ignore[arg-type]

    folder = write_meshes(tmp_path, ONE, {f"slow {k}": b"slow" + bytes([k]) for k in range(9)})
    poses = json.loads((folder / "poses.json").read_text())
    poses["objects"] += [{**poses["objects"][1], "name": "again"}]
    (folder / "poses.json").write_text(json.dumps(poses))
    monkeypatch.setattr(folders, "call", call)
    scene = folders.read_folder(folder, apart=True)
    assert [body.name for body in scene.objects] == ["one"]
    assert len(scene.refused) == 10
    assert len([what for what in asked if "slow" in what]) == 3


@pytest.fixture
def apart(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The files that are read separately, here in this process."""
    asked: list[str] = []

    def call(function: object, raw: bytes, what: str, *args: object, **given: Any) -> object:
        asked.append(what.rpartition(": ")[2])
        given["budget"].charge(6.0)
        return read_surface(raw, what, *args)  # type: ignore[arg-type]

    monkeypatch.setattr(folders, "call", call)
    return asked


def test_files_read_apart_share_a_budget_of_time(tmp_path: Path, apart: list[str]) -> None:
    folder = write_meshes(tmp_path, {f"box {k}": lambda k=k: box(0.05 + k / 1e3) for k in range(6)})
    scene = folders.read_folder(folder, apart=True)
    assert len(apart) == len(scene.objects) == 3
    assert all("16 s of CPU time" in o.detail for o in scene.refused) and len(scene.refused) == 3


def test_files_read_apart_are_bounded_together(
    tmp_path: Path, apart: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = write_meshes(tmp_path, TWO)
    monkeypatch.setattr(folders, "_MOST_TOGETHER", (folder / "one.glb").stat().st_size + 9)
    scene = folders.read_folder(folder, apart=True)
    assert [body.name for body in scene.objects] == ["one"]
    assert "at most 9 are allowed" in scene.refused[0].detail


def test_a_file_of_several_spellings_is_read_once(tmp_path: Path, apart: list[str]) -> None:
    folder = write_meshes(tmp_path, ONE)
    poses = json.loads((folder / "poses.json").read_text())
    (one,) = poses["objects"]
    poses["objects"] = [one | {"file": f} for f in ("one.glb", "./one.glb", ".//one.glb")]
    (folder / "poses.json").write_text(json.dumps(poses))
    assert len(folders.read_folder(folder, apart=True).objects) == 3
    assert apart == ["one.glb"]
