"""The contract of every modeler, whatever the mesh generator."""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
import trimesh
from backends import selected
from backends.modelers.foreign import glb, instance, prior, striped_box
from backends.modelers.server import Answer, Call, quick, serving
from backends.modelers.test_installed import Network, checkout, fake_trellis, install
from backends.modelers.test_tencent import ID, KEY, Cloud

from generator.backends import Backends
from generator.backends.embedded.modeler import EmbeddedModeler as Embedded
from generator.backends.embedded.reasoner import EmbeddedReasoner
from generator.backends.modelers.folder import Folder
from generator.backends.modelers.hunyuan3d import Hunyuan3D
from generator.backends.modelers.tencent import Tencent
from generator.backends.modelers.trellis import Trellis
from generator.backends.modelers.triposr import TripoSR
from generator.backends.protocols import Modeler
from generator.errors import BackendError
from generator.method.models import align_canonically
from generator.physics.inertia import body_mass, is_watertight
from generator.scene import USUAL_VIEW, Model

SIZE = (1.0, 0.8, 0.7)
THING = glb(striped_box(SIZE))


class PlayedTripoSR(Network):
    """Fake of tsr.system: makes a box with vertex colours, z up."""

    def extract_mesh(self, scene_codes, has_vertex_color, resolution: int = 256):
        made = trimesh.creation.box((SIZE[0], SIZE[2], SIZE[1]))
        made.visual = trimesh.visual.ColorVisuals(made, vertex_colors=[200, 30, 30, 255])
        return [made]


def in_process(environment: pytest.MonkeyPatch, folder: Path) -> dict[str, Callable[[], Modeler]]:
    """Fake the packages that generate meshes in this process; return their modelers."""
    fake_trellis(
        environment, lambda app_rep, mesh, simplify, texture_size, verbose: striped_box(SIZE)
    )
    install(environment, "tsr.system", TSR=PlayedTripoSR)
    played = checkout(folder, "[1, 0, 0, 0]")
    return {"trellis": Trellis, "triposr": lambda: TripoSR(device="cpu"), "sam3d": lambda: played}


@pytest.fixture(params=selected.names("modeler"), scope="module")
def modeler(request, tmp_path_factory) -> Iterator[Modeler]:
    """Each modeler that can be selected by name; new ones need an entry here."""
    folder = tmp_path_factory.mktemp("assets")
    (folder / "gizmo.glb").write_bytes(THING)
    cloud = Cloud(loads=[Answer(body=THING)])

    def answer(call: Call) -> Answer:
        return Answer(body=THING) if call.path == "/generate" else cloud(call)

    with serving(answer) as served, pytest.MonkeyPatch.context() as environment:
        environment.setenv("TENCENTCLOUD_SECRET_ID", ID)
        environment.setenv("TENCENTCLOUD_SECRET_KEY", KEY)
        made = {
            "embedded": lambda: Embedded(texture=64),
            "folder": lambda: Folder(str(folder)),
            "hunyuan3d": lambda: Hunyuan3D(served.url, session=quick()),
            "tencent": lambda: Tencent(
                served.url, interval=0.01, hosts=("127.0.0.1",), session=quick()
            ),
            **in_process(environment, folder / "sam3d"),
        }[request.param]()
        assert type(made) is selected.kind(request.param, "modeler")
        yield made


@pytest.fixture(scope="module")
def made(modeler) -> Model:
    return ask(modeler)


def ask(modeler: Modeler) -> Model:
    return modeler.model(instance("gizmo"), prior("gizmo"), USUAL_VIEW)


def test_it_answers_the_protocol_and_is_a_value(modeler):
    assert isinstance(modeler, Modeler)
    with pytest.raises(AttributeError):
        modeler.seed = 3  # type: ignore[attr-defined]
    assert KEY not in repr(modeler)


@pytest.mark.slow
def test_its_model_is_whole_light_and_textured(made):
    mesh = made.mesh
    assert made.label == "gizmo"
    assert is_watertight(mesh)
    assert len(mesh.faces) <= 24_000
    assert max(mesh.texture.shape) <= 2048
    assert mesh.uv.min() >= 0 and mesh.uv.max() <= 1
    assert body_mass(mesh, made.size, made.physics, made.parts).mass > 0


@pytest.mark.slow
def test_its_size_is_the_prior_s(made):
    longest = np.sort(made.size)[1:]
    assert np.prod(longest) == pytest.approx(np.prod(np.sort(prior("gizmo").extent)[1:]), rel=1e-5)


@pytest.mark.slow
def test_the_same_question_has_the_same_answer(modeler, made):
    again = ask(modeler)
    assert again.mesh.vertices.tobytes() == made.mesh.vertices.tobytes()
    assert again.mesh.texture.tobytes() == made.mesh.texture.tobytes()
    assert again.size.tolist() == made.size.tolist()


def test_the_stage_can_align_it(made):
    thing = instance("gizmo")
    aligned = align_canonically(made, thing, prior("gizmo"), EmbeddedReasoner())
    assert (aligned.name, aligned.label) == (thing.name, thing.label)


@pytest.mark.parametrize("name", [n for n in selected.names("modeler") if n != "embedded"])
def test_it_can_be_selected_by_name(name):
    chosen = Backends.select("embedded", modeler=name)
    assert isinstance(chosen.modeler, Modeler)
    assert not {"session", "_turn"} & set(chosen.identity()["modeler"])
    with pytest.raises(BackendError, match=f"Backend '{name}' has no reasoner"):
        Backends.select(name)


@pytest.mark.parametrize("name", ["hunyuan3d", "tencent"])
def test_what_asks_servers_shares_the_session(name):
    session = quick()
    assert Backends.select("embedded", session=session, modeler=name).modeler.session is session  # type: ignore[attr-defined]
