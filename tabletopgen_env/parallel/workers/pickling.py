"""Values, jobs and errors that cross process boundaries."""

from __future__ import annotations

import pickle
import traceback
from typing import Any

import cloudpickle
import gymnasium as gym

from generator.errors import InputError, TabletopError


def pack(things: Any, what: str) -> bytes:
    """Pickle values for another process, including functions and classes defined in scripts.

    Raises:
        InputError: the values cannot be sent; ``what`` begins the message, as in "The scenes and
            settings".
    """
    try:
        return cloudpickle.dumps(things)
    except Exception as error:  # pickling may raise any exception
        raise InputError(
            f"{what} cannot be sent between processes: {type(error).__name__}: {error}. Use "
            "processes=None, which keeps the slots in this process, or picklable values."
        ) from error


def make_portable(error: Exception) -> Exception:
    """Return a picklable error; an error from another package gets its traceback as a note.

    An error that cannot be pickled becomes a RuntimeError with the same message.
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
    """Return the rendered frame of the environment."""
    return env.render()


def call(env: gym.Env, name: str, args: tuple[Any, ...], kwargs: dict[str, Any]) -> Any:
    """Return an attribute, or the result of a method."""
    found = get(env, name)
    return found(*args, **kwargs) if callable(found) else found


def get(env: gym.Env, name: str) -> Any:
    """Return an attribute of the environment or of a wrapper."""
    return env.get_wrapper_attr(name)


def put(env: gym.Env, name: str, value: Any) -> None:
    """Set an attribute of the environment, or of the wrapper that has it."""
    env.set_wrapper_attr(name, value)
