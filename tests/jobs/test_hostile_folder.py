"""Records and prompts written by others: no changes outside the folder, no hangs."""

import json
import os
from pathlib import Path

import pytest
from command import Shell
from toy import toy_object, toy_scene
from toy_maker import ToyMaker

from generator import bundle
from generator import jobs as batch
from generator.errors import InputError, StorageError
from generator.jobs.records import PLACE, key_of, work
from generator.scene import Provenance, Report

JOB = batch.Job("a cube")


@pytest.fixture
def make(tmp_path: Path) -> ToyMaker:
    return ToyMaker(str(tmp_path / "log"))


@pytest.fixture
def out(tmp_path: Path, make: ToyMaker) -> Path:
    """A batch's folder, with files of another user in and beside it."""
    for place in (tmp_path / "kept", tmp_path / "out" / "kept", tmp_path / "out" / PLACE):
        place.mkdir(parents=True)
        (place / "file").write_text("precious")
    return tmp_path / "out"


def record(out: Path, make: ToyMaker, raw: str | bytes | None = None, **told: object) -> Path:
    """Write the record of ``JOB`` as another user might; return the folder of its scene."""
    name = key_of(JOB, make)
    content = json.dumps({"text": JOB.text, "seed": 0, **told}) if raw is None else raw
    path = out / PLACE / f"{name}.json"
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return out / PLACE / name


def other_bundle(folder: Path) -> Path:
    """A valid bundle that no batch created."""
    thing = toy_object("cube_1", (0.07,) * 3, (0.0, 0.0))
    scene = toy_scene((thing,), name="other")
    return bundle.save(
        scene.replace(provenance=Provenance("manual", 0), report=Report(0.0, 0.0, 0.0)), folder
    )


def check_kept(out: Path) -> None:
    for place in (out.parent / "kept", out / "kept", out / PLACE):
        assert (place / "file").read_text() == "precious"


NAMES = [".", "..", "", "/", "kept", "../kept", "own/../../kept", PLACE, "a\0b", "x" * 300,
         "\x1b[2Jx-0123456789ab", 5, [], {}, True, "absolute"]  # fmt: skip


@pytest.mark.parametrize("name", NAMES, ids=repr)
def test_a_record_removes_nothing(out: Path, make: ToyMaker, name: object) -> None:
    name = str(out.parent / "kept") if name == "absolute" else name
    own = record(out, make, bundle=name)
    (own / "kept").mkdir(parents=True)  # so that there is something to put in its place
    outcome = work(JOB, out, make)
    check_kept(out)
    assert outcome.state == "made"
    assert bundle.verify(out / str(outcome.bundle)) == []
    assert not own.exists()


def test_what_lies_where_a_bundle_belongs_stays_unless_it_is_that_bundle(
    out: Path, make: ToyMaker
) -> None:
    name = "kept-0123456789ab"
    (out / "kept").rename(out / name)
    own = record(out, make, bundle=name)
    made = other_bundle(own)
    made.rename(own / name)  # sound, but not of that digest
    assert work(JOB, out, make).state == "made"
    assert (out / name / "file").read_text() == "precious"


def test_a_damaged_bundle_makes_way_for_the_same_one(out: Path, make: ToyMaker) -> None:
    own = record(out, make)
    made = other_bundle(own)
    record(out, make, bundle=made.name)
    (out / made.name).mkdir()
    (out / made.name / "scene.xml").write_text("half")
    assert work(JOB, out, make).state == "there"
    assert bundle.verify(out / made.name) == []
    assert not own.exists()


def test_a_sound_bundle_that_a_record_names_stays(out: Path, make: ToyMaker) -> None:
    other = other_bundle(out)
    before = (other / "scene.json").stat()
    record(out, make, bundle=other.name)
    for retry in (False, True):
        assert work(JOB, out, make, retry).state == "there"
    assert os.path.samestat(before, (other / "scene.json").stat())


def test_links_are_never_gone_through(out: Path, make: ToyMaker) -> None:
    own = record(out, make, bundle="kept-0123456789ab")
    own.symlink_to(out.parent / "kept")
    outcome = work(JOB, out, make)
    assert outcome.state == "made"
    assert not own.is_symlink()
    check_kept(out)

    name = str(outcome.bundle)
    (out / name).rename(out.parent / name)  # sound, elsewhere, and linked to where it is made
    own.mkdir()
    (own / name).symlink_to(out.parent / name)
    (out / name).symlink_to(out.parent / "kept")
    assert work(JOB, out, make).state == "made"
    assert not (out / name).is_symlink()
    assert bundle.verify(out.parent / name) == bundle.verify(out / name) == []
    check_kept(out)


