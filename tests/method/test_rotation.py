import dataclasses

import numpy as np
import pytest
import torch
from posed import FAST, SIZE, VIEW, box, picture_of

from generator.backends.embedded.encoder import EmbeddedEncoder
from generator.errors import InputError
from generator.geometry import wrap
from generator.method import rotation as dro
from generator.method.rotation import RotationConfig
from generator.render.soft import SampledSurface
from generator.scene import TABLE, Mesh, Model, View
from tabletop_objects import build


def shown(key: str, yaw: float, pixel: tuple[int, int] = (320, 240), seed: int = 5):
    """An object of the catalogue, and its visible part in a picture."""
    model = build(key, seed)
    return model, picture_of(model, yaw, pixel)[0]


def optimised(model, instance, config=FAST, view: View = VIEW, **more):
    return dro.optimise_rotation(model, instance, view, EmbeddedEncoder(), config, SIZE, **more)


def objectives(model, instance, config=FAST, **more):
    return dro.make_objectives([model], [instance], VIEW, EmbeddedEncoder(), config, SIZE, **more)


def doubled(value):
    """Return an objective with all its tensors in double precision."""
    if isinstance(value, torch.Tensor):
        return value.double() if value.is_floating_point() else value
    if isinstance(value, tuple):
        return tuple(map(doubled, value))
    if isinstance(value, (SampledSurface, dro.Target, dro.Objective)):
        changes = {f.name: doubled(getattr(value, f.name)) for f in dataclasses.fields(value)}
        return dataclasses.replace(value, **changes)
    return value


# ------------------------------------------------------------------------------------ equations
def test_eq2_by_hand():
    mask = torch.tensor([[1.0, 1.0], [0.0, 0.0]])
    soft = torch.stack([
        mask,
        1 - mask,
        torch.full((2, 2), 0.5),
        torch.tensor([[1.0, 0.0], [1.0, 0.0]]),
    ])  # fmt: skip
    # intersections 2, 0, 1, 1; unions 2, 4, 3, 3
    expected = torch.tensor([0.0, 1.0, 2 / 3, 2 / 3])
    assert torch.allclose(dro.silhouette_loss(soft, mask), expected, atol=1e-5)


def test_eq3_by_hand():
    distance = torch.tensor([[0.0, 1.0, 2.0]])
    edges = torch.tensor([[[1.0, 0.0, 0.0]], [[0.0, 0.5, 0.5]], [[2.0, 0.0, 2.0]]])
    assert torch.allclose(dro.edge_loss(edges, distance), torch.tensor([0.0, 1.5, 1.0]), atol=1e-5)


def test_eq3_ranks_the_candidates_of_one_batch():
    """Averaged over the batch, it would be equal for all candidates."""
    mask = np.zeros((32, 32), bool)
    mask[8:24, 8:24] = True
    distance = torch.as_tensor(dro.contour_distance(mask))
    from generator.render.soft import sobel_edges

    silhouettes = torch.as_tensor(np.stack([np.roll(mask, k, 1) for k in (0, 2, 6)])).float()
    near, off, far = dro.edge_loss(sobel_edges(silhouettes), distance)
    assert near < off < far
    alone = dro.edge_loss(sobel_edges(silhouettes[1:2]), distance)
    assert torch.allclose(alone, off)


def test_contour_distance_of_a_square():
    mask = np.zeros((20, 20), bool)
    mask[5:15, 5:15] = True
    distance = dro.contour_distance(mask)
    assert distance[10, 5] <= 1 and distance[10, 14] <= 1
    assert distance[10, 10] == pytest.approx(5, abs=1)
    assert distance[10, 0] == pytest.approx(5, abs=1)


def test_eq4_by_hand():
    flat, one = torch.zeros(1, 2, 2, 2), torch.ones(2, 2, 2, 2)
    one[1] = 0.5
    finer = torch.zeros(2, 3, 4, 4)
    loss = dro.appearance_loss((one, finer), (flat, torch.zeros(1, 3, 4, 4)))
    assert torch.allclose(loss, torch.tensor([2.0 / 2, 0.5 / 2]))


def test_eq1_weights_are_the_papers():
    one, zero = torch.ones(1), torch.zeros(1)
    config = RotationConfig()
    assert float(dro.rotation_loss(one, zero, zero, config)) == 0.5
    assert float(dro.rotation_loss(zero, one, zero, config)) == 0.5
    assert float(dro.rotation_loss(zero, zero, one, config)) == 2.0


