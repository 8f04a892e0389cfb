"""Who may delete, by the source: a name that a file holds reaches only ``generator.io.files``."""

import ast
from pathlib import Path

ROOT = Path(__file__).parent.parent
PACKAGES = ("tabletop_objects", "generator", "tabletopgen_env", "assets_cache", "research")
REMOVING = {"rmtree", "unlink", "rmdir", "removedirs"}
OF_OS = {"remove", "removedirs", "rmdir", "unlink"}

ALLOWED = {
    "generator/io/files.py": "the one place: plain names inside a folder of ours",
    "generator/bundle/publication.py": "a staging folder that it has emptied",
    "generator/calls/store.py": "its own partial file, as made",
    "research/eye/shards.py": "its own partial file, as made",
    "generator/backends/huggingface/weights/fetch.py": "its own download, not what was pinned",
    "tabletopgen_env/scenes/production/pool.py": "jobs in a temporary folder of its own",
    "tabletopgen_env/scenes/production/background.py": "jobs in a temporary folder of its own",
    "generator/sandbox/child.py": "the empty folder that it works in",
    "generator/jobs/workers.py": "the temporary folder that it was made for",
    "generator/jobs/worker.py": "the temporary folder of its pool",
    "tabletopgen_env/recording/publication.py": "a part folder of its own",
    "tabletopgen_env/recording/formats/npz_writer.py": "a half-written episode in its part folder",
    "tabletopgen_env/recording/lerobot/segments.py": "half-written episodes in its part folder",
    "tabletopgen_env/recording/lerobot/writer.py": "what is half put together in its part folder",
    "tabletopgen_env/learning/runs.py": "checkpoints of a run, by their pattern in its folder",
    "tabletopgen_env/learning/demonstrations/rounds.py": "the rounds of a run, in its folder",
    "assets_cache/make_starter.py": "remakes what the package ships, run by hand",
}
"""The modules that delete, and what: nothing whose name was read from a file."""


def removals(source: str) -> list[str]:
    """Return the calls of a module that delete something."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Attribute) and (
            node.attr in REMOVING
            or (node.attr in OF_OS and isinstance(node.value, ast.Name) and node.value.id == "os")
        ):
            found.append(node.attr)
        elif isinstance(node, ast.ImportFrom) and node.module in ("os", "shutil"):
            found += [a.name for a in node.names if a.name in REMOVING | OF_OS]
    return found


def test_only_those_delete_that_have_a_reason() -> None:
    deleting = set()
    for package in PACKAGES:
        for path in (ROOT / package).rglob("*.py"):
            if removals(path.read_text()):
                deleting.add(path.relative_to(ROOT).as_posix())
    assert deleting == set(ALLOWED)


def test_the_rule_can_fail() -> None:
    assert removals("import shutil\nshutil.rmtree(path)") == ["rmtree"]
    assert removals("from shutil import rmtree") == ["rmtree"]
    assert removals("import os\nos.remove(path)") == ["remove"]
    assert removals("Path(name).unlink()") == ["unlink"]
    assert removals("names.remove('a')") == []
