"""Files of batches and budgets: prompts, records, sums, ledgers, prices, cached answers."""

import contextlib
import functools
import hashlib
import json
import os
import random
import sqlite3
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from toy import toy_object, toy_scene

from generator import bundle
from generator import jobs as batch
from generator.calls.money.budget import SharedBudget
from generator.calls.money.database import FILE, TABLES
from generator.calls.money.entries import Entry
from generator.calls.money.ledger import Account
from generator.calls.money.prices import Prices
from generator.calls.money.scene_cost import Spending
from generator.calls.store import CallStore, StoredAnswer
from generator.errors import InputError, TabletopError
from generator.jobs import pools as batch_pools
from generator.jobs.records import PLACE, key_of
from generator.physics.gate import judge
from generator.scene import Provenance, Scene

from ..judging import accepts, accepts_any, command
from ..odd import put
from ..streams import spoiled
from ..values import TEXTS, mutate, number, text, written
from . import Run

_OUTSIDE = (
    "../../precious", "../../../precious", "../beside.txt", "../../poetry", "../../../poetry", ".",
    "..", "../..", "../precious", "../../inside/precious", ".batch",
)  # fmt: skip


def outside(folder: Path) -> tuple[str, ...]:
    """Return names that lead from a case's folder to the canaries."""
    root = folder.parents[1]
    return (*_OUTSIDE, str(root / "precious"), str(root / "poetry"), str(root / "precious/poetry"))


# ---------------------------------------------------------------------------------------- prompts
def prompts(rng: random.Random, folder: Path) -> Run:
    """Prompt files, plain and JSON, and the command that reads them."""
    told: Any = ["a desk", {"text": "a table", "seed": 3}, {"text": "x.png"}]
    path = folder / rng.choice(("p.txt", "p.json", "p.json", "p.JSON", "\u202ep.json"))
    content = written(mutate(told, rng, raw=True), rng)
    if rng.random() < 0.3:
        content = "\n".join(text(rng) for _ in range(rng.choice((1, 20)))).encode(
            "utf-8", "surrogatepass"
        )
    if rng.random() < 0.1:
        content = spoiled(content, rng)
    if rng.random() < 0.03:
        content = b"a mug\n" * 200_000 if rng.random() < 0.5 else b'["a"' + b',"a"' * 500_000 + b"]"
    put(path, content, rng)
    device = rng.random() < 0.02
    seed, variants = number(rng), rng.choice((1, 2, number(rng)))

    def run() -> bool:
        chosen = Path("/dev/zero") if device else path
        found: list[Any] = []
        good = accepts(lambda: found.append(batch.read_prompts(chosen)))
        accepts(lambda: batch.read_prompts(chosen, seed))
        if found:
            accepts(lambda: batch.jobs_of(found[0], variants=variants))
        else:  # unreadable files must end the command before any work
            good |= command("batch", str(chosen), "--out", "out", "--route", "compose")
        return good

    return run


# ----------------------------------------------------------------------------------------- batches
@functools.cache
def _scene() -> Scene:
    scene = toy_scene((toy_object("cube_1", (0.05, 0.05, 0.05), (0.0, 0.0)),))
    return scene.replace(report=judge(scene), provenance=Provenance("text", 0, "a cube"))


@dataclass(frozen=True)
class StubMaker:
    def identity(self) -> dict[str, Any]:
        return {"route": "stub"}

    def __call__(self, job: batch.Job, folder: Path) -> Path:
        """Publish the scene; "bad" texts cannot be made."""
        if job.text == "bad":
            raise InputError("It cannot be read.")
        return bundle.save(_scene(), folder)


class Inline:
    """A worker pool without processes, which runs tasks immediately."""

    width = 1

    def __init__(self, width: int) -> None:
        """Accept any width."""

    def submit(self, function: Callable[..., Any], *args: Any) -> Future[Any]:
        done: Future[Any] = Future()
        done.set_result(function(*args))
        return done

    def close(self, grace: float = 0.0) -> None:
        """Do nothing."""


