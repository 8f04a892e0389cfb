"""Names, checked on the source: unique classes, functions that are verbs or nouns, plain words.

A class of one name exists once in the project. A function is named by a verb or a noun, not by a
bare participle: ``draw``, not ``drawn``. Words that this project once used in a sense of its own
are found in no name and in no text; CONTRIBUTING.md says what to write.
"""

import ast
import io
import re
import tokenize
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
CODE = (
    "tabletop_objects", "generator", "tabletopgen_env", "tabletopgen_web", "assets_cache",
    "research", "benchmarks", "examples", "docs",
)  # fmt: skip

NO_PARTICIPLES = frozenset({
    "bed", "embed", "exceed", "feed", "heed", "need", "proceed", "seed", "shed", "sled", "speed",
})  # fmt: skip
"""Nouns and verbs that end in "ed"."""

IRREGULAR = frozenset({
    "beaten", "begun", "bent", "born", "borne", "bought", "broken", "brought", "built", "caught",
    "chosen", "dealt", "done", "drawn", "driven", "eaten", "fallen", "fed", "flown", "forgotten",
    "found", "frozen", "given", "gone", "grown", "heard", "held", "hidden", "hung", "kept",
    "known", "laid", "lain", "learnt", "left", "lent", "lit", "lost", "made", "meant", "met",
    "mistaken", "overturned", "paid", "rebuilt", "redrawn", "remade", "retold", "rewritten",
    "ridden", "risen", "said", "sat", "seen", "sent", "sewn", "shaken", "shot", "shown", "shrunk",
    "slept", "sold", "sought", "spent", "spoken", "sprung", "spun", "stolen", "stood", "struck",
    "stuck", "sunk", "swept", "sworn", "taken", "taught", "thought", "thrown", "told", "torn",
    "understood", "undone", "unknown", "unmet", "unseen", "wept", "withdrawn", "won", "worn",
    "wound", "woven", "written",
})  # fmt: skip
"""Participles of irregular verbs that are no base forms: ``cut``, ``put``, ``read`` are verbs."""

GIVEN = frozenset({"namespaced"})
"""Methods whose names another package decides: ``trimesh``'s resolvers."""

WORDS = ("purse", "crew", "haste", "endless")
"""Words of no identifier, in singular or plural; any case, as parts of names too."""

PHRASES = (
    r"purses?", r"crews?", r"hastes?", r"made anew",
    r"(?:goes|go|going|gone|went) on (?:with|from)", r"(?:asks|says|knows|needs|counts) not",
)  # fmt: skip
"""Words of no docstring, comment, message and page."""


def is_participle(word: str) -> bool:
    """Return whether a name is one word that is a past participle and not a base form."""
    if "_" in word:
        return False
    return word in IRREGULAR or (word.endswith("ed") and word not in NO_PARTICIPLES)


def functions(tree: ast.AST) -> Iterator[ast.FunctionDef | ast.AsyncFunctionDef]:
    """Yield functions except properties and predicates."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            answers = ast.unparse(node.returns) if node.returns else ""
            kinds = " ".join(map(ast.unparse, node.decorator_list))
            if answers != "bool" and "TypeGuard" not in answers and "property" not in kinds:
                yield node


def bare_participles(source: str) -> list[str]:
    names = [node.name for node in functions(ast.parse(source))]
    return [n for n in names if is_participle(n.strip("_")) and n.strip("_") not in GIVEN]


def classes(source: str) -> list[str]:
    """Return the names of the public classes of a module."""
    body = ast.parse(source).body
    return [n.name for n in body if isinstance(n, ast.ClassDef) and not n.name.startswith("_")]


def own_words(source: str) -> list[str]:
    """Return the identifiers of a module that contain one of ``WORDS``."""
    tokens = tokenize.generate_tokens(io.StringIO(source).readline)
    names = {t.string for t in tokens if t.type == tokenize.NAME}
    parts = {n: re.findall(r"[A-Z]?[a-z]+|[A-Z]+", n) for n in names}
    banned = {*WORDS, *(f"{word}s" for word in WORDS)}
    return sorted(n for n, words in parts.items() if banned & {w.lower() for w in words})


def own_phrases(text: str) -> list[str]:
    """Return the occurrences of ``PHRASES`` in a text, across line and paragraph breaks."""
    joined = re.sub(r"\s*\n[\s#>]*", " ", text)
    return re.findall(rf"\b(?:{'|'.join(PHRASES)})\b", joined, flags=re.IGNORECASE)


def modules() -> list[Path]:
    """Return the modules of the project except those of objects, whose nouns may differ."""
    found = [path for package in CODE for path in sorted((ROOT / package).rglob("*.py"))]
    return [path for path in found if ROOT / "tabletop_objects" / "objects" not in path.parents]


def pages() -> list[Path]:
    return [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]


def test_a_public_class_name_exists_once() -> None:
    found = defaultdict(list)
    for path in modules():
        for name in classes(path.read_text()):
            found[name].append(path.relative_to(ROOT).as_posix())
    assert {name: paths for name, paths in found.items() if len(paths) > 1} == {}


def test_no_function_is_named_by_a_bare_participle() -> None:
    found = {p.relative_to(ROOT).as_posix(): bare_participles(p.read_text()) for p in modules()}
    assert {path: names for path, names in found.items() if names} == {}


def test_identifiers_are_plain_words() -> None:
    found = {p.relative_to(ROOT).as_posix(): own_words(p.read_text()) for p in modules()}
    assert {path: names for path, names in found.items() if names} == {}


def test_texts_are_plain_english() -> None:
    found = {
        p.relative_to(ROOT).as_posix(): own_phrases(p.read_text()) for p in [*modules(), *pages()]
    }
    assert {path: phrases for path, phrases in found.items() if phrases} == {}


@pytest.mark.parametrize(
    ("source", "names"),
    [
        ("def drawn(): ...", ["drawn"]),
        ("class A:\n    def _settled(self): ...", ["_settled"]),
        ("def f():\n    def told(): ...", ["told"]),
        ("def closed(mesh) -> bool: ...", []),
        ("class A:\n    @property\n    def found(self): ...", []),
        ("def seed(): ...\ndef cut(): ...\ndef draw_boxes(): ...", []),
    ],
)
def test_the_rule_on_functions_can_fail(source: str, names: list[str]) -> None:
    assert bare_participles(source) == names


def test_the_rules_on_words_can_fail() -> None:
    assert own_words("class Purse: ...\nbig_crews = HASTE = 1\nscrew = 2") == [
        "HASTE", "Purse", "big_crews",
    ]  # fmt: skip
    assert own_phrases('"""It is made\n    anew."""  # goes on with that') == [
        "made anew", "goes on with",
    ]  # fmt: skip
    assert own_phrases("A screw. It is regenerated.") == []
