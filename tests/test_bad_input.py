"""Bad input, once through the front door: one error of ours, and no half-written bundle."""

import errno
import os
import select
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import cv2
import numpy as np
import pytest
from command import Shell
from forging import derive, rewrite
from toy import toy_object, toy_scene

import assets_cache
from generator import bundle
from generator.composition import compose
from generator.errors import (
    EXIT_CODES,
    BundleError,
    InputError,
    SceneError,
    StorageError,
    TabletopError,
)
from generator.generation import STAGES
from generator.method.reference import read_image
from generator.physics.gate import judge
from generator.physics.parts import scale_part
from generator.pipeline import generate
from generator.scene import ConvexPart, PlannedObject, PlannedTable, Relation, Scene, ScenePlan
from tabletopgen_env.env import make_env

pytestmark = pytest.mark.usefixtures("store")

TEXT = "a desk with a mug and a book"
BROWN = (150, 100, 60)


def left_over(store: Path) -> list[str]:
    return [p.name for p in store.rglob("*")] if store.exists() else []


def plain(color: Any = 255, height: int = 240, width: int = 360) -> np.ndarray:
    return np.full((height, width, 3), color, np.uint8)


def sound(name: str = "toy") -> Scene:
    scene = toy_scene((toy_object("cube_1", (0.05, 0.05, 0.05), (0.0, 0.0)),), name=name)
    return scene.replace(report=judge(scene))


