"""Bad arguments are refused before anything heavy is loaded, and before any stage."""

import subprocess
import sys
from pathlib import Path

import pytest

from generator import generate
from generator.errors import InputError

ROOT = Path(__file__).parents[1]
_RUN = """
import resource, sys
from generator import cli
code = cli.run(sys.argv[1:])
heavy = {"scipy", "mujoco", "torch", "trimesh", "generator.pipeline"} & set(sys.modules)
print(code, sum(resource.getrusage(resource.RUSAGE_SELF)[:2]), *heavy)
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "code", "said"),
    [
        (["generate", "nofile.jpg"], 2, "No picture at 'nofile.jpg'"),
        (["generate", "photo.jpg", "--depth", "nodepth.png"], 2, "No depth map at 'nodepth.png'"),
        (["generate", "a mug", "--name", "a/b"], 6, "not a valid folder name"),
        (["compose", "a mug", "--name", "a/b"], 6, "not a valid folder name"),
        (["import", "nofile.xml"], 2, "No file or folder at 'nofile.xml'"),
        (["batch", "nofile.txt", "--out", "scenes"], 2, "'nofile.txt' cannot be read"),
    ],
)
def test_bad_arguments_are_refused_before_anything_heavy_is_loaded(
    words: list[str], code: int, said: str, tmp_path: Path
) -> None:
    (tmp_path / "photo.jpg").write_bytes(b"\xff\xd8")
    done = subprocess.run(
        [sys.executable, "-c", _RUN, *words], capture_output=True, text=True, cwd=tmp_path,
        timeout=300, check=True,
    )  # fmt: skip
    ended, seconds, *heavy = done.stdout.split()
    (line,) = done.stderr.splitlines()  # no progress
    assert int(ended) == code and line.startswith("error: ") and said in line
    assert not heavy and float(seconds) < 1.5  # CPU seconds, 0.3 on an idle machine
    assert [p.name for p in tmp_path.iterdir()] == ["photo.jpg"]


def test_a_missing_picture_fails_before_the_first_stage() -> None:
    stages: list[str] = []
    with pytest.raises(InputError, match=r"No picture at 'nofile\.jpg'"):
        generate("nofile.jpg", progress=lambda stage, number, total: stages.append(stage))
    assert stages == []
