"""Decisions use the fields of a gate's failures, never their text: checked on the source itself.

A failure reaches an expression by the attribute ``failures`` or ``failure_text``, or by a variable
whose name says so; whatever such an expression is assigned to, or iterated into, counts as well.
"""

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
SOURCES = sorted(
    path
    for folder in ("generator", "tabletopgen_env", "tabletopgen_web", "benchmarks", "examples")
    for path in (ROOT / folder).rglob("*.py")
)
NAMES = {"failure", "failures", "failure_text"}
TEXT_METHODS = {name for name in dir(str) if not name.startswith("_")} - {"join", "count", "index"}
PATTERNS = {"re", "fnmatch", "difflib", "shlex"}


def text_operations(source: str) -> list[int]:
    """Return the lines of a source that parse or compare a failure's text."""
    tree = ast.parse(source)
    functions = [n for n in ast.walk(tree) if isinstance(n, ast.FunctionDef)]
    return sorted({line for scope in (tree, *functions) for line in _operations(scope)})


def _operations(scope: ast.AST) -> list[int]:
    names = set(NAMES)
    while new := {n for node in ast.walk(scope) for n in _assigned(node, names)} - names:
        names |= new
    nodes = (node for node in ast.walk(scope) if isinstance(node, ast.expr))
    return [node.lineno for node in nodes if _operates(node, names)]


def _assigned(node: ast.AST, names: set[str]) -> set[str]:
    """Return the variables to which a node assigns a failure or its text."""
    if isinstance(node, ast.Assign) and _holds(node.value, names):
        targets = node.targets
    else:
        match node:
            case (
                ast.comprehension(iter=value, target=target)
                | ast.For(iter=value, target=target)
                | ast.NamedExpr(value=value, target=target)
            ):
                targets = [target] if _holds(value, names) else []
            case _:
                targets = []
    return {t.id for target in targets for t in ast.walk(target) if isinstance(t, ast.Name)}


def _holds(node: ast.AST | None, names: set[str]) -> bool:
    """Return whether an expression is a failure, several, or their text."""
    match node:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name in names if isinstance(node, ast.Name) else name in NAMES
        case ast.Subscript(value=value) | ast.Starred(value=value):
            return _holds(value, names)
        case ast.FormattedValue(value=value):
            return _holds(value, names)
        case ast.JoinedStr(values=values) | ast.Tuple(elts=values) | ast.List(elts=values):
            return any(_holds(value, names) for value in values)
        case ast.BoolOp(values=values):
            return any(_holds(value, names) for value in values)
        case ast.IfExp(body=body, orelse=other):
            return _holds(body, names) or _holds(other, names)
        case ast.GeneratorExp(elt=elt, generators=loops) | ast.ListComp(elt=elt, generators=loops):
            inner = names.union(*(_assigned(loop, names) for loop in loops))
            return _holds(elt, inner)
        case ast.Call(func=ast.Name(id="str" | "repr" | "map" | "list" | "tuple" | "sorted")):
            return any(_holds(value, names) for value in node.args)
        case ast.Call(func=ast.Attribute(attr="join")):
            return any(_holds(value, names) for value in node.args)
        case _:
            return False


def _operates(node: ast.AST, names: set[str]) -> bool:
    match node:
        case ast.Call(func=ast.Attribute(value=value, attr=method)) if method in TEXT_METHODS:
            return _holds(value, names) or (
                isinstance(value, ast.Name)
                and value.id in PATTERNS
                and any(_holds(a, names) for a in node.args)
            )
        case ast.Call(func=ast.Attribute(value=ast.Name(id=module))) if module in PATTERNS:
            return any(_holds(a, names) for a in node.args)
        case ast.Compare(ops=ops, comparators=others, left=left):
            texts = [left, *others]
            contains = any(isinstance(op, ast.In | ast.NotIn) for op in ops)
            literal = any(isinstance(t, ast.Constant) and isinstance(t.value, str) for t in texts)
            return (contains or literal) and any(_holds(t, names) for t in texts)
        case _:
            return False


@pytest.mark.parametrize(
    "line",
    [
        "words = report.failures[0].split()",
        "moved = [f for f in failures if ' moved ' in f]",
        "moved = [f for f in failures if ' moved ' in str(f)]",
        "moved = [t for t in map(str, scene.report.failures) if t.startswith(name)]",
        "text = '; '.join(map(str, report.failures))\nfloats = 'floats' in text",
        "floats = name in report.failure_text",
        "text = f'{failure}'\nfound = re.search('moved', text)",
        "for one in report.failures:\n    if str(one) == 'mug floats':\n        pass",
        "def f(failure):\n    said = str(failure)\n    return said.partition(' ')",
    ],
)
def test_an_operation_on_the_text_of_a_failure_is_found(line: str) -> None:
    assert text_operations(line)


@pytest.mark.parametrize(
    "line",
    [
        "names = {name for failure in report.failures for name in failure.objects}",
        "told = '; '.join(str(f) for f in failures if name in f.objects)",
        "restless = failure.kind in ('moved', 'turned')",
        "self.failures += 1\nif failures == 3:\n    pass",
    ],
)
def test_fields_and_messages_are_free(line: str) -> None:
    assert not text_operations(line)


def test_no_decision_rests_on_the_text_of_a_failure() -> None:
    assert len(SOURCES) > 600
    found = [
        f"{path.relative_to(ROOT)}:{line}"
        for path in SOURCES
        if "failure" in (source := path.read_text(encoding="utf-8"))
        for line in text_operations(source)
    ]
    assert not found, found
