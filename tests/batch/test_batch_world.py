"""Batches compared with MuJoCo, and isolation of the worlds in a batch."""

import re
from functools import partial

import numpy as np
import pytest
import torch
from tables import COMPILING, awake, need_warp, shipped, turn
from torch import Tensor

from generator.errors import InputError
from tabletopgen_env.parallel.batch import engine, limits
from tabletopgen_env.parallel.batch.bank import SceneBank
from tabletopgen_env.parallel.batch.batch_world import BatchWorld
from tabletopgen_env.parallel.batch.limits import BatchLimits, bytes_per_world
from tabletopgen_env.robot.panda import HOME_CTRL
from tabletopgen_env.world.world import World

need_warp()
pytestmark = [pytest.mark.usefixtures("kernels"), pytest.mark.timeout(COMPILING)]

PAIR = ("vanity", "coffee-square")
SUBSTEPS = 25


@pytest.fixture(scope="module")
def bank() -> SceneBank:
    return SceneBank(shipped(*PAIR), max_parts=None)


@pytest.fixture(scope="module")
def batch(bank: SceneBank) -> BatchWorld:
    """Three worlds; every test loads them anew."""
    return BatchWorld(bank, 3, device="cpu")


def home(worlds: int) -> Tensor:
    return torch.tensor(HOME_CTRL).repeat(worlds, 1)


def everything(batch: BatchWorld, world: int) -> list[Tensor]:
    """Return a copy of a world's content."""
    state = batch.state
    names = [*type(state).__dataclass_fields__]
    return [getattr(state, name)[world].clone() for name in names] + [batch.bad[world].clone()]


def same(one: list[Tensor], other: list[Tensor]) -> bool:
    """Return whether two worlds are identical."""
    return all(torch.equal(a, b) for a, b in zip(one, other, strict=True))


def assert_close(batch: BatchWorld, k: int, world: World, mm: float, degrees: float) -> None:
    """Compare the objects of a batch's world with one of MuJoCo's."""
    state, bank = batch.state, batch.bank
    scene = int(state.scene[k])
    for name in world.names:
        slot = bank.slot(scene, name)
        off = state.slot_pos[k, slot].numpy() - world.to_base(world.position(name))
        rotation = world.base_rotation.T @ world.rotation(name)
        assert np.linalg.norm(off) < mm / 1e3, (world.scene.name, name)
        assert turn(state.slot_mat[k, slot].numpy(), rotation) < degrees, (world.scene.name, name)
    assert np.allclose(state.arm_qpos[k], world.data.qpos[world.arm_qpos], atol=1e-5)


def test_two_tables_rest_as_in_mujoco(batch: BatchWorld) -> None:
    batch.load([0, 1, 2], [0, 1, 0])
    parked = batch.state.slot_qpos[~batch.state.filled].clone()
    assert len(parked) == 2
    for _ in range(4):
        assert not batch.step(home(3), SUBSTEPS).any()
    for k, name in ((0, "vanity"), (1, "coffee-square"), (2, "vanity")):
        world = awake(*shipped(name))
        world.step(4 * SUBSTEPS)
        assert_close(batch, k, world, mm=0.05, degrees=0.1)
    assert torch.equal(batch.state.slot_qpos[~batch.state.filled], parked), "to the bit"
    assert same(everything(batch, 0), everything(batch, 2))


@pytest.mark.slow
def test_what_spins_in_the_air_does_so_as_in_mujoco(batch: BatchWorld) -> None:
    """Bodies with rotated inertias, for which the model needs space."""
    batch.load([0, 1, 2], [0, 1, 0])
    spin = torch.tensor([3.0, -4.0, 5.0])
    batch.state.slot_qpos[..., 2] += 0.3 * batch.state.filled
    batch.state.slot_qvel[..., 3:] += spin * batch.state.filled[..., None]
    for _ in range(4):
        batch.step(home(3), SUBSTEPS)
    for k, name in enumerate(PAIR):
        world = awake(*shipped(name))
        for thing in world.names:
            world.data.joint(thing).qpos[2] += 0.3
            world.data.joint(thing).qvel[3:] += spin.numpy()
        world.step(4 * SUBSTEPS)
        assert_close(batch, k, world, mm=0.002, degrees=0.002)


@pytest.mark.slow
def test_servo_commands_move_evenly(batch: BatchWorld) -> None:
    batch.load([0, 1, 2], [0, 0, 0])
    world = awake(*shipped("vanity"))
    wanted = np.add(HOME_CTRL, [0.1, 0.05, 0.1, -0.1, 0.1, 0.1, 0.1, -155.0])
    for substeps in (SUBSTEPS, 10, 1):
        batch.step(torch.as_tensor(wanted).float().repeat(3, 1), substeps)
        world.data.ctrl[world.actuators] = wanted
        world.step(substeps)
        assert torch.equal(batch.state.ctrl[0], torch.as_tensor(wanted).float())
        assert np.allclose(batch.state.arm_qpos[0], world.data.qpos[world.arm_qpos], atol=2e-6)
        assert np.allclose(
            batch.state.finger_qpos[0], world.data.qpos[world.finger_qpos], atol=2e-6
        )
        at = world.to_base(world.data.site_xpos[world.tcp])
        assert np.allclose(batch.state.tcp_pos[0], at, atol=1e-5)
        assert np.allclose(batch.state.tcp_mat[0], world.hand, atol=1e-5)
        wanted = np.array(HOME_CTRL)


