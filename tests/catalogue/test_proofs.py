"""Proofs: what a category's digest covers, and what is recorded."""

from __future__ import annotations

from pathlib import Path

import proofs
import pytest
from proofs import Digests, Proofs

from tabletop_objects import CATEGORIES

FILES = {
    "kit/solids.py": "def box():\n    '''Draw.'''\n    return 1\n",
    "kit/styles.py": "THICK = 2\n",
    "kit/unused.py": "x = 1\n",
    "objects/cups.py": "from ..kit.solids import box\nmug = box()\n",
    "objects/pens.py": "from ..kit import solids\npen = solids.box()\n",
    "objects/pins.py": "pin = 3\n",
}


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    for name, code in FILES.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(code)
    return tmp_path


def digests_of(root: Path) -> dict[str, str]:
    made = Digests({}, root)
    return {key: made.of(key, f"objects.{key}") for key in ("cups", "pens", "pins")}


def find_changes(root: Path, name: str, code: str) -> set[str]:
    """Return the keys whose digests change with a file."""
    before = digests_of(root)
    (root / name).write_text(code)
    after = digests_of(root)
    return {key for key in before if before[key] != after[key]}


def test_proofs_name_categories_that_exist() -> None:
    known = proofs.load()
    left = len(proofs.unproven(known, proofs.digests()))
    gone = sorted(set(known.categories) - set(CATEGORIES))
    assert not gone, (
        f"{left} categories are unproven: TABLETOPGEN_RECORD_PROOFS=1 make test-catalogue"
    )


def test_a_category_depends_on_what_its_module_imports(tree: Path) -> None:
    assert find_changes(tree, "kit/solids.py", "def box():\n    return 2\n") == {"cups", "pens"}
    assert find_changes(tree, "objects/pins.py", "pin = 4\n") == {"pins"}
    assert find_changes(tree, "kit/unused.py", "x = 2\n") == set()
    assert find_changes(tree, "kit/styles.py", "THICK = 3\n") == {"cups", "pens", "pins"}


def test_comments_docstrings_and_layout_do_not_count(tree: Path) -> None:
    code = "'''Solids.'''\n\ndef box():  # a box\n    '''Draw a box.'''\n\n    return 1\n"
    assert find_changes(tree, "kit/solids.py", code) == set()


def test_error_messages_do_not_count(tree: Path) -> None:
    code = "def box():\n    if 0:\n        raise ValueError('bad')\n    return 1\n"
    (tree / "kit/solids.py").write_text(code)
    assert find_changes(tree, "kit/solids.py", code.replace("bad", "The box is bad.")) == set()
    assert find_changes(tree, "kit/solids.py", code.replace("if 0", "if 1")) == {"cups", "pens"}


def test_docstrings_of_constants_do_not_count(tree: Path) -> None:
    code = "THICK = 2\n'''Thickness of a wall, metres.'''\n"
    assert find_changes(tree, "kit/styles.py", code) == set()


def test_known_modules_are_not_parsed(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = Digests({}, tree)
    digest = first.of("cups", "objects.cups")
    monkeypatch.setattr(proofs.ast, "parse", lambda code: pytest.fail("parsed"))
    assert Digests(first.modules, tree).of("cups", "objects.cups") == digest


def test_what_passed_is_recorded_and_what_failed_is_dropped(tmp_path: Path) -> None:
    now = proofs.digests()
    path = tmp_path / "proven.json"
    stale = {"mug": "old", "bowl": now["bowl"], "plate": now["plate"], "no such object": "x"}
    proofs.save(Proofs({}, stale), path)
    proofs.record({"mug": now["mug"], "fork": now["fork"]}, {"bowl", "fork"}, path)
    found = proofs.load(path)
    assert found.categories == {"mug": now["mug"], "plate": now["plate"]}
    left = proofs.unproven(found, now)
    assert "mug" not in left and {"bowl", "fork"} < {*left}
    assert len(found.modules) > 100


def test_all_or_changed_categories_are_checked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TABLETOPGEN_EVERY_CATEGORY", "1")
    assert proofs.categories_to_check() == sorted(CATEGORIES)
    monkeypatch.delenv("TABLETOPGEN_EVERY_CATEGORY")
    monkeypatch.setattr(proofs, "unproven", lambda known, now: ["mug"])
    some = proofs.categories_to_check()
    assert "mug" in some and 30 < len(some) < 100
    assert some == proofs.categories_to_check()
