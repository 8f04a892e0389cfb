"""Exports in other physics engines: required elements, and stable and sliding scenes."""

import csv
import json
import subprocess
import sys
import xml.etree.ElementTree as ET
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np
import parity
import pytest
from engines.simulations import ENGINES
from engines.trials import expected_friction, rest_drift, slide_angle
from extent import part_of
from shipped_bundles import BUNDLES
from toy import toy_object, toy_scene

from generator.bundle import load
from generator.exports import export
from generator.exports.bodies import bodies_of
from generator.exports.engines import engine_friction
from generator.geometry import quaternion_matrix
from generator.scene import TABLE, Scene

RULES = {
    "pybullet": lambda a, b: a * b,
    "drake": lambda a, b: 2 * a * b / (a + b),
    "gazebo": min,
}
"""What each engine makes of two coefficients."""

DRAKE_NAMES = {"drake": "http://drake.mit.edu"}


def need(name: str) -> None:
    """Skip unless an engine is installed."""
    if not ENGINES[name].installed:
        pytest.skip(f"NOT CHECKED in {name}: pip install 'tabletopgen[engines]'")


@pytest.fixture(scope="module")
def scene() -> Scene:
    """Return a few objects, rougher and smoother than the table."""
    scene = load(BUNDLES["vanity"])
    things = [
        replace(thing, friction=mu)
        for thing, mu in zip(scene.objects, (0.3, 0.5, 0.7, 0.9), strict=True)
    ]
    return scene.replace(objects=tuple(things), report=None)


# --------------------------------------------------------------------------------------- documents


@pytest.mark.parametrize("engine", RULES)
@pytest.mark.parametrize("table", [0.2, 0.5, 1.5])
def test_friction_on_the_table_is_mujocos_by_each_engines_rule(engine: str, table: float) -> None:
    rough = [0.05, 0.2, 0.5, 0.9, 1.4]
    things = [toy_object(f"cube_{k}", (0.03, 0.03, 0.03), (k / 10, 0.0)) for k in range(5)]
    made = [replace(thing, friction=mu) for thing, mu in zip(things, rough, strict=True)]
    scene = toy_scene(tuple(made))
    scene = scene.replace(table=replace(scene.table, friction=table))
    friction = engine_friction(bodies_of(scene), scene.table.friction)
    found = {n: getattr(f, engine) for n, f in friction.items()}
    assert min(found.values()) > 0
    for thing in made:
        both = RULES[engine](found[thing.name], found[TABLE])
        assert both == pytest.approx(max(thing.friction, table))


def test_every_collision_says_its_friction_to_each_engine(scene: Scene, tmp_path: Path) -> None:
    wanted = engine_friction(bodies_of(scene), scene.table.friction)
    folder = export(scene, "urdf", tmp_path)
    roots = [ET.parse(path).getroot() for path in (folder / "objects").glob("*.urdf")]
    assert len(roots) == len(wanted) == len(scene.objects) + 2
    for root in [*roots, ET.parse(folder / "scene.urdf").getroot()]:
        for link in root.iterfind("link[collision]"):
            mu = wanted[link.attrib["name"]]
            rub = link.find("contact/lateral_friction")
            assert rub is not None and float(rub.attrib["value"]) == pytest.approx(mu.pybullet)
            check_drake_tags(link, mu.drake)
    for model in ET.parse(export(scene, "sdf", tmp_path) / "scene.sdf").getroot().iter("model"):
        mu = wanted[model.attrib["name"]]
        rubs = [float(e.text or "") for e in model.iterfind("link/collision/surface/*/ode/mu")]
        assert rubs and rubs == pytest.approx([mu.gazebo] * len(rubs))
        link = model.find("link")
        assert link is not None
        check_drake_tags(link, mu.drake)


def check_drake_tags(link: ET.Element, friction: float) -> None:
    """Check that each collision of a link has friction and compliant contact for Drake."""
    for collision in link.iterfind("collision"):
        tags = collision.find("drake:proximity_properties", DRAKE_NAMES)
        assert tags is not None
        assert tags.find("drake:compliant_hydroelastic", DRAKE_NAMES) is not None
        for name in ("drake:mu_static", "drake:mu_dynamic"):
            said = tags.find(name, DRAKE_NAMES)
            assert said is not None
            assert float(said.get("value") or said.text or "") == pytest.approx(friction)
        mesh = collision.find("geometry/mesh")
        assert mesh is None or mesh.find("drake:declare_convex", DRAKE_NAMES) is not None


def test_every_body_has_an_inertia(scene: Scene, tmp_path: Path) -> None:
    urdf = export(scene, "urdf", tmp_path)
    documents = [urdf / "scene.urdf", *(urdf / "objects").glob("*.urdf")]
    links = [link for path in documents for link in ET.parse(path).getroot().iter("link")]
    sdf = ET.parse(export(scene, "sdf", tmp_path) / "scene.sdf").getroot()
    mjcf = ET.parse(export(scene, "mjcf", tmp_path) / "scene.xml").getroot()
    for body in [*links, *sdf.iter("link"), *mjcf.iter("body")]:
        assert (body.find("inertial") is not None) == (body.get("name") != "world")


