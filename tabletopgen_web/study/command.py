"""The commands that create a user study as one HTML file, and evaluate the answers."""

from __future__ import annotations

import json as jsons
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import tyro
from tyro.conf import OmitArgPrefixes, Positional, arg

from generator.cli.output import emit
from generator.errors import InputError, StorageError, escape
from generator.io.files import check_folder, check_target, write_whole

from .design import Drawing, StudyOptions, check_methods

if TYPE_CHECKING:
    from .statistics import StudyReport

app = tyro.extras.SubcommandApp()

_OPTIONS, _DRAWING = StudyOptions(), Drawing()


@app.command(name="new")
def make_page(
    methods: Annotated[Positional[tuple[str, ...]], arg(metavar="METHOD=FOLDER [...]")],
    /,
    *,
    out: Path,
    inputs: Path | None = None,
    study: OmitArgPrefixes[StudyOptions] = _OPTIONS,
    drawing: OmitArgPrefixes[Drawing] = _DRAWING,
    json: bool = False,
) -> int:
    """Create a study that compares methods' results for the same input pictures.

    The page is one HTML file that contains all pictures. It names no method; FILE.key.json beside
    it maps results to methods, and must remain with you. Send the page to raters, or serve it.

    Args:
        methods: Each method's name and the folder of its results: bundles, or a picture SCENE.png
            for each scene. Bundles are drawn from the camera of their input picture.
        out: The page, FILE.html.
        inputs: Folder of the input pictures, named after the scenes; by default those in the
            bundles.
        study: Settings of the study.
        drawing: Display of the results.
        json: Print one JSON object instead of lines.
    """
    from .collection import collect
    from .page import key_path, make_study, write_study
    from .page_data import read_template

    folders = _folders(methods)
    if out.suffix.lower() not in (".html", ".htm"):
        raise InputError(f"--out {str(out)!r} must end with .html.")
    for path in (out, key_path(out)):
        check_target(path)
    template = read_template()
    scenes, ignored = collect(folders, inputs, drawing)
    if ignored:
        _warn(f"left out: {', '.join(ignored[:20])}{' ...' if len(ignored) > 20 else ''}")
    files = make_study(scenes, list(folders), study, template)
    page, key = write_study(files, out)
    facts = {
        "page": str(page), "key": str(key), "study": files.key.study, "methods": [*folders],
        "scenes": [one.name for one in scenes], "scenes_each": files.key.scenes_each,
        "attention": files.key.attention, "min_seconds": files.key.min_seconds,
        "bytes": page.stat().st_size, "left_out": ignored,
    }  # fmt: skip
    emit(facts, json, lambda: [
        f"{page} ({facts['bytes'] / 1e6:.1f} MB): study {files.key.study}, {len(scenes)} "
        f"scene{'s' * (len(scenes) != 1)} of {len(folders)} methods; a rater sees "
        f"{files.key.scenes_each}",
        f"{key}: keep this file private; `tabletopgen study report` needs it",
    ])  # fmt: skip
    return 0


@app.command(name="report")
def count_answers(
    answers: Annotated[Positional[tuple[Path, ...]], arg(metavar="ANSWERS [ANSWERS ...]")],
    /,
    *,
    key: Path,
    out: Path | None = None,
    min_seconds: float | None = None,
    allow_failed: int = 0,
    seed: int = 0,
    json: bool = False,
) -> int:
    """Evaluate answers: means, preferences and wins with 95 % intervals, and agreement of raters.

    Answers that do not fit the study are excluded, with a line that gives the reason.

    Args:
        answers: Files from raters, or folders of them.
        key: FILE.key.json, which `study new` wrote.
        out: Folder for table.md (the paper's Table 2 first), table.csv, report.json and, with
            Matplotlib (extra "plot"), chart.png.
        min_seconds: Minimum time of a rater, in place of the study's.
        allow_failed: Maximum number of failed attention checks of a rater.
        seed: Seed of the bootstrap.
        json: Print one JSON object instead of lines.
    """
    from .answers import read_all
    from .key import read_key
    from .statistics import measure
    from .tables import lines

    if out is not None:
        check_folder(out)
    known = read_key(key)
    found, left = read_all(answers, known)
    for one in left:
        _warn(f"excluded: {one.file}: {one.reason}")
    report = measure(
        found, left, known, min_seconds=min_seconds, allowed_failures=allow_failed, seed=seed
    )
    if out is not None:
        _write(report, out)
    emit(report.facts(), json, lambda: lines(report))
    return 0


def _folders(methods: tuple[str, ...]) -> dict[str, Path]:
    pairs = [text.partition("=") for text in methods]
    if wrong := next((name for name, equals, folder in pairs if not (equals and folder)), None):
        raise InputError(
            f"{wrong!r} must have the form METHOD=FOLDER, for example ours=scenes/ours."
        )
    check_methods(name for name, _, _ in pairs)
    return {name: Path(folder) for name, _, folder in pairs}


def _write(report: StudyReport, out: Path) -> None:
    from .chart import draw_chart
    from .tables import to_csv, to_markdown

    files: dict[str, str | bytes] = {
        "report.json": jsons.dumps(report.facts(), indent=1, ensure_ascii=False) + "\n",
        "table.csv": to_csv(report),
        "table.md": to_markdown(report),
    }
    try:
        files["chart.png"] = draw_chart(report)
    except InputError as error:
        _warn(str(error))
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(f"{out} cannot be created: {error.strerror or error}.") from error
    for name in files:
        check_target(out / name)
    for name, content in files.items():
        write_whole(out / name, content, "The report", "Choose another --out.")


def _warn(text: str) -> None:
    print(escape(text), file=sys.stderr)
