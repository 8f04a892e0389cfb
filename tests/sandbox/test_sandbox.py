"""Functions run in a child process with limits."""

import os
import resource
import signal
import subprocess
import sys
import threading
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from generator.errors import InputError
from generator.sandbox import CpuBudget, SandboxError, SandboxLimits, call, runner
from generator.sandbox.runner import memory_text
from generator.sandbox.serialization import class_name, pack, unpack


@dataclass(frozen=True)
class Pair:
    left: np.ndarray
    right: tuple[Any, ...]


def echo(*args: object) -> object:
    return args


def pair(array: np.ndarray) -> Pair:
    return Pair(array * 2, ("words", None, 1.5, b"raw", Path("a/b"), {"k": [1, 2]}))


def spin() -> None:
    while True:
        pass


def burn(seconds: float) -> None:
    end = time.process_time() + seconds
    while time.process_time() < end:
        pass


def fill() -> int:
    return len(bytearray(2**40))


def grow() -> None:
    held = []
    while True:
        held.append(np.ones(2**22))


def pour() -> bytes:
    return bytes(2**24)


def crash() -> None:
    os.abort()


def blunder() -> None:
    raise KeyError("a parser's own")


def wrapped() -> None:
    try:
        fill()
    except MemoryError:
        raise RuntimeError("the parser failed") from None


def lament() -> None:
    raise RuntimeError("std::bad_alloc")


def end_in_words() -> None:
    os.write(2, b"terminate called\n  what():  std::bad_alloc\n")
    os.abort()


def fall() -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def hang_silently() -> None:
    os.closerange(0, 64)
    time.sleep(600)


def refuse() -> None:
    raise InputError("Nothing of this can be used.")


def write() -> str:
    try:
        Path("left_behind").write_text("text")
    except OSError as error:
        return type(error).__name__
    return "written"


def chatter() -> str:
    print("words on standard output" * 10_000)
    sys.stderr.write("words on standard error" * 10_000)
    return "answer"


def limits_inside() -> list[int]:
    kinds = (resource.RLIMIT_CPU, resource.RLIMIT_AS, resource.RLIMIT_CORE)
    return [resource.getrlimit(kind)[0] for kind in kinds]


def nested() -> int:
    return call(os.getpid) - os.getpid()


def sleep() -> None:
    time.sleep(600)


def test_values_come_back_as_they_were() -> None:
    array = np.arange(12, dtype=np.float32).reshape(3, 4)
    empty = np.zeros((0, 3))
    back = call(echo, array, "text", empty, 3, None, True, (1, [2.5, {"a": b"b"}]))
    assert np.array_equal(back[0], array) and back[0].dtype == array.dtype
    assert back[2].shape == (0, 3)
    assert (back[1], *back[3:]) == ("text", 3, None, True, (1, [2.5, {"a": b"b"}]))


def test_dataclasses_come_back_if_they_are_expected() -> None:
    found = call(pair, np.arange(3), returns=(Pair,))
    assert found.left.tolist() == [0, 2, 4]
    assert found.right == ("words", None, 1.5, b"raw", Path("a/b"), {"k": [1, 2]})
    with pytest.raises(SandboxError, match="not one of the expected"):
        call(pair, np.arange(3))


def test_an_array_used_twice_is_one_array() -> None:
    array = np.zeros((50, 50))
    raw = pack([array, array])
    assert len(raw) < 1.5 * array.nbytes
    first, second = unpack(raw, lambda name: object)
    assert first is second


@pytest.mark.parametrize("cut", [0, 3, 12, 40, -100])
def test_a_damaged_answer_is_refused(cut: int) -> None:
    raw = pack({"a": np.arange(100)})
    with pytest.raises(ValueError, match=r"packed value|cut off|Expecting|Unterminated|utf"):
        unpack(raw[:cut], lambda name: object)


