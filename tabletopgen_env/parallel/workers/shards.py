"""Slots in several processes that share arrays with the current process.

A step writes the actions into the arrays, wakes each shard with one byte, and waits for one byte
from each. The processes are workers of a pool (``generator.jobs.workers``): fresh Python processes,
which need no main guard in a script and end with this process, however it ends.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import selectors
import socket
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import wait
from dataclasses import dataclass, replace
from multiprocessing.connection import Connection
from typing import Any

import gymnasium as gym
import numpy as np
from gymnasium import spaces
from gymnasium.vector import AutoresetMode
from jaxtyping import Float

from generator.jobs.workers import WorkerDied, WorkerPool

from ...scenes import SceneSource
from .arrays import SharedBlock, lay_out, open_memory, pad
from .infos import NUMBERS, InfoReader
from .pickling import pack
from .scene_server import AskedScenes, LentScenes, Wish
from .shard import DONE, STEP, ShardAnswer, ShardEnvs, ShardPlace, serve
from .slots import Job

_PATIENCE = 5.0  # seconds for shards to close their environments


@dataclass(frozen=True)
class ShardParts:
    """The parts from which shards are created.

    Attributes:
        packed: the pickled ``ShardEnvs`` of each shard.
        sizes: number of slots of each shard.
        observation, action: the spaces of a slot.
        source: the scene source, if the shards request their scenes.
    """

    packed: tuple[bytes, ...]
    sizes: tuple[int, ...]
    observation: spaces.Space
    action: spaces.Box
    source: SceneSource | None = None


def split_slots(
    envs: Sequence[gym.Env],
    mode: AutoresetMode,
    processes: int,
    asked: AskedScenes | None,
    source: SceneSource,
    joint: bool,
    limit: int | None,
) -> ShardParts:
    """Split slots evenly, in order, into one shard per process.

    ``asked`` is the environments' scene source if ``source`` stays in this process; ``joint`` and
    ``limit`` are as in ``ShardEnvs``.

    Raises:
        InputError: an environment cannot be sent to another process.
    """
    shares = np.array_split(np.arange(len(envs)), processes)
    parts = [ShardEnvs([envs[k] for k in share], mode, asked, joint, limit) for share in shares]
    one: Any = envs[0]
    return ShardParts(
        tuple(pack(part, "The task, the scenes and the settings") for part in parts),
        tuple(map(len, shares)), one.observation_space, one.action_space,
        None if asked is None else source,
    )  # fmt: skip


class ShardSlots:
    """Slots in several processes; a copy has separate processes with copied environments.

    Raises:
        WorkerDied: a process could not be started.
        InputError: the environments could not be unpickled there.
    """

    def __init__(self, parts: ShardParts) -> None:
        self._firsts = np.cumsum([0, *parts.sizes]).tolist()
        self._lent = None if parts.source is None else LentScenes(parts.source)
        self.live = True
        self._owing: set[int] = set()
        self._selector = selectors.DefaultSelector()
        self._reader = InfoReader(self._start(parts))
        # the pickled environments are large and no longer needed
        self._parts = replace(parts, packed=())
        self.pids = self._begin()

    def step(self) -> dict[str, Any]:
        """Step or reset every slot."""
        self._request(dict.fromkeys(range(len(self._channels)), STEP))
        return self._reader.read_all()

    def reset(self, seeds: Mapping[int, int | None], options: dict[str, Any]) -> dict[str, Any]:
        """Reset some slots."""
        self._request({
            shard: pack(("reset", (of, options)), "The options of a reset")
            for shard, of in self._share(seeds).items()
        })  # fmt: skip
        return self._reader.read(seeds)

    def visit(self, jobs: Mapping[int, Job]) -> list[Any]:
        """Run each job on the environment of its slot; jobs and results are pickled."""
        answers = self._request({
            shard: pack(("visit", (of,)), "The functions for the slots")
            for shard, of in self._share(jobs).items()
        })  # fmt: skip
        values = [value for shard in sorted(answers) for value in answers[shard].value]
        done = dict(zip(sorted(jobs), values, strict=True))
        return [done[k] for k in jobs]

    def close(self) -> None:
        """Close the environments and end the processes; repeated calls are allowed."""
        self.live = False
        self._selector.close()
        for channel in self._channels:
            channel.close()
        with contextlib.suppress(KeyboardInterrupt):
            wait(self._futures, _PATIENCE)
        self._pool.close()

    # --------------------------------------------------------------------------------- processes

    def _start(self, parts: ShardParts) -> Float[np.ndarray, "m n"]:
        """Start the processes and share the arrays; return the array for the numbers in infos."""
        count: int = self._firsts[-1]

        def take(shape: tuple[int, ...], dtype: Any) -> np.ndarray:
            nonlocal size
            array = np.zeros(shape, dtype)
            size += pad(array.nbytes)
            return array

        size = 0
        lay_out(take, count, parts.observation, parts.action)
        take((NUMBERS, count), float)
        memory = open_memory(size)
        block = SharedBlock(memory, size)
        self.arrays = lay_out(block.take, count, parts.observation, parts.action)
        pairs = [socket.socketpair() for _ in parts.packed]
        theirs = tuple(their.fileno() for _, their in pairs)
        self._pool = WorkerPool(len(pairs), descriptors=(*theirs, memory))
        places = [
            ShardPlace(k, self._firsts[k], count, theirs, memory, size) for k in range(len(pairs))
        ]
        self._futures = [
            self._pool.submit(serve, place, own)
            for place, own in zip(places, parts.packed, strict=True)
        ]
        os.close(memory)
        for _, their in pairs:
            their.close()
        self._channels = [Connection(ours.detach()) for ours, _ in pairs]
        for shard, channel in enumerate(self._channels):
            self._selector.register(channel, selectors.EVENT_READ, shard)
        return block.take((NUMBERS, count), float)

    def _begin(self) -> tuple[int, ...]:
        """Wait until every shard has unpickled its environments; return the process ids."""
        self._owing = set(range(len(self._channels)))
        try:
            answers = self._finish()
        except BaseException:
            self.close()
            raise
        return tuple(answers[shard].value for shard in sorted(answers))

    def __reduce__(self) -> tuple[type[ShardSlots], tuple[ShardParts]]:
        copies = self._request(dict.fromkeys(range(len(self._channels)), pack(("copy", ()), "")))
        packed = tuple(copies[shard].value for shard in sorted(copies))
        return type(self), (replace(self._parts, packed=packed),)

    # ----------------------------------------------------------------------------------- talking

    def _share(self, told: Mapping[int, Any]) -> dict[int, dict[int, Any]]:
        """Group the values of slots by shard, with slots numbered from the shard's first slot."""
        shares: dict[int, dict[int, Any]] = {}
        for k in sorted(told):
            shard = int(np.searchsorted(self._firsts, k, "right")) - 1
            shares.setdefault(shard, {})[k - self._firsts[shard]] = told[k]
        return shares

    def _request(self, requests: Mapping[int, bytes]) -> dict[int, ShardAnswer]:
        """Send requests to shards; return the answers, or raise the first failed slot's error."""
        if self._owing:  # an earlier call was interrupted
            self._gather()
        for shard, request in requests.items():
            with self._talking(shard):
                self._owing.add(shard)
                self._channels[shard].send_bytes(request)
        return self._finish()

    def _finish(self) -> dict[int, ShardAnswer]:
        """Return the pending answers of all shards, or raise the first failed slot's error."""
        answers = self._gather()
        for shard in sorted(answers):
            if (error := answers[shard].error) is not None:
                raise error
        return answers

    def _gather(self) -> dict[int, ShardAnswer]:
        """Return the pending answers of all shards; meanwhile, serve their scene requests."""
        answers: dict[int, ShardAnswer] = {}
        while self._owing:
            for key, _ in self._selector.select():
                with self._talking(key.data):
                    self._hear(key.data, answers)
        return answers

    def _hear(self, shard: int, answers: dict[int, ShardAnswer]) -> None:
        """Receive a shard's answer, or serve its scene request."""
        packed = self._channels[shard].recv_bytes()
        message: ShardAnswer | Wish = ShardAnswer() if packed == DONE else pickle.loads(packed)
        if isinstance(message, Wish):
            assert self._lent is not None
            self._channels[shard].send_bytes(self._lent.fulfil(message))
        else:
            self._reader.take(message.changes)
            answers[shard] = message
            self._owing.discard(shard)

    @contextlib.contextmanager
    def _talking(self, shard: int) -> Iterator[None]:
        """Close all shards if the exchange of a message is interrupted."""
        try:
            yield
        except (EOFError, OSError):
            error = self._explain(shard)
            self.close()
            raise error from None
        except BaseException:  # interrupted
            self.close()
            raise

    def _explain(self, shard: int) -> WorkerDied:
        """Return an error that reports how a shard ended."""
        try:
            self._futures[shard].result(_PATIENCE)
            how = "hung up"
        except WorkerDied as error:
            how = error.how or f"could not be started ({error})"
        except Exception as error:
            how = f"failed ({type(error).__name__}: {error})"
        first, last = self._firsts[shard], self._firsts[shard + 1] - 1
        died = WorkerDied(
            f"The process of shard {shard} of {len(self._channels)} (slots {first} to {last} "
            f"of the vector environment) {how}. The other shards are closed, too: create a new "
            "vector environment, with fewer processes or a smaller cache if memory is short."
        )
        died.how = how
        return died
