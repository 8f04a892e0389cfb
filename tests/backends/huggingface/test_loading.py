"""Pinned models loaded from a folder, offline: existing files are read, missing ones reported."""

import dataclasses
import json
import pickle
import shutil
import socket
import sys
import threading
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
import tiny_models as tiny
import torch
from bounded import LONG, at_once
from safetensors.torch import load_file, save_file

from generator.backends import Backends
from generator.backends.huggingface.encoder import HuggingFaceEncoder
from generator.backends.huggingface.segmenter import HuggingFaceSegmenter
from generator.backends.huggingface.weights.loader import device_for, load_model, load_tokenizer
from generator.backends.huggingface.weights.pins import (
    WEIGHTS,
    find_model,
    missing,
    pin,
    pins,
    snapshot,
)
from generator.backends.requirements import Once, models_folder
from generator.errors import BackendError, InputError

DINOV2 = pins()["dinov2"]


@pytest.fixture
def folder(tiny_models: Path, tmp_path: Path) -> Path:
    """A copy of the tiny DINOv2, for tests that damage it."""
    shutil.copytree(snapshot(DINOV2, tiny_models), snapshot(DINOV2, tmp_path))
    return tmp_path


@pytest.fixture
def offline(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_args: Any, **_named: Any) -> None:
        raise AssertionError("the network was asked")

    for name in ("connect", "connect_ex"):
        monkeypatch.setattr(socket.socket, name, refuse)
    monkeypatch.setattr(socket, "getaddrinfo", refuse)


# ------------------------------------------------------------------------------------- the table
def test_every_model_is_pinned_to_a_commit_and_holds_no_pickle() -> None:
    assert {"grounding-dino-base", "sam2", "sam3", "dinov2", "clip"} <= set(pins())
    for model in pins().values():
        assert len(model.revision) == 40
        assert int(model.revision, 16)
        assert len(model.sha256) in (0, 64)
        assert bool(model.bytes) == bool(model.sha256)
        assert model.licence
        assert {"config.json", WEIGHTS} <= set(model.files)
        assert all(name.endswith((".json", ".safetensors")) for name in model.files)


def test_an_unknown_model_lists_those_there_are() -> None:
    with pytest.raises(BackendError, match="Did you mean 'dinov2'"):
        pin("dinov3")
    with pytest.raises(BackendError, match=r"no model 'dinov2' of kind Sam2Model.*Available: sam2"):
        pin("dinov2", "Sam2Model")
    with pytest.raises(BackendError, match=r"no model 'owl'.*grounding-dino-base.*sam3"):
        HuggingFaceSegmenter("owl")
    with pytest.raises(BackendError, match="no model 'sam1'"):
        HuggingFaceSegmenter(masker="sam1")
    with pytest.raises(BackendError, match="Available: dinov2"):
        HuggingFaceEncoder("clip")


