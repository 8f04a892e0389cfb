"""Comparison of entries and files of two bundles before and after an edit."""

from pathlib import Path
from typing import Any

from generator.bundle.folder import read_truth


def kept(before: Path, after: Path, *, poses: bool = True) -> set[str]:
    """Return the names of the objects whose entries and files are identical."""
    old, new = entries(before, poses), entries(after, poses)
    return {name for name, entry in old.items() if new.get(name) == entry}


def entries(bundle: Path, poses: bool = True) -> dict[str, Any]:
    """Return the entry of each object in a bundle by name, including the bytes of its files."""
    truth = read_truth(bundle)
    found = {}
    for listed in truth["objects"]:
        entry = {**listed, "model": dict(truth["models"][listed["model"]])}
        for key in ("mesh", "texture"):
            entry[key] = (bundle / entry["model"][key]).read_bytes()
        if not poses:
            del entry["pose"]
        found[entry["name"]] = entry
    return found