def test_an_array_larger_than_its_buffer_is_refused() -> None:
    raw = pack(np.zeros(4)).replace(b'"shape": [4]', b'"shape": [9]')
    with pytest.raises(ValueError, match="bytes"):
        unpack(raw, lambda name: object)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (b'"<f8"', b'"(((((("'), (b'"<f8"', b'"O"'), (b'"<f8"', b'"<f99"'),
        (b'"shape": [4]', b'"shape": [1e999]'), (b'"shape": [4]', b'"shape": {"a": 4}'),
        (b'{"array"', b'{"dict": 3, "x"'),
        (b'{"array": 0', b'{"array": 99999999999999999999'),
        (b'{"array": 0, "dtype": "<f8", "shape": [4]}', b'{"enum": "x", "name": 3}'),
        (b'{"array": 0, "dtype": "<f8", "shape": [4]}', b'{"path": 3}'),
        (b'{"array": 0, "dtype": "<f8", "shape": [4]}', b"[" * 200 + b"]" * 200),
        (b'{"tree"', b"[3]#"),
    ],
)  # fmt: skip
def test_a_damaged_head_is_a_value_error(old: bytes, new: bytes) -> None:
    raw = pack(np.zeros(4))
    length = int.from_bytes(raw[4:12], "little")
    head = raw[12 : 12 + length].replace(old, new)
    assert old in raw
    damaged = raw[:4] + len(head).to_bytes(8, "little") + head + raw[12 + length :]
    with pytest.raises(ValueError, match=r".") as caught:
        unpack(damaged, lambda name: object)
    assert not isinstance(caught.value, InputError)


def test_the_head_is_bounded() -> None:
    head = b"[" + b"0," * 5_000_000 + b"0]"
    with pytest.raises(ValueError, match="values"):
        unpack(b"ttg1" + len(head).to_bytes(8, "little") + head, lambda name: object)


def test_objects_are_not_packed() -> None:
    for value in (object(), np.array([object()]), {1: 2}):
        with pytest.raises(TypeError):
            pack(value)


def test_names_of_classes() -> None:
    assert class_name(SandboxLimits) == "generator.sandbox.runner:SandboxLimits"


@pytest.mark.parametrize(
    ("function", "limits", "breach"),
    [
        (spin, SandboxLimits(cpu_seconds=0.5), "time"),
        (fill, SandboxLimits(), "memory"),
        (grow, SandboxLimits(memory=2**28), "memory"),
        (pour, SandboxLimits(output=2**20), "output"),
        (crash, SandboxLimits(), "crash"),
        (blunder, SandboxLimits(), "parser"),
        (wrapped, SandboxLimits(), "memory"),
        (lament, SandboxLimits(), "parser"),
        (end_in_words, SandboxLimits(), "crash"),
        (fall, SandboxLimits(), "killed"),
    ],
)
def test_a_child_that_goes_wrong_is_one_error(
    function: Any, limits: SandboxLimits, breach: str
) -> None:
    with pytest.raises(SandboxError) as caught:
        call(function, limits=limits)
    assert caught.value.breach == breach


@pytest.mark.parametrize("function", [lament, end_in_words])
def test_words_choose_the_message_alone(function: Any) -> None:
    with pytest.raises(SandboxError) as caught:
        call(function)
    assert str(caught.value) == memory_text(SandboxLimits().memory)


def test_a_kill_from_outside_is_not_called_a_limit() -> None:
    with pytest.raises(SandboxError, match="the system killed its parser"):
        call(fall)


def test_a_child_that_closes_its_pipes_and_goes_on_is_ended(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(runner, "_ENDING", 0.5)
    with pytest.raises(SandboxError) as caught:
        call(hang_silently)
    assert caught.value.breach == "hung"


@pytest.mark.slow
def test_a_limit_of_memory_is_not_called_inherited() -> None:
    with pytest.raises(SandboxError) as caught:
        call(grow, limits=SandboxLimits(memory=2**28))
    assert str(caught.value) == memory_text(2**28)


def test_no_process_to_start_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "/nowhere/python")
    with pytest.raises(SandboxError, match="no process"):
        call(chatter)


def test_errors_of_the_project_are_raised_as_they_are() -> None:
    with pytest.raises(InputError, match="Nothing of this"):
        call(refuse)


def test_nothing_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    assert call(write) in ("FileNotFoundError", "OSError")
    assert [*tmp_path.iterdir()] == []


