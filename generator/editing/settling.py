"""An edited scene settled and judged again, at one place after the other until it holds."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

from ..errors import SceneError
from ..generation import Config
from ..method.assembly import reassemble
from ..physics.seating import overlapping
from ..scene import TABLE, Scene
from .placing import check_held, loads, set_down


def settle_again(
    wanted: Scene,
    arranged: Scene,
    fresh: Collection[str],
    config: Config,
    loose: Collection[str] = (),
) -> Scene:
    """Settle and judge the scene again; check that what is new or was moved holds where it is."""
    done = reassemble(wanted, arranged, fresh, config.assembly)
    touched = [*fresh, *loose]
    check_held(done, [*touched, *(n for name in touched for n in loads(done, name))])
    return done


def try_places(
    placed: Callable[[int], Scene],
    name: str,
    fresh: Sequence[str],
    config: Config,
    loose: Sequence[str] = (),
    attempts: int = 1,
) -> Scene:
    """Return the first scene to pass its gate of those with ``name`` placed so or so.

    ``placed`` gives the scene with the thing at its place, by the number of the attempt. ``fresh``
    is what is new, ``loose`` what is not new, but elsewhere.

    Raises:
        SceneError: none of the places is free, or holds the thing. Where they do, but no scene
            passes, the last one is returned.
    """
    error: SceneError | None = None
    done = None
    for attempt in range(attempts):
        try:
            wanted = placed(attempt)
            stacked = [n for n in (name,) if wanted.object(n).placement.on != TABLE]
            arranged = set_down(wanted, stacked)
            _check_free(arranged, (name, *loose))
            done = settle_again(wanted, arranged, fresh, config, loose)
        except SceneError as failed:
            error = failed
            continue
        if done.report is not None and done.report.passed:
            return done
    if done is None:
        raise error or SceneError(f"No place was tried for {name}.")
    return done


def _check_free(scene: Scene, names: Sequence[str]) -> None:
    for name in names:
        if overlapping(scene, name):
            raise SceneError(
                f"{name} would overlap another thing. Choose another place, or move that first."
            )
