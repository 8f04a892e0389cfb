"""The environments of some slots, stepped one by one into their rows of the arrays."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Protocol

import gymnasium as gym
from gymnasium.vector import AutoresetMode

from .arrays import SlotArrays

Job = Callable[[gym.Env], Any]
"""What may be asked of a slot: a function of its environment."""


class SlotRunner(Protocol):
    """All slots of a vector environment, wherever they are stepped.

    An error is raised once all slots are done, that of the first slot that has one.
    """

    @property
    def arrays(self) -> SlotArrays:
        """The rows of all slots."""
        ...

    @property
    def live(self) -> bool:
        """Whether it is not closed."""
        ...

    def step(self) -> dict[str, Any]:
        """Step every slot by its row of ``actions``, or reset it; return their infos."""
        ...

    def reset(self, seeds: Mapping[int, int | None], options: dict[str, Any]) -> dict[str, Any]:
        """Reset the slots that have a seed, or None, in ``seeds``; return their infos."""
        ...

    def visit(self, jobs: Mapping[int, Job]) -> list[Any]:
        """Return what each slot's job returns of its environment."""
        ...

    def close(self) -> None:
        """Close the slots."""
        ...


class SlotSet:
    """Environments, the way that they are reset after an episode, and their rows.

    What is told of slot k of this set is in row k. No two threads may work on the same slot.
    """

    def __init__(self, envs: Sequence[gym.Env], mode: AutoresetMode, rows: SlotArrays) -> None:
        self.envs = list(envs)
        self._mode = mode
        self._rows = rows

    def step_all(self, first: int) -> list[Any]:
        """Step or reset every slot; return their infos or errors. ``first`` is slot 0's number."""
        return [attempt(self.step, k, first) for k in range(len(self.envs))]

    def step(self, k: int) -> dict[str, Any]:
        """Step slot ``k`` by its action, or reset it if its episode is over; return its info."""
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
        """Reset slot ``k``, which has no episode until that is done; return its info.

        An episode that is not over is given up: no curriculum hears of it.
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
        """Write down what a step gave."""
        rows = self._rows
        rows.rewards[k], rows.terminated[k], rows.truncated[k] = reward, terminated, truncated


def attempt(work: Callable[[int], Any], k: int, first: int = 0) -> Any:
    """Return what ``work`` returns of slot ``k``, or the error it raises, which names the slot."""
    try:
        return work(k)
    except Exception as error:
        return name_slot(error, first + k)


def name_slot(error: Exception, k: int) -> Exception:
    """Return an error with a note of its slot."""
    error.add_note(f"(in slot {k} of the vector environment)")
    return error
