"""Who may ask: the token, the host, the origin; and what every answer says."""

from dataclasses import replace
from pathlib import Path

import pytest
from starlette.responses import PlainTextResponse
from starlette.testclient import TestClient
from studio_clients import ACCESS, TOKEN

from tabletopgen_web.studio.server.guard import HEADERS, Access, StudioGuard

OWN = "http://127.0.0.1:8123"


def one_line(answer) -> str:
    error = answer.json()["error"]
    assert error and "\n" not in error
    return error


def test_the_printed_address_sets_the_cookie_and_leads_to_the_page(client: TestClient) -> None:
    del client.headers["authorization"]
    assert client.get("/api/state").status_code == 403
    opened = client.get(f"/?token={TOKEN}", follow_redirects=False)
    assert (opened.status_code, opened.headers["location"]) == (303, "/")
    cookie = opened.headers["set-cookie"].lower()
    assert "httponly" in cookie and "samesite=strict" in cookie and "8123" in cookie
    page = client.get("/")
    assert page.status_code == 200 and "Studio" in page.text
    assert TOKEN not in page.text


def test_a_browser_is_started_with_an_address_that_opens_once() -> None:
    access = replace(ACCESS, ticket="the-ticket")
    guarded = StudioGuard(PlainTextResponse("the page"), access)
    assert TOKEN not in access.ticket_link
    own, other = (TestClient(guarded, base_url=ACCESS.address) for _ in range(2))
    for wrong in ("?ticket=", "?ticket=wrong", f"?ticket={TOKEN}", "?token=the-ticket"):
        assert other.get(f"/{wrong}").status_code == 403
    assert own.get("/?ticket=the-ticket").text == "the page"
    assert own.get("/?ticket=the-ticket").text == "the page", "its cookie is there"
    refused = other.get("/?ticket=the-ticket")
    assert refused.status_code == 403 and "once" in refused.text
    bare = TestClient(StudioGuard(PlainTextResponse("the page"), ACCESS), base_url=ACCESS.address)
    assert bare.get("/?ticket=None").status_code == 403


@pytest.mark.parametrize("query", ["", "?token=", "?token=wrong", "?token=%00%ff",
                                   f"?token={TOKEN}&token=x", "?token=" + "x" * 5000])  # fmt: skip
def test_without_the_token_there_is_a_page_that_says_so(client: TestClient, query: str) -> None:
    del client.headers["authorization"]
    answer = client.get(f"/{query}", follow_redirects=False)
    assert answer.status_code == 403 and "set-cookie" not in answer.headers
    assert answer.headers["content-type"].startswith("text/html")
    assert "address" in answer.text and TOKEN not in answer.text and "script" not in answer.text
    assert "address" in one_line(client.get("/api/state"))


@pytest.mark.parametrize("given", ["Bearer wrong", "Bearer", f"Basic {TOKEN}", TOKEN, "",
                                   f"Bearer {TOKEN} ", f"Bearer {TOKEN}x"])  # fmt: skip
def test_another_token_opens_nothing(client: TestClient, given: str) -> None:
    for path in ("/", "/api/state", "/assets/studio.js", "/nowhere", "/api/events"):
        assert client.get(path, headers={"authorization": given}).status_code == 403


def test_the_cookie_of_another_port_opens_nothing(client: TestClient) -> None:
    del client.headers["authorization"]
    client.cookies.set("tabletopgen-studio-9999", TOKEN)
    assert client.get("/api/state").status_code == 403
    client.cookies.set("tabletopgen-studio-8123", TOKEN)
    assert client.get("/api/state").status_code == 200


@pytest.mark.parametrize("host", [
    "evil.example", "evil.example:8123", "127.0.0.1", "127.0.0.1:8124", "localhost", "",
    "127.0.0.1:8123@evil.example", "192.168.0.9:8123", "127.0.0.1:8123.evil.example", "[::1",
    "x" * 300,
    "127.0.0.1:99999999", "127.0.0.1:-1",
])  # fmt: skip
def test_a_foreign_host_is_refused(client: TestClient, host: str) -> None:
    answer = client.get("/api/state", headers={"host": host})
    assert answer.status_code == 403, host
    one_line(answer)


@pytest.mark.parametrize("host", ["127.0.0.1:8123", "localhost:8123", "[::1]:8123"])
def test_own_names_are_known(client: TestClient, host: str) -> None:
    assert client.get("/api/state", headers={"host": host}).status_code == 200


@pytest.mark.parametrize(
    "origin",
    [
        "http://evil.example",
        "null",
        "https://127.0.0.1:8123",
        "http://127.0.0.1:8124",
        f"{OWN}.evil.example",
        f"{OWN}/",
    ],
)
def test_a_foreign_origin_is_refused(client: TestClient, origin: str) -> None:
    for method in ("GET", "POST", "DELETE", "PUT"):
        answer = client.request(method, "/api/jobs", headers={"origin": origin}, json={})
        assert answer.status_code == 403, (method, origin)


def test_what_changes_something_says_where_it_comes_from(client: TestClient) -> None:
    assert client.post("/api/explain", json={"text": "a mug"}).status_code == 200, "a program"
    del client.headers["authorization"]
    client.cookies.set(ACCESS.cookie, TOKEN)
    said = {"text": "a mug"}
    assert client.post("/api/explain", json=said).status_code == 403
    assert client.post("/api/explain", json=said, headers={"origin": OWN}).status_code == 200


def test_every_answer_says_how_it_is_to_be_treated(client: TestClient) -> None:
    answers = [
        client.get(path, **more)
        for path in ("/", "/assets/studio.js", "/api/state", "/nowhere", "/api/jobs/none")
        for more in ({}, {"headers": {"authorization": ""}})
    ]
    answers.append(client.post("/api/jobs", content=b"x" * 100_000))
    assert {a.status_code for a in answers} == {200, 403, 404, 415}
    for answer in answers:
        assert {k: answer.headers[k] for k in HEADERS} == dict(HEADERS)
        assert "server" not in answer.headers
    policy = HEADERS["content-security-policy"]
    assert "'unsafe-inline'" not in policy and "'unsafe-eval'" not in policy


def test_files_of_the_page_are_those_that_were_built(client: TestClient, static: Path) -> None:
    script = client.get("/assets/studio.js")
    assert script.text == "export {}" and script.headers["content-type"].startswith(
        "text/javascript"
    )
    assert client.get("/static/assets/studio.js").status_code == 200
    assert client.get("/assets/mujoco.wasm").headers["content-type"] == "application/wasm"
    (static / "late.js").write_text("late")
    for path in (
        "/late.js",
        "/secret",
        "/static/secret",
        "/assets/../studio.html",
        "/assets",
        "/assets/%2e%2e/studio.html",
        "/static/..%2f..%2fetc/passwd",
        "/etc/passwd",
    ):
        assert client.get(path).status_code == 404, path


def test_a_server_for_others_is_found_by_its_numbers_alone() -> None:
    opened = Access("0.0.0.0", 80, "t")
    assert opened.is_own("192.168.0.9") and opened.is_own("[fe80::1]:80")
    assert not opened.is_own("rebound.example") and not opened.is_local
    assert opened.address == "http://127.0.0.1:80/"
    assert Access("::1", 8123, "t").address == "http://[::1]:8123/"
    assert Access("127.0.0.1", 1, "t").is_local and Access("localhost", 1, "t").is_local
