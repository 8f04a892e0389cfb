"""Models in this process: fakes with the real signatures, and their inputs."""

from __future__ import annotations

import contextlib
import sys
import types
from pathlib import Path

import numpy as np
import pytest
import trimesh
from backends.modelers.foreign import instance, prior, striped_box
from scipy.spatial.transform import Rotation

from generator.backends.modelers.sam3d import Sam3D
from generator.backends.modelers.trellis import Trellis
from generator.backends.modelers.triposr import TripoSR
from generator.errors import BackendError, InputError
from generator.geometry import Camera
from generator.method.rotation import prior_yaw
from generator.scene import USUAL_VIEW, Model, View


def install(monkeypatch, name: str, **members) -> None:
    """Install a module and its parent packages in sys.modules."""
    parts = name.split(".")
    for k in range(1, len(parts) + 1):
        stem = ".".join(parts[:k])
        if k == len(parts) or stem not in sys.modules:
            monkeypatch.setitem(sys.modules, stem, types.ModuleType(stem))
    vars(sys.modules[name]).update(members)


def ask(modeler, view: View = USUAL_VIEW) -> Model:
    return modeler.model(instance("mug"), prior("mug"), view)


def tall(up: int) -> trimesh.Trimesh:
    """Return a box twice as high as wide, with vertex colours."""
    size = np.ones(3)
    size[up] = 2
    made = trimesh.creation.box(extents=size)
    made.visual = trimesh.visual.ColorVisuals(made, vertex_colors=[10, 150, 20, 255])
    return made


class FakeTrellis:
    """Fake of trellis.pipelines: loaded once, called with a cut-out."""

    loads: list[str]
    asked: list[dict]

    def cuda(self) -> None:
        pass

    def run(
        self, image, num_samples: int = 1, seed: int = 42,
        sparse_structure_sampler_params: dict = {}, slat_sampler_params: dict = {},  # noqa: B006
        formats: list[str] = ["mesh", "gaussian", "radiance_field"], preprocess_image: bool = True,  # noqa: B006
    ) -> dict:  # fmt: skip
        self.asked.append({"seed": seed, "formats": formats, "mode": image.mode})
        return {"gaussian": ["splats"], "mesh": ["shape"]}


def fake_trellis(monkeypatch, bake) -> type[FakeTrellis]:
    class Pipeline(FakeTrellis):
        loads, asked = [], []

        @staticmethod
        def from_pretrained(path: str) -> Pipeline:
            Pipeline.loads.append(path)
            return Pipeline()

    install(monkeypatch, "trellis.pipelines", TrellisImageTo3DPipeline=Pipeline)
    install(monkeypatch, "trellis.utils.postprocessing_utils", to_glb=bake)
    return Pipeline


def test_trellis_is_loaded_once_and_its_mesh_stands_up(monkeypatch):
    def to_glb(
        app_rep, mesh, simplify: float = 0.95, fill_holes: bool = True,
        fill_holes_max_size: float = 0.04, texture_size: int = 1024, debug: bool = False,
        verbose: bool = True,
    ):  # fmt: skip
        assert (app_rep, mesh) == ("splats", "shape")
        return striped_box((1.0, 2.0, 1.0))

    fake = fake_trellis(monkeypatch, to_glb)
    modeler = Trellis(seed=5)
    for _ in range(2):
        made = ask(modeler)
    np.testing.assert_allclose(made.size / made.size[0], [1, 1, 2], rtol=1e-5)
    assert fake.loads == ["microsoft/TRELLIS-image-large"]
    assert fake.asked == [{"seed": 5, "formats": ["gaussian", "mesh"], "mode": "RGBA"}] * 2


def test_a_changed_signature_is_told(monkeypatch):
    fake_trellis(monkeypatch, lambda splats, shape, quality: None)
    with pytest.raises(BackendError, match=r"installed version has .*\(splats, shape, quality\)"):
        ask(Trellis())


def test_what_a_model_raises_or_makes_is_told(monkeypatch):
    def full(app_rep, mesh, simplify, texture_size, verbose):
        raise RuntimeError("CUDA out of memory.\nTried to allocate 2 GiB")

    fake_trellis(monkeypatch, full)
    said = (
        r"^trellis, model of 'mug_1': the model failed \(RuntimeError: CUDA out of memory\. Tried"
    )
    with pytest.raises(BackendError, match=said):
        ask(Trellis())
    fake_trellis(monkeypatch, lambda *_, **__: "a path")
    with pytest.raises(BackendError, match="the output is str, not a trimesh"):
        ask(Trellis())


