"""Every endpoint, asked what it does not expect: no answer is a 500, none is more than one line."""

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from starlette.testclient import TestClient

from tabletopgen_web.studio.server.application import ROUTES

IDS = [
    "x", "..", "%2e%2e", "%2e%2e%2f%2e%2e%2fetc%2fpasswd", "a%00b", "x" * 3000, "%ff", "*", "~",
    "office-desk-9a3d5bb3cd64", "0" * 32, "0" * 12, "-", "CON", "%0d%0aset-cookie:x=y",
]  # fmt: skip
METHODS = ["GET", "POST", "PUT", "PATCH", "DELETE", "OPTIONS", "HEAD", "TRACE", "PROPFIND"]
BODIES = [b"", b"{}", b"[]", b"null", b'"x"', b"{", b"\xff\xfe", b"[" * 5000, b'{"a":NaN}',
          b'{"kind":1e999}', b'{"kind":"compose","text":"\\ud800"}',
          b'{"kind":' + b"9" * 5000 + b"}"]  # fmt: skip


def check(answer: Any) -> None:
    assert answer.status_code < 500, (answer.request.method, answer.request.url, answer.text)
    if answer.status_code >= 400 and answer.request.method != "HEAD":
        error = answer.json()["error"]
        assert error.strip() and "\n" not in error and len(error) < 1000
        assert "Traceback" not in error


def paths() -> list[str]:
    """Return every endpoint's path with every invalid id in every position."""
    found = set()
    for route in ROUTES:
        if route.path != "/api/events":
            names = [part for part in route.path.split("/") if part.startswith("{")]
            for strange in IDS if names else [""]:
                path = route.path
                for name in names:
                    path = path.replace(name, strange)
                found.add(path)
    return sorted(found)


@pytest.mark.parametrize("method", METHODS)
def test_strange_ids_and_methods(fake: TestClient, method: str, tmp_path: Path) -> None:
    before = list_made(tmp_path)
    for path in paths():
        check(fake.request(method, path, headers={"content-type": "application/json"}))
    for path in ("/", "//", "/api", "/api/", "/api/jobs/", "/static/", "/.git/config", "/%2e%2e"):
        check(fake.request(method, path))
    assert list_made(tmp_path) == before


def list_made(folder: Path) -> list[Path]:
    """Return all files except the database and prepared scenes."""
    found = folder.rglob("*")
    return sorted(p for p in found if "sqlite" not in p.name and "views" not in p.parts)


@pytest.mark.parametrize("body", BODIES, ids=range(len(BODIES)))
def test_strange_bodies(fake: TestClient, body: bytes) -> None:
    posts = [r.path for r in ROUTES if "POST" in (r.methods or ()) and "cancel" not in r.path]
    for path in posts:
        for kind in ("application/json", "text/plain", "", "multipart/form-data; boundary=x"):
            answer = fake.post(path.replace("{", "").replace("}", ""), content=body,
                               headers={"content-type": kind})  # fmt: skip
            check(answer)
            assert answer.status_code >= 400


GOOD: dict[str, dict[str, Any]] = {
    "generate": {"text": "a mug", "seed": 1, "name": "x", "budget": 1.0, "backend": "embedded"},
    "compose": {"text": "a mug", "seed": 1, "density": "dense", "name": "x"},
    "edit": {"scene": "office-desk-9a3d5bb3cd64", "action": "move", "words": ["mug_1"],
             "to": [0, 0.1], "turn": 5, "seed": 0, "modeler": "embedded"},
    "episode": {"scene": "office-desk-9a3d5bb3cd64", "task": "Lift", "seed": 0},
    "export": {"scene": "office-desk-9a3d5bb3cd64", "format": "glb"},
}  # fmt: skip
WRONG: list[Any] = [True, -1, 1.5, 2**63, 1e308, "", " ", "\0", "x" * 5000, [], [[]], {},
                    ["a"] * 200, 10**4000, [1, "x"], "../..", "cloud", None]  # fmt: skip


