"""Pages that are read back: only what `study new` writes is one, and only its answers fit it."""

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import tiny_studies as tiny
from command import Shell

from generator.errors import InputError
from tabletopgen_web.study import page_data
from tabletopgen_web.study.page_data import read_page


def refill(page: str, change: Callable[[dict[str, Any]], object]) -> str:
    """Fill the built page with a modified study, as an attacker could."""
    found = re.search(r'<script id="study" type="application/json">(.*?)</script>', page)
    assert found
    facts = json.loads(found[1])
    change(facts)
    return page_data.fill(tiny.TEMPLATE, facts)


def test_a_page_is_read_back_without_its_key(tmp_path: Path) -> None:
    files, page = tiny.served_study(tmp_path)
    assert (page.study, page.content) == (files.key.study, files.page.encode())
    assert {c: [*s.results] for c, s in page.key.scenes.items()} == {
        c: [*s.results] for c, s in files.key.scenes.items()
    }
    assert {*page.key.methods} == {"1", "2"}
    policy = dict(part.strip().split(" ", 1) for part in page.policy.split(";"))
    assert policy["frame-ancestors"] == policy["base-uri"] == policy["form-action"] == "'none'"
    assert (policy["connect-src"], policy["img-src"]) == ("'self'", "data:")
    for name in ("script-src", "style-src"):
        assert re.fullmatch(r"'sha256-[\w+/]{43}='", policy[name])


HOSTILE: dict[str, Callable[[str], str | bytes]] = {
    "another script": lambda page: page.replace("let a = 1;", "let a = 2;"),
    "one more script": lambda page: page.replace("</head>", "<script>evil()</script></head>"),
    "a handler": lambda page: page.replace("<body>", '<body onload="evil()">'),
    "markup after it": lambda page: page + "<p>",
    "another policy": lambda page: page.replace("default-src 'none'", "default-src *"),
    "spaces in the data": lambda page: page.replace('"schema":1', '"schema": 1'),
    "markup in the data": lambda page: page.replace('"title":""', '"title":"<b>"'),
    "the data twice": lambda page: page.replace("</body>", f"{page_data.MARK}</body>"),
    "no data": lambda page: tiny.TEMPLATE,
    "no text": lambda page: b"\xff" + page.encode(),
    "empty": lambda page: "",
}


@pytest.mark.parametrize("name", HOSTILE)
def test_what_is_not_the_built_page_is_refused(name: str, tmp_path: Path) -> None:
    files, _ = tiny.served_study(tmp_path)
    changed = HOSTILE[name](files.page)
    path = tmp_path / "changed.html"
    path.write_bytes(changed if isinstance(changed, bytes) else changed.encode())
    assert path.read_bytes() != files.page.encode()
    with pytest.raises(InputError, match=r"changed\.html.*(again|written)"):
        read_page(path, tiny.TEMPLATE, tiny.POST)


CHANGES: dict[str, Callable[[dict[str, Any]], object]] = {
    "schema": lambda f: f.update(schema=2),
    "an id that is a path": lambda f: f.update(study="../../etc"),
    "an id that is a number": lambda f: f.update(study=3),
    "more": lambda f: f.update(more=1),
    "a title of two lines": lambda f: f.update(title="a\nb"),
    "no title": lambda f: f.update(title=None),
    "too many scenes each": lambda f: f.update(scenesEach=7),
    "no scene each": lambda f: f.update(scenesEach=0, attention=0),
    "half a check": lambda f: f.update(attention=0.5),
    "scenes that are none": lambda f: f.update(scenes={"a": 1}),
    "no scenes": lambda f: f.update(scenes=[]),
    "a scene that is none": lambda f: f["scenes"].__setitem__(0, 3),
    "a scene twice": lambda f: f["scenes"].append(f["scenes"][0]),
    "one result": lambda f: f["scenes"][0]["results"].pop(),
    "a code that is none": lambda f: f["scenes"][0].update(id="<img>"),
    "a picture from elsewhere": lambda f: f["scenes"][0].update(input="http://evil.example/a"),
    "a picture that is a drawing": lambda f: f["scenes"][0].update(
        input="data:image/svg+xml;base64,AAAA"
    ),
    "posting elsewhere": lambda f: f.update(post="//evil.example/answers"),
    "posting nowhere": lambda f: f.update(post=None),
    "posting as another study": lambda f: f.update(post="/api/studies/0123456789ab/answers"),
    "posting numbers": lambda f: f.update(post=[1]),
}


@pytest.mark.parametrize("name", CHANGES)
def test_a_study_that_does_not_fit_is_refused(name: str, tmp_path: Path) -> None:
    files, _ = tiny.served_study(tmp_path)
    path = tmp_path / "changed.html"
    path.write_text(refill(files.page, lambda facts: None))
    assert read_page(path, tiny.TEMPLATE, tiny.POST).study == files.key.study
    path.write_text(refill(files.page, CHANGES[name]))
    with pytest.raises(InputError):
        read_page(path, tiny.TEMPLATE, tiny.POST)


def test_the_messages_say_what_to_do(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    tiny.served_study(tmp_path)
    path = tmp_path / "study.html"
    with pytest.raises(InputError, match=r"another version.*Create it again with the same options"):
        read_page(path, tiny.TEMPLATE.replace("a = 1", "a = 2"), tiny.POST)
    path.write_text(tiny.small_study(tmp_path / "other").page)
    with pytest.raises(InputError, match=r"--post '/api/studies/\{study\}/answers'"):
        read_page(path, tiny.TEMPLATE, tiny.POST)
    with pytest.raises(InputError, match="No such file"):
        read_page(tmp_path / "none.html", tiny.TEMPLATE, tiny.POST)
    with pytest.raises(InputError, match="not a regular file"):
        read_page(tmp_path, tiny.TEMPLATE, tiny.POST)
    monkeypatch.setattr(page_data, "_MAX_READ", 1000)
    with pytest.raises(InputError, match="limit"):
        read_page(path, tiny.TEMPLATE, tiny.POST)


def test_answers_are_checked_without_the_key(tmp_path: Path) -> None:
    files, page = tiny.served_study(tmp_path)
    for rater in range(3):
        page.check(tiny.answers_of(files.key, rater))
    for change in ({"rater": "ann"}, {"scenes": []}, {"more": "x" * 1000}, {"study": "0" * 12}):
        with pytest.raises(InputError, match="do not match the study"):
            page.check(tiny.answers_of(files.key, 0) | change)


def test_one_is_not_several(tmp_path: Path, shell: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    folders = tiny.write_pictures(tmp_path, scenes=tiny.SCENES[:1])
    monkeypatch.setattr(page_data, "read_template", lambda: tiny.TEMPLATE)
    named = [f"{name}={folder}" for name, folder in folders.items()]
    places = ("--inputs", str(tmp_path / "inputs"), "--out", str(tmp_path / "a.html"))
    shown = shell("study", "new", *named, *places)
    assert "1 scene of 2 methods; a rater sees 1" in shown.out