def test_trellis_2_bakes_by_voxels(monkeypatch):
    asked: dict = {}

    class Pipeline:
        @classmethod
        def from_pretrained(cls, path: str, config_file: str = "pipeline.json"):
            asked["weights"] = path
            return cls()

        def cuda(self):
            pass

        def run(self, image, num_samples: int = 1, seed: int = 42, preprocess_image: bool = True):
            names = ("vertices", "faces", "attrs", "coords", "layout", "voxel_size")
            made = types.SimpleNamespace(**{name: name for name in names})
            made.simplify = lambda target: asked.update(simplified=target)
            return [made]

    def to_glb(
        vertices, faces, attr_volume, coords, attr_layout, aabb, voxel_size=None, grid_size=None,
        decimation_target=1000000, texture_size: int = 2048, remesh: bool = True,
    ):  # fmt: skip
        assert (vertices, attr_volume, attr_layout) == ("vertices", "attrs", "layout")
        return striped_box((1.0, 2.0, 1.0))

    install(monkeypatch, "trellis2.pipelines", Trellis2ImageTo3DPipeline=Pipeline)
    install(monkeypatch, "o_voxel.postprocess", to_glb=to_glb)
    assert ask(Trellis(version="2")).size[2] > 0.1
    assert asked == {"weights": "microsoft/TRELLIS.2-4B", "simplified": 16_777_216}


class Network:
    """Fake of tsr.system without ``extract_mesh``, which changed."""

    def __init__(self) -> None:
        self.renderer = types.SimpleNamespace(set_chunk_size=lambda size: None)

    @classmethod
    def from_pretrained(
        cls, pretrained_model_name_or_path: str, config_name: str, weight_name: str
    ):
        assert (config_name, weight_name) == ("config.yaml", "model.ckpt")
        return cls()

    def to(self, device: str):
        assert device == "cpu"

    def __call__(self, image, device):
        assert np.asarray(image[0])[0, 0].tolist() in ([127] * 3, [128] * 3)
        return ["codes"]


class Older(Network):
    def extract_mesh(self, scene_codes, resolution: int = 256, threshold: float = 25.0):
        return [tall(2)]


class Newer(Network):
    def extract_mesh(
        self, scene_codes, has_vertex_color, resolution: int = 256, threshold: float = 25.0
    ):
        assert has_vertex_color is True and resolution == 128
        return [tall(2)]


@pytest.mark.parametrize("network", [Older, Newer])
def test_both_versions_of_triposr_work(monkeypatch, network):
    cuda = types.SimpleNamespace(is_available=lambda: False)
    install(monkeypatch, "torch", inference_mode=contextlib.nullcontext, cuda=cuda)
    install(monkeypatch, "tsr.system", TSR=network)
    made = ask(TripoSR(resolution=128))
    np.testing.assert_allclose(made.size / made.size[0], [1, 1, 2], rtol=1e-5)
    assert made.mesh.texture[0, 0].tolist() == [10, 150, 20]


SCRIPT = """
import numpy as np, trimesh

class Inference:
    def __init__(self, config_file: str, compile: bool = False):
        assert config_file.endswith("pipeline.yaml")

    def __call__(self, image, mask, seed=None, pointmap=None, export_usd_path=None):
        assert image.shape == (60, 80, 3) and image.dtype == np.uint8
        assert mask.shape == (60, 80) and mask.dtype == bool and mask[30, 40] and not mask[0, 0]
        made = MESH
        return {"glb": made if seed else None, "rotation": ROTATION}
"""


BOX = "trimesh.creation.box(extents=(1, 2, 1))"


def checkout(folder: Path, rotation: str, mesh: str = BOX) -> Sam3D:
    """Return a fake SAM 3D that returns a rotation and a mesh for every picture."""
    (folder / "notebook").mkdir(parents=True)
    script = SCRIPT.replace("ROTATION", rotation).replace("MESH", mesh)
    (folder / "notebook/inference.py").write_text(script)
    (folder / "checkpoints/hf").mkdir(parents=True)
    (folder / "checkpoints/hf/pipeline.yaml").write_text("")
    return Sam3D(str(folder))


def test_sam3d_is_loaded_from_its_checkout(monkeypatch, tmp_path):
    with pytest.raises(BackendError, match="TABLETOPGEN_SAM3D"):
        ask(Sam3D(str(tmp_path)))
    checkout(tmp_path, "[1, 0, 0, 0]")
    monkeypatch.setenv("TABLETOPGEN_SAM3D", str(tmp_path))
    path = list(sys.path)
    made = ask(Sam3D())
    np.testing.assert_allclose(made.size / made.size[0], [1, 1, 2], rtol=1e-5)
    assert sys.path == path
    with pytest.raises(BackendError, match="the output is NoneType"):
        ask(Sam3D(seed=0))


def in_pytorch3d(view: View, axes: np.ndarray) -> np.ndarray:
    """Return SAM 3D's quaternion of an object with these axes (rows) in the world.

    By hand: a camera of PyTorch3D has x to the left, y up and z ahead, and points are rows that
    its matrices are applied to from the right.
    """
    level = np.array([np.sin(view.azimuth), -np.cos(view.azimuth), 0.0])
    ahead = -(np.cos(view.elevation) * level + [0, 0, np.sin(view.elevation)])
    left = np.cross([0.0, 0.0, 1.0], ahead)
    left /= np.linalg.norm(left)
    up = np.cross(ahead, left)
    rows = np.stack([axes @ left, axes @ up, axes @ ahead], 1)
    return Rotation.from_matrix(rows).as_quat(scalar_first=True)


