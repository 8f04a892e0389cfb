"""Jobs that create a scene: generate, compose and edit."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..specs import ComposeSpec, EditSpec, GenerateSpec, Paid
from .order import JobOrder, Telling

if TYPE_CHECKING:
    from generator.backends import Backends
    from generator.calls import Session
    from generator.editing import Edited
    from generator.generation import Generation


def open_session(paid: Paid, dry: bool = False) -> Session:
    """Return a session with the user's response cache and the shipped prices."""
    from generator.backends.paid_run import calls_folder
    from generator.calls import Session
    from generator.calls.store import CallStore

    return Session(CallStore(calls_folder()), budget=paid.budget, dry=dry)


def run_generate(
    spec: GenerateSpec, order: JobOrder, telling: Telling | None, session: Session, chosen: Backends
) -> Generation:
    """Generate the scene; report its stages and their pictures to ``telling``."""
    from generator.backends.paid_run import answering, scene_key
    from generator.errors import InputError
    from generator.method.figures import draw_stage
    from generator.pipeline import generate

    source = order.picture if spec.text is None else spec.text
    if source is None:
        raise InputError("The uploaded picture no longer exists. Upload it again.")

    def watch(stage: str, found: Mapping[str, Any]) -> None:
        if telling is not None:
            telling.show(stage, draw_stage(stage, found))

    key = scene_key("generate", source, None, None, spec.seed, None, chosen.identity())
    with answering(session, key, _print):
        # Plan texts here, so that no text from outside is interpreted as the path of a picture.
        planned = source if spec.text is None else chosen.reasoner.plan_scene(spec.text, spec.seed)
        return generate(
            planned, chosen, seed=spec.seed, name=spec.name, watch=watch,
            progress=None if telling is None else telling.stage,
        )  # fmt: skip


def run_edit(spec: EditSpec, order: JobOrder, session: Session, chosen: Backends | None) -> Edited:
    """Return the edited scene."""
    from generator.backends.paid_run import answering, scene_key
    from generator.editing.edits import WordedEdit

    asked = WordedEdit(spec.action, spec.words, spec.to, spec.turn, spec.seed)
    who, path = None if chosen is None else chosen.identity(), order.start
    key = scene_key("edit", path.name, spec.action, spec.words, spec.to, spec.turn, spec.seed, who)
    with answering(session, key, _print):
        return asked.apply(path, chosen)


def generate_scene(spec: GenerateSpec, order: JobOrder, telling: Telling) -> dict[str, Any]:
    """Run a job of the kind "generate"."""
    session = open_session(spec.paid)
    made = run_generate(spec, order, telling, session, spec.paid.mix.select(session))
    path = made.save(order.scenes)
    facts = _spend(session, path)
    if (match := made.match) is not None:
        facts |= {"mean_iou": match.mean_iou, "doubts": list(match.doubts)}
    return {"scene": path.name, "facts": facts}


def compose_scene(spec: ComposeSpec, order: JobOrder, telling: Telling) -> dict[str, Any]:
    """Run a job of the kind "compose"."""
    from generator.bundle import save
    from generator.composition import compose
    from generator.method.figures import preview

    telling.stage("composing", 1, 1)
    scene = compose(spec.text, spec.seed, name=spec.name, density=spec.density)
    picture = preview(scene)
    telling.show("composing", {"preview": picture})
    path = save(scene, order.scenes, images={"preview": picture})
    return {"scene": path.name}


def edit_scene(spec: EditSpec, order: JobOrder, telling: Telling) -> dict[str, Any]:
    """Run a job of the kind "edit"."""
    from generator.bundle import load, load_pictures
    from generator.language.reader import NOT_UNDERSTOOD

    telling.stage(spec.action, 1, 1)
    session = open_session(spec.paid)
    mix = spec.paid.mix
    edited = run_edit(spec, order, session, mix.select(session) if mix.given else None)
    path = edited.save(order.scenes)
    pictures = load_pictures(path)
    telling.show(spec.action, {k: v for k, v in pictures.items() if k == "preview"})
    known = load(order.start).provenance.warnings
    lost = [words for words in edited.scene.provenance.warnings
            if words.startswith(NOT_UNDERSTOOD) and words not in known]  # fmt: skip
    return {"scene": path.name, "facts": _spend(session, path) | {"not_understood": lost}}


_print = partial(print, flush=True)  # to the log of the job


def _spend(session: Session, path: Path) -> dict[str, Any]:
    """Write the ledger of calls beside a bundle; return their cost, if there were any calls."""
    from generator.backends.paid_run import save_ledger

    save_ledger(session, path)
    if not session.account.entries:
        return {}
    return {"spent": session.account.money, "currency": session.prices.currency}