def test_a_body_without_inertia_can_be_added_to_mjcf(scene: Scene, tmp_path: Path) -> None:
    path = export(scene, "mjcf", tmp_path) / "scene.xml"
    spec = mujoco.MjSpec.from_file(str(path))
    before = spec.compile()
    added = spec.worldbody.add_body(name="cup", pos=[0, 0, 2])
    added.add_freejoint()
    added.add_geom(size=[0.02, 0.02, 0.02])
    after = spec.compile()
    assert after.body("cup").mass[0] > 0
    for thing in scene.objects:
        assert after.body(thing.name).mass[0] == before.body(thing.name).mass[0]
        assert after.body(thing.name).mass[0] == pytest.approx(thing.mass)


def test_the_floor_is_a_box_under_the_table(scene: Scene, tmp_path: Path) -> None:
    sdf = ET.parse(export(scene, "sdf", tmp_path) / "scene.sdf").getroot()
    floor = sdf.find("world/model[@name='floor']")
    assert floor is not None and floor.findtext("static") == "true"
    assert not [*sdf.iter("plane")]
    size = np.array(floor.findtext(".//box/size", "").split(), float)
    height = float(floor.findtext("pose", "").split()[2])
    assert height + size[2] / 2 == pytest.approx(0)
    poses = json.loads((export(scene, "urdf", tmp_path) / "poses.json").read_text())
    assert poses["floor"]["fixed"] and poses["floor"]["position"] == pytest.approx([0, 0, height])


def test_isaac_sim_takes_the_larger_coefficient(scene: Scene, tmp_path: Path) -> None:
    pytest.importorskip("pxr")
    from pxr import Usd, UsdShade

    stage = Usd.Stage.Open(str(export(scene, "usd", tmp_path) / "scene.usdc"))
    rubbing = [
        p for p in stage.Traverse() if p.IsA(UsdShade.Material) and p.GetName() == "Friction"
    ]
    assert len(rubbing) == len(scene.objects) + 1
    for prim in rubbing:
        applied = prim.GetMetadata("apiSchemas").GetAddedOrExplicitItems()
        assert {"PhysicsMaterialAPI", "PhysxMaterialAPI"} <= {*applied}
        assert prim.GetAttribute("physxMaterial:frictionCombineMode").Get() == "max"


# ----------------------------------------------------------------------------------------- engines


def test_pybullet_has_every_object_free_at_its_pose(scene: Scene, tmp_path: Path) -> None:
    need("PyBullet")
    simulation = ENGINES["PyBullet"].open(export(scene, "urdf", tmp_path))
    try:
        check_places(simulation.positions(), scene)
        drift, whose = rest_drift(simulation)
    finally:
        simulation.close()
    assert drift < 2e-3, whose


def test_pybullet_loads_into_the_client_that_is_named(scene: Scene, tmp_path: Path) -> None:
    need("PyBullet")
    folder = export(scene, "urdf", tmp_path)
    first, second = (ENGINES["PyBullet"].open(folder) for _ in range(2))
    try:
        check_places(first.positions(), scene)
        check_places(second.positions(), scene)
    finally:
        second.close()
        first.close()


@pytest.mark.slow
@pytest.mark.parametrize("name", ["Drake (URDF)", "Drake (SDF)"])
def test_drake_has_every_object_free_at_its_pose(name: str, scene: Scene, tmp_path: Path) -> None:
    need(name)
    simulation = ENGINES[name].open(export(scene, ENGINES[name].to, tmp_path))
    check_places(simulation.positions(), scene)


def check_places(found: object, scene: Scene) -> None:
    """Check that centres of mass match the scene, and that nothing else is free."""
    assert isinstance(found, dict)
    bodies = [body for body in bodies_of(scene) if not body.fixed]
    assert {*found} == {body.name for body in bodies}
    for thing, body in zip(scene.objects, bodies, strict=True):
        place = quaternion_matrix(thing.pose.quaternion) @ thing.com + thing.pose.position
        np.testing.assert_allclose(found[body.name], place, atol=1e-6, err_msg=body.name)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("to", "script", "needs"),
    [
        ("mjcf", "load_mujoco.py", "MuJoCo"), ("urdf", "load_pybullet.py", "PyBullet"),
        ("urdf", "load_drake.py", "Drake (URDF)"), ("sdf", "load_drake.py", "Drake (SDF)"),
    ],
)  # fmt: skip
def test_loaders_run_by_themselves(to: str, script: str, needs: str, tmp_path: Path) -> None:
    """They need nothing of this package, and can be started from any folder."""
    need(needs)
    scene = load(BUNDLES["vanity"])
    path = export(scene, to, tmp_path / "there") / script
    assert "generator" not in path.read_text()
    done = subprocess.run(
        [sys.executable, "-I", str(path)], capture_output=True, text=True, timeout=250, cwd="/"
    )
    assert done.returncode == 0, done.stderr[-2000:]
    rows = [line.split() for line in done.stdout.splitlines()]
    moved = {row[0]: float(row[1]) for row in rows if len(row) == 2}
    assert {*moved} >= {thing.name for thing in scene.objects}
    assert max(moved.values()) < 2.0


