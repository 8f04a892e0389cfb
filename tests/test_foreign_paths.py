"""What users and records name: seeds, folders, files that are none; one rule and one message."""

import json
import os
import shutil
from pathlib import Path

import numpy as np
import pytest
from command import Shell, command
from toy import toy_object, toy_scene

import assets_cache
from generator import editing
from generator.bundle import save
from generator.composition import compose
from generator.errors import InputError, StorageError, require_seed
from generator.evaluation.external import load_external
from generator.io.files import check_folder, check_target
from generator.jobs import Job
from generator.method.reference import fetch, fetch_depth, is_picture_name
from generator.pipeline import generate
from generator.scene import Intrinsics
from tabletopgen_env.certificates.certificate import Terms
from tabletopgen_env.env import make_env
from tabletopgen_env.recording import RecordConfig
from tabletopgen_env.scenes import RefreshingScenes

SEED = "A seed must be a whole number from 0 to "


# -------------------------------------------------------------------------------------------- seeds
@pytest.mark.parametrize("seed", [-1, 1.5, True, "1", None, 2**63, 10**400, float("nan")], ids=str)
def test_a_seed_is_a_whole_number_from_0(seed: object) -> None:
    with pytest.raises(InputError, match=SEED):
        require_seed(seed)


def test_every_good_seed_is_one() -> None:
    for seed in (0, 7, 2**63 - 1, np.int64(3)):
        require_seed(seed)


NO_BUNDLE = Path("nothing at all")  # a seed is refused before anything is read
SEEDED = {
    "generate": lambda: generate("a desk with a mug", seed=-1),
    "compose": lambda: compose("a desk with a mug", -1),
    "batch": lambda: Job("a desk", -1),
    "swap": lambda: editing.swap(NO_BUNDLE, "mug_1", "a cup", -1),
    "add": lambda: editing.add(NO_BUNDLE, "a cup", -1),
    "move": lambda: editing.move(NO_BUNDLE, "mug_1", (0.0, 0.0), seed=-1),
    "restyle": lambda: editing.restyle(NO_BUNDLE, "cartoon", seed=-1),
    "certify": lambda: Terms(seed=-1),
    "record": lambda: RecordConfig("Lift", seed=-1).check(),
    "refreshing": lambda: RefreshingScenes(seed=-1),
}


@pytest.mark.parametrize("call", SEEDED.values(), ids=SEEDED)
def test_a_negative_seed_is_refused_alike_by_functions(call) -> None:
    with pytest.raises(InputError, match=SEED):
        call()


@pytest.mark.parametrize(
    "args",
    [("generate", "a desk"), ("compose", "a desk"), ("batch", "no.txt", "--out", "out"),
     ("edit", "workbench", "remove", "x")],
    ids=lambda args: args[0],
)  # fmt: skip
def test_a_negative_seed_is_refused_alike_by_commands(args: tuple[str, ...], shell: Shell) -> None:
    assert SEED in shell(*args, "--seed", "-1", code=2).err


def test_a_negative_seed_begins_no_episode() -> None:
    env = make_env("workbench", task="Reach")
    try:
        with pytest.raises(InputError, match=SEED):
            env.reset(seed=-1)
        one, other = env.reset(seed=np.int64(3))[0], env.reset(seed=3)[0]
        assert np.array_equal(one, other)
    finally:
        env.close()


