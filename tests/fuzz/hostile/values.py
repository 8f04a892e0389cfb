"""Hostile JSON values: types swapped, sizes, numbers, names, nesting."""

import copy
import json
import math
import random
from collections.abc import Callable
from typing import Any

NUMBERS: tuple[Any, ...] = (
    math.nan, math.inf, -math.inf, 1e308, -1e308, 1e-320, 5e-324, 1e-12, 1e-7, 1e6, 1e12, 1e30,
    0, 0.0, -0.0, 1, -1, 2, 255, 256, 65536, 2**31, -(2**31), 2**53 + 1, 2**63, 2**64, 10**30,
    10**400, True, False, 0.1, 0.5, -0.5, 1e-3, 1000,
)  # fmt: skip

TEXTS: tuple[str, ...] = (
    "", " ", "\x00", "a\x00b", "\x1b[2J\x1b[Hx", "\x1b]0;title\x07", "\x9b31mred", "\u202egnp.exe",
    "\ud800", "\udfff\ud800", "\n", "a\nb", "a\r\nb\tc", "\u2028", "\ufeffx", ".", "..", "../x",
    "../beside.txt", "../../precious", "../../precious/file.txt", "../../poetry.lock", "a/../../x",
    "/nonexistent/x", "./", "a//b", "a\\b", "C:\\x", "CON", "~", "~root/x", "-", "--help", "*", "[",
    "**/x", "x" * 300, "x" * 5000, "%s%n", "{0.__class__}", "table", "nan", "inf", "1e309", "-1",
    "[bold]x[/red]", "file:///etc/passwd", "http://[::1", "https://a℀b/x", "é", "机", "𝒳", "ß",
    "<include file='../../outside.xml'/>", '"/><include file="../../outside.xml"/>', "&amp;", "]]>",
    "a:b", "0", "null", "spot", "none", "__class__", "x" * 100_000,
)  # fmt: skip

RAW: tuple[str, ...] = (
    "NaN", "-Infinity", "1e999", "-0", "-1e-400", "1" * 4400, "1" + "0" * 350, '"\\ud800"',
    '"\\u0000"', '{"a":1,"a":[]}', "[" * 200 + "]" * 200, "[" * 100_000 + "]" * 100_000,
    "[" * 100_000, '{"a":' * 3000 + "1" + "}" * 3000, "0x10", "1_000", "'x'", "", ",", "/* x */ 1",
)  # fmt: skip
"""What JSON's texts may hold where a value should be; some are no JSON."""

_MARK = "\ue000raw {}\ue001"


def number(rng: random.Random) -> Any:
    return rng.choice(NUMBERS)


def text(rng: random.Random, extra: tuple[str, ...] = ()) -> str:
    return rng.choice((*TEXTS, *extra, *extra))


def value(rng: random.Random, extra: tuple[str, ...] = ()) -> Any:
    kind = rng.randrange(8)
    if kind < 3:
        return number(rng)
    if kind < 5:
        return text(rng, extra)
    if kind == 5:
        return rng.choice(([], {}, None, [[]], [None], {"": None}))
    if kind == 6:
        return [value(rng, extra) for _ in range(rng.randrange(5))]
    return {text(rng, extra): value(rng, extra) for _ in range(rng.randrange(4))}


def mutate(given: Any, rng: random.Random, extra: tuple[str, ...] = (), raw: bool = False) -> Any:
    """Return a copy of JSON values with one to three changes.

    Args:
        given: dicts, lists, texts, numbers; left as it is.
        rng: draws the changes.
        extra: texts that mean something where the values are read, drawn more often.
        raw: also put pieces of text in that are no values; write the result with ``written``.
    """
    changed = [copy.deepcopy(given)]
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        holder, key = _place(changed, rng)
        _change(holder, key, rng, extra, raw)
    return changed[0]


