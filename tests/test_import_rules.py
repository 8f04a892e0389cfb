"""Who may import whom: the rules in CONTRIBUTING.md, checked on the source itself."""

import ast
import re
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PACKAGES = (
    "tabletop_objects", "generator", "tabletopgen_env", "tabletopgen_web", "assets_cache",
    "research",
)  # fmt: skip

# The layers, foundations first. A module may import its own part and the rows listed before it,
# never another part of its own row. It belongs to the longest name here that it starts with.
LAYERS: tuple[tuple[str, ...], ...] = (
    ("tabletop_objects.errors",),
    ("tabletop_objects.values",),
    ("tabletop_objects.kit",),
    ("tabletop_objects.objects",),
    ("tabletop_objects.catalogue",),
    ("tabletop_objects",),
    ("generator.errors", "generator.threads"),
    ("generator.io",),
    ("generator.sandbox",),
    ("generator.pictures",),
    ("generator.scene", "generator.calls"),
    ("generator.geometry", "generator.backends.protocols", "generator.backends.requirements"),
    ("generator.render", "generator.physics"),
    ("generator.tables", "generator.stand_ins", "generator.bundle"),
    ("generator.language", "generator.layout", "generator.comparison", "assets_cache"),
    ("generator.meshes",),
    (
        "generator.method",  # the paper, a file a section
        "generator.backends.embedded",
        "generator.backends.cloud",
        "generator.backends.huggingface",
        "generator.backends.modelers",
    ),
    ("generator.backends", "generator.generation"),
    ("generator.pipeline", "generator.composition", "generator.evaluation"),
    ("generator.jobs", "generator.editing", "generator.exports", "generator.imports"),
    ("generator.objects",),
    ("generator", "generator.cli"),
    ("generator.__main__",),
    ("tabletopgen_env.robot", "tabletopgen_env.affordance", "tabletopgen_env.files"),
    ("tabletopgen_env.scenes",),
    ("tabletopgen_env.world",),
    ("tabletopgen_env.goals", "tabletopgen_env.actions", "tabletopgen_env.parallel.batch"),
    ("tabletopgen_env.rendering", "tabletopgen_env.expert"),
    ("tabletopgen_env.tasks", "tabletopgen_env.detection", "tabletopgen_env.grasps"),
    ("tabletopgen_env.observations",),
    ("tabletopgen_env.parallel.core",),
    ("tabletopgen_env.randomization",),
    ("tabletopgen_env.certificates", "tabletopgen_env.episodes", "tabletopgen_env.settings"),
    ("tabletopgen_env.env",),
    ("tabletopgen_env.parallel.workers", "tabletopgen_env.parallel.batch"),
    ("tabletopgen_env.parallel.vector", "tabletopgen_env.statistics"),
    ("tabletopgen_env.certificates.certify",),
    (
        "tabletopgen_env.certificates.command",
        "tabletopgen_env.certificates.replay",
        "tabletopgen_env.learning",
    ),
    ("tabletopgen_env.recording", "tabletopgen_env.bench"),
    ("tabletopgen_env.teleoperation",),
    ("tabletopgen_env", "assets_cache.make_starter"),
    ("tabletopgen_web.frontend",),
    ("tabletopgen_web.page",),
    ("tabletopgen_web.study",),
    ("tabletopgen_web.studio",),
    ("tabletopgen_web",),
    ("research",),
)
# What the environments may use of the generator: values, bundles and whole scenes.
OF_GENERATOR = (
    "generator.errors", "generator.threads", "generator.io", "generator.scene",
    "generator.geometry", "generator.render", "generator.physics.mjcf", "generator.physics.spec",
    "generator.physics.gate", "generator.bundle",
    "generator.language.distribution", "generator.composition", "generator.pipeline",
    "generator.jobs",
)  # fmt: skip


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


def part_of(name: str) -> tuple[int, str]:
    """Return the row and the part of the table that contain a module."""
    rows = {part: row for row, parts in enumerate(LAYERS) for part in parts}
    part = max((p for p in rows if within(name, p)), key=len)
    return rows[part], part


