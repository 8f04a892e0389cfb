"""Who may import whom: the rules in CONTRIBUTING.md, checked on the source itself."""

from __future__ import annotations

import ast
import re
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PACKAGES = ("generator", "tabletopgen_env", "assets_cache")

VALUES = (
    "generator.threads", "generator.errors", "generator.geometry", "generator.io.png",
    "generator.io.reading", "generator.scene", "generator.io.terminal",
)  # fmt: skip
# The first rule whose prefix fits a module decides what of this project it may import.
RULES: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("generator.threads", ()),
    ("generator.io.terminal", ()),
    ("generator.errors", ("generator.io.terminal",)),
    ("generator.io.png", ()),
    ("generator.io.reading", ("generator.errors",)),
    ("generator.io.npz", ("generator.errors", "generator.io.reading")),
    ("generator.scene", ("generator.errors", "generator.io.reading", "generator.scene")),
    ("generator.geometry", VALUES),
    ("generator.scene.paper_json", VALUES),
    ("generator.render", (*VALUES, "generator.render")),
    ("generator.backends.protocols", VALUES),
    ("generator.backends.installing", ("generator.errors",)),
    (
        "generator.calls",
        ("generator.errors", "generator.io.files", "generator.io.reading", "generator.calls"),
    ),
    (
        "generator.backends.select",
        (*VALUES, "generator.backends.protocols", "generator.calls"),
    ),
    (
        "generator.backends.embedded",
        (
            *VALUES,
            "generator.backends.protocols",
            "generator.backends.embedded",
            "generator.catalogue",
            "generator.layout",
            "generator.render",
        ),
    ),
    (
        "generator.backends.modelers",
        (
            *VALUES,
            "generator.backends.protocols",
            "generator.backends.installing",
            "generator.backends.modelers",
            "generator.backends.embedded",
            "generator.catalogue",
            "generator.render",
            "generator.calls",
        ),
    ),
    (
        "generator.backends.cloud",
        (
            *VALUES,
            "generator.backends.protocols",
            "generator.backends.cloud",
            "generator.backends.embedded.drawing.topview",
            "generator.catalogue",
            "generator.render",
            "generator.calls",
        ),
    ),
    (
        "generator.backends.huggingface",
        (
            *VALUES,
            "generator.backends.protocols",
            "generator.backends.huggingface",
            "generator.backends.installing",
            "generator.catalogue",
        ),
    ),
    (
        "generator.backends",
        ("generator.backends.mix", "generator.backends.select", "generator.calls"),
    ),
    ("generator.catalogue.sheet", (*VALUES, "generator.catalogue", "generator.render")),
    ("generator.catalogue", (*VALUES, "generator.catalogue")),
    ("generator.layout", (*VALUES, "generator.layout", "generator.catalogue")),
    (
        "generator.physics",
        (*VALUES, "generator.physics.mjcf", "generator.io.npz", "generator.physics"),
    ),
    (
        "generator.method",  # which stage a stage's own modules may import: see below
        (
            *VALUES,
            "generator.backends.protocols",
            "generator.render",
            "generator.physics",
            "generator.physics.mjcf",
            "generator.method",
        ),
    ),
    ("generator.physics.mjcf", VALUES),
    ("generator.io.files", ("generator.errors",)),
    ("generator.io.pictures", (*VALUES, "generator.io.files")),
    (
        "generator.bundle",
        (
            *VALUES,
            "generator.io.files",
            "generator.physics.mjcf",
            "generator.scene.provenance",
            "generator.bundle",
        ),
    ),
    (
        "generator.comparison",
        (*VALUES, "generator.bundle", "generator.render", "generator.comparison"),
    ),
    (
        "generator.evaluation.perceptual",
        (
            *VALUES,
            "generator.evaluation",
            "generator.backends.embedded",
            "generator.backends.huggingface",
        ),
    ),
    (
        "generator.evaluation",
        (
            *VALUES,
            "generator.meshes.reading.surface",
            "generator.backends.protocols",
            "generator.bundle",
            "generator.catalogue",
            "generator.comparison",
            "generator.evaluation",
            "generator.physics",
            "generator.render",
        ),
    ),
    (
        "generator.compose",
        (
            *VALUES,
            "generator.backends",
            "generator.catalogue",
            "generator.layout",
            "generator.method.assembly",
            "generator.scene.provenance",
        ),
    ),
    (
        "generator.language.distribution",
        (*VALUES, "generator.backends.embedded", "generator.catalogue"),
    ),
    ("generator.method.supplement", (*VALUES, "generator.layout")),
    (
        "generator.jobs",
        (
            *VALUES,
            "generator.backends",
            "generator.jobs",
            "generator.bundle",
            "generator.compose",
            "generator.method.figures",
            "generator.io.files",
            "generator.pipeline",
            "generator.scene.provenance",
            "generator.calls",
            "generator.method.reference",
        ),
    ),
    (
        "generator.editing",
        (
            *VALUES,
            "generator.backends",
            "generator.bundle",
            "generator.catalogue",
            "generator.editing",
            "generator.method.figures",
            "generator.layout",
            "generator.physics",
            "generator.pipeline",
            "generator.scene.provenance",
            "generator.method.salvage",
            "generator.method",
            "generator.method.supplement",
        ),
    ),
    (
        "research.eye",
        (
            *VALUES,
            "research.eye",
            "generator.backends.embedded",
            "generator.catalogue",
            "generator.layout",
            "generator.render",
        ),
    ),
    ("generator.scene.provenance", ()),
    ("generator.cli", ("generator", "assets_cache")),
    ("generator", ("generator",)),
    (
        "assets_cache.make_starter",
        ("generator", "assets_cache", "tabletopgen_env.certificates.certificate"),
    ),
    ("assets_cache", (*VALUES, "generator.bundle", "assets_cache")),
    (
        "tabletopgen_env",
        (
            *VALUES,
            "generator.bundle",
            "generator.io.files",
            "generator.physics.mjcf",
            "generator.io.npz",
            "generator.io.pictures",
            "generator.render",
            "generator.compose",
            "generator.language.distribution",
            "generator.pipeline",
            "generator.jobs.workers",
            "assets_cache",
            "tabletopgen_env",
        ),
    ),
)


