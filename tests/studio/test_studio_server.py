"""A studio in a process of its own: many clients, real jobs, kills, full disks, second studios."""

import contextlib
import os
import signal
import socket
import subprocess
from collections.abc import Iterator
from pathlib import Path

import httpx2
import pytest
from bounded import LONG, at_once, until
from studio_clients import (
    Listener,
    Studio,
    ask_raw,
    queue,
    run_studio,
    studio_command,
    wait_for,
    wait_until,
)

pytestmark = pytest.mark.slow

DESK = "a desk with a mug"


@pytest.fixture(scope="module")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    """A studio for tests without side effects."""
    folder = tmp_path_factory.mktemp("studio")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("TABLETOPGEN_CACHE", str(folder / "store"))
        with run_studio(folder / "own", "--workers", "2") as studio:
            yield studio


def children(pid: int) -> list[int]:
    with contextlib.suppress(FileNotFoundError):
        return [int(n) for n in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]
    return []


def is_alive(pid: int) -> bool:
    with contextlib.suppress(FileNotFoundError, ProcessLookupError):
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
    return False


def test_twenty_clients_at_once(studio: Studio) -> None:
    listener, failures = Listener(studio), []

    def work(number: int) -> None:
        try:
            with studio.connect() as client:
                assert client.get("/api/state").json()["workers"] == 2
                assert len(client.get("/api/scenes").json()["scenes"]) >= 23
                said = client.post("/api/explain", json={"text": f"{number} red mugs", "seed": 0})
                assert {row["role"] for row in said.json()["rows"]} >= {"thing", "count"}
                assert f"{number} × red mug" in said.json()["summary"]
                job = queue(client, f"a desk with a mug {number}")
                client.post(f"/api/jobs/{job}/cancel")
                assert wait_for(client, job)["state"] in ("cancelled", "done")
                assert client.delete(f"/api/jobs/{job}").status_code == 204
        except BaseException as error:
            failures.append(error)

    at_once(*(lambda n=n: work(n) for n in range(2, 22)))
    assert not failures
    until(lambda: sum(e.get("state") == "deleted" for e in listener.events) == 20)
    numbers = [event["seq"] for event in listener.events]
    assert numbers == sorted(set(numbers))


def test_a_scene_is_composed_edited_shown_exported_and_played(studio: Studio) -> None:
    client, listener = studio.client, Listener(studio)
    made = wait_for(client, queue(client, DESK))
    assert made["state"] == "done", made
    scene = made["result"]["scene"]
    assert client.get(made["figures"][0]["url"]).content.startswith(b"\x89PNG")
    asked = {"kind": "edit", "scene": scene, "action": "add", "words": ["a book"], "seed": 1}
    edited = wait_for(client, client.post("/api/jobs", json=asked).json()["id"])
    assert edited["state"] == "done", edited
    later = edited["result"]["scene"]
    row = client.get(f"/api/scenes/{later}").json()
    assert (row["parent"], row["in"], len(row["things"])) == (scene, "workspace", 2)
    assert (row["edits"], row["last_edit"], row["asked"]) == (1, "add book_1: a book", ["a book"])
    assert edited["result"]["facts"]["not_understood"] == []
    history = client.get(f"/api/scenes/{later}/history").json()
    assert [(s["id"], s["kind"]) for s in history["steps"]] == [(scene, "made"), (later, "add")]
    assert client.get(f"/api/scenes/{scene}/history").json()["later"] == [later]
    assert client.get(f"/api/scenes/{later}/view.json").json()["row"]["id"] == later
    for more, start in (
        ({"kind": "export", "format": "glb"}, b"glTF"),
        ({"kind": "export", "format": "urdf"}, b"PK"),
        ({"kind": "episode", "task": "Lift"}, b""),
    ):
        job = client.post("/api/jobs", json={"scene": scene, **more}).json()["id"]
        done = wait_for(client, job)
        assert done["state"] == "done", done
        content = client.get(done["result"]["url"])
        assert content.content.startswith(start)
        assert len(content.content) == done["result"]["bytes"] > 100
        assert "attachment" in content.headers["content-disposition"]
    until(lambda: any(e["type"] == "result" for e in listener.of(job)))
    half = {"kind": "edit", "scene": scene, "action": "move", "words": ["mug_1", "2 metres left"]}
    moved = wait_for(client, client.post("/api/jobs", json=half).json()["id"])
    assert "2 metres" in str(moved["error"] or moved["result"]["facts"]["not_understood"])
    wrong = {"kind": "edit", "scene": scene, "action": "remove", "words": ["piano_1"]}
    failed = wait_for(client, client.post("/api/jobs", json=wrong).json()["id"])
    assert failed["state"] == "failed" and "piano_1" in failed["error"]


