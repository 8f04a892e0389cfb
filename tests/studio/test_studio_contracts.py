"""The page's types say what the server answers, and the reference lists every endpoint."""

import dataclasses
import re
from pathlib import Path
from typing import get_args

from generator.exports import WRITERS
from generator.scene import EditKind
from tabletopgen_web.page.rows import SceneRow
from tabletopgen_web.studio import contracts
from tabletopgen_web.studio.server.application import ROUTES
from tabletopgen_web.studio.specs import FORMATS

ROOT = Path(__file__).parents[2]
SCRIPT = (ROOT / "web" / "src" / "studio" / "api.ts").read_text(encoding="utf-8")
PAGE = (ROOT / "docs" / "reference" / "studio-api.md").read_text(encoding="utf-8")


def test_rows_have_the_fields_of_the_values() -> None:
    found = {
        name: set(re.findall(r"^  (\w+)\??:", body, re.MULTILINE))
        for name, body in re.findall(r"export interface (\w+)[^{]*\{\n(.*?)^\}", SCRIPT,
                                     re.DOTALL | re.MULTILINE)
    }  # fmt: skip
    rows = [
        v for v in vars(contracts).values() if dataclasses.is_dataclass(v) and v is not SceneRow
    ]
    assert len(rows) > 12
    for row in rows:
        if row is not contracts.JobEvent:
            names = {"in" if f.name == "place" else f.name for f in dataclasses.fields(row)}
            if row is contracts.StudioScene:  # the rest is the gallery's, in data.ts
                names -= {f.name for f in dataclasses.fields(SceneRow)}
            assert found[row.__name__] == names, row.__name__


def test_names_are_the_same_on_both_sides() -> None:
    for name, values in (
        ("JobKind", get_args(contracts.JobKind)),
        ("JobState", get_args(contracts.JobState)),
        ("ScenePlace", get_args(contracts.ScenePlace)),
        ("Format", FORMATS),
    ):
        said = re.search(rf"export type {name} =([^;]*);", SCRIPT)
        assert said is not None and tuple(re.findall(r'"([^"]+)"', said[1])) == values
    assert all(f'"{kind}"' in SCRIPT for kind in get_args(EditKind))
    assert {*FORMATS} == {*WRITERS}


def test_the_reference_lists_every_endpoint() -> None:
    for route in ROUTES:
        for method in (route.methods or set()) - {"HEAD"}:
            assert f"| `{method} {route.path}` |" in PAGE, (method, route.path)


def test_encoding_keeps_the_events_own_fields() -> None:
    event = contracts.JobEvent(3, "a", "log", 1.0, {"text": "x", "seq": 99, "job": "b"})
    told = contracts.encode(event)
    assert told == {"text": "x", "seq": 3, "job": "a", "type": "log", "time": 1.0}