@pytest.mark.parametrize("yaw", [0.0, 0.5, -0.5, 2.8, -2.0])
@pytest.mark.parametrize("azimuth", [0.0, 0.7, -0.7])
@pytest.mark.parametrize("elevation", [0.4, 1.1])
def test_sam3ds_pose_is_a_hint_of_the_yaw(tmp_path, yaw, azimuth, elevation):
    view = View(azimuth, elevation, 0.6)
    c, s = np.cos(yaw), np.sin(yaw)
    told = in_pytorch3d(view, np.array([[c, s, 0.0], [-s, c, 0], [0, 0, 1]]))
    made = ask(checkout(tmp_path, str(told.tolist())), view)
    assert made.orientation is not None
    np.testing.assert_allclose(made.orientation[:, 0], [c, s, 0], atol=1e-9)
    np.testing.assert_allclose(made.orientation[:, 2], [0, 0, 1], atol=1e-9)
    assert prior_yaw(made) == pytest.approx(yaw)


def test_the_mesh_lies_in_the_frame_of_the_pose(tmp_path):
    """A cone along the GLB's z, which is y-up: its tip as the model's maintainers carry it over."""
    told = in_pytorch3d(USUAL_VIEW, np.eye(3))
    cone = "trimesh.creation.cone(radius=0.5, height=2.0, sections=12)"
    made = ask(checkout(tmp_path, str(told.tolist()), cone))
    tip = np.array([0.0, 0, 1]) @ np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])
    along = made.mesh.vertices @ tip
    at_tip, at_base = (made.mesh.vertices[np.isclose(along, e)] for e in (0.5, -0.5))
    assert np.ptp(at_tip, 0).max() < 0.01 < np.ptp(at_base, 0).max()


def test_the_hand_made_camera_sees_what_ours_sees():
    """Left and up in its frame are left and up in the picture: pixels agree with ``Camera``."""
    view = View(-0.7, 0.5, 0.6)
    camera = Camera.looking_at(np.zeros(3), view, 2.0, 640, 480)
    points = np.array([[0.3, 0.1, 0.2], [-0.2, 0.4, -0.1], [0.1, -0.3, 0.5]])
    quaternion = in_pytorch3d(view, np.eye(3))
    seen = points @ Rotation.from_quat(quaternion, scalar_first=True).as_matrix() + [0, 0, 2.0]
    pixels = [320, 240] - camera.focal * seen[:, :2] / seen[:, 2:]
    np.testing.assert_allclose(pixels, camera.project(points), atol=1e-6)


def test_sam3ds_pose_of_a_thing_that_leans_is_none(tmp_path):
    for k, degrees in enumerate((20.0, 40.0, 90.0)):
        axes = Rotation.from_euler("zx", [30.0, degrees], degrees=True).as_matrix().T
        told = in_pytorch3d(USUAL_VIEW, axes)
        made = ask(checkout(tmp_path / str(k), str(told.tolist())))
        assert (prior_yaw(made) is None) == (degrees > 30)


def test_sam3ds_pose_may_be_a_tensor(tmp_path):
    told = in_pytorch3d(USUAL_VIEW, np.eye(3)).tolist()
    made = ask(checkout(tmp_path, f"__import__('torch').tensor([{told}], requires_grad=True)"))
    assert prior_yaw(made) == pytest.approx(0.0, abs=1e-5)


@pytest.mark.parametrize(
    "wrong",
    ["[float('nan'), 0, 0, 0]", "[0, 0, 0, 0]", "[2, 0, 0, 0]", "[1, 0, 0]", "'sideways'",
     "[float('inf'), 0, 0, 0]", "[[1, 0, 0, 0], [1, 0, 0, 0]]", "{'w': 1}"],
)  # fmt: skip
def test_a_pose_of_sam3d_that_is_none_is_dropped_with_a_warning(tmp_path, caplog, wrong):
    made = ask(checkout(tmp_path, wrong))
    assert made.orientation is None and made.size[2] > 0.1
    (record,) = caplog.records
    assert "model of 'mug_1': the rotation is not a unit quaternion" in record.getMessage()


def test_no_pose_of_sam3d_is_no_fault(tmp_path, caplog):
    assert ask(checkout(tmp_path, "None")).orientation is None
    assert caplog.records == []


@pytest.mark.parametrize(
    ("modeler", "said"),
    [
        (Trellis(), "trellis needs trellis.* which cannot be imported .* Install github"),
        (Trellis(version="2"), "trellis needs (trellis2|o_voxel)"),
        (TripoSR(device="cpu"), "triposr needs tsr.system"),
    ],
)
def test_what_is_not_installed_says_how_to(modeler, said):
    with pytest.raises(BackendError, match=said):
        ask(modeler)


def test_settings_out_of_range_are_refused():
    with pytest.raises(BackendError, match=r"Trellis\.version '3' is unknown"):
        Trellis(version="3")  # type: ignore[arg-type]
    with pytest.raises(InputError, match=r"TripoSR\.resolution must"):
        TripoSR(resolution=4)