# ---------------------------------------------------------------------------------------- pictures
def gradient() -> np.ndarray:
    y, x = np.mgrid[0:240, 0:360]
    return np.dstack([x * 255 // 360, y * 255 // 240, (x + y) * 255 // 600]).astype(np.uint8)


def bare_table() -> np.ndarray:
    corners = np.array([[90, 70], [270, 70], [325, 205], [35, 205]])
    return cv2.fillConvexPoly(plain(), corners, BROWN)


def things_alone() -> np.ndarray:
    image = cv2.circle(plain(), (90, 120), 25, (200, 30, 30), -1)
    return cv2.rectangle(image, (180, 90), (230, 155), (30, 60, 200), -1)


def screenshot() -> np.ndarray:
    image = plain(245, 360, 640)
    cv2.rectangle(image, (30, 45), (400, 330), (255, 255, 255), -1)
    cv2.rectangle(image, (30, 45), (400, 60), (40, 90, 160), -1)
    cv2.rectangle(image, (420, 45), (620, 200), (30, 30, 30), -1)
    for row in range(80, 320, 13):
        cv2.putText(image, "lorem ipsum dolor sit amet", (40, row), 0, 0.3, (30, 30, 30), 1)
    return image


def face() -> np.ndarray:
    image = plain((120, 140, 160), 320, 320)
    cv2.ellipse(image, (160, 260), (130, 100), 0, 0, 360, (60, 70, 120), -1)
    cv2.ellipse(image, (160, 140), (75, 95), 0, 0, 360, (224, 180, 150), -1)
    cv2.ellipse(image, (160, 80), (82, 55), 0, 180, 360, (70, 45, 30), -1)
    for x in (130, 190):
        cv2.ellipse(image, (x, 130), (14, 7), 0, 0, 360, (255, 255, 255), -1)
        cv2.circle(image, (x, 130), 6, (60, 40, 30), -1)
    cv2.ellipse(image, (160, 185), (25, 9), 0, 0, 180, (170, 60, 70), -1)
    return image


@pytest.mark.slow
@pytest.mark.parametrize(
    ("image", "says"),
    [
        (plain(255), "No table"),
        (plain(0), "No table"),
        (plain(BROWN), "No table"),
        (np.random.default_rng(0).integers(0, 255, (240, 360, 3), np.uint8), "No table"),
        (gradient(), "No table"),
        (plain(255, 64, 64), "No table"),
        (plain(255, 64, 2000), "8 times"),
        (bare_table(), "Nothing found on the table"),
        (things_alone(), "No table|Nothing found"),
        (screenshot(), "No table"),
        (face(), "No table"),
    ],
    ids=[
        "white", "black", "brown", "noise", "gradient", "tiny", "wide", "bare", "no table",
        "screenshot", "face",
    ],
)  # fmt: skip
def test_pictures_without_a_laid_table_are_refused(image: np.ndarray, says: str) -> None:
    with pytest.raises((InputError, SceneError), match=says):
        generate(image)


@pytest.mark.parametrize("source", [None, 5, 1.5, ["a desk"], object()])
def test_what_is_neither_text_nor_picture_is_refused(source: Any) -> None:
    with pytest.raises(InputError, match=r"Expected a prompt.*, got"):
        generate(source)
    with pytest.raises(InputError, match=r"Expected a prompt.*, got"):
        compose(source)


def test_no_other_program_is_started_to_read_a_picture() -> None:
    postscript = b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 100 100\n%%EndComments\nshowpage\n"
    with pytest.raises(InputError, match="format is not supported"):
        read_image(postscript)


# ------------------------------------------------------------------------------------------- plans
MUG = PlannedObject("mug_1", "mug", "mug")
IMPOSSIBLE: dict[str, Callable[[], Any]] = {
    "twice the same": lambda: ScenePlan("p", PlannedTable(), (MUG, MUG)),
    "called table": lambda: ScenePlan("p", PlannedTable(), (replace(MUG, name="table"),)),
    "on nothing": lambda: ScenePlan(
        "p", PlannedTable(), (replace(MUG, relations=(Relation("on", "tray_1"),)),)
    ),
    "on itself": lambda: ScenePlan(
        "p", PlannedTable(), (replace(MUG, relations=(Relation("on", "mug_1"),)),)
    ),
    "on each other": lambda: ScenePlan(
        "p",
        PlannedTable(),
        (
            PlannedObject("a", "book", "book", {}, (Relation("on", "b"),)),
            PlannedObject("b", "book", "book", {}, (Relation("in", "a"),)),
        ),
    ),
    "unknown relation": lambda: replace(MUG, relations=(Relation("above"),)),  # type: ignore[arg-type]
    "no size": lambda: replace(MUG, size=(0.0, 0.1, 0.1)),
    "NaN size": lambda: PlannedTable(size=(float("nan"), 1.0, 0.7)),
    "unknown outline": lambda: PlannedTable(outline="star"),  # type: ignore[arg-type]
}


@pytest.mark.parametrize("plan", IMPOSSIBLE.values(), ids=IMPOSSIBLE.keys())
def test_impossible_plans_are_refused_as_they_are_made(plan: Callable[[], Any]) -> None:
    with pytest.raises(InputError):
        plan()


def test_an_empty_plan_is_refused() -> None:
    for make in (compose, generate):
        with pytest.raises(InputError, match="contains no objects"):
            make(ScenePlan("p", PlannedTable(), ()))


@pytest.mark.parametrize("make", [compose, generate])
@pytest.mark.parametrize(
    "text", ["", "x" * 10_000, "机の上のマグカップ", "200 mugs", "a mug on a book on the mug"]
)
def test_unusable_texts_are_refused_on_both_routes(make: Callable[..., Any], text: str) -> None:
    with pytest.raises(InputError):
        make(text)


# ----------------------------------------------------------------------------------------- bundles
ENTRY = {"bytes": 3, "sha256": "0" * 64}


@pytest.mark.parametrize("name", ["a\0b", "a\nb", "", "a" * 5000])
def test_file_names_that_no_disk_takes(store: Path, name: str) -> None:
    path = bundle.save(sound(), store)
    forged = rewrite(path, lambda p: p["files"].update({name: ENTRY}))
    with pytest.raises(BundleError, match="forged"):
        bundle.load(forged)
    assert bundle.verify(forged)


def test_half_a_surrogate_pair_is_no_text(store: Path) -> None:
    path = bundle.save(sound(), store).rename(store / "forged")
    text = (path / "scene.json").read_text()
    (path / "scene.json").write_text(text.replace('"cube_1"', '"\\ud800"', 1))
    with pytest.raises(BundleError, match="not valid JSON"):
        bundle.load(path)


@pytest.mark.parametrize("wanted", ["x" * 5000, "a/" * 3000, "a\0b", "/"])
def test_paths_that_cannot_be(wanted: str) -> None:
    with pytest.raises(BundleError):
        bundle.load(wanted)
    assert bundle.verify(wanted)


def flatten(payload: dict[str, Any]) -> None:
    flat = [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0.1, 0.1, 0]]
    payload["objects"][0]["parts"] = [{"kind": "hull", "axis": 2, "vertices": flat}]


@pytest.mark.slow
@pytest.mark.parametrize(
    "change",
    [
        flatten,
        lambda p: p["objects"][0].update(inertia=[[0] * 3] * 3),
        lambda p: p["objects"][0].update(inertia=[[1, 0, 0], [0, 1, 0], [0, 0, 50]]),
    ],
)
def test_bodies_that_no_simulator_takes(
    store: Path, change: Callable[[dict[str, Any]], None], shell: Shell
) -> None:
    forged = rewrite(bundle.save(sound(), store), change)
    derive(forged)
    with pytest.raises(BundleError, match="MuJoCo cannot build"):
        make_env(forged).reset(seed=0)
    assert "MuJoCo cannot build" in shell("verify", str(forged), code=1).out


@pytest.mark.parametrize(
    "change",
    [
        lambda p: p["objects"][0].update(parts=[]),
        lambda p: p["objects"][0].update(friction=-1),
        lambda p: p["table"].update(parts=[]),
        lambda p: p["table"].update(outline=[[0, 0]]),
        lambda p: p["table"].update(scale=[0, 1, 1]),
    ],
)
def test_bodies_without_a_shape(store: Path, change: Callable[[dict[str, Any]], None]) -> None:
    forged = rewrite(bundle.save(sound(), store), change)
    with pytest.raises(BundleError, match="forged"):
        bundle.load(forged)


def test_a_flat_part_becomes_solid_however_it_lies() -> None:
    from scipy.spatial import ConvexHull

    sheet = np.array([[-0.5, -0.5, -0.5], [0.5, -0.5, 0.5], [-0.5, 0.5, -0.5], [0.5, 0.5, 0.5]])
    for scale in ([0.3, 0.3, 0.3], [3e-4, 2e-3, 3e-4], [0.1, 1e-5, 0.1]):
        part = scale_part(ConvexPart(sheet), np.array(scale))
        assert ConvexHull(part.vertices).volume > 1e-12


# ------------------------------------------------------------------------------ disk and interrupt
def stop() -> None:
    raise KeyboardInterrupt


def full() -> None:
    raise OSError(errno.ENOSPC, "No space left on device")


@pytest.mark.parametrize(("trouble", "code"), [(stop, 130), (full, 5)])
@pytest.mark.parametrize("after", [0, 1, 3])
def test_trouble_while_writing_leaves_nothing(
    trouble: Callable[[], None], code: int, after: int, store: Path,
    monkeypatch: pytest.MonkeyPatch, shell: Shell,
) -> None:  # fmt: skip
    """The failure occurs with half of a file on the disk."""
    written: list[Path] = []

    def write(self: Path, content: bytes) -> int:
        with self.open("wb") as out:
            if len(written) == after:
                out.write(content[: len(content) // 2])
                out.flush()
                trouble()
            written.append(self)
            return out.write(content)

    monkeypatch.setattr("generator.composition.compose", lambda *args, **kwargs: sound())
    monkeypatch.setattr("generator.method.figures.preview", lambda scene: plain(200, 8, 8))
    monkeypatch.setattr(Path, "write_bytes", write)
    assert len(shell("compose", TEXT, code=code).err.strip().splitlines()) == 1
    assert len(written) == after
    assert left_over(store) == []


def test_trouble_at_the_last_rename_leaves_nothing(
    store: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for trouble, kind in ((stop, KeyboardInterrupt), (full, StorageError)):
        monkeypatch.setattr(Path, "replace", lambda *args, now=trouble: now())
        with pytest.raises(kind):
            bundle.save(sound(), store)
        assert left_over(store) == []


STAGE_FUNCTIONS = ("refer", "extract", "estimate_view", "make_models", "estimate_rotations",
                   "align", "refine_scene", "publish")  # fmt: skip


@pytest.mark.parametrize("at", range(len(STAGES)), ids=STAGES)
def test_an_interrupt_in_any_stage_of_generate_leaves_nothing(
    at: int, store: Path, monkeypatch: pytest.MonkeyPatch, shell: Shell
) -> None:
    """Earlier stages are stubs; the given one is interrupted."""
    reference = SimpleNamespace(
        prompt=TEXT, plan=None, depth=None, image=np.zeros((4, 4, 3), np.uint8)
    )
    answers: list[Any] = [
        reference,
        (reference, (SimpleNamespace(name="table"),)),
        None,
        {"table": None},
        {},
        SimpleNamespace(placements=(), table_scale=np.ones(3), warnings=()),
        SimpleNamespace(placements=(), before=0.0, after=0.0),
    ]
    ran: list[str] = []

    def stub(number: int) -> Callable[..., Any]:
        def stage(*args: Any, **kwargs: Any) -> Any:
            ran.append(STAGE_FUNCTIONS[number])
            return stop() if number == at else answers[number]

        return stage

    for number, name in enumerate(STAGE_FUNCTIONS):
        place = "generator.backends.embedded.reasoner.EmbeddedReasoner" if number == 2 else (
            "generator.pipeline")  # fmt: skip
        monkeypatch.setattr(f"{place}.{name}", stub(number))
    monkeypatch.setattr(
        "generator.backends.embedded.reasoner.EmbeddedReasoner.estimate_sizes", lambda *args: {}
    )
    *progress, last = shell("generate", TEXT, code=130).err.strip().splitlines()
    assert ran == list(STAGE_FUNCTIONS[: at + 1])
    assert last == "interrupted; nothing was published"
    assert len(progress) == at + 1
    assert left_over(store) == []


@pytest.mark.parametrize("name", ["plan_scene", "build_models", "lay_out", "bring_to_rest"])
def test_an_interrupt_in_any_step_of_compose_leaves_nothing(
    name: str, store: Path, monkeypatch: pytest.MonkeyPatch, shell: Shell
) -> None:
    model = SimpleNamespace(size=np.ones(3))
    layout = SimpleNamespace(placements=(), warnings=())
    monkeypatch.setattr("generator.composition.build_models", lambda *args: {})
    monkeypatch.setattr("generator.composition.lay_out", lambda *args: (layout, model))
    monkeypatch.setattr(f"generator.composition.{name}", lambda *args, **kwargs: stop())
    assert "nothing was published" in shell("compose", TEXT, code=130).err
    assert left_over(store) == []


def lines_of(process: subprocess.Popen[bytes], until: float) -> Iterator[str]:
    """Yield the standard error lines of a process as they arrive."""
    assert process.stderr is not None
    while time.monotonic() < until:
        if select.select([process.stderr], [], [], 0.5)[0]:
            line = process.stderr.readline()
            if not line:
                return
            yield line.decode().strip()


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="POSIX signals")
@pytest.mark.parametrize("stage", ["[1/8]", "[2/8]"])
def test_a_real_interrupt_of_the_command(stage: str, store: Path) -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", "generator", "generate", TEXT], stderr=subprocess.PIPE
    )
    try:
        said: list[str] = []
        for line in lines_of(process, time.monotonic() + 60):
            said.append(line)
            if line.startswith(stage):
                process.send_signal(signal.SIGINT)
        # An interrupt inside exec() (dataclasses being made on import) makes CPython 3.11 die of
        # the signal after our handler has run; a shell calls both endings 130.
        assert process.wait(30) in (130, -signal.SIGINT)
    finally:
        process.kill()
    assert said[-1] == "interrupted; nothing was published"
    assert all(line.startswith("[") for line in said[:-1])
    assert left_over(store) == []


LOST = """
import signal, sys, time
from generator import cli

class Falling:
    def __del__(self):
        signal.raise_signal(signal.SIGINT)

def run(arguments):
    try:
        Falling()  # Python prints this interrupt as ignored, and goes on
        time.sleep(60)
    except KeyboardInterrupt:
        return 130
    return 0

cli.run = run
cli.main()
"""
TWICE = """
import atexit, signal
from generator import cli

atexit.register(signal.raise_signal, signal.SIGINT)
cli.run = lambda arguments: 130
cli.main()
"""


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="POSIX signals")
@pytest.mark.parametrize("code", [LOST, TWICE], ids=["that Python would lose", "a second one"])
def test_an_interrupt_is_heeded_and_does_not_disturb_the_end(code: str) -> None:
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, timeout=50)
    assert (ended.returncode, ended.stderr) == (130, b"")


# ------------------------------------------------------------------------------------- environment
@pytest.mark.parametrize("action", [np.zeros(4), np.full(5, np.nan), "up", None])
def test_bad_actions_are_refused_and_the_episode_goes_on(action: Any) -> None:
    env = make_env(sound())
    env.reset(seed=0)
    with pytest.raises(InputError):
        env.step(action)
    assert np.isfinite(env.step(np.zeros(5))[1])


def test_a_published_scene_with_nothing_graspable_says_why(store: Path) -> None:
    block = toy_object("block_1", (0.2, 0.2, 0.2), (0.0, 0.0))
    path = assets_cache.add(toy_scene((block,)), allow_failed=True)
    with pytest.raises(SceneError, match="but the gripper spans only"):
        make_env(path).reset(seed=0)


def test_every_error_of_ours_has_an_exit_code() -> None:
    kinds = {kind for kind, _ in EXIT_CODES}
    assert kinds == set(TabletopError.__subclasses__())
    assert len({code for _, code in EXIT_CODES}) == len(kinds)