def test_paper_settings():
    paper = RotationConfig.paper()
    assert (paper.lambda_s, paper.lambda_e, paper.lambda_a) == (0.5, 0.5, 2.0)
    assert np.rad2deg(paper.coarse_step) == pytest.approx(5.0)
    assert (paper.candidates, paper.steps, paper.learning_rate) == (8, 140, 3e-2)
    assert (paper.resolution, paper.patience, paper.perspective) == (256, 0, False)


@pytest.mark.parametrize(
    "wrong",
    [
        {"coarse_step": 0.0}, {"candidates": 0}, {"resolution": 4}, {"close_resolution": 4},
        {"close_points": 1}, {"rivals": 0}, {"close_steps": -1}, {"doubt": -0.1},
        {"tie": float("nan")}, {"lambda_a": float("nan")}, {"lambda_s": -1.0},
        {"lambda_s": 0, "lambda_e": 0, "lambda_a": 0}, {"learning_rate": float("nan")},
        {"learning_rate": 0.0}, {"edge_unit": 0.0}, {"max_tilt": -0.1}, {"max_fit": float("inf")},
        {"candidates": 2.5}, {"steps": True}, {"unsure": 2.0}, {"device": "gpu"}, {"device": None},
        {"patience": -1}, {"separation": -0.1}, {"thinning": "3"},
    ],
)  # fmt: skip
def test_settings_out_of_range_are_refused(wrong):
    with pytest.raises(InputError, match=r"RotationConfig\.\w+"):
        RotationConfig(**wrong)


def test_a_gpu_that_is_not_there_is_refused(monkeypatch):
    monkeypatch.setattr(torch.cuda, "device_count", lambda: 1)
    with pytest.raises(InputError, match=r"torch finds 1 CUDA GPUs"):
        objectives(*shown("plate", 2.0, seed=0), dataclasses.replace(FAST, device="cuda:1"))


# --------------------------------------------------------------------------------------- search
def test_candidates_keep_their_separation():
    yaws = np.deg2rad(np.arange(0, 360, 5.0))
    losses = np.minimum(np.abs(np.rad2deg(yaws) - 90), np.abs(np.rad2deg(yaws) - 270) + 3)
    config = RotationConfig(candidates=3, separation=np.deg2rad(15.0))
    np.testing.assert_allclose(np.rad2deg(yaws[dro.select(yaws, losses, config)]), [90, 270, 75])
    neighbours = yaws[dro.select(yaws, losses, RotationConfig(candidates=3, separation=0.0))]
    assert np.rad2deg(neighbours)[0] == pytest.approx(90)
    assert np.ptp(np.rad2deg(neighbours)) < 200


@pytest.mark.slow
@pytest.mark.parametrize(
    ("key", "yaw", "pixel"),
    [("mug", 20.0, (320, 250)), ("toy_train", -130.0, (150, 130)), ("hairbrush", 75.0, (480, 330))],
)
def test_yaw_is_recovered_with_a_wrong_elevation(key, yaw, pixel):
    model = build(key, 5)
    instance, reference = picture_of(model, np.deg2rad(yaw), pixel)
    believed = View(VIEW.azimuth, VIEW.elevation + np.deg2rad(2.5), VIEW.fov)
    found = dro.estimate_rotations(
        reference, (instance,), {model.name: model}, believed, EmbeddedEncoder(), FAST
    )[model.name]
    assert abs(np.rad2deg(wrap(found.yaw - np.deg2rad(yaw)))) < 4
    assert found.candidates[0] == (found.yaw, found.loss)
    losses = [loss for _, loss in found.candidates]
    assert losses == sorted(losses)


@pytest.mark.slow
def test_an_object_at_the_side_is_seen_along_its_own_ray():
    model = build("toy_train", 5)
    yaw = 0.4
    wide = View(0.0, np.deg2rad(50.0), np.deg2rad(55.0))
    instance, _ = picture_of(model, yaw, (70, 240), wide)
    errors = {}
    for perspective in (True, False):
        config = dataclasses.replace(FAST, perspective=perspective)
        found = optimised(model, instance, config, wide)
        errors[perspective] = abs(np.rad2deg(wrap(found.yaw - yaw)))
    assert errors[True] < 3
    assert errors[False] > errors[True] + 3


@pytest.mark.slow
def test_refining_descends_from_the_coarse_angle():
    objective = objectives(*shown("toy_train", 0.53)).fine
    before = dro.coarse_losses(objective, np.array([0.45]))[0, 0]
    ((found,),) = dro.refine(objective, [[dro.RotationCandidate(0.45, before)]], 25)
    assert found.loss < before
    assert abs(found.yaw - 0.53) < abs(0.45 - 0.53) / 2


