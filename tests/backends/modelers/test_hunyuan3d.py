"""The local Hunyuan3D servers: requests, and processing of responses."""

import base64
import io
import threading

import numpy as np
import pytest
import trimesh
from backends.modelers.foreign import (
    claiming,
    edited,
    glb,
    instance,
    painted_with,
    png,
    prior,
    striped_box,
)
from backends.modelers.server import Answer, Call, quick, serving
from PIL import Image

from generator.backends.modelers.hunyuan3d import Hunyuan3D
from generator.calls.session import Session
from generator.calls.store import CallStore
from generator.errors import BackendError, DryRunError, InputError
from generator.scene import USUAL_VIEW, Model

GOOD = glb(striped_box((1.0, 2.0, 1.0)))
FAILED = Answer.of({"text": "**NETWORK ERROR DUE TO HIGH TRAFFIC.**", "error_code": 1}, 404)


def ask(url: str, **settings) -> Model:
    settings.setdefault("session", quick())
    made = Hunyuan3D(url, **settings)
    return made.model(instance("mug"), prior("mug"), USUAL_VIEW)


def said(answer: Answer, **settings) -> str:
    with serving(lambda call: answer) as served, pytest.raises(BackendError) as caught:
        ask(served.url, **settings)
    assert "hunyuan3d" in str(caught.value) and "model" in str(caught.value)
    return str(caught.value)


def test_a_mesh_comes_back_upright_textured_and_sized():
    with serving(lambda call: Answer(body=GOOD)) as served:
        made = ask(served.url)
    np.testing.assert_allclose(made.size / made.size[0], [1, 1, 2], rtol=1e-5)
    assert made.mesh.texture.shape == (64, 64, 3)
    assert (made.name, made.label, made.category) == ("mug_1", "mug", "mug")


def test_the_picture_sent_is_a_cut_out():
    with serving(lambda call: Answer(body=GOOD)) as served:
        ask(served.url)
    (call,) = served.calls
    assert (call.method, call.path) == ("POST", "/generate")
    sent = np.asarray(Image.open(io.BytesIO(base64.b64decode(call.json["image"], validate=True))))
    assert sent.shape == (256, 256, 4)
    assert sent[0, 0, 3] == 0 and sent[128, 128].tolist() == [200, 30, 30, 255]
    assert not any(name.startswith("x-tabletopgen") for name in call.headers)


# The fields of api_models.GenerationRequest in 2.1; 2.0 hands all of its own to the pipeline.
FIELDS_2_1 = {
    "image", "remove_background", "texture", "seed", "octree_resolution", "num_inference_steps",
    "guidance_scale", "num_chunks", "face_count",
}  # fmt: skip
FIELDS_2_0 = {
    "image", "texture", "seed", "octree_resolution", "num_inference_steps", "guidance_scale",
    "face_count", "type",
}  # fmt: skip


@pytest.mark.parametrize(("version", "fields"), [("2.0", FIELDS_2_0), ("2.1", FIELDS_2_1)])
def test_each_version_gets_the_body_it_reads(version, fields):
    with serving(lambda call: Answer(body=GOOD)) as served:
        ask(served.url, version=version, seed=7, octree=128, textured=False)
    body = served.calls[0].json
    assert set(body) == fields
    assert (body["seed"], body["octree_resolution"], body["texture"]) == (7, 128, False)


def test_failures_come_as_404_and_are_told():
    told = said(FAILED)
    assert told.startswith("hunyuan3d, model of 'mug_1': the server failed (404, '**NETWORK ERROR")
    assert "--enable_tex" in said(FAILED, version="2.0")
    assert "--enable_tex" not in told


SQUARE = trimesh.Trimesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], [[0, 1, 2], [1, 3, 2]])


@pytest.mark.parametrize("first", [FAILED, Answer(body=glb(SQUARE))], ids=["failure", "no model"])
def test_an_answer_of_no_use_is_not_kept(first, tmp_path):
    answers = [first, Answer(body=GOOD)]
    with serving(lambda call: answers[len(served.calls) - 1]) as served:
        with pytest.raises(BackendError, match="hunyuan3d, model"):
            ask(served.url, session=quick(CallStore(tmp_path)))
        assert len(CallStore(tmp_path)) == 0
        assert ask(served.url, session=quick(CallStore(tmp_path))).name == "mug_1"