def violations(name: str, used: set[str]) -> list[str]:
    row, part = part_of(name)
    forbidden = {u for u in used if part_of(u)[1] != part and part_of(u)[0] >= row}
    if within(name, "tabletopgen_env") and name != "tabletopgen_env.__main__":
        allowed = (*OF_GENERATOR, "tabletopgen_env", "assets_cache")
        forbidden |= {u for u in used if not any(within(u, a) for a in allowed)}
    return sorted(forbidden - {"generator", "tabletopgen_env", name})


@pytest.mark.parametrize("package", PACKAGES)
def test_every_module_imports_earlier_layers_only(package: str) -> None:
    wrong = {
        name: found
        for name, path in modules()
        if within(name, package) and (found := violations(name, imports(name, path)))
    }
    assert wrong == {}


def test_no_stage_imports_another_stage() -> None:
    whole = ("generator.method.publish", "generator.method.figures")
    stages = [(n, p) for n, p in modules() if within(n, "generator.method") and n not in whole]
    assert len(stages) > 3
    for name, path in stages:
        own = ".".join(name.split(".")[:3])
        used = {u for u in imports(name, path) if within(u, "generator.method")}
        assert {u for u in used if not within(u, own)} <= {"generator.method"}, name


def test_no_imports_close_a_circle() -> None:
    known = dict(modules())
    graph = {name: imports(name, path) & {*known} - {name} for name, path in known.items()}
    done: set[str] = set()
    while free := [n for n, used in graph.items() if n not in done and used <= done]:
        done.update(free)
    assert {*graph} - done == set()


def test_the_rules_can_fail() -> None:
    assert violations("generator.method.rotation", {"generator.backends.embedded.encoder"})
    assert violations("generator.backends.cloud.imager", {"generator.backends.embedded.imager"})
    assert violations("generator.physics.mjcf", {"tabletopgen_env.env"})
    assert violations("tabletopgen_env.env", {"generator.stand_ins"})
    assert not violations("tabletopgen_env.env", {"generator.bundle"})


# Packages whose import has another name than their distribution.
DISTRIBUTIONS = {
    "array_api_compat": "array-api-compat",
    "stable_baselines3": "stable-baselines3",
    "PIL": "pillow",
    "cv2": "opencv-python-headless",
    "fast_simplification": "fast-simplification",
    "pxr": "usd-core",
    "pydrake": "drake",
    "OpenGL": "pyopengl",
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
    """Every imported package is a dependency, and vice versa."""
    used, learning, recording, cloud = set(), set(), set(), set()
    many, hub, others, by_hand = set(), set(), set(), set()
    served, charted, decoded = set(), set(), set()
    extras = {
        "tabletopgen_env.learning": learning,
        "tabletopgen_env.recording": recording,
        "tabletopgen_env.teleoperation": by_hand,
        "tabletopgen_web.study": charted,
        "tabletopgen_web.studio": served,
        "generator.meshes.reading.codecs": decoded,
        "generator.calls": cloud,
        "generator.backends.cloud": cloud,
        "generator.backends.modelers": cloud,
        "generator.jobs": many,
        "generator.exports": others,
        "generator.backends.huggingface": hub,
    }
    for name, path in modules():
        own = (packages for part, packages in extras.items() if within(name, part))
        next(own, used).update(foreign(path))
    assert used | ((cloud | many | hub | others) & declared()) | INDIRECT == declared()
    adapter = declared("rsl") - {"rsl-rl-lib"}  # which steps worlds, and is not imported
    assert learning - declared() == declared("train") | declared("plot") | adapter
    assert recording - declared() == declared("record") | declared("lerobot")
    assert many - declared() == declared("ray")
    assert others - declared() == declared("usd") | declared("engines")
    assert decoded - declared() == declared("gltf")
    assert by_hand - declared() == declared("teleop")
    assert served - declared() == declared("studio")
    assert charted - declared() == declared("plot")
    assert cloud - declared() <= declared("cloud")
    assert hub - declared() <= declared("huggingface")
    assert {line.split("==")[0] for line in constraints()} >= declared()


def constraints() -> list[str]:
    lines = (ROOT / "constraints.txt").read_text().splitlines()
    return [line for line in lines if line and not line.startswith("#")]
