"""The command line as a user types it: results, exit codes, one-line errors."""

import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from command import Shell, command
from PIL import Image
from toy import toy_scene

from generator import bundle
from generator.errors import SceneError
from generator.method.stopwatch import Seconds
from generator.physics.gate import judge
from generator.render.sheet import render_scene

pytestmark = pytest.mark.usefixtures("store")

TEXT = "a desk with a mug and a book"


@pytest.mark.slow
def test_compose_inspect_verify_view_and_remove(store: Path, tmp_path: Path, shell: Shell) -> None:
    made = shell("compose", TEXT, "--name", "reading", "--json").facts
    bundle = Path(made["bundle"])
    assert bundle.parent == store
    assert made["passed"]
    assert sorted(o["label"] for o in made["objects"]) == ["book", "mug"]

    assert shell("inspect", "reading", "--json").facts["objects"] == made["objects"]

    assert "valid" in shell("verify", "reading").out

    picture = tmp_path / "view.png"
    assert command("view", "reading", "--picture", str(picture)) == 0
    assert Image.open(picture).size == (960, 720)

    assert str(bundle) in shell("cache", "list", "--json").out
    assert command("cache", "rm", "reading") == 0
    assert not bundle.exists()


@pytest.mark.slow
def test_a_damaged_bundle_fails_verification(store: Path, shell: Shell) -> None:
    assert command("compose", TEXT, "--name", "reading") == 0
    (bundle,) = store.glob("reading-*")
    mesh = next((bundle / "meshes").glob("*.obj"))
    content = bytearray(mesh.read_bytes())
    content[len(content) // 2] ^= 1
    mesh.write_bytes(bytes(content))
    assert mesh.name in shell("verify", str(bundle), code=1).out
    assert command("inspect", str(bundle)) == 4


@pytest.mark.parametrize(
    ("args", "code", "words"),
    [
        (("compose", "   "), 2, "empty"),
        (("compose", "200 mugs on a table"), 2, "at most"),
        (("compose", "机の上にマグカップがあります"), 2, "English"),
        (("generate", "nowhere/desk.png"), 2, "No picture"),
        (("generate", TEXT, "--backend", "embeded"), 3, "Did you mean 'embedded'"),
        (("generate", TEXT, "--modeler", "hunyuan3"), 3, "Did you mean 'hunyuan3d'"),
        (("generate", TEXT, "--backend", "cloud"), 3, "no segmenter (segment)"),
        (("inspect", "no-such-scene"), 4, "no-such-scene"),
        (("cache", "rm", "no-such-scene"), 4, "no-such-scene"),
    ],
)
def test_errors_are_one_line_and_an_exit_code(
    args: tuple[str, ...], code: int, words: str, shell: Shell
) -> None:
    *progress, message = shell(*args, code=code).err.strip().splitlines()
    assert message.startswith("error: ")
    assert words in message
    assert all(line.startswith("[") for line in progress)


@pytest.mark.slow
@pytest.mark.parametrize(
    "words",
    [("compose", TEXT, "--out", "file/scenes"), ("view", "reading", "--picture", "file/view.png")],
    ids=["folder", "picture"],
)
def test_what_cannot_be_written_is_a_storage_error(
    words: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, shell: Shell
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("file").write_text("")
    if words[0] == "view":
        shell("compose", TEXT, "--name", "reading")
    assert "cannot be written" in shell(*words, code=5).err


def test_a_scene_error_has_its_own_code(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*args, **kwargs):
        raise SceneError("no room")

    monkeypatch.setattr("generator.composition.compose", fail)
    assert command("compose", TEXT) == 6


@pytest.mark.slow
@pytest.mark.parametrize(
    ("words", "left_out"),
    [((), ()), (("--without", "tsa"), ("tsa",)), (("--without", "both"), ("dro", "tsa"))],
)
def test_stages_can_be_left_out_and_timed(
    words: tuple[str, ...], left_out: tuple[str, ...], monkeypatch: pytest.MonkeyPatch, shell: Shell
) -> None:
    asked = []

    def generate(source, backends, config, seed, **_):
        asked.append(config.without)
        scene = toy_scene()
        scene = scene.replace(report=judge(scene))
        return SimpleNamespace(
            scene=scene,
            seconds={"extraction": Seconds(2.5, 4.0), "assembly": Seconds(1.0, 0.5)},
            save=lambda folder, allow_failed: bundle.save(scene, folder),
            match=None,
        )

    monkeypatch.setattr("generator.pipeline.generate", generate)
    told = shell("generate", TEXT, *words, "--json", "--timings").facts["seconds"]
    assert asked == [left_out]
    assert told == {"extraction": {"wall": 2.5, "cpu": 4.0}, "assembly": {"wall": 1.0, "cpu": 0.5}}
    lines = shell("generate", TEXT, *words, "--timings").out.splitlines()
    assert [line.split()[:2] for line in lines[-3:]] == [
        ["extraction", "2.5"], ["assembly", "1.0"], ["total", "3.5"],
    ]  # fmt: skip
    assert "seconds" not in shell("generate", TEXT, *words).out


def test_only_what_can_be_left_out_is_taken(shell: Shell) -> None:
    shown = shell("generate", TEXT, "--without", "rotation", code=2)
    assert "dro" in shown.out + shown.err


def test_help_names_every_command(shell: Shell) -> None:
    shown = shell("--help").out
    made = ("generate", "compose", "cache")
    for name in (*made, "inspect", "verify", "view", "compare", "evaluate"):
        assert name in shown


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("inspect", "a", "b"), "b"),
        (("generate", TEXT, "desk"), "desk"),
        (("view", "a", "--frob", "3"), "--frob"),
        (("cache", "frob"), "frob"),
    ],
)
def test_words_too_many_are_named(words: tuple[str, ...], told: str, shell: Shell) -> None:
    shown = shell(*words, code=2).err
    assert f"Unrecognized options: {told}" in shown


