"""What users may pass as ``scenes``, and the sources it means."""

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
"""What may be passed as ``scenes``."""


def resolve(scenes: SceneChoice, needs: Needs = (), start: SceneChoice = STARTER) -> SceneSource:
    """Make a scene source of what a user may pass as ``scenes``.

    Args:
        scenes: one of

            - "starter": the shipped bundles that are for any task; "starter:train" and
              "starter:held_out" split them by digest, a fifth held out;
            - a bundle's name, digest, path or a glob of these, as ``assets_cache.find`` takes;
            - "fresh": made again for each draw, of every theme and for the task at hand (see
              ``needs``); "fresh:PROMPT": of a text;
            - "refreshing": a pool that begins with ``start`` and is renewed in the background, of
              every theme; "refreshing:PROMPT": of a text from the start, which takes about a second
              a scene at the first reset;
            - "curriculum": new tables as of "fresh", of a difficulty at which most is learned;
              "curriculum:SCENES": of those that any other text here means, such as
              "curriculum:starter:train" or "curriculum:fresh:an office desk". See
              ``CurriculumScenes``;
            - a ``Scene``, or a sequence of scenes, names, paths and globs;
            - a ``SceneSource``, which is returned as it is.

        needs: what each table of every theme holds besides (``Task.needs``); not those of a text.
        start: what the pool of "refreshing" begins with (``Task.scenes``), if these are fixed.

    Raises:
        BundleError: no bundle fits; the message says what there is.
        InputError: ``scenes`` is of another kind, an empty list, or a text that cannot be planned.
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
    """Return the source of only the scenes to train on, or only those held out.

    Which side a scene is on depends on the scene alone: the sides never meet, in whatever process,
    list or order they are asked for. See ``splits``.

    Args:
        scenes: anything ``resolve`` takes. Of a refreshing pool the first scenes and all later
            ones are split.
        side: "train" or "held_out".
        by: "digest" for a share of all scenes, "category" for what is on the table.
        share: by digest, the share of all scenes that is held out.
        categories: by category, the held-out ones ("mug", "wine glass"): a scene with any object
            of any of them is held out.
        needs: as ``resolve`` takes them.
        start: likewise.

    Raises:
        InputError: settings that do not go together, no such category, or fixed scenes of which
            none is on that side. Where scenes are made on demand, a draw that finds none raises
            ``SceneError``.
    """
    given = (categories,) if isinstance(categories, str) else tuple(categories)
    return admitting(resolve(scenes, needs, start), SplitRule(side, by, share, given))


def _make(text: str, needs: Needs, start: SceneChoice) -> SceneSource:
    """Return the source that a form of ``FRESH`` or ``REFRESHING`` means."""
    head, colon, prompt = text.partition(":")
    if colon and not prompt.strip():
        raise InputError(
            f"scenes={text!r} lacks a prompt. Pass for example '{head}:an office desk', or just "
            f"{head!r}."
        )
    fresh = FreshScenes(prompt.strip() if colon else SceneDistribution(needs=needs))
    fresh.check()
    if head == FRESH:
        return fresh
    if colon or isinstance(start, SceneSource) or on_demand(start):
        return RefreshingScenes(fresh)
    return RefreshingScenes(fresh, initial=start)
