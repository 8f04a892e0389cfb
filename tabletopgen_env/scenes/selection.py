"""Conversion of the values that users pass as ``scenes`` to scene sources."""

from __future__ import annotations

from collections.abc import Iterable

from generator.errors import InputError
from generator.language.distribution import Needs, SceneDistribution

from .curriculum import CurriculumScenes
from .fresh import FreshScenes
from .lookup import FRESH, STARTER, FixedChoice, fixed_scenes, graded_of, on_demand
from .refresh import RefreshingScenes
from .source import SceneSource
from .splits import SHARE, By, Side, SplitRule, admitting

SceneChoice = FixedChoice | SceneSource
"""Types accepted as ``scenes``."""


def resolve(scenes: SceneChoice, needs: Needs = (), start: SceneChoice = STARTER) -> SceneSource:
    """Create a scene source from a value that a user passes as ``scenes``.

    Args:
        scenes: one of

            - "starter": the shipped bundles that suit any task; "starter:train" and
              "starter:held_out" split them by digest, a fifth held out;
            - a bundle's name, digest, path or a glob of these, as ``assets_cache.find`` takes;
            - "fresh": generated for each draw, of every theme and for the current task (see
              ``needs``); "fresh:PROMPT": from a prompt;
            - "refreshing": a pool that starts with ``start`` and is renewed in the background, of
              every theme; "refreshing:PROMPT": from a prompt, also at the start, which takes about
              a second per scene at the first reset;
            - "curriculum": new tables as for "fresh", of the difficulty at which most is learned;
              "curriculum:SCENES": scenes of any other form listed here, such as
              "curriculum:starter:train" or "curriculum:fresh:an office desk". See
              ``CurriculumScenes``;
            - a ``Scene``, or a sequence of scenes, names, paths and globs;
            - a ``SceneSource``, which is returned unchanged.

        needs: objects that tables of every theme must also have (``Task.needs``); ignored for
            texts.
        start: initial pool of "refreshing" (``Task.scenes``), if these scenes are fixed.

    Raises:
        BundleError: no bundle matches; the message lists the available ones.
        InputError: ``scenes`` has an unsupported type, is an empty list, or is a text that cannot
            be planned.
    """
    if isinstance(scenes, SceneSource):
        return scenes
    if isinstance(scenes, str) and (graded := graded_of(scenes)) is not None:
        return CurriculumScenes(resolve(graded, needs, start))
    return _make(str(scenes), needs, start) if on_demand(scenes) else fixed_scenes(scenes)


def split(
    scenes: SceneChoice,
    side: Side,
    *,
    by: By = "digest",
    share: float = SHARE,
    categories: Iterable[str] = (),
    needs: Needs = (),
    start: SceneChoice = STARTER,
) -> SceneSource:
    """Return a source of either the training scenes or the held-out scenes.

    Whether a scene is held out depends only on the scene, so the two sides are disjoint in all
    processes and lists. See ``splits``.

    Args:
        scenes: anything ``resolve`` takes. For a refreshing pool, initial and later scenes are
            split.
        side: "train" or "held_out".
        by: "digest" for a share of all scenes, "category" for the objects on the table.
        share: by digest, the share of all scenes that is held out.
        categories: by category, the held-out ones ("mug", "wine glass"): a scene with an object of
            any of them is held out.
        needs: as for ``resolve``.
        start: as for ``resolve``.

    Raises:
        InputError: settings are inconsistent, a category does not exist, or no fixed scene is on
            that side. For scenes generated on demand, a draw that finds none raises ``SceneError``.
    """
    given = (categories,) if isinstance(categories, str) else tuple(categories)
    return admitting(resolve(scenes, needs, start), SplitRule(side, by, share, given))


def _make(text: str, needs: Needs, start: SceneChoice) -> SceneSource:
    """Create the source for a ``FRESH`` or ``REFRESHING`` string, with its prompt if it has one."""
    head, colon, prompt = text.partition(":")
    if colon and not prompt.strip():
        raise InputError(
            f"scenes={text!r} lacks a prompt. Pass, for example, '{head}:an office desk', or "
            f"just {head!r}."
        )
    fresh = FreshScenes(prompt.strip() if colon else SceneDistribution(needs=needs))
    fresh.check()
    if head == FRESH:
        return fresh
    if colon or isinstance(start, SceneSource) or on_demand(start):
        return RefreshingScenes(fresh)
    return RefreshingScenes(fresh, initial=start)