def batches(rng: random.Random, folder: Path) -> Run:
    """Batch folders with foreign records, resumed by a batch."""
    place = folder / "batch"
    make = StubMaker()
    texts = rng.sample(("a cube", "bad", "two", "x" * 300, "../../precious"), 2)
    kept = f"{_scene().name}-{'0' * 12}"
    for job in texts:
        key = key_of(batch.Job(job, 0), make)
        record: Any = {
            "text": job, "seed": 0, "bundle": kept, "kind": None, "error": None,
            "seconds": 1.0, "gate": {"objects": 1, "penetration_mm": 0.1},
        }  # fmt: skip
        if rng.random() < 0.3:
            record |= {"bundle": None, "kind": "InputError", "error": text(rng)}
        if rng.random() < 0.5:
            record["bundle"] = text(rng, outside(folder))
        else:
            record = mutate(record, rng, (*outside(folder), "InputError", "SceneError"), raw=True)
        put(place / PLACE / f"{key}.json", written(record, rng), rng)
        _begun(place, key, record, rng)
    _put_money(place / PLACE, rng, folder, share=0.1)
    retry = rng.random() < 0.3

    def run() -> bool:
        before = batch_pools.WorkerPool
        batch_pools.WorkerPool = Inline  # type: ignore[assignment,misc]
        try:
            return accepts(
                lambda: batch.run(texts, place, make, retry=retry),
                lambda: batch.run(texts, place, make),
            )
        finally:
            batch_pools.WorkerPool = before  # type: ignore[misc]

    return run


def _begun(place: Path, key: str, record: Any, rng: random.Random) -> None:
    """Create possible remains of a killed batch: an unpublished bundle, and a lock."""
    own = place / PLACE / key
    kind = rng.randrange(5)
    named = record.get("bundle") if isinstance(record, dict) else None
    if kind < 3:
        own.mkdir(parents=True, exist_ok=True)
        if kind == 0:
            bundle.save(_scene(), own)
        if kind == 1 and isinstance(named, str) and named.isprintable() and len(named) < 100:
            inner = own / named.lstrip("/").replace("..", "up")
            inner.mkdir(parents=True, exist_ok=True)
    elif kind == 3:
        own.symlink_to(rng.choice(("../..", "../../../precious", key)))
    lock = place / PLACE / f"{key}.lock"
    if rng.random() < 0.1:
        put(lock, b"", rng, share=0.9)


# ------------------------------------------------------------------------------------------- money
def _cell(value: Any, rng: random.Random) -> str | int | float | bytes | None:
    """Return a value that a database can hold."""
    if isinstance(value, str):
        return value.encode("utf-8", "replace").decode()
    if value is None or isinstance(value, float | bytes):
        return value
    if isinstance(value, int) and abs(value) < 2**63:
        return int(value)
    return written(value, rng)


def _database(rng: random.Random, **rows: list[Any]) -> bytes:
    """Return a database with rows, sometimes damaged, or with a missing or additional table."""
    with contextlib.closing(sqlite3.connect(":memory:")) as made:
        for table in TABLES:
            made.execute(table)
        for table, told in rows.items():
            for row in told:
                marks = ", ".join("?" * len(row))
                made.execute(f"INSERT INTO {table} VALUES ({marks})", [_cell(v, rng) for v in row])
        if rng.random() < 0.1:
            made.execute(rng.choice((
                "DROP TABLE held", "CREATE TABLE other (a)", "DROP INDEX calls_of_scenes",
                "CREATE TRIGGER t AFTER UPDATE ON spent BEGIN UPDATE spent SET money = 0; END",
                "CREATE VIEW v AS SELECT * FROM spent",
            )))  # fmt: skip
        made.commit()
        content = made.serialize()
    return spoiled(content, rng) if rng.random() < 0.3 else content


def _put_money(place: Path, rng: random.Random, folder: Path, share: float = 0.9) -> None:
    """Put a shared budget into a folder, and possible files beside it."""
    if rng.random() > share:
        return
    spent, held = ["m", "USD", 1.0, 0], [1, "0123456789abcdef", 2.0]
    if rng.random() < 0.6:
        spent[rng.randrange(4)] = rng.choice((text(rng, outside(folder)), number(rng), None))
    if rng.random() < 0.6:
        held[rng.randrange(1, 3)] = rng.choice((text(rng, outside(folder)), number(rng), None))
    put(place / FILE, _database(rng, spent=[spent] * rng.choice((1, 1, 1, 0, 2)), held=[held]), rng)
    if rng.random() < 0.1:
        name = str(folder.parents[1] / "precious").encode()
        put(place / f"{FILE}-journal", b"x" * 512 + name + b"\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", rng)
    spenders = place / "spenders"
    if rng.random() < 0.1:
        spenders.symlink_to(rng.choice(("../../precious", "../precious", "spenders")))
    elif rng.random() < 0.3:
        put(spenders / "0123456789abcdef.lock", b"", rng, share=0.5)
    if rng.random() < 0.05:
        put(place / "spent.json", b"{}", rng, share=0.5)


