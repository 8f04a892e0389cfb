"""A shard: some slots of a vector environment in a separate process.

It reads requests from its channel and answers each after writing its slots' rows to the shared
arrays. The step request is one byte, and so is the answer if all results are in the arrays. While
handling a request the shard can request a scene (``scene_server``).
"""

from __future__ import annotations

import os
import pickle
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any

import cloudpickle
import gymnasium as gym
from gymnasium.vector import AutoresetMode

from .arrays import SharedBlock, SlotArrays, lay_out
from .infos import NUMBERS, InfoChange, InfoWriter
from .joint import JointSlots
from .pickling import make_portable, pack
from .scene_server import AskedScenes, Wish
from .slots import Job, SlotSet, attempt

STEP, DONE = b"s", b"."
"""Message that requests a step, and that replies that all results are in the shared arrays."""


@dataclass(frozen=True)
class ShardEnvs:
    """Environments and settings of a shard.

    ``envs`` are its environments; with ``joint`` they run as ``JointSlots`` with the time limit
    ``limit``. ``asked`` is the environments' scene source if the scenes come from another process.
    """

    envs: Sequence[gym.Env]
    mode: AutoresetMode
    asked: AskedScenes | None = None
    joint: bool = False
    limit: int | None = None

    def make(self, rows: SlotArrays) -> SlotSet:
        """Create the runner of the environments, which writes to ``rows``."""
        if self.joint:
            return JointSlots(self.envs, self.mode, rows, self.limit)
        return SlotSet(self.envs, self.mode, rows)


@dataclass(frozen=True)
class ShardPlace:
    """The position of a shard among all shards, and its open files.

    Attributes:
        number: index of the shard.
        first: its first slot.
        count: number of slots of all shards.
        channels: the shards' ends of all channels.
        memory, size: the file of the shared arrays, and its size in bytes.
    """

    number: int
    first: int
    count: int
    channels: tuple[int, ...]
    memory: int
    size: int


@dataclass(frozen=True)
class ShardAnswer:
    """The answer to a request: changes to infos, and a value or the first failed slot's error."""

    changes: tuple[InfoChange, ...] = ()
    value: Any = None
    error: Exception | None = None

    @property
    def empty(self) -> bool:
        """Whether there is nothing to send."""
        return not self.changes and self.value is None and self.error is None


def serve(place: ShardPlace, packed: bytes) -> None:
    """Run a shard until its channel closes; ``packed`` is its pickled ``ShardEnvs``."""
    for channel in place.channels:
        if channel != place.channels[place.number]:
            os.close(channel)
    with Connection(place.channels[place.number]) as channel:
        try:
            shard = _Shard(channel, place, pickle.loads(packed))
        except Exception as error:
            _send(channel, ShardAnswer(error=make_portable(error)))
            return
        _send(channel, ShardAnswer(value=os.getpid()))
        try:
            while True:
                _send(channel, shard.answer(channel.recv_bytes()))
        except (EOFError, OSError):  # the vector environment was closed or has ended
            shard.close()


class _Shard:
    """The slots of a shard, the writer of their infos, and the handlers of requests."""

    def __init__(self, channel: Connection, place: ShardPlace, own: ShardEnvs) -> None:
        block, sample = SharedBlock(place.memory, place.size), own.envs[0]
        os.close(place.memory)
        assert isinstance(sample.action_space, gym.spaces.Box)
        arrays = lay_out(block.take, place.count, sample.observation_space, sample.action_space)
        numbers = block.take((NUMBERS, place.count), float)
        part = slice(place.first, place.first + len(own.envs))
        self._channel, self._own, self._first = channel, own, place.first
        self._slots = own.make(arrays.rows(part))
        self._infos = InfoWriter(numbers[:, part], place.first)
        if own.asked is not None:
            own.asked.connect(self._ask)

    def answer(self, request: bytes) -> ShardAnswer:
        """Handle a request."""
        if request == STEP:
            return self._tell(range(len(self._own.envs)), self._slots.step_all(self._first))
        try:
            what, given = pickle.loads(request)
        except Exception as error:  # unpickling may raise any exception
            return ShardAnswer(error=make_portable(error))
        return getattr(self, f"_{what}")(*given)

    def close(self) -> None:
        """Close the environments."""
        self._each(lambda k: self._own.envs[k].close(), range(len(self._own.envs)))

    def _reset(self, seeds: Mapping[int, int | None], options: dict[str, Any]) -> ShardAnswer:
        def start(k: int) -> dict[str, Any]:
            return self._slots.reset(k, seed=seeds[k], options=options or None)

        return self._tell(seeds, self._each(start, seeds))

    def _visit(self, jobs: Mapping[int, Job]) -> ShardAnswer:
        done = self._each(lambda k: jobs[k](self._own.envs[k]), jobs)
        error = _first_error(done)
        return ShardAnswer(value=None if error else done, error=error)

    def _copy(self) -> ShardAnswer:
        """Return a pickled copy of the environments, none of which has an episode."""
        return ShardAnswer(value=pack(self._own, "The slots' environments"))

    def _each(self, work: Callable[[int], Any], slots: Iterable[int]) -> list[Any]:
        return [attempt(work, k, self._first) for k in slots]

    def _tell(self, slots: Iterable[int], infos: Iterable[Any]) -> ShardAnswer:
        """Write the infos of slots; return an answer with their changes and the first error."""
        infos = list(infos)
        pairs = [(k, i) for k, i in zip(slots, infos, strict=True) if isinstance(i, dict)]
        changes = [change for k, i in pairs if (change := self._infos.write(k, i)) is not None]
        return ShardAnswer(tuple(changes), error=_first_error(infos))

    def _ask(self, wish: Wish) -> Any:
        """Request a scene, or have the source record a result."""
        self._channel.send_bytes(cloudpickle.dumps(wish))
        well, value = pickle.loads(self._channel.recv_bytes())
        if not well:
            raise value
        return value


def _first_error(done: Iterable[Any]) -> Exception | None:
    error = next((d for d in done if isinstance(d, Exception)), None)
    return None if error is None else make_portable(error)


def _send(channel: Connection, answer: ShardAnswer) -> None:
    if answer.empty:
        channel.send_bytes(DONE)
        return
    try:
        packed = pack(answer, "What the slots return")
    except Exception as error:  # the values are dropped, but the changes of infos have been applied
        packed = pack(ShardAnswer(error=error), "An error")
    channel.send_bytes(packed)