@pytest.mark.slow
def test_mjcf_opens_in_drake(scene: Scene, tmp_path: Path) -> None:
    need("Drake (URDF)")
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    plant = MultibodyPlant(0.002)
    Parser(plant).AddModels(export(scene, "mjcf", tmp_path) / "scene.xml")
    plant.Finalize()
    free = [plant.get_body(k) for k in plant.GetFloatingBaseBodies()]
    masses = {body.name(): body.default_mass() for body in free}
    assert masses == pytest.approx({thing.name: thing.mass for thing in scene.objects}, rel=1e-5)


@pytest.mark.slow
@pytest.mark.timeout(900)  # eleven things in Drake take half a minute of an idle machine
@pytest.mark.parametrize(
    "name",  # rectangular, all kinds of parts; round; boxes and hulls only
    part_of(BUNDLES, "lab", "coffee-table-task-2", "tidy-task-3"),
)
@pytest.mark.parametrize("engine", ["PyBullet", "Drake (URDF)"])
def test_every_shipped_bundle_stays_and_slides_as_in_mujoco(engine: str, name: str) -> None:
    """At rest within 2 mm for 2 s; the flattest thing slides within 2 degrees of MuJoCo's angle."""
    need(engine)
    rows = [row for e in ("MuJoCo", engine) for row in parity.work((BUNDLES[name], e))]
    assert parity.faults(rows) == []


@pytest.mark.slow
@pytest.mark.parametrize("name", part_of(["coffee-oval", "workbench"], "workbench"))
def test_bundles_stay_and_slide_in_drake_as_sdf(name: str) -> None:
    need("Drake (SDF)")
    rows = [row for e in ("MuJoCo", "Drake (SDF)") for row in parity.work((BUNDLES[name], e))]
    assert parity.faults(rows) == []


@pytest.mark.slow
@pytest.mark.parametrize("friction", [0.2, 0.8])
@pytest.mark.parametrize("engine", [name for name in ENGINES if name != "MuJoCo"])
def test_smooth_and_rough_things_slide_where_they_do_in_mujoco(
    engine: str, friction: float, tmp_path: Path
) -> None:
    need(engine)
    tile = replace(toy_object("tile", (0.1, 0.1, 0.02), (0.0, 0.0)), friction=friction)
    scene = toy_scene((tile,))
    expected = expected_friction(scene, tile)
    angles = []
    for name in ("MuJoCo", engine):
        simulation = ENGINES[name].open(export(scene, ENGINES[name].to, tmp_path, name))
        try:
            angles.append(slide_angle(simulation, "tile", expected))
        finally:
            simulation.close()
    assert angles[0] == pytest.approx(np.rad2deg(np.arctan(expected)), abs=1.5)
    assert angles[1] == pytest.approx(angles[0], abs=2.0)


def test_the_trials_see_what_falls_and_what_slides_early() -> None:
    good = {"bundle": "b", "engine": "MuJoCo", "drift_mm": "0.1", "moves": "a", "angle": "27.0",
            "error": ""}  # fmt: skip
    rows = [good, good | {"engine": "x"}]
    assert parity.faults(rows) == []
    for wrong in ({"drift_mm": "2.1"}, {"drift_mm": "nan"}, {"angle": "24.9"}, {"error": "broke"}):
        assert len(parity.faults([good, good | {"engine": "x"} | wrong])) == 1
    assert len(parity.faults([good | {"error": "broke", "drift_mm": "", "angle": ""}])) == 1


def test_the_trial_of_rest_can_fail(scene: Scene, tmp_path: Path) -> None:
    first, *rest = scene.objects
    pose = replace(first.pose, position=first.pose.position + np.array([0, 0, 0.01]))
    odd = scene.replace(objects=(replace(first, pose=pose), *rest), report=None)
    drift, whose = rest_drift(ENGINES["MuJoCo"].open(export(odd, "mjcf", tmp_path)))
    assert whose == first.name and drift > 5e-3


def test_the_table_of_results_has_every_shipped_bundle_and_no_fault() -> None:
    with (parity.HERE / "results" / "parity.csv").open(newline="") as file:
        rows = [*csv.DictReader(file)]
    assert {(r["bundle"], r["engine"]) for r in rows} == {(b, e) for b in BUNDLES for e in ENGINES}
    assert parity.faults(rows) == []
