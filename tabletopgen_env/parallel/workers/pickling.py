"""Values, jobs and errors that cross process boundaries."""

from __future__ import annotations

import pickle
import traceback
from typing import Any

import cloudpickle
import gymnasium as gym

from generator.errors import InputError, TabletopError


def pack(things: Any, what: str) -> bytes:
    """Return things as bytes for another process; functions and classes of a script too.

    Raises:
        InputError: they cannot be sent; ``what`` begins the message, "The scenes and settings".
    """
    try:
        return cloudpickle.dumps(things)
    except Exception as error:  # whatever the things do as they are packed
        raise InputError(
            f"{what} cannot be sent between processes: {type(error).__name__}: {error}. Use "
            "processes=None, which keeps the slots in this process, or things that can be pickled."
        ) from error


def make_portable(error: Exception) -> Exception:
    """Return an error that can be sent, its traceback noted if it is none of the project's.

    Where it cannot be sent itself, it is a RuntimeError that says the same.
    """
    if not isinstance(error, TabletopError):
        error.add_note("".join(traceback.format_exception(error)))
    try:
        pickle.loads(cloudpickle.dumps(error))
        return error
    except Exception:
        other = RuntimeError(f"{type(error).__name__}: {error}")
        for note in getattr(error, "__notes__", ()):
            other.add_note(note)
        return other


def render(env: gym.Env) -> Any:
    """Return what the environment draws."""
    return env.render()


def call(env: gym.Env, name: str, args: tuple[Any, ...], kwargs: dict[str, Any]) -> Any:
    """Return what a method returns, or an attribute."""
    found = get(env, name)
    return found(*args, **kwargs) if callable(found) else found


def get(env: gym.Env, name: str) -> Any:
    """Return an attribute of the environment or of a wrapper."""
    return env.get_wrapper_attr(name)


def put(env: gym.Env, name: str, value: Any) -> None:
    """Set an attribute of the environment or of the wrapper that has it."""
    env.set_wrapper_attr(name, value)
