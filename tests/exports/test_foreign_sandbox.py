"""Foreign scenes are parsed only in a child process with limits."""

import json
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
from generator.imports import reader
from generator.imports.reader import read_scene
from generator.sandbox import SandboxLimits

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
    monkeypatch.setattr(reader, "LIMITS", SandboxLimits(cpu_seconds=0.1))
    with pytest.raises(InputError, match=r"'scene\.xml' takes more than 0\.1 s of CPU time"):
        read_scene("mjcf", path)
    monkeypatch.setattr(reader, "LIMITS", SandboxLimits(memory=2**22))
    with pytest.raises(InputError, match=r"'scene\.xml' .*memory"):
        read_scene("mjcf", path)


_READ = """
import sys
from pathlib import Path
from generator.imports.reader import read_scene
print("begun", flush=True)
print(len(read_scene("mjcf", Path(sys.argv[1])).objects))
"""


def started(path: Path, folder: Path, before: str = "") -> subprocess.Popen[str]:
    """Return a process that reads a scene, with ``folder`` as working and temporary folder."""
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
    assert "InputError: The body 'cube' has a position that is not finite" in err
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


_COST = """
import json, resource, sys
from pathlib import Path
from generator.errors import TabletopError
from generator.imports.importer import find_source
from generator.imports.reader import read_scene

def used():
    both = [resource.getrusage(kind) for kind in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    status = Path("/proc/self/status").read_text()  # ru_maxrss has that of the process that forked
    own = int(status.partition("VmHWM:")[2].split()[0])
    return sum(r.ru_utime + r.ru_stime for r in both), (own + both[1].ru_maxrss) / 1024

for path in sys.argv[1:]:
    before = used()[0]
    try:
        read_scene(*find_source(Path(path)))
        end = "accepted"
    except TabletopError as error:
        end = type(error).__name__
    print(json.dumps([path, end, used()[0] - before, used()[1]]), flush=True)
"""


def hostile_scenes(folder: Path) -> list[Path]:
    """Small foreign scenes that require much work or memory."""
    ball = trimesh.creation.icosphere(6, 0.03)  # 81,920 triangles
    flat = '<texture name="t" type="2d" builtin="flat" width="26000" height="26000"/>'
    heads = {
        "sizes": '<size nuser_body="200000000" nuserdata="290000000"/>',
        "sensor": '<sensor><user name="u" dim="500000000"/></sensor>',
        "builtin": f"<asset>{flat}</asset>",
        "states": '<actuator><general body="cube" dyntype="user" actdim="2000000000"/></actuator>',
        "lengths": '<compiler><lengthrange mode="all" timestep="1e-9"/></compiler>'
        '<actuator><general body="cube"/></actuator>',
    }  # fmt: skip
    sphere = '<geom type="ellipsoid" size=".001 .002 .003"/>'
    copies = '<replicate count="200" offset="0 0 .001">'
    bodies = {
        "copies": TABLE + CUBE + copies * 3 + sphere + "</replicate>" * 3,
        "fewer": TABLE + CUBE + copies + '<replicate count="45">' + sphere + "</replicate>" * 2,
        "nan": TABLE + NAN,
    }
    paths = [write(folder / name, head=head) for name, head in heads.items()]
    paths += [write(folder / name, body) for name, body in bodies.items()]
    thing = '<body pos="1 2 .8"><freejoint/><geom type="mesh" mesh="m"/></body>'
    (folder / "many").mkdir()
    ball.export(folder / "many" / "ball.obj")
    head = '<asset><mesh name="m" file="ball.obj"/></asset>'
    paths.append(write(folder / "many", TABLE + 100 * thing, head))
    scene = trimesh.Scene()
    scene.add_geometry(ball, node_name="table", geom_name="ball")
    for k in range(99):
        scene.add_geometry(ball, node_name=f"n{k}", geom_name="ball")
    (folder / "many.glb").write_bytes(scene.export(file_type="glb"))
    return [*paths, folder / "many.glb"]


@pytest.mark.slow
@pytest.mark.timeout(900)
def test_hostile_scenes_take_little(tmp_path: Path) -> None:
    paths = hostile_scenes(tmp_path)
    done = subprocess.run(
        [sys.executable, "-c", _COST, *map(str, paths)], capture_output=True, text=True,
        timeout=800, check=False, cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    assert len(rows) == len(paths)
    for path, end, seconds, mib in rows:
        assert end in ("accepted", "InputError", "BackendError"), path
        assert seconds < 20 and mib < 2048, (path, end, seconds, mib)
    assert not (tmp_path / "MUJOCO_LOG.TXT").exists()