@pytest.mark.parametrize("kind", GOOD)
def test_each_field_is_checked_and_named(fake: TestClient, kind: str) -> None:
    whole = {"kind": kind, **GOOD[kind]}
    assert fake.post("/api/estimate", json=whole).status_code == 200, kind
    refused = dict.fromkeys(GOOD[kind], 0)
    for name in GOOD[kind]:
        for wrong in WRONG:
            answer = fake.post("/api/jobs", json={**whole, name: wrong})
            check(answer)
            if answer.status_code == 422:
                refused[name] += 1
    assert min(refused.values()) >= 8, refused
    for name in ("text", "scene", "task", "format", "action"):
        if name in whole:
            lacking = {k: v for k, v in whole.items() if k != name}
            answer = fake.post("/api/jobs", json=lacking)
            assert answer.status_code == 422 and name in answer.json()["error"]
    unknown = fake.post("/api/jobs", json={**whole, "seeed": 1})
    assert unknown.status_code == 422 and "'seeed'" in unknown.json()["error"]
    assert "Did you mean 'seed'?" in unknown.json()["error"] or kind == "export"


@pytest.mark.parametrize(("body", "says"), [
    ({"kind": "compos", "text": "a mug"}, "Did you mean 'compose'?"),
    ({"kind": "generate", "text": "a mug", "picture": "0" * 32}, "either text or picture"),
    ({"kind": "generate", "backend": "cloud", "text": "a mug"}, "has no segmenter"),
    ({"kind": "generate", "picture": "0" * 32}, "no picture"),
    ({"kind": "generate", "picture": "/etc/passwd"}, "picture"),
    ({"kind": "edit", "scene": "office-desk-9a3d5bb3cd64", "action": "add", "words": ["x"],
      "turn": 3}, "only move accepts"),
    ({"kind": "export", "scene": "none-000000000000", "format": "glb"}, "no scene"),
    ({"kind": "episode", "scene": "office-desk-9a3d5bb3cd64", "task": "Lif"}, "'Lift'"),
    ({"kind": "compose", "text": "a mug", "name": "../x"}, "folder"),
])  # fmt: skip
def test_a_sentence_says_what_is_wrong(fake: TestClient, body: dict, says: str) -> None:
    answer = fake.post("/api/jobs", json=body)
    assert answer.status_code in (404, 422) and says in answer.json()["error"]
    assert fake.get("/api/jobs").json() == {"jobs": []}


@pytest.mark.parametrize(
    "query", ["since=x", "since=-1", "since=1.5", "since=" + "9" * 40, "since=%00"]
)
def test_events_begin_at_a_number(fake: TestClient, query: str) -> None:
    check(fake.get(f"/api/events?{query}"))
    assert fake.get(f"/api/events?{query}").status_code == 422


json_values = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(max_size=20),
    lambda inner: (
        st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=8), inner, max_size=4)
    ),
    max_leaves=8,
)
fields = st.sampled_from(sorted({"kind", *(n for fields in GOOD.values() for n in fields)}))


@settings(
    max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(body=st.dictionaries(fields, json_values, max_size=6), kind=st.sampled_from(sorted(GOOD)),
       data=st.data())  # fmt: skip
def test_random_jobs_are_read_or_refused(
    fake: TestClient, body: dict, kind: str, data: st.DataObject
) -> None:
    kept = data.draw(st.sets(st.sampled_from(sorted(GOOD[kind]))))
    whole = {**{name: GOOD[kind][name] for name in kept}, **body}
    if data.draw(st.booleans()):
        whole["kind"] = kind
    raw = json.dumps(whole).encode()
    headers = {"content-type": "application/json"}
    for path in ("/api/jobs", "/api/explain"):
        answer = fake.post(path, content=raw, headers=headers)
        if answer.status_code != 429:
            check(answer)