@pytest.mark.slow
def test_loading_leaves_the_others_to_the_bit(bank: SceneBank, batch: BatchWorld) -> None:
    batch.load([0, 1, 2], [0, 1, 0])
    push = home(3) + torch.tensor([0.1, 0.1, 0, 0, 0, 0, 0, 0])
    batch.step(push, SUBSTEPS)
    before = everything(batch, 0), everything(batch, 2)
    batch.load([1], [0])
    assert same(before[0], everything(batch, 0)) and same(before[1], everything(batch, 2))
    batch.step(push, SUBSTEPS)
    undisturbed = BatchWorld(bank, 3, device="cpu")
    undisturbed.load([0, 1, 2], [0, 1, 0])
    for _ in range(2):
        undisturbed.step(push, SUBSTEPS)
    assert same(everything(batch, 0), everything(undisturbed, 0))
    fresh = BatchWorld(bank, 3, device="cpu")
    fresh.step(push, SUBSTEPS)
    assert same(everything(batch, 1), everything(fresh, 0)), "nothing is left of what was there"


@pytest.mark.slow
def test_a_start_of_ones_own(bank: SceneBank, batch: BatchWorld) -> None:
    batch.load([0, 1, 2], [0, 1, 0])
    at = bank.union.addresses
    qpos = torch.as_tensor(bank.rows["qpos"][[1, 0]]).clone()
    ctrl = home(2) + torch.tensor([0.2, 0, 0, 0, 0, 0, 0, -255.0])
    qpos[:, at.arm_qpos] = ctrl[:, :7]
    qpos[:, at.slot_qpos.start + 2] += 0.1
    batch.load([2, 0], [1, 0], qpos=qpos, ctrl=ctrl)
    state = batch.state
    assert state.scene.tolist() == [0, 1, 1]
    assert torch.equal(state.slot_pos[2, 0], qpos[0, at.slot_qpos][:3]), "poses follow at once"
    assert not torch.allclose(state.tcp_pos[2], state.tcp_pos[1], atol=0.05)
    batch.step(torch.cat([ctrl[:1], home(1), ctrl[:1]]), 1)
    assert torch.allclose(state.arm_qpos[2], ctrl[0, :7], atol=1e-4), "no servo pulls it back"


@pytest.mark.slow
def test_one_world_alone_has_absent_parts_too(bank: SceneBank, batch: BatchWorld) -> None:
    alone = BatchWorld(bank, 1, device="cpu")
    batch.load([0, 1, 2], [0, 1, 0])
    for one in (alone, batch):
        for _ in range(2):
            one.step(home(one.num_worlds), SUBSTEPS)
    assert torch.allclose(alone.state.slot_qpos[0], batch.state.slot_qpos[0], atol=1e-7)


def spoil_by_heap(batch: BatchWorld) -> None:
    """Put all objects of world 1 at one point."""
    batch.state.slot_qpos[1, :, :3] = torch.tensor([0.5, 0.0, 0.05])


def spoil_by_nan(batch: BatchWorld) -> None:
    batch.state.qpos[1, 10] = torch.nan


def spoil_by_speed(batch: BatchWorld) -> None:
    batch.state.qvel[1, 12] = 1e30


@pytest.mark.slow
@pytest.mark.parametrize("spoil", [spoil_by_heap, spoil_by_nan, spoil_by_speed])
def test_a_world_that_breaks_down_breaks_down_alone(bank: SceneBank, spoil) -> None:
    few = BatchLimits(contacts=32, depths=16, rows=150)
    healthy, spoilt = (BatchWorld(bank, 3, device="cpu", limits=few) for _ in range(2))
    for one in (healthy, spoilt):
        one.load([0, 1, 2], [0, 1, 0])
    spoil(spoilt)
    for _ in range(3):
        assert not healthy.step(home(3), 5).any()
        assert spoilt.step(home(3), 5).tolist() == [False, True, False]
    for k in (0, 2):
        assert same(everything(healthy, k), everything(spoilt, k))
    counts = (3, 0) if spoil is spoil_by_heap else (0, 3)
    assert (spoilt.overflows, spoilt.divergences) == counts
    for one in (healthy, spoilt):
        one.load([1], [1])
        assert not one.bad.any()
        assert not one.step(home(3), SUBSTEPS).any()
    assert same(everything(healthy, 1), everything(spoilt, 1)), "a load heals it"