def test_records_elsewhere_are_refused(out: Path, make: ToyMaker) -> None:
    (out / PLACE).rename(out.parent / "elsewhere")
    (out / PLACE).symlink_to(out.parent / "elsewhere")
    with pytest.raises(StorageError, match="is a link"):
        batch.run([JOB], out, make)
    assert [p.name for p in (out.parent / "elsewhere").iterdir()] == ["file"]


RECORDS = {
    "deep": b"[" * 100_000,
    "list": b"[]",
    "nothing": b"",
    "huge": b'"' + b"x" * (2 * 2**20) + b'"',
    "no text": b"\xff\xfe",
    "kind": {"kind": []},
    "error": {"kind": "InputError", "error": {}},
    "seconds": {"kind": "InputError", "seconds": "5"},
    "long": {"kind": "InputError", "seconds": 1e300},
    "whole": b'{"kind": "InputError", "seconds": 1' + b"0" * 400 + b"}",
    "true": {"bundle": True},
}


@pytest.mark.parametrize("told", RECORDS.values(), ids=RECORDS)
def test_a_record_that_says_nothing_is_none(out: Path, make: ToyMaker, told) -> None:
    record(out, make, told) if isinstance(told, bytes) else record(out, make, **told)
    assert work(JOB, out, make).state == "made"


def test_a_record_that_is_a_pipe_is_none(out: Path, make: ToyMaker) -> None:
    path = record(out, make).with_suffix(".json")
    path.unlink()
    os.mkfifo(path)
    assert work(JOB, out, make).state == "made"


@pytest.mark.slow
@pytest.mark.parametrize("gate", [5, [1], {"drift_mm": "x"}, {"drift_mm": None}, {"x": 1e300}])
def test_figures_that_are_none_are_left_out(out: Path, make: ToyMaker, gate: object) -> None:
    other = other_bundle(out)
    record(out, make, bundle=other.name, gate=gate)
    texts = ["another cube", JOB.text]
    summary = batch.run(texts, out, make)
    assert [o.state for o in summary.outcomes] == ["made", "there"]
    assert summary.gate()["penetration_mm"] == {"mean": 0.1, "most": 0.1}
    record(out, make, bundle=other.name, gate={"own": 2})
    assert batch.run(texts, out, make).gate()["own"]["mean"] == 2.0


def test_prompts_are_read_from_regular_files_alone(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "pipe.json").symlink_to("pipe")
    for place in ("/dev/zero", tmp_path / "pipe", tmp_path / "pipe.json", tmp_path):
        with pytest.raises(InputError, match=r"not a regular file|cannot be read"):
            batch.read_prompts(place)


@pytest.mark.parametrize(
    ("content", "words"),
    [(b"[" * 100_000, "deeper than"), (b'["\\ud800"]', "not valid JSON"), (b"[NaN]", "not valid"),
     (b'[{"text": "a", "seed": 1' + b"0" * 400 + b"}]", "A seed must"), (b"\xff", "not valid JSON"),
     (b'["a", {"text": "a", "seed": true}]', "A seed must")],
)  # fmt: skip
def test_hostile_prompts_are_refused(tmp_path: Path, content: bytes, words: str) -> None:
    path = tmp_path / "deep.json"
    path.write_bytes(content)
    with pytest.raises(InputError, match=words):
        batch.read_prompts(path)


def test_a_picture_that_is_a_pipe_names_a_job(tmp_path: Path, make: ToyMaker) -> None:
    os.mkfifo(tmp_path / "desk.png")
    assert key_of(batch.Job(str(tmp_path / "desk.png")), make)


def test_what_a_record_says_is_printed_without_escapes(tmp_path: Path, shell: Shell) -> None:
    prompts, out = tmp_path / "prompts.txt", tmp_path / "out"
    prompts.write_text("a desk\n")
    name = key_of(batch.Job("a desk"), batch.Composing())
    (out / PLACE).mkdir(parents=True)
    told = {"kind": "InputError", "error": "bad \x1b]0;title\x07 \x9b31m"}
    (out / PLACE / f"{name}.json").write_text(json.dumps(told))
    shown = "".join(shell("batch", str(prompts), "--out", str(out), "--route", "compose", code=1))
    assert "bad \\x1b]0;title\\x07 \\x9b31m" in shown
    assert all(c.isprintable() or c == "\n" for c in shown)