@pytest.mark.slow
@pytest.mark.parametrize("weights", [(1, 0, 0), (0, 1, 0), (0, 0, 1)], ids=["s", "e", "a"])
@pytest.mark.parametrize("settings", [RotationConfig(), RotationConfig.paper()], ids=["", "paper"])
def test_gradients_of_the_objective_agree_with_finite_differences(settings, weights):
    """For yaw and tilt of an off-axis object, whose centre moves while its crop stays tight.

    Without the picture's light on the render: what that is does not follow the normals' gradient.
    """
    model = build("toy_train", 5)
    instance, _ = picture_of(model, 0.53, (520, 130))
    s, e, a = weights
    config = dataclasses.replace(
        settings, lambda_s=s, lambda_e=e, lambda_a=a, resolution=48, coarse_resolution=48,
        points=2000, relight=False,
    )  # fmt: skip
    made = dro.make_objectives([model], [instance], VIEW, EmbeddedEncoder(), config, SIZE).fine
    objective, owner = doubled(made), torch.zeros(1, dtype=torch.long)

    def loss(angles: torch.Tensor) -> torch.Tensor:
        return objective(dro.Candidates(owner, angles[:1], angles[1:]))[0]

    angles = torch.tensor([0.7, 0.02], dtype=torch.float64, requires_grad=True)
    (gradient,) = torch.autograd.grad(loss(angles), angles)
    for k, offset in enumerate(1e-6 * torch.eye(2, dtype=torch.float64)):
        with torch.no_grad():
            slope = float((loss(angles + offset) - loss(angles - offset)) / 2e-6)
        assert float(gradient[k]) == pytest.approx(slope, rel=2e-3, abs=2e-4)
        assert abs(slope) > 0.01


@pytest.mark.slow
def test_objects_of_a_batch_are_found_as_if_alone():
    models = [build("toy_train", 5), build("plate", 0), build("mug", 5)]
    instances = [
        picture_of(m, yaw, (320, 240))[0] for m, yaw in zip(models, (0.5, 2.0, -1.0), strict=True)
    ]
    config = dataclasses.replace(FAST, steps=6, patience=0)
    together = dro.search(
        dro.make_objectives(models, instances, VIEW, EmbeddedEncoder(), config, SIZE)
    )
    assert [answer.symmetric for answer in together] == [False, True, False]
    assert together[1].looks[0][0].yaw == 0.0, "a plate has no yaw"
    for model, instance, found in zip(models, instances, together, strict=True):
        alone = dro.optimise_rotation(model, instance, VIEW, EmbeddedEncoder(), config, SIZE)
        assert alone.yaw == pytest.approx(found.looks[0][0].yaw, abs=np.deg2rad(0.2))