def test_events_are_resumed_where_a_client_left(studio: Studio) -> None:
    first = Listener(studio)
    job = queue(studio.client, DESK)
    wait_for(studio.client, job)
    until(lambda: [e for e in first.of(job) if e.get("state") == "done"])
    told = first.of(job)
    middle = told[2]["seq"]
    for since in (middle, 10**14):
        again = Listener(studio, since)
        until(lambda again=again: [e for e in again.of(job) if e.get("state") == "done"])
        expected = told[3:] if since == middle else told
        assert again.of(job) == expected


def test_an_upload_of_a_gigabyte_is_refused_while_it_comes(studio: Studio) -> None:
    head = (
        f"POST /api/pictures HTTP/1.1\r\nHost: {studio.host}\r\n"
        f"Authorization: Bearer {studio.token}\r\n"
    )
    claimed = ask_raw(studio.port, f"{head}Content-Length: {2**30}\r\n\r\n".encode())
    assert b" 413 " in claimed.split(b"\r\n")[0] and b"20 MiB" in claimed
    with socket.create_connection(("127.0.0.1", studio.port), timeout=20) as line:
        line.sendall(f"{head}Transfer-Encoding: chunked\r\n\r\n".encode())
        piece, sent = b"100000\r\n" + bytes(2**20) + b"\r\n", 0
        with contextlib.suppress(OSError):
            while sent < 2**30:
                line.sendall(piece)
                sent += 2**20
        assert sent < 64 * 2**20, "it went on reading"
    memory = Path(f"/proc/{studio.process.pid}/status").read_text()
    peak = int(memory.split("VmHWM:")[1].split()[0])
    assert peak < 1_500_000, f"{peak} kB"
    assert studio.client.get("/api/state").status_code == 200


@pytest.mark.parametrize("path", [
    "/../../etc/passwd", "//etc/passwd", "/assets/../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd",
    "/api/scenes/..%2f..%2fetc/passwd", "/static/%00", "/api/jobs/%2e%2e/figures/%2e%2e", "/\\..\\",
    "/api/scenes/office-desk-9a3d5bb3cd64/bundle/../../../jobs.sqlite3", "http://evil/", "*",
])  # fmt: skip
def test_no_path_leads_out(studio: Studio, path: str) -> None:
    said = ask_raw(studio.port, (
        f"GET {path} HTTP/1.1\r\nHost: {studio.host}\r\nConnection: close\r\n"
        f"Authorization: Bearer {studio.token}\r\n\r\n"
    ).encode())  # fmt: skip
    status = int(said.split(b" ", 2)[1])
    assert status in (400, 403, 404), said
    assert b"root:" not in said and b"SQLite" not in said


@pytest.mark.parametrize("request_", [
    b"GET / HTTP/1.1\r\n\r\n", b"\0\xff" * 100, b"GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n",
    b"GET / HTTP/1.1\r\n" + b"x: y\r\n" * 100_000, b"GET /" + b"a" * 10**6 + b" HTTP/1.1\r\n\r\n",
])  # fmt: skip
def test_what_is_no_request_is_refused(studio: Studio, request_: bytes) -> None:
    said = ask_raw(studio.port, request_, seconds=10)
    assert not said or b" 4" in said.split(b"\r\n")[0]
    assert studio.client.get("/api/state").status_code == 200