def test_what_libraries_print_is_no_part_of_the_answer() -> None:
    assert call(chatter) == "answer"


def test_calls_inside_a_child_start_no_other() -> None:
    assert call(nested) == 0


def test_no_environment_switches_the_sandbox_off(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TABLETOPGEN_SANDBOX", "1")
    assert call(os.getpid) != os.getpid()


def test_calls_take_their_time_from_a_budget() -> None:
    budget = CpuBudget(2.0)
    call(burn, 0.3, budget=budget)
    assert 1.0 < budget.left < 1.71
    for _ in range(2):
        with pytest.raises(SandboxError) as caught:
            call(spin, budget=budget)
        assert caught.value.breach == "time"
        assert budget.left == 0


def test_a_call_inside_a_child_takes_its_time_from_a_budget(inline: None) -> None:
    budget = CpuBudget(2.0)
    call(burn, 0.1, budget=budget)
    assert 1.0 < budget.left < 1.91


def test_a_call_is_cancelled() -> None:
    cancelled = threading.Event()
    timer = threading.Timer(1.0, cancelled.set)
    timer.start()
    with pytest.raises(SandboxError) as caught:
        call(sleep, cancelled=cancelled)
    timer.join(timeout=10)
    assert caught.value.breach == "cancelled"


_UNDER_LIMITS = """
import resource, sys
for kind in (resource.RLIMIT_CPU, resource.RLIMIT_AS):
    soft, hard = resource.getrlimit(kind)
memory = int(sys.argv[1])
resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
resource.setrlimit(resource.RLIMIT_CPU, (50, 60))
import test_sandbox
from generator.sandbox import SandboxLimits, call
print(*call(test_sandbox.limits_inside, limits=SandboxLimits(cpu_seconds=1000, memory=2**40)))
"""


def test_smaller_inherited_limits_stay() -> None:
    memory = 6 * 2**30
    done = subprocess.run(
        [sys.executable, "-c", _UNDER_LIMITS, str(memory)],
        cwd=Path(__file__).parent, capture_output=True, text=True, timeout=120, check=False,
        env={**os.environ, "PYTHONPATH": os.pathsep.join([*sys.path, str(Path(__file__).parent)])},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert [int(word) for word in done.stdout.split()] == [50, memory, 0]


_ABANDONED = """
import sys, test_sandbox
from generator.sandbox import call
print("begun", flush=True)
call(test_sandbox.sleep)
"""


def _children(pid: int) -> list[int]:
    listed = Path(f"/proc/{pid}/task/{pid}/children")
    return [int(word) for word in listed.read_text().split()] if listed.is_file() else []


@pytest.mark.skipif(sys.platform != "linux", reason="the kernel ends orphans on Linux only")
def test_a_child_ends_with_its_parent() -> None:
    parent = subprocess.Popen(
        [sys.executable, "-c", _ABANDONED], cwd=Path(__file__).parent, stdout=subprocess.PIPE,
        env={**os.environ, "PYTHONPATH": os.pathsep.join([*sys.path, str(Path(__file__).parent)])},
    )  # fmt: skip
    assert parent.stdout is not None
    try:
        assert parent.stdout.readline() == b"begun\n"
        for _ in range(600):
            children = _children(parent.pid)
            if children and _children(children[0]) == [] and _is_limited(children[0]):
                break
            time.sleep(0.05)
        assert children
    finally:
        parent.kill()
        parent.wait(timeout=30)
        parent.stdout.close()
    for _ in range(600):
        if not Path(f"/proc/{children[0]}/cmdline").is_file() or _is_zombie(children[0]):
            return
        time.sleep(0.05)
    pytest.fail("the child outlives its parent")


def _is_limited(pid: int) -> bool:
    """Return whether the child has set its limits, which follows its tie to the parent."""
    limits = Path(f"/proc/{pid}/limits").read_text()
    return any(line.startswith("Max file size") and " 0 " in line for line in limits.splitlines())


def _is_zombie(pid: int) -> bool:
    try:
        return " Z " in Path(f"/proc/{pid}/stat").read_text()
    except OSError:
        return True
