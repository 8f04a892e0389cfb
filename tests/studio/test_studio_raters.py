"""Studies that the studio serves: what a rater's link opens, and what it does not."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
import tiny_studies as tiny
from command import Shell
from starlette.testclient import TestClient
from studio_clients import ACCESS, TOKEN, open_client, rater_token

from generator.errors import StorageError
from tabletopgen_web import frontend
from tabletopgen_web.studio.folder import StudioFolder
from tabletopgen_web.studio.library import answers as books
from tabletopgen_web.studio.server import listener
from tabletopgen_web.studio.server.guard import HEADERS
from tabletopgen_web.study.key import StudyKey
from tabletopgen_web.study.page_data import StudyPage

OWN = {"origin": "http://127.0.0.1:8123"}


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[StudyKey, StudyPage, StudyPage]:
    folder = tmp_path_factory.mktemp("studies")
    files, page = tiny.served_study(folder / "a")
    return files.key, page, tiny.served_study(folder / "b", seed=1)[1]


@pytest.fixture
def key(made: tuple) -> StudyKey:
    return made[0]


@pytest.fixture
def rater(made: tuple, tmp_path: Path, static: Path, store: Path) -> Iterator[TestClient]:
    """A client without a token for a studio with two served studies."""
    with open_client(tmp_path / "studio", static, studies=made[1:]) as client:
        del client.headers["authorization"]
        yield client


def enter(rater: TestClient, study: str) -> None:
    rater.get(f"/study/{study}?token={rater_token(study)}")


def test_a_link_sets_a_cookie_and_leads_to_the_page(rater: TestClient, made: tuple) -> None:
    page = made[1]
    path = f"/study/{page.study}"
    opened = rater.get(f"{path}?token={rater_token(page.study)}", follow_redirects=False)
    assert (opened.status_code, opened.headers["location"]) == (303, path)
    cookie = opened.headers["set-cookie"].lower()
    assert "httponly" in cookie and "samesite=lax" in cookie and "8123" in cookie
    assert "tabletopgen" not in cookie
    shown = rater.get(path)
    assert (shown.status_code, shown.content) == (200, page.content)
    assert shown.headers["content-type"] == "text/html; charset=utf-8"
    assert shown.headers["content-security-policy"] == page.policy
    others = {k: v for k, v in HEADERS.items() if k != "content-security-policy"}
    assert {k: shown.headers[k] for k in others} == others
    assert rater.head(path).status_code == 200


@pytest.mark.parametrize("query", ["", "?token=", "?token=wrong", f"?token={TOKEN}",
                                   "?token=a&token=b", "?token=%00%ff"])  # fmt: skip
def test_without_the_token_a_page_says_so_and_names_no_method(
    rater: TestClient, made: tuple, query: str
) -> None:
    for study in (made[1].study, "0123456789ab"):
        answer = rater.get(f"/study/{study}{query}", follow_redirects=False)
        assert answer.status_code == 403 and "set-cookie" not in answer.headers
        assert answer.headers["content-type"].startswith("text/html")
        assert "address" in answer.text and "tabletopgen" not in answer.text.lower()
        assert answer.headers["content-security-policy"] == HEADERS["content-security-policy"]


def test_a_rater_reaches_nothing_else(rater: TestClient, made: tuple, tmp_path: Path) -> None:
    own, other = made[1].study, made[2].study
    enter(rater, own)
    assert rater.get(f"/study/{own}").status_code == 200
    for path in ("/", "/api/state", "/api/jobs", "/api/scenes", "/api/events", "/assets/studio.js",
                 f"/?token={rater_token(own)}", f"/api/studies/{own}/answers", f"/study/{other}",
                 f"/study/{other}?token={rater_token(own)}", f"/study/{own}/", "/study/",
                 f"/study/{own}/../../api/state", f"/study/{own}%2f..%2f..%2fapi%2fstate",
                 f"/study/{own}%0a", f"//study/{own}", "/nowhere",
                 "/static/study.html"):  # fmt: skip
        for method in ("GET", "HEAD", "OPTIONS", "DELETE", "PUT"):
            assert rater.request(method, path, headers=OWN).status_code == 403, (method, path)
    for path in ("/api/jobs", "/api/pictures", "/api/explain", "/api/estimate", f"/study/{own}",
                 f"/api/studies/{other}/answers", f"/api/studies/{own}/answers/",
                 "/api/studies/another/answers"):  # fmt: skip
        assert rater.post(path, headers=OWN, json={}).status_code == 403, path
    rater.cookies.set(ACCESS.cookie, rater_token(own))
    assert rater.get("/api/state").status_code == 403
    bearer = {"authorization": f"Bearer {rater_token(own)}"}
    assert rater.get("/api/state", headers=bearer).status_code == 403
    assert not list((tmp_path / "studio" / "answers").iterdir())


def test_answers_come_from_the_page_alone_and_are_complete(
    rater: TestClient, made: tuple, key: StudyKey, tmp_path: Path
) -> None:
    path, said = f"/api/studies/{key.study}/answers", tiny.answers_of(key, 0)
    assert rater.post(path, json=said, headers=OWN).status_code == 403
    enter(rater, key.study)
    assert rater.post(path, json=said).status_code == 403, "no origin"
    foreign = {"origin": "http://evil.example"}
    assert rater.post(path, json=said, headers=foreign).status_code == 403
    changes = ({"more": "x"}, {"scenes": said["scenes"][1:]}, {"rater": "../../etc"},
               {"study": made[2].study})  # fmt: skip
    for wrong in ({}, {"rater": "ann"}, *(said | change for change in changes)):
        answer = rater.post(path, json=wrong, headers=OWN)
        assert answer.status_code == 422 and "do not match the study" in answer.json()["error"]
    assert not list((tmp_path / "studio" / "answers").iterdir())
    for _ in range(3):  # sent again
        assert rater.post(path, json=said, headers=OWN).json() == {"answers": 1}
    kept = tmp_path / "studio" / "answers" / key.study
    assert [p.name for p in kept.iterdir()] == [f"{said['rater']}.json"]
    assert books.AnswerBook(kept.parent).read(key.study) == {said["rater"]: [said]}


def test_a_rater_cannot_fill_the_disk(
    rater: TestClient, key: StudyKey, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = f"/api/studies/{key.study}/answers"
    enter(rater, key.study)

    def send(number: int, seconds: float) -> int:
        said = tiny.answers_of(key, 0, rater=f"{number:016x}", seconds=seconds)
        return rater.post(path, json=said, headers=OWN).status_code

    assert [send(0, 1.0 + k) for k in range(9)] == [201] * 8 + [507]
    assert send(0, 1.0) == 201, "what is there already is no more"
    folder = tmp_path / "studio" / "answers" / key.study
    size = sum(path.stat().st_size for path in folder.iterdir())
    monkeypatch.setattr(books, "_MAX_SHARED_BYTES", int(size * 1.5))
    found = [send(k, 1.0) for k in range(1, 9)]
    assert {201, 507} == {*found} and found == sorted(found)
    assert sum(path.stat().st_size for path in folder.iterdir()) <= size * 1.5


def test_the_studio_opens_what_raters_open(rater: TestClient, key: StudyKey, made: tuple) -> None:
    rater.cookies.set(ACCESS.cookie, TOKEN)
    assert rater.get(f"/study/{key.study}").content == made[1].content
    path, said = f"/api/studies/{key.study}/answers", tiny.answers_of(key, 1)
    assert rater.post(path, json=said, headers=OWN).status_code == 201
    assert rater.get(path).json()["answers"] == {said["rater"]: [said]}
    missing = rater.get("/study/0123456789ab")
    assert missing.status_code == 404 and "--study" in missing.json()["error"]
    more = rater.post("/api/studies/another/answers", json={"rater": "ann"}, headers=OWN)
    assert more.status_code == 201, "of a study that is not served, as before"


def test_links_have_the_token_of_their_study() -> None:
    access = replace(ACCESS, studies={"0123456789ab": "t1", "ba9876543210": "t2"})
    assert access.study_link("0123456789ab") == "http://127.0.0.1:8123/study/0123456789ab?token=t1"
    assert len({access.cookie, *map(access.study_cookie, access.studies)}) == 3


def test_tokens_outlive_the_studio(tmp_path: Path) -> None:
    folder, other = StudioFolder(tmp_path / "a"), StudioFolder(tmp_path / "b")
    folder.make(), other.make()
    token = folder.make_token("0123456789ab")
    assert len(token) >= 32 and token == StudioFolder(tmp_path / "a").make_token("0123456789ab")
    assert token not in (folder.make_token("ba9876543210"), other.make_token("0123456789ab"))
    secret = tmp_path / "a" / "studies.secret"
    assert secret.stat().st_mode & 0o777 == 0o600 and token not in secret.read_text()
    secret.write_text("short")
    with pytest.raises(StorageError, match="Remove it"):
        folder.make_token("0123456789ab")


def test_a_secret_is_written_whole_or_not_at_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = StudioFolder(tmp_path / "a")
    folder.make()

    def end_early(path: Path, target: Path) -> Path:
        raise KeyboardInterrupt

    before = {path.name for path in folder.root.iterdir()}
    with monkeypatch.context() as broken:
        broken.setattr(Path, "replace", end_early)
        with pytest.raises(KeyboardInterrupt):
            folder.make_token("0123456789ab")
    assert {path.name for path in folder.root.iterdir()} == before
    assert folder.make_token("0123456789ab")


# --------------------------------------------------------------------------------------- command
@pytest.fixture
def serving(monkeypatch: pytest.MonkeyPatch, static: Path) -> list[tuple]:
    """Return the application of the command without serving it."""
    served: list[tuple] = []
    (static / "study.html").write_text(tiny.TEMPLATE)
    monkeypatch.setattr(frontend, "static_folder", lambda: static)
    monkeypatch.setattr(listener, "serve", lambda *told: served.append(told))
    return served


def test_the_command_serves_pages(serving: list, tmp_path: Path, shell: Shell) -> None:
    pages = [tiny.served_study(tmp_path / str(k), seed=k)[1] for k in range(2)]
    files = [str(tmp_path / str(k) / "study.html") for k in range(2)]
    studio = shell.of("studio", "--folder", str(tmp_path / "own"), "--no-browser")
    studio("--study", *files)
    studio("--study", *files)
    studio()
    first, second, none = (told[2] for told in serving)
    assert {*first.studies} == {page.study for page in pages}
    assert first.studies == second.studies and first.token not in first.studies.values()
    assert first.token != second.token and not none.studies


def test_the_command_refuses_other_files(serving: list, tmp_path: Path, shell: Shell) -> None:
    tiny.served_study(tmp_path)
    file = str(tmp_path / "study.html")
    studio = shell.of("studio", "--folder", str(tmp_path / "own"), "--study")
    assert "each study once" in studio(file, file, code=2).err
    assert "maximum is 16" in studio(*[file] * 17, code=2).err
    (tmp_path / "other.html").write_text("<script>evil()</script>")
    assert "study new" in studio(file, str(tmp_path / "other.html"), code=2).err
    assert "cannot be read" in studio(str(tmp_path / "none.html"), code=2).err
    assert not serving and not (tmp_path / "own").exists()