# ------------------------------------------------------------------------------------ the folder
def test_the_folder_is_given_or_the_environment_s_or_the_user_s(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("TABLETOPGEN_MODELS", str(tmp_path / "mine"))
    assert models_folder() == models_folder("") == tmp_path / "mine"
    assert models_folder(tmp_path) == tmp_path
    monkeypatch.delenv("TABLETOPGEN_MODELS")
    assert models_folder().parts[-2:] == ("tabletopgen", "models")


@pytest.mark.slow
def test_a_model_lies_as_in_hugging_face_s_cache_at_its_commit(folder: Path) -> None:
    from huggingface_hub import try_to_load_from_cache

    known = try_to_load_from_cache(
        DINOV2.repository, WEIGHTS, cache_dir=folder, revision=DINOV2.revision
    )
    assert known == str(snapshot(DINOV2, folder) / WEIGHTS)
    assert missing(DINOV2, folder) == ()


@pytest.mark.slow
def test_another_commit_is_not_the_model(folder: Path) -> None:
    other = dataclasses.replace(DINOV2, revision="0" * 40)
    assert missing(other, folder) == DINOV2.files
    with pytest.raises(BackendError, match=r"facebook/dinov2-base at 000000000000.*is not in"):
        find_model(other, folder, "huggingface, features:")


def test_a_missing_model_names_the_question_and_the_command(tmp_path: Path) -> None:
    encoder = HuggingFaceEncoder(folder=str(tmp_path / "none"))
    with pytest.raises(BackendError) as told:
        encoder.features(torch.zeros(1, 3, 28, 28))
    assert str(told.value).startswith("huggingface, features: model dinov2")
    assert f"tabletopgen models pull dinov2 --folder {tmp_path / 'none'}" in str(told.value)
    assert "TABLETOPGEN_MODELS" in str(told.value)
    assert not (tmp_path / "none").exists()


def test_a_pickle_is_never_read_in_place_of_safetensors(folder: Path) -> None:
    home, ran = snapshot(DINOV2, folder), folder / "ran"

    class Bomb:
        def __reduce__(self) -> Any:
            return Path.touch, (ran,)

    (home / "pytorch_model.bin").write_bytes(pickle.dumps(Bomb()))
    assert load_model(DINOV2, folder, "who:").config.hidden_size == 32  # beside it: not opened
    (home / WEIGHTS).unlink()
    with pytest.raises(
        BackendError, match=r"as a pickle \(pytorch_model.bin\).*never loaded.*pull"
    ):
        load_model(DINOV2, folder, "who:")
    assert not ran.exists()


# ------------------------------------------------------------------------------------- the models
@pytest.mark.slow
def test_reading_asks_no_network_and_is_silent(
    tiny_models: Path, offline: None, capfd: pytest.CaptureFixture[str]
) -> None:
    for name in ("grounding-dino-base", "sam2", "sam3", "dinov2", "clip"):
        model = load_model(pins()[name], tiny_models, "who:")
        assert type(model).__name__ == pins()[name].kind
        assert not model.training
        assert not any(p.requires_grad for p in model.parameters())
        assert {p.dtype for p in model.parameters()} == {torch.float32}
    load_tokenizer(pins()["sam3"], tiny_models, "who:")
    assert capfd.readouterr() == ("", "")


@pytest.mark.slow
@pytest.mark.parametrize("name", ["sam2", "sam3"])
def test_models_published_with_their_tracker_are_read_without_it(
    name: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    tiny.save_for_video(tmp_path)
    capfd.readouterr()
    model = load_model(pins()[name], tmp_path, "who:")
    saved = load_file(snapshot(pins()[name], tmp_path) / WEIGHTS)
    prefix = "detector_model." if name == "sam3" else ""
    weights = model.state_dict()
    assert len(weights) > 50
    for key in weights.keys() & {k.removeprefix(prefix) for k in saved}:
        assert torch.equal(weights[key], saved[prefix + key])
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("damage", ["cut", "noise", "empty"])
def test_damaged_weights_are_told(folder: Path, damage: str) -> None:
    file = snapshot(DINOV2, folder) / WEIGHTS
    whole = file.read_bytes()
    file.write_bytes({"cut": whole[:-100], "noise": b"\xff" * 500, "empty": b""}[damage])
    with pytest.raises(BackendError, match=r"who: model dinov2 in .* cannot be read.*pull dinov2"):
        load_model(DINOV2, folder, "who:")


def test_a_damaged_configuration_is_told(folder: Path) -> None:
    (snapshot(DINOV2, folder) / "config.json").write_text("{")
    with pytest.raises(BackendError, match="cannot be read"):
        load_model(DINOV2, folder, "who:")


def test_weights_that_lack_some_are_refused_rather_than_made_up(folder: Path) -> None:
    file = snapshot(DINOV2, folder) / WEIGHTS
    kept = {k: v for k, v in load_file(file).items() if not k.startswith("layernorm")}
    save_file(kept, file, {"format": "pt"})
    with pytest.raises(BackendError, match=r"lacks 2 weights of Dinov2Model.*layernorm"):
        load_model(DINOV2, folder, "who:")


def test_a_damaged_tokenizer_is_told(tiny_models: Path, tmp_path: Path) -> None:
    model = pins()["grounding-dino-base"]
    shutil.copytree(snapshot(model, tiny_models), snapshot(model, tmp_path))
    (snapshot(model, tmp_path) / "tokenizer.json").write_text(json.dumps({"version": "1.0"}))
    with pytest.raises(BackendError, match=r"tokenizer.json cannot be read.*pull grounding-dino"):
        load_tokenizer(model, tmp_path, "who:")


def test_a_missing_or_old_transformers_is_told(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    old = ModuleType("transformers")
    old.__dict__["__version__"] = "4.1"
    monkeypatch.setitem(sys.modules, "transformers", old)
    with pytest.raises(BackendError, match=r"transformers 4.1 has no class Dinov2Model.*--upgrade"):
        load_model(DINOV2, folder, "who:")
    monkeypatch.setitem(sys.modules, "transformers", None)
    with pytest.raises(BackendError, match=r"pip install 'tabletopgen\[huggingface\]'"):
        load_model(DINOV2, folder, "who:")


# -------------------------------------------------------------------------------------- selecting
def test_by_name_in_every_mix_and_nothing_is_read_until_asked(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("TABLETOPGEN_MODELS", str(tmp_path))
    monkeypatch.delenv("TABLETOPGEN_DETECTOR", raising=False)
    mix = Backends.select("embedded", segmenter="huggingface", encoder="huggingface")
    assert isinstance(mix.segmenter, HuggingFaceSegmenter)
    assert isinstance(mix.encoder, HuggingFaceEncoder)
    told = mix.identity()
    assert told["segmenter"]["detector"] == "grounding-dino-base"
    assert told["segmenter"]["revisions"] == "grounding-dino-base@12bdfa3120f3, sam2@665f8e2ad61c"
    assert told["encoder"]["revision"] == "dinov2@f9e44c814b77"
    assert str(tmp_path) not in str(told)
    with pytest.raises(BackendError, match="'huggingface' has no reasoner"):
        Backends.select("huggingface")


def test_the_environment_chooses_the_detector(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TABLETOPGEN_DETECTOR", "sam3")
    assert HuggingFaceSegmenter().revisions == "sam3@3c879f39826c"
    monkeypatch.setenv("TABLETOPGEN_DETECTOR", "sam")
    with pytest.raises(BackendError, match="no model 'sam'"):
        Backends.select("embedded", segmenter="huggingface")


@pytest.mark.parametrize(
    ("kind", "setting"),
    [(HuggingFaceSegmenter, s) for s in ({"threshold": 0.0}, {"tiles": 0}, {"tiles": 2.5},
                                         {"overlap": 0.9}, {"side": 1}, {"words": 0})]
    + [(HuggingFaceEncoder, s) for s in ({"side": 13}, {"batch": 0})],
)  # fmt: skip
def test_settings_out_of_range_are_refused(kind: type, setting: dict[str, Any]) -> None:
    with pytest.raises(InputError, match=rf"^{kind.__name__}\.{next(iter(setting))} must be"):
        kind(**setting)


def test_threads_that_ask_at_once_share_what_one_of_them_made() -> None:
    made: list[int] = []
    entered = threading.Barrier(4)

    def make() -> object:
        made.append(1)
        return object()

    once, seen = Once(make), list[object]()

    def ask() -> None:
        entered.wait(LONG)
        seen.append(once())

    at_once(*[ask] * 4)
    assert len(made) == 1
    assert len(set(map(id, seen))) == 1


def test_what_fails_is_tried_again_when_asked_again() -> None:
    answers = iter([BackendError("no"), "yes"])

    def make() -> str:
        answer = next(answers)
        if isinstance(answer, BackendError):
            raise answer
        return answer

    once = Once(make)
    with pytest.raises(BackendError):
        once()
    assert once() == "yes"


def test_the_device_is_the_chosen_one(monkeypatch: pytest.MonkeyPatch) -> None:
    assert device_for("cpu") == "cpu"
    monkeypatch.setattr(torch.cuda, "is_available", lambda: True)
    assert device_for("") == "cuda"
    monkeypatch.setattr(torch.cuda, "is_available", lambda: False)
    assert device_for("") == "cpu"
