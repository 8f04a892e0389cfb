"""What is sent: pictures by their content, bodies no longer than they may be."""

import io
import os
import struct
import zlib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from starlette.testclient import TestClient

from generator.errors import StorageError
from tabletopgen_web.studio.library import pictures
from tabletopgen_web.studio.queue.jobs import JobStore


def picture(kind: str = "PNG", size: tuple[int, int] = (320, 200), **more: object) -> bytes:
    noise = np.random.default_rng(0).integers(0, 255, (size[1], size[0], 3)).astype(np.uint8)
    packed = io.BytesIO()
    Image.fromarray(noise).save(packed, kind, **more)
    return packed.getvalue()


def bomb(width: int, height: int) -> bytes:
    """Return a PNG whose header claims too many pixels."""

    def chunk(kind: bytes, data: bytes) -> bytes:
        return (
            struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        )

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
            + chunk(b"IDAT", zlib.compress(bytes(10_000_000))) + chunk(b"IEND", b""))  # fmt: skip


def test_old_pictures_that_no_job_names_are_swept(tmp_path: Path) -> None:
    shelf = pictures.PictureShelf(tmp_path)
    wanted, stale, fresh = (shelf.add(picture(size=(320, 200 + k))).picture for k in range(3))
    note = tmp_path / "notes.txt"
    note.write_text("mine")
    for path in (p for name in (wanted, stale) for p in tmp_path.glob(f"{name}*")):
        os.utime(path, (0, 0))
    os.utime(note, (0, 0))
    shelf.sweep({wanted})
    left = {path.name for path in tmp_path.iterdir()}
    assert left == {wanted, f"{wanted}.png", fresh, f"{fresh}.png", "notes.txt"}


@pytest.mark.parametrize("kind", ["PNG", "JPEG", "WEBP", "BMP", "TIFF", "GIF"])
def test_a_picture_is_kept_by_its_content(client: TestClient, tmp_path: Path, kind: str) -> None:
    data = picture(kind)
    told = {"content-type": "text/html; whatever"}
    first, again = (client.post("/api/pictures", content=data, headers=told) for _ in range(2))
    assert first.status_code == 201 and first.json() == again.json()
    row = first.json()
    assert (row["width"], row["height"]) == (320, 200)
    shown = client.get(f"/api/pictures/{row['picture']}")
    assert shown.headers["content-type"] == "image/png"
    assert Image.open(io.BytesIO(shown.content)).size == (320, 200)
    kept = tmp_path / "studio" / "pictures"
    assert (kept / row["picture"]).read_bytes() == data
    assert len(list(kept.iterdir())) == 2


def test_a_large_picture_is_shown_as_it_is_worked_at(client: TestClient) -> None:
    row = client.post("/api/pictures", content=picture("JPEG", (3000, 1500))).json()
    assert (row["width"], row["height"]) == (1280, 640)


@pytest.mark.parametrize(("data", "status", "says"), [
    (b"<!doctype html><script>alert(1)</script>", 415, "not a PNG"),
    (b"<svg xmlns='http://www.w3.org/2000/svg'/>", 415, "not a PNG"),
    (b"%!PS-Adobe-3.0", 415, "not a PNG"),
    (b"", 415, "not a PNG"),
    (b"\x89PNG\r\n\x1a\n<html>", 422, "picture"),
    (b"GIF89a" + b"\0" * 50, 422, "picture"),
    (bomb(100_000, 100_000), 422, "pixels"),
    (bomb(2**31 - 1, 2**31 - 1), 422, "picture"),
    (bomb(6000, 5000), 422, "megapixels"),
    (picture(size=(8, 8)), 422, "64 pixels"),
    (picture()[:2000], 422, "damaged"),
])  # fmt: skip
def test_what_is_no_sound_picture_is_refused(
    client: TestClient, tmp_path: Path, data: bytes, status: int, says: str
) -> None:
    answer = client.post("/api/pictures", content=data, headers={"content-type": "image/png"})
    assert answer.status_code == status, answer.text
    error = answer.json()["error"]
    assert says in error and "\n" not in error
    assert not list((tmp_path / "studio" / "pictures").iterdir())


def test_no_more_is_read_than_may_come(client: TestClient) -> None:
    pieces = (bytes(2**20) for _ in range(21))
    answer = client.post("/api/pictures", content=pieces)
    assert answer.status_code == 413 and "20 MiB" in answer.json()["error"]
    answer = client.post("/api/jobs", content=b" " * 70_000,
                         headers={"content-type": "application/json"})  # fmt: skip
    assert answer.status_code == 413 and "64 KiB" in answer.json()["error"]
    claimed = client.post("/api/pictures", content=b"x", headers={"content-length": "1" + "0" * 30})
    assert claimed.status_code in (400, 413)


def test_a_full_disk_is_said_and_leaves_nothing(
    client: TestClient, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*told: object) -> None:
        raise StorageError("The picture cannot be written: No space left on device.")

    monkeypatch.setattr(pictures, "write_whole", refuse)
    answer = client.post("/api/pictures", content=picture())
    assert answer.status_code == 507 and "No space left" in answer.json()["error"]
    monkeypatch.undo()
    monkeypatch.setattr(JobStore, "add", refuse)
    answer = client.post("/api/jobs", json={"kind": "compose", "text": "a mug"})
    assert answer.status_code == 507
    assert not list((tmp_path / "studio" / "pictures").iterdir())


def test_answers_of_a_study_are_kept_by_rater(client: TestClient, tmp_path: Path) -> None:
    path = "/api/studies/spring-2026/answers"
    for number, rater in enumerate(["ann", "bob", "ann"], 1):
        answer = client.post(path, json={"rater": rater, "choice": {"left": number}, "ü": "✓"})
        assert answer.status_code == 201
    assert answer.json() == {"answers": 2}
    kept = client.get(path).json()["answers"]
    assert [a["choice"]["left"] for a in kept["ann"]] == [1, 3] and len(kept["bob"]) == 1
    files = sorted(p.name for p in (tmp_path / "studio" / "answers" / "spring-2026").iterdir())
    assert files == ["ann.json", "bob.json"]
    assert client.get("/api/studies/none/answers").json()["answers"] == {}


@pytest.mark.parametrize(("study", "body"), [
    ("Spring", {"rater": "ann"}), ("x" * 65, {"rater": "ann"}), ("a.b", {"rater": "ann"}),
    ("ok", {"rater": "../ann"}), ("ok", {"rater": ""}), ("ok", {"rater": 7}), ("ok", {}),
    ("ok", {"rater": "a" * 65}), ("ok", {"rater": None}),
])  # fmt: skip
def test_ids_of_answers_are_plain(
    client: TestClient, tmp_path: Path, study: str, body: dict
) -> None:
    assert client.post(f"/api/studies/{study}/answers", json=body).status_code == 422
    assert not list((tmp_path / "studio" / "answers").iterdir())


def test_a_long_answer_is_refused(client: TestClient) -> None:
    answer = client.post("/api/studies/s/answers", json={"rater": "ann", "text": "x" * 2**20})
    assert answer.status_code == 413 and "1 MiB" in answer.json()["error"]
    short = client.post("/api/studies/s/answers", json={"rater": "ann", "text": "x" * 2**19})
    assert short.status_code == 201
