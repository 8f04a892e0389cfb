"""Scene makers for tests, by name: ``making="makers:toy"``."""

import os
import subprocess
import time
from pathlib import Path

import numpy as np
from toy import toy_object, toy_scene

from generator.errors import SceneError
from generator.scene import Scene, ScenePlan


def toy(what: str | ScenePlan, seed: int) -> Scene:
    """Make one cube with position and name from the seed; "small" also requires a die."""
    x, y = np.random.default_rng(seed).uniform(-0.2, 0.2, 2)
    objects = [toy_object("cube_1", (0.045, 0.045, 0.045), (x, y))]
    if what == "small":
        objects.append(toy_object("die_1", (0.02, 0.02, 0.02), (0.4, 0.2)))
    return toy_scene(tuple(objects), name=f"toy_{seed}")


def unhurried(what: str | ScenePlan, seed: int) -> Scene:
    """Make a scene in a tenth of a second."""
    time.sleep(0.1)
    return toy(what, seed)


def slow(what: str | ScenePlan, seed: int) -> Scene:
    """Make a scene that takes longer than any test."""
    time.sleep(600)
    return toy(what, seed)


def nested(what: str | ScenePlan, seed: int) -> Scene:
    """Start a child process, write its id to the file ``what``, and take long."""
    inner = subprocess.Popen(["sleep", "600"])
    part = Path(f"{what}.part")
    part.write_text(str(inner.pid))
    part.rename(str(what))
    return slow(what, seed)


def failing(what: str | ScenePlan, seed: int) -> Scene:
    """Fail to settle."""
    raise SceneError("nothing stands")


def broken(what: str | ScenePlan, seed: int) -> Scene:
    """Raise an unexpected exception."""
    raise ZeroDivisionError("a bug")


def crashing(what: str | ScenePlan, seed: int) -> Scene:
    """End the process as a crash in a library would."""
    os.write(2, b"memory was lost\n")
    os._exit(7)


def second_try(what: str | ScenePlan, seed: int) -> Scene:
    """Succeed only with the seeds of a second attempt."""
    if seed < 2**30:
        raise SceneError("not at first")
    return toy(what, seed)


def categories(what: str | ScenePlan, seed: int) -> Scene:
    """Make a mug or a bowl, depending on the seed, so that no plan can predict it."""
    name = "mug_1" if seed % 2 else "bowl_1"
    return toy_scene((toy_object(name, (0.05, 0.05, 0.05), (0, 0)),), name=f"{name}_{seed}")
