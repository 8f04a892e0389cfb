"""Jobs: queued, done, cancelled, resumed, removed; whatever their processes do."""

import itertools
import json
from pathlib import Path

import pytest
from starlette.testclient import TestClient
from studio_clients import open_client, queue, wait_for

from tabletopgen_web.studio.queue import jobs, process


def events_of(client: TestClient, job: str) -> list[dict]:
    store = client.app._app.state.services.store
    return [{"type": e.type, **e.data} for e in store.events(0, 10_000) if e.job == job]


def states_of(client: TestClient, job: str) -> list[str]:
    return [e["state"] for e in events_of(client, job) if e["type"] == "state"]


def test_a_job_is_queued_done_and_told_of(fake: TestClient) -> None:
    job = queue(fake, "quick as can be")
    row = wait_for(fake, job)
    assert (row["state"], row["error"], row["runs"]) == ("done", None, 1)
    assert row["result"]["scene"] == "fake-000000000000"
    assert row["created"] <= row["started"] <= row["finished"]
    (figure,) = row["figures"]
    picture = fake.get(figure["url"])
    assert picture.content.startswith(b"\x89PNG") and picture.headers["content-type"] == "image/png"
    kinds = [event["type"] for event in events_of(fake, job)]
    assert kinds == ["state", "state", "stage", "figure", "result", "state"]
    assert states_of(fake, job) == ["queued", "running", "done"]
    listed = fake.get("/api/jobs").json()["jobs"]
    assert listed == [{**row, "log": ""}]


def test_jobs_run_in_the_order_they_came(fake: TestClient) -> None:
    names = [queue(fake, f"quick {n}") for n in range(4)]
    rows = [wait_for(fake, job) for job in names]
    begun = [row["started"] for row in rows]
    assert begun == sorted(begun)
    assert all(a["finished"] <= b["started"] for a, b in itertools.pairwise(rows))
    assert [row["id"] for row in fake.get("/api/jobs").json()["jobs"]] == names[::-1]


@pytest.mark.parametrize(("text", "says"), [
    ("fails", "The mug is broken."),
    ("crashes", "signal 11"),
    ("silent", "code 3"),
    ("babbles", "not valid JSON"),
    ("shouts", "invalid message"),
    ("unknown", "invalid message"),
])  # fmt: skip
def test_a_job_that_fails_says_why_and_the_next_one_runs(
    fake: TestClient, text: str, says: str
) -> None:
    job = queue(fake, text)
    row = wait_for(fake, job)
    assert row["state"] == "failed" and says in row["error"] and "\n" not in row["error"]
    assert row["result"] is None
    assert wait_for(fake, queue(fake))["state"] == "done"


def test_a_failed_job_keeps_the_facts_of_its_error(fake: TestClient) -> None:
    row = wait_for(fake, queue(fake, "occupied"))
    assert (row["state"], row["error"]) == ("failed", "A mug is in the way.")
    assert row["result"]["scene"] is None
    assert row["result"]["facts"] == {"place": "occupied", "free_position": [0.1, 0.2]}


