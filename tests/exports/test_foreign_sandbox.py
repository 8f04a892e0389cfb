"""Foreign scenes are read in a child process with limits; this process parses nothing."""

import os
import subprocess
import sys
import time
from pathlib import Path

import mujoco
import pytest
import trimesh
from foreign_models import CUBE, TABLE, write

from generator.errors import InputError
from generator.imports import reading
from generator.imports.reading import read_scene
from generator.sandbox import Limits

NAN = CUBE.replace("1 2 .77", "nan 2 .77")


def refuse(*args: object, **kwargs: object) -> None:
    raise AssertionError("foreign data is parsed in this process")


@pytest.mark.slow
def test_only_the_child_parses_and_compiles(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mujoco, "MjModel", refuse)
    monkeypatch.setattr(trimesh, "load_scene", refuse)
    found = read_scene("mjcf", write(tmp_path))
    assert [body.name for body in found.objects] == ["cube"]
    assert not found.objects[0].surface.vertices.flags.writeable


@pytest.mark.slow
def test_what_the_reader_refuses_is_raised_here(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no free body"):
        read_scene("mjcf", write(tmp_path, TABLE))


@pytest.mark.slow
def test_a_reader_that_reaches_a_limit_is_one_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    points = " ".join(f"{k % 97 * 0.01} {k % 89 * 0.01} {k % 83 * 0.01}" for k in range(300_000))
    head = f'<asset><mesh name="m" vertex="{points}"/></asset>'
    path = write(tmp_path, TABLE + CUBE.replace('type="box"', 'type="mesh" mesh="m"'), head)
    monkeypatch.setattr(reading, "LIMITS", Limits(cpu_seconds=0.1))
    with pytest.raises(InputError, match=r"'scene\.xml' takes more than 0\.1 s of CPU time"):
        read_scene("mjcf", path)
    monkeypatch.setattr(reading, "LIMITS", Limits(memory=2**22))
    with pytest.raises(InputError, match=r"'scene\.xml' .*memory"):
        read_scene("mjcf", path)


_READ = """
import sys
from pathlib import Path
from generator.imports.reading import read_scene
print("begun", flush=True)
print(len(read_scene("mjcf", Path(sys.argv[1])).objects))
"""


def started(path: Path, folder: Path, before: str = "") -> subprocess.Popen[str]:
    """Return a process that reads a scene, its working and temporary folder being ``folder``."""
    folder.mkdir()
    command = f'{before} exec "$0" "$@"'
    return subprocess.Popen(
        ["/bin/sh", "-c", command, sys.executable, "-c", _READ, str(path)],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=folder,
        env={**os.environ, "TMPDIR": str(folder), "PYTHONPATH": os.pathsep.join(sys.path)},
    )  # fmt: skip


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="other systems do not limit address space")
def test_a_sound_scene_is_read_under_a_smaller_inherited_limit(tmp_path: Path) -> None:
    process = started(write(tmp_path / "in"), tmp_path / "out", "ulimit -v 5500000;")
    out, err = process.communicate(timeout=240)
    assert out.split() == ["begun", "1"], err


@pytest.mark.slow
def test_a_scene_that_is_refused_leaves_nothing_behind(tmp_path: Path) -> None:
    process = started(write(tmp_path / "in", TABLE + NAN), tmp_path / "out")
    _, err = process.communicate(timeout=240)
    assert "InputError" in err
    assert [*(tmp_path / "out").iterdir()] == []


@pytest.mark.slow
def test_a_killed_import_leaves_nothing_behind(tmp_path: Path) -> None:
    process = started(write(tmp_path / "in"), tmp_path / "out")
    assert process.stdout is not None
    assert process.stdout.readline() == "begun\n"
    time.sleep(0.5)  # of the seconds that reading takes
    process.kill()
    process.communicate(timeout=60)
    assert [*(tmp_path / "out").iterdir()] == []