def test_a_second_studio_says_where_the_first_is(tmp_path: Path, store: Path) -> None:
    def start(*options: str) -> subprocess.CompletedProcess[str]:
        command = studio_command(tmp_path / "page", *options)
        return subprocess.run(command, capture_output=True, text=True, timeout=LONG, check=False)

    with run_studio(tmp_path / "one") as studio:
        same = start("--folder", str(tmp_path / "one"))
        assert same.returncode == 5 and str(studio.port) in same.stderr
        assert "Another studio" in same.stderr and studio.token not in same.stderr
        port = start("--folder", str(tmp_path / "two"), "--port", str(studio.port))
        assert port.returncode == 3 and "--port" in port.stderr
        assert same.stderr.count("\n") == port.stderr.count("\n") == 1
        assert studio.client.get("/api/state").status_code == 200
        studio.process.send_signal(signal.SIGINT)
        assert studio.process.wait(LONG) == 0
        assert "Traceback" not in studio.process.stderr.read()
    (tmp_path / "one" / "jobs.sqlite3").write_bytes(b"no database at all" * 1000)
    damaged = start("--folder", str(tmp_path / "one"))
    assert damaged.returncode == 5 and "damaged" in damaged.stderr


def test_a_generation_is_cancelled_in_its_middle(tmp_path: Path, store: Path) -> None:
    with run_studio(tmp_path / "studio") as studio:
        asked = {"kind": "generate", "text": DESK}
        job = studio.client.post("/api/jobs", json=asked).json()["id"]
        wait_until(lambda: studio.client.get(f"/api/jobs/{job}").json()["figures"], "a figure")
        (worker,) = children(studio.process.pid)
        studio.client.post(f"/api/jobs/{job}/cancel")
        row = wait_for(studio.client, job)
        assert row["state"] == "cancelled" and row["result"] is None
        until(lambda: not is_alive(worker), 20)
        assert not [p for p in (tmp_path / "studio" / "scenes").iterdir() if p.name[0] != "."]
        assert wait_for(studio.client, queue(studio.client, DESK))["state"] == "done"


def test_a_killed_studio_loses_nothing(tmp_path: Path, store: Path) -> None:
    """The next studio restarts the job, and produces the same bundle as the pipeline."""
    folder = tmp_path / "studio"
    with run_studio(folder) as studio:
        asked = {"kind": "generate", "text": DESK, "seed": 4}
        job = studio.client.post("/api/jobs", json=asked).json()["id"]
        waiting = queue(studio.client, DESK, seed=5)
        wait_until(lambda: studio.client.get(f"/api/jobs/{job}").json()["figures"], "a figure")
        (worker,) = children(studio.process.pid)
        os.kill(studio.process.pid, signal.SIGKILL)
        studio.process.wait(LONG)
        until(lambda: not is_alive(worker), 20)
    assert not [p for p in (folder / "scenes").iterdir() if p.name[0] != "."]
    with run_studio(folder) as studio:
        row = wait_for(studio.client, job)
        assert (row["state"], row["runs"]) == ("done", 2), row
        stages = [f["stage"] for f in row["figures"]]
        assert stages[0] == "reference" and stages[-1] == "assembly" and len(stages) >= 7
        assert wait_for(studio.client, waiting)["state"] == "done"
        states = [e["state"] for e in all_events(studio) if e["job"] == job and "state" in e]
        assert states == ["queued", "running", "interrupted", "queued", "running", "done"]
    from generator.pipeline import generate

    assert generate(DESK, seed=4).save(tmp_path / "own").name == row["result"]["scene"]