@pytest.mark.slow
def test_another_bank_takes_the_place_of_the_first(
    bank: SceneBank, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    second = SceneBank(shipped("coffee-square"), shape=bank.union.shape, max_parts=None)
    batch = BatchWorld(bank, 2, device="cpu")
    batch.step(home(2), SUBSTEPS)
    held, warp = batch.state.qpos, engine.Engine.load().warp
    with monkeypatch.context() as patch:
        patch.setattr(warp.config, "log_level", warp.LOG_INFO)
        capfd.readouterr()
        batch.swap(second)
        batch.step(home(2), SUBSTEPS)
    assert "compiled" not in "".join(capfd.readouterr())
    assert batch.state.qpos is held and batch.state.scene.tolist() == [0, 0]
    fresh = BatchWorld(second, 2, device="cpu")
    fresh.step(home(2), SUBSTEPS)
    assert same(everything(batch, 1), everything(fresh, 1))
    other = SceneBank(shipped("dining-fruit"))
    with pytest.raises(InputError, match=r"shape=old.union.shape"):
        batch.swap(other)


@pytest.mark.slow
def test_wrong_calls_are_refused(batch: BatchWorld) -> None:
    with pytest.raises(InputError, match=r"ctrl must have shape \(3, 8\), got \(2, 8\)"):
        batch.step(home(2), SUBSTEPS)
    with pytest.raises(InputError, match="substeps"):
        batch.step(home(3), 0)
    with pytest.raises(InputError, match=r"from 0 to 2, got \[3\]"):
        batch.load([3], [0])
    with pytest.raises(InputError, match=r"from 0 to 1, got \[-1, 2\]"):
        batch.load([0, 1], [2, -1])
    with pytest.raises(InputError, match="one scene per world, got 1 scenes for 2"):
        batch.load([0, 1], [1])


@pytest.mark.slow
def test_what_does_not_fit_says_how_many_do(
    bank: SceneBank, monkeypatch: pytest.MonkeyPatch
) -> None:
    each = bytes_per_world(bank, BatchLimits.of(bank))
    assert 2e5 < each < 2e6
    assert bytes_per_world(bank, BatchLimits(contacts=256, depths=128, rows=1000)) > 2 * each
    monkeypatch.setattr(limits, "free_bytes", lambda device: 10 * each)
    with pytest.raises(InputError, match=r"11 worlds take about .* GiB free: at most 10 fit"):
        BatchWorld(bank, 11, device="cpu")
    for count in (0, -1, 2.5):
        with pytest.raises(InputError, match="num_worlds"):
            BatchWorld(bank, count, device="cpu")  # type: ignore[arg-type]


@pytest.mark.slow
def test_a_world_takes_the_memory_that_is_said(
    bank: SceneBank, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Compared with all allocations of MuJoCo Warp for model, state and a step."""
    warp = engine.Engine.load().warp
    taken = []
    make = {name: getattr(warp, name) for name in ("empty", "zeros", "full")}

    def count(name: str, *args, **kwargs):
        taken.append(made := make[name](*args, **kwargs))
        return made

    sums = []
    for worlds in (40, 60):
        batch = BatchWorld(bank, worlds, device="cpu")
        simulator = batch._simulator
        taken.clear()
        with monkeypatch.context() as patch:
            for name in make:
                patch.setattr(warp, name, partial(count, name))
            simulator._engine.physics.step(simulator._model, simulator._data)
        kept = [limits._array_bytes(simulator._engine, simulator._data)]
        kept += [limits._array_bytes(simulator._engine, simulator._model)]
        sums.append(sum(kept) + sum(array.capacity or 0 for array in taken))
    each = (sums[1] - sums[0]) / 20
    assert bytes_per_world(bank, BatchLimits.of(bank)) == pytest.approx(each, rel=0.1)


def test_limits_are_checked() -> None:
    with pytest.raises(InputError, match="rows"):
        BatchLimits(rows=0)
    with pytest.raises(InputError, match=r"depths must be at most BatchLimits\.contacts"):
        BatchLimits(contacts=8, depths=9)


@pytest.mark.parametrize("device", ["tpu", "mps", "cuda:99", 3.5])
def test_devices_that_there_are_not(device) -> None:
    with pytest.raises(InputError, match=r"device must be|not on 'mps'|'cuda:99' is not available"):
        engine.find_device(device)


@pytest.mark.skipif(torch.cuda.is_available(), reason="there is a GPU here")
def test_a_gpu_is_asked_for_where_there_is_none(bank: SceneBank) -> None:
    with pytest.raises(InputError, match=r"no CUDA device that torch can use.*device='cpu'"):
        BatchWorld(bank, 4)


@pytest.mark.parametrize(
    ("versions", "said"),
    [
        ({"mujoco-warp": None, "warp-lang": None}, "mujoco-warp and warp-lang are not installed"),
        ({"warp-lang": None}, "warp-lang is not installed"),
        ({"mujoco-warp": "3.13.0"}, "mujoco 3.17.0 and mujoco-warp 3.13.0 are installed"),
    ],
)
def test_the_extra_is_checked(versions, said, monkeypatch: pytest.MonkeyPatch) -> None:
    there = {"mujoco": "3.17.0", "mujoco-warp": "3.17.0", "warp-lang": "1.19.0"} | versions
    monkeypatch.setattr(engine, "_version", lambda package: there[package])
    with pytest.raises(InputError, match=re.escape(said) + ".*" + re.escape(engine.PIP)):
        engine.Engine.load()