def budgets(rng: random.Random, folder: Path) -> Run:
    """Budgets that several processes share."""
    place = folder / "batch" / PLACE
    place.mkdir(parents=True)
    _put_money(place, rng, folder)
    budget = rng.choice((None, 5.0, 0.0))

    def spend() -> None:
        shared = SharedBudget.open(place, "USD")
        shared.total()
        with shared.spending() as spender:
            reservation = spender.reserve(0.5, budget, "a call")
            if reservation is not None:
                spender.settle(reservation, 0.25)
        shared.total()

    return lambda: accepts(spend, lambda: batch.shared_budget(folder / "batch"))


def ledgers(rng: random.Random, folder: Path) -> Run:
    """Ledgers of earlier runs, a row per call."""
    good: Any = {
        "key": "0" * 64, "time": 1.0, "currency": "USD", "server": "cloud",
        "question": "plan_scene", "model": "m", "outcome": "answered", "seconds": 1.0,
        "tokens_in": 5, "tokens_out": 6, "images": 0, "money": 0.5, "earlier": False,
    }  # fmt: skip
    told = [written({**good, "money": rng.choice((None, 1, 0.1))}, rng)]
    if rng.random() < 0.7:
        told += [written(mutate(good, rng, raw=True), rng) for _ in range(rng.choice((1, 3)))]
    told = [row.decode("utf-8", "replace") if rng.random() < 0.9 else row for row in told]
    spending = Spending(folder / "calls", "scene")
    content = _database(rng, calls=[(None, "scene", row) for row in rng.sample(told, len(told))])
    put(spending.path, content, rng)
    prices = Prices.default()

    def read() -> None:
        account = Account()
        account.resume(spending, prices)
        with account.reserving(0.1, 1e12, "a call", lambda: None) as enter:
            enter(Entry("cloud", "plan_scene"))
        account.text()
        json.dumps(account.facts(prices))
        account.save(folder, prices)

    def write() -> None:
        spending.write("0" * 64, Entry("cloud", "plan_scene"))

    return lambda: accepts(read, write, read)


def prices(rng: random.Random, folder: Path) -> Run:
    """Tables of prices."""
    table: Any = {
        "date": "2026-01-01", "currency": "USD",
        "models": {"m": {"input": 1.0, "output": 10.0, "picture": 100},
                   "@host:80": {"call": 0.1, "image": 0.5}},
    }  # fmt: skip
    content = toml(mutate(table, rng)) if rng.random() < 0.8 else _bad_toml(rng)
    if rng.random() < 0.1:
        content = spoiled(content, rng)
    path = folder / "prices.toml"
    put(path, content, rng)

    def read() -> None:
        found = Prices.load(path)
        for model in ("m", "x/m-2026-01-01", "other"):
            price = found.price(model, "host:80")
            if price is not None:
                price.of(5, 6, 1)

    return lambda: accepts(read)


def toml(table: Any) -> bytes:
    """Return values as TOML, even if TOML cannot represent them."""
    if not isinstance(table, dict):
        return _toml_value(table).encode("utf-8", "surrogatepass")
    lines = [f"{_toml_key(k)} = {_toml_value(v)}" for k, v in table.items()]
    return "\n".join(lines).encode("utf-8", "surrogatepass")


def _toml_key(key: Any) -> str:
    return json.dumps(str(key))


def _toml_value(found: Any) -> str:
    if isinstance(found, dict):
        inner = ", ".join(f"{_toml_key(k)} = {_toml_value(v)}" for k, v in found.items())
        return "{" + inner + "}"
    if isinstance(found, list | tuple):
        return "[" + ", ".join(map(_toml_value, found)) + "]"
    if isinstance(found, str):
        return json.dumps(found).replace("\\ud800", "\\uD800")
    if isinstance(found, bool):
        return str(found).lower()
    return "1979-05-27T07:32:00Z" if found is None else str(found)