def all_events(studio: Studio) -> list[dict]:
    listener = Listener(studio)
    last = studio.client.get("/api/state").json()["last_event"]
    until(lambda: listener.events and listener.events[-1]["seq"] >= last)
    return listener.events


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of 3 MB."""
    place = tmp_path / "small"
    place.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", "size=3m", "tmpfs", str(place)]
    done = subprocess.run(command, capture_output=True, timeout=LONG, check=False)
    if done.returncode:
        pytest.skip("a small file system cannot be mounted here")
    yield place
    subprocess.run(["umount", "-l", str(place)], timeout=LONG, check=True)


def test_a_full_disk_fails_jobs_and_the_studio_lives(small_disk: Path, store: Path) -> None:
    with run_studio(small_disk / "studio") as studio:
        assert studio.client.get("/api/state").status_code == 200, "it has begun"
        filler = small_disk / "filler"
        with contextlib.suppress(OSError), filler.open("wb") as file:
            while True:
                file.write(bytes(4096))
                file.flush()
        uploaded = studio.client.post("/api/pictures", content=b"\x89PNG\r\n\x1a\n" + bytes(99))
        assert uploaded.status_code in (422, 507)
        refused = studio.client.post("/api/jobs", json={"kind": "compose", "text": DESK})
        assert refused.status_code == 507 and "\n" not in refused.json()["error"]
        with filler.open("r+b") as file:
            file.truncate(filler.stat().st_size - 200_000)
        job = queue(studio.client, DESK)
        row = wait_for(studio.client, job)
        assert row["state"] == "failed" and "pace" in row["error"], row
        filler.unlink()
        assert studio.client.post(f"/api/jobs/{job}/resume").status_code == 202
        assert wait_for(studio.client, job)["state"] == "done"


def test_an_uploaded_picture_becomes_a_scene(studio: Studio) -> None:
    from generator.backends import Backends
    from generator.io.pictures import encode_png

    backends = Backends.select("embedded")
    drawn = backends.imager.draw(backends.reasoner.plan_scene(DESK, 4), 4)
    picture = studio.client.post("/api/pictures", content=encode_png(drawn)).json()["picture"]
    asked = {"kind": "generate", "picture": picture, "seed": 1, "name": "my-photo"}
    row = wait_for(studio.client, studio.client.post("/api/jobs", json=asked).json()["id"])
    assert row["state"] == "done", row
    assert row["result"]["scene"].startswith("my-photo-")
    scene = studio.client.get(f"/api/scenes/{row['result']['scene']}").json()
    assert scene["prompt"] == "" and len(scene["things"]) == 1


def test_an_estimate_names_who_answers_and_what_that_may_cost(
    tmp_path: Path, store: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TABLETOPGEN_CLOUD_KEY", "sk-secret-secret-1")
    monkeypatch.setenv("TABLETOPGEN_CALLS", str(tmp_path / "calls"))
    with run_studio(tmp_path / "studio") as studio:
        asked = {"kind": "generate", "text": DESK, "reasoner": "cloud"}
        answer = studio.client.post("/api/estimate", json=asked)
        said = answer.json()
        assert said["asks_servers"] and "plan_scene" in said["calls"][0]
        assert "USD" in said["calls"][0] and "secret" not in answer.text
        roles = {row["role"]: row["backend"] for row in said["roles"]}
        assert roles["reasoner"] == "cloud" and roles["encoder"] == "embedded"
        free = studio.client.post("/api/estimate", json={"kind": "compose", "text": DESK}).json()
        assert free == {"roles": [], "calls": [], "asks_servers": False}
        (cloud,) = (
            b for b in studio.client.get("/api/state").json()["backends"] if b["name"] == "cloud"
        )
        assert cloud["available"] and cloud["charges"]
        assert studio.client.get("/api/jobs").json() == {"jobs": []}


def test_a_browser_that_knows_no_token_gets_one_line(studio: Studio) -> None:
    with httpx2.Client(base_url=f"http://{studio.host}", trust_env=False) as stranger:
        answer = stranger.get("/")
        assert answer.status_code == 403 and "address" in answer.text
        opened = stranger.get(f"/?token={studio.token}", follow_redirects=True)
        assert opened.status_code == 200 and "<html" in opened.text
        assert stranger.get("/api/state").status_code == 200
