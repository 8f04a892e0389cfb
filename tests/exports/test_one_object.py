"""A single object in each format, read by other programs."""

from pathlib import Path

import pytest
from imported import READERS

from generator.errors import InputError, StorageError
from generator.exports import WRITERS, export_object
from generator.objects.checks import stand_on_floor
from tabletop_objects import build


@pytest.mark.slow
@pytest.mark.parametrize("to", WRITERS)
@pytest.mark.parametrize("key", ["bowl", "orange", "book"])
def test_every_format_holds_the_object(key: str, to: str, tmp_path: Path) -> None:
    if to.startswith("usd"):
        pytest.importorskip("pxr")
    thing = stand_on_floor(build(key, 1))
    found = READERS[to](export_object(thing, to, tmp_path))
    assert {*found} == {key}
    body = found[key]
    assert body.mass == pytest.approx(thing.mass, rel=1e-4)
    assert body.position == pytest.approx(thing.pose.position, abs=1e-6)
    assert body.com == pytest.approx(thing.com, abs=1e-6)
    assert len(body.parts) == len(thing.parts)
    assert to == "urdf" or body.friction == pytest.approx(thing.friction, rel=1e-4)


def test_unknown_formats_and_folders_are_refused(tmp_path: Path) -> None:
    thing = stand_on_floor(build("die", 0))
    with pytest.raises(InputError, match="No export to 'obj'"):
        export_object(thing, "obj", tmp_path)
    (tmp_path / "file").write_text("")
    with pytest.raises(StorageError, match="file"):
        export_object(thing, "glb", tmp_path / "file" / "below")