def _bad_toml(rng: random.Random) -> bytes:
    size = rng.choice((100, 3000, 100_000))
    return rng.choice((
        b"a = " + b"[" * size, b"a = " + b"{a=" * size, b"[" * size, b"a." * size + b"b = 1",
        b"a = 1\na = 2", b"[a]\n[a]", b"a = 1e400", b"a = nan", b"a = 0x" + b"f" * size,
        b"a = 1" + b"0" * size, b'a = "\\ud800"', b"\xff\xfe", b"\x00", b"a = '''" + b"x" * size,
        b"[models]\n" + b"".join(b'"%d" = {}\n' % k for k in range(size // 20)), b"[models.m]\n",
        b"models = 1", b"models = []", b"[[models]]", b"a = 2026-13-45", b"=", b"a" * size,
    ))  # fmt: skip


def calls(rng: random.Random, folder: Path) -> Run:
    """Cached answers: damaged, forged with matching sums, or not files at all."""
    place = folder / "calls"
    key = hashlib.sha256(b"question").hexdigest()
    facts: Any = {"status": 200, "content_type": "application/json"}
    head = written(mutate(facts, rng, raw=True), rng) if rng.random() < 0.8 else rng.randbytes(20)
    content = head.replace(b"\n", b" ") + b"\n" + rng.randbytes(rng.choice((0, 10, 10_000)))
    check = hashlib.sha256(key.encode() + b"\n" + content).hexdigest().encode()
    raw = b"tabletopgen call 1 " + check + b"\n" + content
    if rng.random() < 0.3:
        raw = spoiled(raw, rng)
    home = place / "answers" / key[:2]
    put(home / key, raw, rng, share=0.15)
    for _ in range(rng.randrange(3)):
        name = rng.choice((f".partial-{key}-x", "x", "\x1b[2J", key[::-1], ".partial-old"))
        if not os.path.lexists(home / name):
            put(home / name, b"x", rng, share=0.5)
    if rng.random() < 0.1:
        put(place / "locks" / f"{key[:3]}.lock", b"", rng, share=0.9)
    wrong = text(rng, outside(folder))
    most = rng.choice((100, 10_000, 2**30))

    def use() -> None:
        store = CallStore(place, most)
        with store.holding(key):
            found = store.get(key)
            if found is not None:
                found.body.decode("latin-1")
                assert isinstance(found.status, int) and isinstance(found.content_type, str)
            store.put(key, StoredAnswer(200, "text/plain", b"x" * 50))
            store.get(key)
        len(store)
        store.size()
        store.forget(key)

    return lambda: accepts_any(use, lambda: CallStore(place).get(wrong))


# ------------------------------------------------------------------------------------------- store
def stores(rng: random.Random, folder: Path) -> Run:
    """Bundle names from users: to find, to save as, to remove."""
    import assets_cache

    store = folder / "store"
    bundle.save(_scene(), store)
    extra = (*outside(folder), "toy", "toy-*", str(store), str(store / "*"), "starter", "0" * 12)
    wanted = rng.choice((*TEXTS, *extra, *extra))
    if rng.random() < 0.3:
        wanted = mutate(rng.choice(extra), rng)
        wanted = wanted if isinstance(wanted, str) else str(wanted)
    scene = _scene().replace(name=wanted)
    asked = rng.random() < 0.2

    def run() -> bool:
        good = accepts_any(
            lambda: _quietly(lambda: assets_cache.find(wanted, store)),
            lambda: bundle.save(scene, folder / "other"),
            lambda: _quietly(lambda: bundle.load(wanted)),
        )
        bundle.verify(wanted)
        if asked and wanted.isprintable():
            os.environ["TABLETOPGEN_CACHE"] = str(store)
            command("cache", "list", wanted)
            command("inspect", wanted)
        accepts(lambda: _quietly(lambda: assets_cache.remove(wanted, store)))
        return good

    return run


def _quietly(call: Callable[[], Any]) -> None:
    """Make a call whose error may repeat the user's input, including control characters."""
    try:
        call()
    except TabletopError:
        raise InputError("refused") from None
