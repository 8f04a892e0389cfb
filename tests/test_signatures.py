"""No function takes more than ten parameters; what needs more takes a dataclass."""

import ast
from pathlib import Path

ROOT = Path(__file__).parent.parent
PACKAGES = ("tabletop_objects", "generator", "tabletopgen_env", "tabletopgen_web", "assets_cache")
MOST = 10


def too_long(tree: ast.AST) -> list[str]:
    """Return the functions and methods with more than ``MOST`` parameters, including ``self``.

    The constructor that ``dataclass`` writes is none of them: its fields are its documentation.
    """
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            own = node.args
            named = (*own.posonlyargs, *own.args, *own.kwonlyargs)
            if len(named) + (own.vararg is not None) + (own.kwarg is not None) > MOST:
                found.append(f"{getattr(node, 'name', 'lambda')}:{node.lineno}")
    return found


def test_signatures_are_short() -> None:
    paths = (path for name in PACKAGES for path in sorted((ROOT / name).rglob("*.py")))
    found = {path: too_long(ast.parse(path.read_text(encoding="utf-8"))) for path in paths}
    assert {str(path): names for path, names in found.items() if names} == {}


def test_the_rule_can_fail() -> None:
    ten = ", ".join(f"a{k}" for k in range(MOST))
    assert too_long(ast.parse(f"def f({ten}): ...")) == []
    assert too_long(ast.parse(f"class C:\n    def f({ten}, *, b): ...")) == ["f:2"]
    assert too_long(ast.parse(f"def f({ten}, **more): ...")) == ["f:1"]
    assert too_long(ast.parse(f"lambda {ten}, *more: 0")) == ["lambda:1"]
