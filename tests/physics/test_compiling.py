"""Models compiled in memory, or once for many poses, equal the compiled document."""

import dataclasses

import mujoco
import numpy as np
from toy import toy_object, toy_scene

from generator.physics.mjcf import document
from generator.physics.simulation import Simulation
from generator.physics.spec import compile_spec, scene_spec, spec_of
from generator.scene import Pose, Scene

NAMED = ("names", "paths", "pathadr", "names_map")


def numbers(model: mujoco.MjModel) -> dict[str, np.ndarray]:
    """Return all arrays of a model except names and their addresses."""
    found = {name: getattr(model, name) for name in dir(model) if not name.startswith("_")}
    return {
        name: value
        for name, value in found.items()
        if isinstance(value, np.ndarray) and not name.endswith(NAMED) and "name_" not in name
    }


def differing(one: mujoco.MjModel, other: mujoco.MjModel) -> list[str]:
    pairs = numbers(one), numbers(other)
    return [name for name in pairs[0] if not np.array_equal(pairs[0][name], pairs[1][name])]


def tossed(scene: Scene, seed: int) -> Scene:
    """Return the scene with everything at other, rotated poses."""
    rng = np.random.default_rng(seed)
    turns = [q / np.linalg.norm(q) for q in rng.normal(size=(len(scene.objects), 4))]
    return scene.replace(
        objects=tuple(
            dataclasses.replace(o, pose=Pose(rng.uniform(-0.3, 0.3, 3), turn))
            for o, turn in zip(scene.objects, turns, strict=True)
        )
    )


def test_meshes_handed_over_compile_to_what_their_files_do() -> None:
    scene = toy_scene()
    made = document(scene)
    files = compile_spec(spec_of(made, scene.name), scene.name)
    assert made.files
    assert differing(compile_spec(scene_spec(scene), scene.name), files) == []


def test_a_simulation_at_new_poses_is_as_if_compiled_there() -> None:
    scene = toy_scene()
    Simulation(scene)  # compiles the shapes
    for seed in range(5):
        moved = tossed(scene, seed)
        anew = compile_spec(scene_spec(moved, visuals=False), moved.name)
        simulation = Simulation(moved)
        assert differing(simulation.model, anew) == []
        assert np.allclose(simulation.positions, [o.pose.position for o in moved.objects], atol=0)


def test_simulations_of_one_scene_do_not_share_what_they_change() -> None:
    first, second = Simulation(toy_scene()), Simulation(toy_scene())
    first.model.opt.timestep = 0.1
    first.model.geom_margin[:] = 1.0
    assert second.model.opt.timestep != 0.1
    assert not second.model.geom_margin.any()


def test_other_masses_and_shapes_are_compiled_anew() -> None:
    scene = toy_scene()
    [first, *rest] = scene.objects
    heavier = scene.replace(objects=(dataclasses.replace(first, mass=2 * first.mass), *rest))
    wider = scene.replace(objects=(toy_object(first.name, (0.2, 0.2, 0.2), (0, 0)), *rest))
    masses = [Simulation(s).model.body(first.name).mass[0] for s in (scene, heavier)]
    assert masses[1] == 2 * masses[0]
    sizes = [Simulation(s).model.geom_rbound.sum() for s in (scene, wider)]
    assert sizes[0] != sizes[1]