def test_what_may_be_hidden_counts_for_little():
    model, instance = shown("toy_train", 0.53)
    x0, _, x1, _ = instance.box.astype(int)
    hidden = np.zeros(instance.mask.shape, bool)
    hidden[:, : x0 + (x1 - x0) // 3] = True
    spoilt = instance.crop.copy()
    spoilt[:, : spoilt.shape[1] // 3, :3] = (255, 0, 255)  # a wrong guess of the hidden part
    guessed = dataclasses.replace(instance, crop=spoilt)
    known, unsure = (
        dro.coarse_losses(objectives(model, guessed, hidden=[where]).fine, np.array([0.53]))[0, 0]
        for where in (None, hidden)
    )
    assert unsure < 0.6 * known


@pytest.mark.slow
def test_a_hidden_part_that_is_missing_is_allowed_for():
    model, instance = shown("toy_train", 0.53)
    cut = instance.crop.copy()
    cut[:, -int(0.12 * cut.shape[1]) :, 3] = 0
    errors = []
    for occluded in (True, False):
        found = optimised(model, dataclasses.replace(instance, crop=cut, occluded=occluded))
        errors.append(abs(np.rad2deg(wrap(found.yaw - 0.53))))
    assert errors[0] < min(errors[1], 4)


def test_no_tilt_and_no_fit_leave_both_as_they_are():
    model, instance = shown("toy_train", 0.53)
    part = dataclasses.replace(instance, occluded=True)
    config = dataclasses.replace(FAST, max_tilt=0.0, max_fit=0.0)
    objective = objectives(model, part, config).fine
    ((found,),) = dro.refine(objective, [[dro.RotationCandidate(0.5)]], 6)
    assert found.tilt == 0.0 and found.place == (0.0, 0.0, 0.0)
    assert abs(found.yaw - 0.53) < 0.02


@pytest.mark.slow
def test_same_seed_same_rotation():
    model, instance = shown("mug", 0.3, (300, 200), seed=1)
    config = dataclasses.replace(FAST, steps=4)
    first, again = (optimised(model, instance, config, seed=3) for _ in range(2))
    assert first == again


@pytest.mark.slow
def test_an_object_of_revolution_keeps_yaw_zero():
    found = optimised(*shown("plate", 2.0, seed=0), RotationConfig())
    assert found.yaw == 0.0 and found.symmetric
    assert found.margin == 0.0 and found.width == np.pi


def painted(quarter: tuple[int, int, int], half: tuple[int, int, int]) -> Model:
    """A round tin with a white side, except for one half with a quarter in other colours."""
    n, corners, faces, u = 48, [], [], []
    at = np.arange(n + 1) * 2 * np.pi / n
    ring = np.column_stack([np.cos(at), np.sin(at)]) / 2
    for k in range(n):
        (x0, y0), (x1, y1) = ring[k], ring[k + 1]
        m = len(corners)
        corners += [(x0, y0, -0.5), (x1, y1, -0.5), (x1, y1, 0.5), (x0, y0, 0.5)]
        corners += [(0, 0, 0.5), (x0, y0, 0.5), (x1, y1, 0.5)]
        corners += [(0, 0, -0.5), (x1, y1, -0.5), (x0, y0, -0.5)]
        faces += [
            (m, m + 1, m + 2),
            (m, m + 2, m + 3),
            (m + 4, m + 5, m + 6),
            (m + 7, m + 8, m + 9),
        ]
        u += [(k + 0.5) / n] * 4 + [0.95] * 6
    texture = np.full((1, 64, 3), 235, np.uint8)
    texture[0, :32], texture[0, 8:24] = half, quarter
    mesh = Mesh(
        np.array(corners), np.array(faces), np.column_stack([u, np.full(len(u), 0.5)]), texture
    )
    return dataclasses.replace(build("candle", 0), mesh=mesh, size=np.array([0.09, 0.09, 0.08]))


@pytest.mark.slow
def test_a_round_thing_with_a_print_is_turned_and_the_surer_the_stronger_it_is():
    sure = []
    for model in (painted((200, 30, 30), (30, 60, 190)), painted((225, 235, 235), (230, 230, 240))):
        found = optimised(model, picture_of(model, 0.7, (320, 240))[0], RotationConfig())
        sure.append((found, found.margin / (found.margin + 0.1)))
    (found, strong), (_, weak) = sure
    assert not found.symmetric
    assert abs(np.rad2deg(wrap(found.yaw - 0.7))) < 4
    assert found.margin > 0.234
    assert np.rad2deg(found.width) < 5
    assert weak < 0.5 * strong


@pytest.mark.slow
@pytest.mark.parametrize(
    ("size", "front", "order"),
    [((0.16, 0.09, 0.06), None, 2), ((0.1, 0.1, 0.06), None, 4),
     ((0.16, 0.09, 0.06), (200, 30, 30), 1)],
)  # fmt: skip
def test_a_side_that_looks_the_same_is_no_rival(size, front, order):
    """For a plain box, half a turn is not a distinct answer; for one with a red end, it is."""
    model = box(size, front)
    found = optimised(model, picture_of(model, 0.6, (320, 240))[0])
    assert found.order == order and not found.symmetric
    assert abs(np.rad2deg(wrap(order * (found.yaw - 0.6)) / order)) < 4
    assert found.margin > 0.15
    rivals = [loss for yaw, loss in found.candidates if abs(wrap(yaw - found.yaw)) > 1]
    if order > 1 and rivals:  # it is sure though another yaw fits as well
        assert min(rivals) < 1.1 * found.loss


@pytest.mark.parametrize(
    ("margins", "expected"),
    [
        ([[(0.0, 1.0), (2.0, 1.3)]], 0.3),
        ([[(0.0, 1.0)], [(0.1, 2.0), (2.0, 3.0)]], 0.5),
        ([[(0.0, 1.0), (2.0, 1.3)], [(2.05, 1.0), (0.0, 2.0)]], 0.3),  # its closest look counts
        ([[(0.0, 1.0), (0.2, 1.1)]], 0.0),  # no other side was looked at
        ([[(0.0, 1.0)], [(0.0, 2.0), (-2.0, 1.8)]], 0.0),
    ],
)
def test_margin_is_told_by_the_closest_look(margins, expected):
    looks = [[dro.RotationCandidate(yaw, loss) for yaw, loss in look] for look in margins]
    assert dro.margin(looks) == pytest.approx(expected)


def test_margin_is_modulo_the_looks():
    look = [
        dro.RotationCandidate(y, loss) for y, loss in ((0.1, 1.0), (0.1 - np.pi, 1.01), (1.6, 1.4))
    ]
    assert dro.margin([look]) == pytest.approx(0.01)
    assert dro.margin([look], order=2) == pytest.approx(0.4)
    assert dro.margin([look], order=4) == 0.0


@pytest.mark.slow
def test_width_follows_the_curvature():
    """Defined by a loss increase of a fiftieth; sharper minima are narrower."""
    wide = {}
    for key in ("hairbrush", "mug"):
        objective = objectives(*shown(key, 0.5)).fine
        ((found, *_),) = dro.refine(objective, [[dro.RotationCandidate(0.5)]], 20)
        (wide[key],) = dro.widths(objective, [found])
        there = np.array([found.yaw, found.yaw + 3 * wide[key]])
        low, high = dro.losses_at(objective, 0, there, [found.place] * 2)
        assert high > 1.04 * low
    assert 0 < wide["hairbrush"] < wide["mug"] < np.deg2rad(30)


@pytest.mark.slow
def test_a_mug_whose_handle_is_small_is_not_taken_for_round():
    config = dataclasses.replace(RotationConfig(), suspect=1e9)
    mug, plate = (
        objectives(*shown(key, 2.4, seed=seed), config).close
        for key, seed in (("mug", 5), ("plate", 0))
    )
    assert not dro.looks_round(mug, np.array([True]), config.flat)[0]
    assert dro.looks_round(plate, np.array([True]), config.flat)[0]
    assert dro.turning_changes(plate(), 0) < config.flat / 2


# ---------------------------------------------------------------------------------- hidden sides
def test_which_sides_may_be_cut_off():
    box = np.array([0.0, 0, 80, 40])
    hidden = np.zeros((100, 100), bool)
    assert not dro.cut_sides(hidden, box).any()
    needle = np.array([0.0, 0, 400, 1])
    assert not dro.cut_sides(hidden, needle).any()
    hidden[68:, 30:60] = True  # below: the box's lower side is at 72.5
    assert dro.cut_sides(hidden, box).tolist() == [False, False, False, True]
    hidden[40:60, 93:] = True
    assert dro.cut_sides(hidden, box).tolist() == [False, False, True, True]


@pytest.mark.parametrize("side", ["left", "right", "top", "bottom"])
def test_an_object_reaches_past_the_side_that_is_hidden(side):
    """Drawn in full, it fits its visible part better than drawn into that part's box."""
    model, instance = shown("toy_train", 0.53)
    height, width = instance.crop.shape[:2]
    cut = instance.crop.copy()
    gone = {
        "left": np.s_[:, : width // 6], "right": np.s_[:, -(width // 6) :],
        "top": np.s_[: height // 6], "bottom": np.s_[-(height // 6) :],
    }[side]  # fmt: skip
    cut[..., 3][gone] = 0
    x0, y0 = instance.box[:2].astype(int)
    hidden = np.zeros(instance.mask.shape, bool)
    hidden[y0 : y0 + height, x0 : x0 + width] = cut[..., 3] == 0
    part = dataclasses.replace(instance, crop=cut, occluded=True)
    coarse = objectives(model, part, RotationConfig(), hidden=[hidden]).coarse
    tight = dro.coarse_losses(coarse, np.array([0.53]))
    losses, ((place,),) = dro.coarse_search(coarse, np.array([0.53]))
    assert losses[0, 0] < 0.8 * tight[0, 0]
    towards = {"left": (0, -1), "right": (0, 1), "top": (1, -1), "bottom": (1, 1)}[side]
    assert towards[1] * place[towards[0]] > 0.02


@pytest.mark.slow
def test_the_table_is_left_out_and_a_missing_model_named():
    model = build("mug", 1)
    instance, reference = picture_of(model, 0.3, (300, 200))
    table = dataclasses.replace(instance, name=TABLE)
    assert dro.estimate_rotations(reference, (table,), {}, VIEW, EmbeddedEncoder(), FAST) == {}
    with pytest.raises(InputError, match="no model"):
        dro.estimate_rotations(reference, (instance,), {}, VIEW, EmbeddedEncoder(), FAST)


def test_an_empty_crop_is_refused():
    model, instance = shown("mug", 0.3, (300, 200), seed=1)
    with pytest.raises(InputError, match="fully transparent crop"):
        optimised(model, dataclasses.replace(instance, crop=np.zeros((8, 8, 4), np.uint8)))