def test_the_package_is_a_command() -> None:
    run = [sys.executable, "-m", "generator", "explain", "a mug on a desk"]
    assert (
        "mug" in subprocess.run(run, capture_output=True, text=True, check=True, timeout=120).stdout
    )


@pytest.mark.parametrize("words", [("verify",), ("cache", "rm")])
def test_checking_or_removing_nothing_is_a_mistake(words: tuple[str, ...], shell: Shell) -> None:
    assert "at least one bundle" in shell(*words, code=2).err


@pytest.mark.parametrize("name", ["generate", "compose"])
def test_a_name_that_is_no_folders_is_refused_before_any_work(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def work(*args, **kwargs):
        raise AssertionError("work began")

    monkeypatch.setattr("generator.composition.compose", work)
    monkeypatch.setattr("generator.pipeline.generate", work)
    assert command(name, TEXT, "--name", "../reading") == 6


@pytest.mark.slow
def test_compare_writes_a_sheet_and_figures(tmp_path: Path, shell: Shell) -> None:
    scene = toy_scene()
    shot = render_scene(scene, width=240, height=180, supersample=1)
    names = ("table", *(thing.name for thing in scene.objects))
    path = bundle.save(
        scene.replace(report=judge(scene)),
        tmp_path / "made",
        images={"reference": shot.image},
        segments=bundle.Segments(names, names, (shot.ids + 1).astype(np.uint8)),
    )
    sheet = tmp_path / "sheet.png"
    facts = shell("compare", str(path), "--out", str(sheet), "--json").facts
    assert [o["name"] for o in facts["objects"]] == list(names[1:])
    assert facts["mean_iou"] > 0.85
    first = sheet.read_bytes()
    assert Image.open(sheet).width > 1000

    other = tmp_path / "dark.png"
    Image.fromarray(np.asarray(shot.image) // 2).save(other)
    assert "cube_1" in shell("compare", str(other), str(path), "--out", str(sheet)).out
    assert sheet.read_bytes() != first
    assert command("compare", str(path), "--out", str(other / "sheet.png")) == 5


@pytest.mark.slow
def test_compare_needs_a_bundle_with_a_picture(shell: Shell) -> None:
    assert command("compose", TEXT, "--name", "reading") == 0
    assert "tabletopgen generate" in shell("compare", "reading", code=2).err
    assert command("compare") == 2
    assert command("compare", "a", "b", "c") == 2