def test_the_log_is_bounded_and_holds_no_secret(
    fake: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TEST_API_KEY", "hunter2-hunter2")
    row = wait_for(fake, queue(fake, "logs"))
    assert row["state"] == "done"
    assert (
        "line 3 yyy" in row["log"]
        or "line 399" in row["log"]
        or "further lines are omitted" in row["log"]
    )
    assert len(row["log"]) <= jobs.MOST_LOG
    told = json.dumps([row, events_of(fake, row["id"])])
    assert "hunter2" not in told and "\x1b" not in row["log"]
    lines = [e for e in events_of(fake, row["id"]) if e["type"] == "log"]
    assert len(lines) == 401 and "[redacted]" in lines[0]["text"]


@pytest.mark.parametrize("text", ["slow", "stubborn"])
def test_a_running_job_is_cancelled_and_resumed(fake: TestClient, text: str) -> None:
    job = queue(fake, text)
    wait_for(fake, job, "running")
    assert fake.delete(f"/api/jobs/{job}").status_code == 409
    assert fake.post(f"/api/jobs/{job}/resume").status_code == 409
    assert fake.post(f"/api/jobs/{job}/cancel").status_code == 202
    assert wait_for(fake, job)["state"] == "cancelled"
    assert fake.post(f"/api/jobs/{job}/cancel").status_code == 409
    assert fake.post(f"/api/jobs/{job}/resume").json()["state"] in ("queued", "running")
    wait_for(fake, job, "running")
    fake.post(f"/api/jobs/{job}/cancel")
    wait_for(fake, job)
    assert states_of(fake, job) == ["queued", "running", "cancelled"] * 2


def test_a_waiting_job_is_cancelled_before_it_begins(fake: TestClient) -> None:
    first, second = queue(fake, "slow"), queue(fake)
    assert fake.post(f"/api/jobs/{second}/cancel").json()["state"] == "cancelled"
    fake.post(f"/api/jobs/{first}/cancel")
    wait_for(fake, first)
    assert fake.get(f"/api/jobs/{second}").json()["runs"] == 0
    assert wait_for(fake, queue(fake))["state"] == "done"
    assert fake.get(f"/api/jobs/{second}").json()["state"] == "cancelled"


def test_a_removed_job_takes_its_events_and_figures_along(fake: TestClient, tmp_path: Path) -> None:
    job, other = queue(fake), queue(fake)
    url = wait_for(fake, job)["figures"][0]["url"]
    wait_for(fake, other)
    kept = events_of(fake, other)
    assert fake.delete(f"/api/jobs/{job}").status_code == 204
    assert fake.get(url).status_code == fake.get(f"/api/jobs/{job}").status_code == 404
    assert fake.delete(f"/api/jobs/{job}").status_code == 404
    assert not (tmp_path / "studio" / "figures" / job).exists()
    assert [e["state"] for e in events_of(fake, job)] == ["deleted"]
    assert events_of(fake, other) == kept


def test_the_queue_is_bounded(fake: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jobs, "QUEUE_LIMIT", 3)
    running = queue(fake, "slow")
    for _ in range(2):
        queue(fake)
    full = fake.post("/api/jobs", json={"kind": "compose", "text": "one more"})
    assert full.status_code == 429 and "3 jobs" in full.json()["error"]
    fake.post(f"/api/jobs/{running}/cancel")
    wait_for(fake, running)
    queue(fake)


def test_a_job_is_resumed_only_if_the_queue_has_room(
    fake: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    job = queue(fake, "slow")
    fake.post(f"/api/jobs/{job}/cancel")
    assert wait_for(fake, job)["state"] == "cancelled"
    monkeypatch.setattr(jobs, "QUEUE_LIMIT", 0)
    assert fake.post(f"/api/jobs/{job}/resume").status_code == 429


def test_several_jobs_run_at_once_if_there_are_workers(
    tmp_path: Path, static: Path, store: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(process, "MODULE", "fake_job")
    with open_client(tmp_path / "two", static, workers=2) as client:
        first, second, third = (queue(client, "slow") for _ in range(3))
        wait_for(client, first, "running")
        wait_for(client, second, "running")
        assert client.get(f"/api/jobs/{third}").json()["state"] == "queued"


def test_what_ran_when_the_studio_ended_begins_again(
    tmp_path: Path, static: Path, store: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(process, "MODULE", "fake_job")
    with open_client(tmp_path / "again", static) as client:
        job, waiting = queue(client, "slow"), queue(client, "quick")
        wait_for(client, job, "running")
    for _ in range(jobs.MOST_INTERRUPTED - 1):
        with open_client(tmp_path / "again", static) as client:
            wait_for(client, waiting)
            wait_for(client, job, "running")
            assert states_of(client, job)[-3:] == ["interrupted", "queued", "running"]
    with open_client(tmp_path / "again", static) as client:
        row = client.get(f"/api/jobs/{job}").json()
        assert row["state"] == "interrupted" and "3 times" in row["error"]
        assert client.get(f"/api/jobs/{waiting}").json()["state"] == "done"
        assert client.post(f"/api/jobs/{job}/resume").status_code == 202
        wait_for(client, job, "running")


def test_what_no_job_owns_is_swept(
    tmp_path: Path, static: Path, store: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(process, "MODULE", "fake_job")
    figures = tmp_path / "swept" / "figures"
    with open_client(tmp_path / "swept", static) as client:
        job = wait_for(client, queue(client))["id"]
        (figures / "0123456789ab").mkdir()
    with open_client(tmp_path / "swept", static):
        assert [p.name for p in figures.iterdir()] == [job]


def test_a_full_disk_fails_the_job_and_nothing_else(
    fake: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    from generator.errors import StorageError

    whole = jobs.JobStore.note_stage
    refusing = [True]

    def refuse(store: jobs.JobStore, *told: object) -> None:
        if refusing:
            raise StorageError("jobs.sqlite3 cannot be written: the disk is full.")
        whole(store, *told)

    monkeypatch.setattr(jobs.JobStore, "note_stage", refuse)
    row = wait_for(fake, queue(fake))
    assert row["state"] == "failed" and "disk is full" in row["error"]
    refusing.clear()
    assert wait_for(fake, queue(fake))["state"] == "done"


def test_an_ending_that_cannot_be_written_is_written_later(
    fake: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    from generator.errors import StorageError

    whole, refusals = jobs.JobStore.finish, [1, 2]

    def refuse(store: jobs.JobStore, *told: object, **more: object) -> None:
        if refusals:
            refusals.pop()
            raise StorageError("the disk is full")
        whole(store, *told, **more)

    monkeypatch.setattr(jobs.JobStore, "finish", refuse)
    monkeypatch.setattr("tabletopgen_web.studio.queue.runner._AGAIN", 0.05)
    assert wait_for(fake, queue(fake))["state"] == "done" and not refusals


def test_a_job_that_cannot_be_taken_does_not_stop_the_queue(
    fake: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole, faults = jobs.JobStore.take, [1, 2]

    def fail(store: jobs.JobStore) -> object:
        if faults:
            faults.pop()
            raise RuntimeError("a defect")
        return whole(store)

    monkeypatch.setattr(jobs.JobStore, "take", fail)
    monkeypatch.setattr("tabletopgen_web.studio.queue.runner._AGAIN", 0.05)
    assert wait_for(fake, queue(fake))["state"] == "done" and not faults


def test_jobs_that_make_way_take_their_files_along(
    fake: TestClient, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(jobs, "_MAX_JOBS", 2)
    made = [wait_for(fake, queue(fake))["id"] for _ in range(4)]
    (figures,) = tmp_path.rglob("figures")
    assert {path.name for path in figures.iterdir()} == {*made[2:]}


def test_an_estimate_asks_a_process_of_its_own(fake: TestClient) -> None:
    said = fake.post("/api/estimate", json={"kind": "generate", "text": "cloud"}).json()
    assert said == {"roles": [], "calls": ["Would ask cloud."], "asks_servers": True}
    assert fake.get("/api/jobs").json() == {"jobs": []}