# ------------------------------------------------------------------------------------------- places
def test_a_folder_is_checked_before_the_work(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x")
    check_folder(tmp_path / "new" / "folder")
    check_target(tmp_path / "new" / "picture.png")
    check_target(tmp_path / "file")
    os.mkfifo(tmp_path / "pipe")
    for wrong in (tmp_path / "file", tmp_path / "file" / "deep" / "er", tmp_path / "pipe"):
        with pytest.raises(StorageError, match=r"--out .*cannot be written.*not a folder"):
            check_folder(wrong)
    for wrong in (tmp_path, tmp_path / "pipe"):
        with pytest.raises(StorageError, match=r"--sheet .*not a regular file"):
            check_target(wrong, "--sheet")
    with pytest.raises(StorageError, match="not a folder"):
        check_target(tmp_path / "file" / "picture.png")


@pytest.mark.parametrize(
    "args",
    [("generate", "a desk"), ("compose", "a desk"), ("batch", "PROMPTS"),
     ("edit", "workbench", "remove", "x")],
    ids=lambda args: args[0],
)  # fmt: skip
def test_out_on_a_file_is_refused_before_the_work(
    tmp_path: Path, shell: Shell, monkeypatch: pytest.MonkeyPatch, args
) -> None:
    monkeypatch.setenv("TABLETOPGEN_CALLS", str(tmp_path / "calls"))
    (tmp_path / "file").write_text("precious")
    (tmp_path / "prompts.txt").write_text("a desk")
    given = [str(tmp_path / "prompts.txt") if a == "PROMPTS" else a for a in args]
    told = shell(*given, "--out", str(tmp_path / "file"), code=5)
    assert "is not a folder" in told.err
    assert "/" not in told.err.partition("error")[0], "no stage was begun"
    assert (tmp_path / "file").read_text() == "precious"
    assert {p.name for p in tmp_path.iterdir()} == {"file", "prompts.txt"}


def test_a_directory_is_no_text(tmp_path: Path, shell: Shell) -> None:
    assert "is a directory" in shell("generate", str(tmp_path), code=2).err


def test_words_that_are_a_folders_name_stay_words(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("desk").mkdir()
    assert not is_picture_name("desk")
    assert is_picture_name("./desk")


def test_pictures_and_depth_maps_are_regular_files(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "desk.png")
    for place in (tmp_path / "desk.png", Path("/dev/zero")):
        with pytest.raises(InputError, match="not a regular file"):
            fetch(place)
        with pytest.raises(InputError, match="not a regular file"):
            fetch_depth(place)


# ------------------------------------------------------------------------------------------- values
@pytest.mark.parametrize(
    "values", [("400", 400, 1, 1), (400, 400, None, 1), (True, 400, 1, 1), (10**400, 400, 1, 1),
               (400, [400], 1, 1), (float("nan"), 400, 1, 1), (1e300, 400, 1, 1), (400, -4, 1, 1)],
    ids=repr,
)  # fmt: skip
def test_intrinsics_are_numbers(values: tuple[object, ...]) -> None:
    with pytest.raises(InputError, match=r"Intrinsics\."):
        Intrinsics(*values)  # type: ignore[arg-type]


def test_intrinsics_of_other_kinds_of_numbers_are_fine() -> None:
    assert Intrinsics(np.float32(400), np.int64(400), 0, 1.5).fx == 400.0  # type: ignore[arg-type]


TABLE = {"size": [1.0, 0.6, 0.7]}


@pytest.mark.parametrize(
    "text",
    [
        '{"up": []}',
        '{"up": {}}',
        "[" * 100_000,
        '{"objects": {}, "table": []}',
        json.dumps({"objects": [], "table": TABLE, "name": 5}),
        json.dumps({"objects": [], "table": TABLE, "name": "\x1b[2J"}),
        json.dumps({"objects": [], "table": TABLE, "method": "\x1b[2J"}),
        json.dumps({"objects": [{"name": "\x1b[2J"}], "table": TABLE}),
        json.dumps({"objects": [{"name": 5}], "table": TABLE}),
        json.dumps({"objects": [], "table": {"size": 1}}),
        json.dumps({"objects": [], "table": {"size": [1e300, 1, 1]}}),
        json.dumps({"objects": [], "table": {"size": [1, 1, 1], "top": "x"}}),
        json.dumps({"objects": [], "table": {"glb": "\x1b[2J"}}),
        json.dumps({"objects": [], "table": {"glb": []}}),
    ],
    ids=lambda text: text[:60],
)
def test_a_hostile_transforms_file_is_one_clear_error(tmp_path: Path, text: str) -> None:
    (tmp_path / "transforms.json").write_text(text)
    with pytest.raises(InputError) as caught:
        load_external(tmp_path, decompose=False)
    assert str(caught.value).isprintable() and len(str(caught.value)) < 2000


def test_a_transforms_file_is_a_regular_file(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "transforms.json")
    with pytest.raises(InputError, match="not a regular file"):
        load_external(tmp_path)


@pytest.mark.slow
def test_names_of_foreign_bundles_reach_no_terminal(store: Path, shell: Shell) -> None:
    thing = toy_object("cube_1", (0.05,) * 3, (0.0, 0.0))
    made = save(toy_scene((thing,), name="toy"), store, allow_failed=True)
    shutil.copytree(made, store / "a\x1b[2J-0123456789ab")
    assert command("cache", "list", "a*") == 0
    assert command("cache", "verify") == 1
    told = "".join(shell("cache", "rm", "a*"))
    assert "a\\x1b[2J-0123456789ab" in told and "\x1b" not in told
    assert assets_cache.entries(store)[-1].name == made.name or made.is_dir()
