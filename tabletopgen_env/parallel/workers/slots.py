"""The environments of some slots, stepped one by one, with results in rows of arrays."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Protocol

import gymnasium as gym
from gymnasium.vector import AutoresetMode

from .arrays import SlotArrays

Job = Callable[[gym.Env], Any]
"""A job of a slot: a function of its environment."""


class SlotRunner(Protocol):
    """The interface for running all slots of a vector environment, on threads or in processes.

    If slots raise errors, the first slot's error is raised after all slots are done.
    """

    @property
    def arrays(self) -> SlotArrays:
        """The arrays of actions, observations and results, with one row per slot."""
        ...

    @property
    def live(self) -> bool:
        """Whether the slots are open."""
        ...

    def step(self) -> dict[str, Any]:
        """Step every slot with its row of ``arrays.actions``, or reset it; return the infos."""
        ...

    def reset(self, seeds: Mapping[int, int | None], options: dict[str, Any]) -> dict[str, Any]:
        """Reset the slots in ``seeds``, which maps each to its seed or None; return their infos."""
        ...

    def visit(self, jobs: Mapping[int, Job]) -> list[Any]:
        """Run each slot's job on its environment; return the results."""
        ...

    def close(self) -> None:
        """Close the slots."""
        ...


class SlotSet:
    """Environments with their autoreset mode, and the arrays to which results are written.

    Slot k of this set uses row k. No two threads may work on the same slot.
    """

    def __init__(self, envs: Sequence[gym.Env], mode: AutoresetMode, rows: SlotArrays) -> None:
        self.envs = list(envs)
        self._mode = mode
        self._rows = rows

    def step_all(self, first: int) -> list[Any]:
        """Step or reset every slot, numbered from ``first``; return each slot's info or error."""
        return [attempt(self.step, k, first) for k in range(len(self.envs))]

    def step(self, k: int) -> dict[str, Any]:
        """Step slot ``k`` with its action, or reset it if its episode is over; return its info."""
        if self._rows.over[k]:
            info = self.reset(k)
            self._end(k, 0.0, False, False)
            return info
        seen, reward, terminated, truncated, info = self.envs[k].step(self._rows.actions[k])
        ended = bool(terminated or truncated)
        self._rows.over[k] = ended
        if ended and self._mode == AutoresetMode.SAME_STEP:
            info = {"final_obs": seen, "final_info": info, **self.reset(k)}
        else:
            self._rows.show(k, seen)
        self._end(k, float(reward), bool(terminated), bool(truncated))
        return info

    def reset(self, k: int, **given: Any) -> dict[str, Any]:
        """Reset slot ``k``, which has no episode until this succeeds; return its info.

        An unfinished episode is discarded; curricula do not record it.
        """
        rows = self._rows
        if rows.playing[k] and not rows.over[k]:
            self.envs[k].unwrapped.give_up()  # type: ignore[attr-defined]
        rows.playing[k] = False
        seen, info = self.envs[k].reset(**given)
        rows.show(k, seen)
        rows.playing[k], rows.over[k] = True, False
        return info

    def _end(self, k: int, reward: float, terminated: bool, truncated: bool) -> None:
        """Store the results of a step of slot ``k``."""
        rows = self._rows
        rows.rewards[k], rows.terminated[k], rows.truncated[k] = reward, terminated, truncated


def attempt(work: Callable[[int], Any], k: int, first: int = 0) -> Any:
    """Return the result of ``work`` for slot ``k``, or its error with a note naming the slot."""
    try:
        return work(k)
    except Exception as error:
        return name_slot(error, first + k)


def name_slot(error: Exception, k: int) -> Exception:
    """Add a note that names the slot to an error."""
    error.add_note(f"(in slot {k} of the vector environment)")
    return error
