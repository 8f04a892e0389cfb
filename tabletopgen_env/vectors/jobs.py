"""What vector environments ask of their slots; each can be sent to another process."""

from __future__ import annotations

from typing import Any

import gymnasium as gym


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
