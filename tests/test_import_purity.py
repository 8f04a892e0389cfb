"""Importing the packages is cheap and silent: no torch, no MuJoCo, no socket."""

import subprocess
import sys
import textwrap

import pytest

PROBE = """
import socket, sys

def refuse(*args, **kwargs):
    raise RuntimeError("a socket was opened on import")

socket.socket.connect = refuse
socket.create_connection = refuse
socket.getaddrinfo = refuse
{statement}
heavy = ("torch", "stable_baselines3", "mujoco", "cv2", "coacd", "httpx2", "openai", "transformers",
         "warp")
print(" ".join(m for m in heavy if m in sys.modules))
"""


def loaded_by(statement: str) -> list[str]:
    code = textwrap.dedent(PROBE).format(statement=statement)
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=300
    )
    return done.stdout.split()


@pytest.mark.parametrize(
    "package", ["tabletop_objects", "generator", "tabletopgen_env", "assets_cache"]
)
def test_import_is_light(package: str) -> None:
    assert "torch" not in loaded_by(f"import {package}")


@pytest.mark.slow
@pytest.mark.parametrize("module", ["generator.composition", "generator.evaluation.report"])
def test_composing_and_evaluating_geometry_need_no_torch(module: str) -> None:
    assert "torch" not in loaded_by(f"import {module}")


def test_the_facade_loads_what_is_asked_for_and_no_more() -> None:
    assert loaded_by("from generator import Backends") == []
    assert loaded_by("from generator import load, save") == []
    import generator

    assert all(callable(getattr(generator, name)) for name in generator.__all__)
    assert {*generator.__all__} <= {*dir(generator)}
    with pytest.raises(AttributeError, match="'generator' has no attribute 'regenerate'"):
        generator.regenerate  # noqa: B018


def test_stepping_a_shipped_bundle_loads_no_learning_and_no_vision() -> None:
    loaded = loaded_by(
        "import gymnasium, tabletopgen_env\n"
        "env = gymnasium.make('TabletopGen/Lift-v0')\n"
        "env.reset(seed=0)\n"
        "env.step(env.action_space.sample())"
    )
    assert {*loaded} & {"torch", "cv2", "coacd", "stable_baselines3"} == set()


@pytest.mark.slow
def test_batches_load_no_warp_until_one_is_made() -> None:
    assert "warp" not in loaded_by("import tabletopgen_env.parallel.batch.batch_world")


def test_registration_needs_no_simulator() -> None:
    registered = "import gymnasium, tabletopgen_env; gymnasium.spec('TabletopGen/PickPlace-v0')"
    assert not {"torch", "mujoco"} & set(loaded_by(registered))


@pytest.mark.slow
def test_a_session_loads_no_client_until_one_is_asked_for() -> None:
    asked = "from generator.calls import Session; session = Session()"
    assert loaded_by(asked) == []
    assert "httpx2" in loaded_by(f"{asked}; session.client('here', 'http://127.0.0.1:9')")


@pytest.mark.slow
def test_choosing_open_models_loads_none_until_one_is_asked() -> None:
    chosen = "from generator.backends import Backends; Backends.select("
    loaded = loaded_by(f"{chosen}segmenter='huggingface', encoder='huggingface')")
    assert "transformers" not in loaded
    assert "transformers" in loaded_by("import transformers")


@pytest.mark.slow
def test_the_probe_can_fail() -> None:
    assert "torch" in loaded_by("import torch")
    with pytest.raises(subprocess.CalledProcessError):
        loaded_by("socket.create_connection(('127.0.0.1', 9))")