def written(changed: Any, rng: random.Random, **options: Any) -> bytes:
    """Return values as JSON text, with the raw pieces inserted by ``mutate``."""
    options.setdefault("ensure_ascii", rng.random() < 0.5)
    content = json.dumps(changed, **options)
    for index, piece in enumerate(RAW):
        mark = _MARK.format(index)
        content = content.replace(json.dumps(mark), piece).replace(f'"{mark}"', piece)
    if rng.random() < 0.05:
        content = content[: rng.randrange(len(content) + 1)]
    return content.encode("utf-8", "surrogatepass")


def _place(root: list[Any], rng: random.Random) -> tuple[Any, Any]:
    """Return a container and a key in it, at any depth with equal probability."""
    holder: Any = root
    key: Any = 0
    while True:
        inner = holder[key]
        if not isinstance(inner, dict | list) or not inner or rng.random() < 0.12:
            return holder, key
        holder = inner
        key = rng.choice(list(inner)) if isinstance(inner, dict) else rng.randrange(len(inner))


def _change(holder: Any, key: Any, rng: random.Random, extra: tuple[str, ...], raw: bool) -> None:
    here = holder[key]
    if isinstance(here, bool) or here is None or rng.random() < 0.25:
        choices: list[Callable[[], Any]] = [lambda: value(rng, extra)]
    elif isinstance(here, int | float):
        choices = [lambda: number(rng), lambda: _nudged(here, rng), lambda: str(here)]
    elif isinstance(here, str):
        choices = [lambda: text(rng, extra), lambda: _spoiled(here, rng)]
    elif isinstance(here, list):
        choices = [lambda: _of_list(here, rng, extra)]
    else:
        choices = [lambda: _of_dict(here, rng, extra)]
    if raw and rng.random() < 0.15:
        choices = [lambda: _MARK.format(rng.randrange(len(RAW)))]
    drawn = rng.choice(choices)()
    if isinstance(holder, dict) and rng.random() < 0.1:
        del holder[key]
        return
    holder[key] = drawn


def _nudged(here: float, rng: random.Random) -> Any:
    try:
        return rng.choice((
            -here, here * 10 ** rng.randrange(-300, 300), here + rng.choice((1, -1, 1e-9)),
            here * rng.uniform(0.5, 2), int(here), [here], float(here),
        ))  # fmt: skip
    except (OverflowError, ValueError):
        return math.inf


def _spoiled(here: str, rng: random.Random) -> Any:
    at = rng.randrange(len(here) + 1)
    return rng.choice((
        here[:at] + rng.choice(TEXTS[:24]) + here[at:], here * 2, here.upper(), here + " ", [here],
        here[:at], here + "\x00", " " + here, {here: here}, here + "/", "./" + here,
    ))  # fmt: skip


def _of_list(here: list[Any], rng: random.Random, extra: tuple[str, ...]) -> Any:
    kind = rng.randrange(8)
    if kind == 0:
        return []
    if kind == 1:
        return here * rng.choice((2, 3, 50)) if len(here) < 1000 else here * 2
    if kind == 2:
        return here[: rng.randrange(len(here) + 1)]
    if kind == 3:
        return rng.sample(here, len(here))
    if kind == 4:
        return [*here, value(rng, extra)]
    if kind == 5:
        return [here]
    if kind == 6 and here:
        return [*here, copy.deepcopy(rng.choice(here))]
    return {str(k): inner for k, inner in enumerate(here)}


def _of_dict(here: dict[str, Any], rng: random.Random, extra: tuple[str, ...]) -> Any:
    kind, keys = rng.randrange(7), list(here)
    if kind == 0 or not keys:
        return {}
    key = rng.choice(keys)
    if kind == 1:
        return {k: v for k, v in here.items() if k != key}
    if kind == 2:
        return {**here, text(rng, extra): value(rng, extra)}
    if kind == 3:
        return {(text(rng, extra) if k == key else k): v for k, v in here.items()}
    if kind == 4:
        return {**here, key: here[rng.choice(keys)]}
    if kind == 5:
        return list(here.values())
    return {**here, key + rng.choice((" ", "s", "_1", "\x00")): here[key]}