def modules() -> list[tuple[str, Path]]:
    found = []
    for package in PACKAGES:
        for path in sorted((ROOT / package).rglob("*.py")):
            parts = path.relative_to(ROOT).with_suffix("").parts
            found.append((".".join(p for p in parts if p != "__init__"), path))
    return found


def imports(name: str, path: Path) -> set[str]:
    """Every module of this project that ``path`` imports, anywhere in the file."""
    package = name.split(".") if path.name == "__init__.py" else name.split(".")[:-1]
    found = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            stem = ".".join([*base, *([node.module] if node.module else [])])
            found |= {stem if is_module(stem) else "", *children(stem, node)}
    return {m for m in found if m.split(".")[0] in PACKAGES}


def is_module(name: str) -> bool:
    path = ROOT.joinpath(*name.split("."))
    return path.with_suffix(".py").is_file()


def children(stem: str, node: ast.ImportFrom) -> set[str]:
    """Modules named by ``from package import module``, else the package itself."""
    if is_module(stem):
        return set()
    names = {f"{stem}.{alias.name}" for alias in node.names}
    return {n if is_module(n) or ROOT.joinpath(*n.split(".")).is_dir() else stem for n in names}


def within(module: str, prefix: str) -> bool:
    return module == prefix or module.startswith(prefix + ".")


def violations(name: str, used: set[str]) -> list[str]:
    allowed = next(allow for prefix, allow in RULES if within(name, prefix))
    return sorted(
        u for u in used if u not in ("generator", name) and not any(within(u, a) for a in allowed)
    )


@pytest.mark.slow
@pytest.mark.parametrize(("name", "path"), modules(), ids=lambda v: str(v))
def test_module_keeps_the_import_rules(name: str, path: Path) -> None:
    assert violations(name, imports(name, path)) == []


def test_no_stage_imports_another_stage() -> None:
    stages = [(n, p) for n, p in modules() if within(n, "generator.method")]
    assert len(stages) > 3
    for name, path in stages:
        own = ".".join(name.split(".")[:3])
        used = {u for u in imports(name, path) if within(u, "generator.method")}
        assert {u for u in used if not within(u, own)} <= {"generator.method"}, name


def test_the_rules_can_fail() -> None:
    assert violations("generator.method.rotation", {"generator.backends.embedded.encoder"})
    assert violations("generator.physics.mjcf", {"tabletopgen_env.env"})
    assert violations("tabletopgen_env.env", {"generator.catalogue"})


# Packages whose import has another name than their distribution.
DISTRIBUTIONS = {
    "stable_baselines3": "stable-baselines3",
    "PIL": "pillow",
    "cv2": "opencv-python-headless",
    "fast_simplification": "fast-simplification",
}
INDIRECT = {"coacd", "mapbox-earcut"}  # run in a child process; called by trimesh


def declared(extra: str | None = None) -> set[str]:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    listed = project["optional-dependencies"][extra] if extra else project["dependencies"]
    return {re.split(r"[^A-Za-z0-9-]", entry)[0] for entry in listed}


def foreign(path: Path) -> set[str]:
    """Third-party packages that ``path`` imports, anywhere in the file, by distribution."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            found |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and not node.level and node.module:
            found.add(node.module.split(".")[0])
    found -= {*sys.stdlib_module_names, *PACKAGES}
    return {DISTRIBUTIONS.get(name, name) for name in found}


@pytest.mark.slow
def test_what_is_imported_is_what_is_installed() -> None:
    """Every package imported is a dependency, and the other way round."""
    used, learning, recording, cloud, many, hub = set(), set(), set(), set(), set(), set()
    extras = {
        "tabletopgen_env.learning": learning,
        "tabletopgen_env.recording": recording,
        "generator.calls": cloud,
        "generator.backends.cloud": cloud,
        "generator.backends.modelers": cloud,
        "generator.jobs": many,
        "generator.backends.huggingface": hub,
    }
    for name, path in modules():
        own = (packages for part, packages in extras.items() if within(name, part))
        next(own, used).update(foreign(path))
    assert used | ((cloud | many | hub) & declared()) | INDIRECT == declared()
    assert learning - declared() == declared("train")
    assert recording - declared() == declared("record")
    assert many - declared() == declared("ray")
    assert cloud - declared() <= declared("cloud")
    assert hub - declared() <= declared("huggingface")
    assert {line.split("==")[0] for line in constraints()} >= declared()


def constraints() -> list[str]:
    lines = (ROOT / "constraints.txt").read_text().splitlines()
    return [line for line in lines if line and not line.startswith("#")]
