"""The wheel, built from a copy of the checkout, installed separately and tested.

    python tests/installing/built_wheel.py dist

Needs no network: setuptools and the dependencies of the package are already installed.
"""

import os
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from tabletopgen_web.frontend import static_folder

ROOT = Path(__file__).parents[2]
PACKAGES = ("tabletop_objects", "generator", "tabletopgen_env", "tabletopgen_web", "assets_cache")
BESIDE = ("pyproject.toml", "README.md", "LICENSE", "NOTICE")
LONG = 240.0
"""Seconds after which a step is taken to hang."""

TRIAL = """
import pathlib, sys, tempfile

ABSENT = ("stable_baselines3", "tensorboard", "minari", "h5py", "openai", "transformers",
          "huggingface_hub", "hypothesis", "pytest", "research.eye")
sys.modules.update(dict.fromkeys(ABSENT))  # importing any of them fails, as without the extras

import gymnasium as gym
import assets_cache, generator, tabletopgen_env, tabletopgen_web
from generator.bundle import load, save, verify
from generator.composition import compose
from tabletopgen_web.frontend import static_folder
from tabletopgen_web.page.site import write_site

for package in (assets_cache, generator, tabletopgen_env, tabletopgen_web):
    assert pathlib.Path(package.__file__).is_relative_to(sys.argv[1]), package.__file__
assert len(assets_cache.find("starter")) >= 12
assert not any(assets_cache.verify().values()), assets_cache.verify()
scene = compose("a desk with a mug", seed=0)
assert scene.report.passed
with tempfile.TemporaryDirectory() as folder:
    bundle = save(scene, pathlib.Path(folder))
    assert verify(bundle) == [] and len(load(bundle).objects) == len(scene.objects)
    for scenes in ("office-desk", str(bundle)):
        env = gym.make("tabletopgen_env:TabletopGen/Reach-v0", scenes=scenes)
        env.action_space.seed(0)
        seen, _ = env.reset(seed=0)
        assert env.observation_space.contains(seen)
        seen, reward, *_ = env.step(env.action_space.sample())
        assert env.observation_space.contains(seen) and 0 <= reward <= 1
        env.close()
held = [path for path in static_folder().rglob("*") if path.is_file()]
assert static_folder().is_relative_to(sys.argv[1])
assert sum(path.stat().st_size for path in held) <= 15_000_000
assert "@mujoco/mujoco" in (static_folder() / "licenses.md").read_text()
with tempfile.TemporaryDirectory() as folder:
    site = write_site(assets_cache.find("office-desk"), pathlib.Path(folder) / "site")
    assert (site.path / "index.html").is_file() and site.scenes[0].error is None
print("tried", sys.argv[1])
"""
"""What is done where the wheel is installed, given that folder."""


def build(out: Path) -> Path:
    """Build the wheel into a folder from a copy, without files of earlier builds."""
    static_folder()  # a checkout builds it here with npm
    source = out / "source"
    unused = shutil.ignore_patterns("__pycache__")
    for name in PACKAGES:
        shutil.copytree(ROOT / name, source / name, ignore=unused)
    for name in BESIDE:
        shutil.copy(ROOT / name, source)
    _run("-m", "pip", "wheel", "--no-deps", "--no-build-isolation", "-w", out, source)
    shutil.rmtree(source)
    (wheel,) = out.glob("*.whl")
    return wheel


def left_out(wheel: Path) -> set[str]:
    """Return the packages' files that are missing from the wheel."""
    files = (path for name in PACKAGES for path in (ROOT / name).rglob("*") if path.is_file())
    wanted = {p.relative_to(ROOT).as_posix() for p in files if "__pycache__" not in p.parts}
    with zipfile.ZipFile(wheel) as held:
        return wanted - set(held.namelist())


def install(wheel: Path, folder: Path) -> None:
    _run("-m", "pip", "install", "--no-deps", "--no-index", "--target", folder, wheel)


def attempt(folder: Path) -> None:
    """Test an installation in a folder: the packages, the command, the module."""
    _run("-P", "-c", TRIAL, folder, cwd=folder, path=folder)
    for words in ([folder / "bin" / "tabletopgen"], ["-m", "tabletopgen_env"]):
        shown = _run("-P", *words, "--help", cwd=folder, path=folder)
        assert all(name in shown for name in ("usage", "generate", "doctor", "train", "certify"))


def _run(*words: object, cwd: Path | None = None, path: Path | None = None) -> str:
    """Run Python; return its output.

    Raises:
        AssertionError: it fails.
    """
    command: Sequence[str] = [sys.executable, *map(str, words)]
    quiet = {"PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_QUIET": "1"}
    more: Mapping[str, str] = {"PYTHONPATH": str(path)} if path else {}
    done = subprocess.run(
        command, cwd=cwd, env={**os.environ, **quiet, **more}, stdin=subprocess.DEVNULL,
        capture_output=True, text=True, timeout=LONG,
    )  # fmt: skip
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return done.stdout


def main(out: Path) -> None:
    """Build the wheel, test it, and leave it in a folder."""
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    wheel = build(out)
    assert not left_out(wheel), left_out(wheel)
    install(wheel, out / "installed")
    attempt(out / "installed")
    print(wheel)


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
