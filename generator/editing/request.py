"""What the words of an edit ask for: the new thing, and the things of the scene it refers to."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from ..errors import InputError, choices
from ..method.planned import fresh_names
from ..scene import TABLE, Object, PlannedObject, Scene, ScenePlan
from .plans import planned_things

Planner = Callable[[str, int], ScenePlan]
"""A reasoner's ``plan_scene``."""


@dataclass(frozen=True)
class Asked:
    """A thing asked for.

    Its name is new to the scene, unless it is a thing that moves; its relations are to things of
    the scene, by their names, or to the table.
    """

    planned: PlannedObject
    style: str
    warnings: tuple[str, ...]


def understand(scene: Scene, text: str, planner: Planner, seed: int) -> Asked:
    """Return the one new thing that a text asks for ("a red mug left of the laptop").

    Things of the scene are meant by their words or by their names ("mug_2").

    Raises:
        InputError: the text names no thing or several, or refers to what is not on the table, or
            to what several things could be.
        BackendError: the planner could not answer.
    """
    words, named = _in_words(scene, text)
    plan = planner(words, seed)
    subject = _subject(plan, words)
    by_name = {o.name: o for o in plan.objects}
    targets = [r.target for r in subject.relations if r.target != TABLE]
    meant = {t: _resolve(scene, by_name[t], named) for t in dict.fromkeys(targets)}
    relations = tuple(replace(r, target=meant.get(r.target, TABLE)) for r in subject.relations)
    taken = {TABLE, *(o.name for o in (*scene.objects, *planned_things(scene)))}
    name = fresh_names([subject], taken)[subject.name]
    style = plan.style if plan.style != "plain" or not scene.plan else scene.plan.style
    return Asked(replace(subject, name=name, relations=relations), style, plan.warnings)


def whereabouts(scene: Scene, thing: Object, where: str, planner: Planner, seed: int) -> Asked:
    """Return a thing of the scene as asked to stand where a text says ("left of the laptop").

    Raises:
        InputError: the text says no place, or refers to what is not there or not told apart.
        BackendError: the planner could not answer.
    """
    asked = understand(scene, f"a {thing.label} {where}", planner, seed)
    relations = asked.planned.relations
    if not relations:
        raise InputError(
            f"{where!r} says no place. Say for example 'left of the laptop', 'on the book', 'in "
            "the middle of the table', or give metres."
        )
    return replace(asked, planned=replace(as_planned(scene, thing), relations=relations))


def as_planned(scene: Scene, thing: Object) -> PlannedObject:
    """Return a thing of the scene as its plan has it, without relations."""
    planned = next((o for o in planned_things(scene) if o.name == thing.name), None)
    if planned is not None and planned.category == thing.model.category:
        return replace(planned, relations=())
    return PlannedObject(thing.name, thing.label, thing.model.category)


def _in_words(scene: Scene, text: str) -> tuple[str, dict[str, str]]:
    """Replace names of things in a text by their words; return also which name a word meant."""
    named: dict[str, str] = {}
    for thing in scene.objects:
        pattern = rf"(?<![\w-])(?:the )?{re.escape(thing.name)}(?![\w-])"
        text, count = re.subn(pattern, f"a {thing.label}", text)
        if count:
            named[thing.label] = thing.name
    return text, named


def _subject(plan: ScenePlan, text: str) -> PlannedObject:
    """Return the one thing asked for, named first; the others only say where it goes."""
    if not plan.objects:
        raise InputError(f"{text!r} names no thing to put on the table. Say for example 'a mug'.")
    place = {o.name: text.lower().find(o.noun.lower()) for o in plan.objects}
    subject = min(plan.objects, key=lambda o: place[o.name] if place[o.name] >= 0 else len(text))
    targets = {r.target for r in subject.relations}
    # Others of a target's kind go with it: "behind the two books".
    kinds = {(o.category, o.noun) for o in plan.objects if o.name in targets}
    others = [o for o in plan.objects if o is not subject and (o.category, o.noun) not in kinds]
    if others:
        raise InputError(
            f"{text!r} is read as several things: {subject.noun}, "
            f"{', '.join(o.noun for o in others)}. An edit is about one; make one after the other."
        )
    return subject


def _resolve(scene: Scene, target: PlannedObject, named: dict[str, str]) -> str:
    """Return the name of the scene's thing that a planned target means."""
    if target.noun in named:
        return named[target.noun]
    fits = [o for o in scene.objects if _fits(o, target)]
    if not fits:
        words = sorted({o.label for o in scene.objects} | {o.name for o in scene.objects})
        raise InputError(f"There is no {target.noun} on the table." + choices(target.noun, words))
    matching = _of_look(scene, fits, target) if len(fits) > 1 else fits
    if len(matching) > 1:
        raise InputError(
            f"{' and '.join(o.name for o in matching)} could be meant by {target.noun!r}. "
            f"Say which, as in 'next to {matching[0].name}'."
        )
    return matching[0].name


def _fits(thing: Object, target: PlannedObject) -> bool:
    same = target.category == thing.model.category != "generic"
    return same or target.noun.lower() == thing.label.lower()


def _of_look(scene: Scene, things: Sequence[Object], target: PlannedObject) -> Sequence[Object]:
    """Return those that look as the target does, by the scene's plan; all if it cannot tell."""
    looks = {o.name: dict(o.attributes) for o in planned_things(scene)}
    alike = [t for t in things if target.attributes.items() <= looks.get(t.name, {}).items()]
    return alike or things