def test_an_answer_is_asked_for_once(tmp_path):
    with serving(lambda call: Answer(body=GOOD)) as served:
        for _ in range(2):
            ask(served.url, session=quick(CallStore(tmp_path)))
        assert len(served.calls) == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    "bad", [GOOD[: len(GOOD) // 2], b'{"status": "processing"}', b"", b"PK\x03\x04" + bytes(99)]
)
def test_a_damaged_answer_is_asked_for_once_more_then_refused(bad, tmp_path):
    with serving(lambda call: Answer(body=bad)) as served:
        with pytest.raises(BackendError, match="hunyuan3d, model"):
            ask(served.url, session=quick(CallStore(tmp_path)))
        assert len(served.calls) == 2
    answers = [Answer(body=bad), Answer(body=GOOD)]
    with serving(lambda call: answers[len(served.calls) - 1]) as served:
        for _ in range(2):
            assert ask(served.url, session=quick(CallStore(tmp_path))).name == "mug_1"
        assert len(served.calls) == 2


def test_a_compressed_answer_is_not_damaged():
    def compress(header: dict) -> None:
        header["extensionsUsed"] = header["extensionsRequired"] = ["KHR_mesh_quantization"]

    with serving(lambda call: Answer(body=edited(GOOD, compress))) as served:
        assert ask(served.url).name == "mug_1"
        assert len(served.calls) == 1


def nan() -> bytes:
    made = striped_box()
    made.vertices[3] = np.nan
    return glb(made)


@pytest.mark.parametrize(
    ("body", "told"),
    [
        (edited(GOOD, lambda h: h["meshes"][0]["primitives"][0].update(mode=0)), "0 triangles"),
        (claiming(GOOD, 10_000_000), "has 10000000 triangles; 1 to 2000000 are allowed"),
        (
            edited(GOOD, lambda h: h["buffers"][0].update(uri="http://x.example/a")),
            "external file",
        ),
        (nan(), "finite"),
        (painted_with(GOOD, png(60_000, 60_000)), "pixels"),
        (b"<!doctype html><html>busy</html>", "HTML page"),
    ],
    ids=["no faces", "10 M faces", "external URI", "NaN", "bomb", "HTML"],
)
@pytest.mark.filterwarnings("ignore::PIL.Image.DecompressionBombWarning")
def test_meshes_that_would_do_harm_are_refused_and_not_kept(body, told, tmp_path):
    with (
        serving(lambda call: Answer(body=body)) as served,
        pytest.raises(BackendError, match=told) as caught,
    ):
        ask(served.url, session=quick(CallStore(tmp_path)))
    assert str(caught.value).startswith("hunyuan3d, model")
    assert len(CallStore(tmp_path)) == 0


def test_answers_of_another_kind_are_refused():
    page = Answer(body=b"<!DOCTYPE html><html>Welcome to nginx</html>", kind="text/html")
    assert "HTML page" in said(page)
    assert "returned status 404" in said(Answer.of({"detail": "Not Found"}, 404))
    assert "TABLETOPGEN_HUNYUAN3D_URL" in said(Answer.of({"detail": "Not Found"}, 404))
    assert "rejected the request" in said(Answer.of({"detail": [{"loc": ["body"]}]}, 422))


def test_two_hundred_megabytes_are_not_read():
    assert "exceeds the limit" in said(Answer(length=200 * 2**20))


def test_an_answer_cut_off_is_tried_again():
    answers = [Answer(body=GOOD[:100], length=len(GOOD)), Answer(body=GOOD)]
    with serving(lambda call: answers[len(served.calls) - 1]) as served:
        assert ask(served.url, session=quick(attempts=2)).name == "mug_1"


@pytest.mark.slow
def test_a_server_that_hangs_or_is_not_there_is_given_up():
    hang = threading.Event()
    try:
        assert "within 0.2 s" in said(Answer(hang=hang), timeout=0.2)
    finally:
        hang.set()
    with pytest.raises(BackendError, match=r"hunyuan3d, model.*cannot be reached"):
        ask("http://127.0.0.1:9")


def test_a_dry_run_says_what_it_would_ask():
    with serving(lambda call: Answer(body=GOOD)) as served:
        with pytest.raises(DryRunError, match=r"Would call hunyuan3d, model \(hunyuan3d-2\.1\)"):
            ask(served.url, session=Session(dry=True))
        assert not served.calls


def test_the_environment_names_the_server(monkeypatch):
    with serving(lambda call: Answer(body=GOOD)) as served:
        monkeypatch.setenv("TABLETOPGEN_HUNYUAN3D_URL", served.url)
        assert ask("").name == "mug_1"


def health(call: Call) -> Answer:
    well = Answer.of({"status": "healthy", "worker_id": "3f2a1c"})
    return well if call.path == "/health" else Answer(404)


def test_health():
    with serving(health) as served:
        assert Hunyuan3D(served.url, session=quick()).health() == "3f2a1c"
        assert served.calls[0].method == "GET"
    with (
        serving(lambda call: Answer.of({"detail": "Not Found"}, 404)) as served,
        pytest.raises(BackendError, match=r"hunyuan3d, health: .* returned status 404"),
    ):
        Hunyuan3D(served.url, session=quick()).health()


@pytest.mark.slow
@pytest.mark.parametrize("body", [b"[" * 200_000, b'{"a":' * 9_000, b'{"status": [1]}', b"\xff"])
@pytest.mark.parametrize("status", [200, 404])
def test_an_answer_nested_without_end_is_told(body: bytes, status: int) -> None:
    answer = Answer(status, body, "text/plain")
    assert len(said(answer)) < 1000
    with (
        serving(lambda call: answer) as served,
        pytest.raises(BackendError, match="hunyuan3d, health"),
    ):
        Hunyuan3D(served.url, session=quick()).health()


def test_settings_out_of_range_are_refused():
    with pytest.raises(BackendError, match=r"Did you mean '2\.1'"):
        Hunyuan3D(version="2.2")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="octree must"):
        Hunyuan3D(octree=1024)


def test_the_session_is_no_identity():
    assert Hunyuan3D(session=quick()) == Hunyuan3D(session=quick())
    assert "session" not in repr(Hunyuan3D())


def test_a_password_in_the_address_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(BackendError, match=r"hunyuan3d: its address .* password") as caught:
        Hunyuan3D("http://me:hunter2@gpu:8081")
    monkeypatch.setenv("TABLETOPGEN_HUNYUAN3D_URL", "http://me:hunter2@gpu:8081")
    with pytest.raises(BackendError, match="TABLETOPGEN_HUNYUAN3D_URL") as told:
        Hunyuan3D().health()
    assert "hunter2" not in str(caught.value) + str(told.value)
