"""``tabletopgen batch``: scenes composed in processes equal those composed here."""

import pickle
from pathlib import Path

import pytest
from command import Shell, command

from generator import jobs as batch
from generator.backends import Mix
from generator.bundle import save
from generator.composition import compose
from generator.method.figures import preview

TEXT = "a desk with a mug"


@pytest.mark.slow
def test_a_batch_makes_what_compose_makes(tmp_path: Path, shell: Shell) -> None:
    prompts, out = tmp_path / "prompts.txt", tmp_path / "out"
    prompts.write_text(f"{TEXT}\n???\n")
    args = ("batch", str(prompts), "--out", str(out), "--route", "compose", "--seed", "2")
    told = shell(*args, "--json", code=1).facts
    assert (told["made"], told["failed"]) == (1, 1)
    scene = compose(TEXT, 2)
    path = save(scene, tmp_path / "here", images={"preview": preview(scene)})
    (made,) = (s["bundle"] for s in told["scenes"] if s["bundle"])
    assert made == path.name
    assert sorted(p.name for p in (out / made).iterdir()) == sorted(p.name for p in path.iterdir())

    prompts.write_text(TEXT)
    shown = shell(*args)
    assert "0 made, 1 already done, 0 failed" in shown.out
    assert "penetration_mm" in shown.out


def test_the_processes_get_the_mix_of_the_command(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    makers = []

    def run(jobs: object, out: Path, make: batch.Generating, **_: object) -> batch.Summary:
        makers.append(pickle.loads(pickle.dumps(make)))
        return batch.Summary(())

    monkeypatch.setattr(batch, "run", run)
    prompts = tmp_path / "prompts.txt"
    prompts.write_text(TEXT)
    roles = ("--modeler", "hunyuan3d", "--imager", "embedded")
    assert command("batch", str(prompts), "--out", str(tmp_path / "out"), *roles) == 0
    (made,) = makers
    assert made.mix == Mix(imager="embedded", modeler="hunyuan3d")


def test_an_interrupted_batch_says_that_what_is_made_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, shell: Shell
) -> None:
    def interrupted(*jobs: object, **settings: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(batch, "run", interrupted)
    prompts = tmp_path / "prompts.txt"
    prompts.write_text(TEXT)
    args = ("batch", str(prompts), "--out", str(tmp_path / "out"), "--route", "compose")
    assert "partial results are kept" in shell(*args, code=130).err


@pytest.mark.parametrize(
    ("args", "code", "words"),
    [
        (("no-such.txt",), 2, "No such file"),
        (("prompts.txt", "--backend", "embeded"), 3, "Did you mean 'embedded'"),
        (("prompts.txt", "--encoder", "cloud"), 3, "no encoder (features)"),
        (("prompts.txt", "--route", "compose", "--imager", "cloud"), 2, "uses no backends"),
        (("prompts.txt", "--workers", "0", "--route", "compose"), 2, "workers"),
    ],
)
def test_a_wrong_batch_is_one_clear_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, shell: Shell,
    args: tuple[str, ...], code: int, words: str
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    Path("prompts.txt").write_text(TEXT)
    assert words in shell("batch", *args, "--out", "out", code=code).err
