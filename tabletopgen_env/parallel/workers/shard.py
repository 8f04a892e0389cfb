"""A shard: some slots of a vector environment in a process of their own.

It reads requests from its channel and answers each, its slots' rows written to the shared arrays.
The request to step is one byte, and so is the answer if there is nothing to tell. While it is at a
request it may ask for a scene (``scene_server``).
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
"""The request to step, and the answer if all is in the arrays."""


@dataclass(frozen=True)
class ShardEnvs:
    """What a shard is made of.

    ``envs`` are its environments, ``joint`` makes a ``JointSlots`` of them with ``limit``, and
    ``asked`` is what of them asks for scenes, if anything.
    """

    envs: Sequence[gym.Env]
    mode: AutoresetMode
    asked: AskedScenes | None = None
    joint: bool = False
    limit: int | None = None

    def make(self, rows: SlotArrays) -> SlotSet:
        """Return the slots, whose rows these are."""
        if self.joint:
            return JointSlots(self.envs, self.mode, rows, self.limit)
        return SlotSet(self.envs, self.mode, rows)


@dataclass(frozen=True)
class ShardPlace:
    """Where a shard is among the others, and its open files.

    Attributes:
        number: which of the shards it is.
        first: its first slot.
        count: slots of all shards.
        channels: the ends of all shards' channels that are the shards'.
        memory, size: the file of the shared arrays, and its bytes.
    """

    number: int
    first: int
    count: int
    channels: tuple[int, ...]
    memory: int
    size: int


@dataclass(frozen=True)
class ShardAnswer:
    """What a request came to: what changed in infos, and a value or the first slot's error."""

    changes: tuple[InfoChange, ...] = ()
    value: Any = None
    error: Exception | None = None

    @property
    def empty(self) -> bool:
        """Whether there is nothing to tell."""
        return not self.changes and self.value is None and self.error is None


def serve(place: ShardPlace, packed: bytes) -> None:
    """Be a shard until the channel ends; ``packed`` is its ``ShardEnvs``."""
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
        except (EOFError, OSError):  # the vector environment is closed, or gone
            shard.close()


class _Shard:
    """The slots, the columns of their infos, and what is asked of them."""

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
        """Do what a request says."""
        if request == STEP:
            return self._tell(range(len(self._own.envs)), self._slots.step_all(self._first))
        try:
            what, given = pickle.loads(request)
        except Exception as error:  # something in it cannot be made here
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
        """Answer with a packed copy of the environments, none of which has an episode."""
        return ShardAnswer(value=pack(self._own, "The slots' environments"))

    def _each(self, work: Callable[[int], Any], slots: Iterable[int]) -> list[Any]:
        return [attempt(work, k, self._first) for k in slots]

    def _tell(self, slots: Iterable[int], infos: Iterable[Any]) -> ShardAnswer:
        """Write infos; errors among them are no infos."""
        infos = list(infos)
        pairs = [(k, i) for k, i in zip(slots, infos, strict=True) if isinstance(i, dict)]
        changes = [change for k, i in pairs if (change := self._infos.write(k, i)) is not None]
        return ShardAnswer(tuple(changes), error=_first_error(infos))

    def _ask(self, wish: Wish) -> Any:
        """Ask for a scene, or have the source record."""
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
    except Exception as error:  # the values; what changed in infos has to arrive
        packed = pack(ShardAnswer(error=error), "An error")
    channel.send_bytes(packed)
