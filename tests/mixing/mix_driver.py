"""Generates one scene with ``cloud``, ``huggingface`` and ``hunyuan3d`` in its own process.

    python mix_driver.py OUT CALLS WORKERS

The settings are the coarsest that make a scene: what is tested is who is asked what, and when.
"""

import logging
import sys

import laid_table
from backends.openai_server import CHAT, IMAGES
from fitted_models import SIDE

from generator.backends import Backends
from generator.backends.huggingface.encoder import HuggingFaceEncoder
from generator.backends.huggingface.segmenter import HuggingFaceSegmenter
from generator.calls import Session
from generator.calls.http.retries import RetryPolicy
from generator.calls.money.prices import Price, Prices
from generator.calls.store import CallStore
from generator.generation import Config, Generation
from generator.method.refinement import RefinementConfig
from generator.method.rotation import RotationConfig
from generator.pipeline import generate

CONFIG = Config(
    rotation=RotationConfig(
        candidates=2, rivals=1, finalists=1, coarse_steps=1, rival_steps=1, close_steps=0, steps=1,
        coarse_step=0.8, points=400, resolution=32, coarse_resolution=32, suspect=0.0,
    ),
    refinement=RefinementConfig(steps=2, points=200, resolution=24),
)  # fmt: skip

PRICES = Prices(
    "2026-01-01", "USD", {CHAT: Price(input=1.0, output=10.0), IMAGES: Price(image=0.5)}
)
"""By these a question costs 0.0003, a picture 0.5, and a mesh, made on this machine, nothing."""


def mix(session: Session) -> Backends:
    """Return the mix, with small models on the CPU."""
    return Backends.select(
        "cloud",
        session=session,
        segmenter=HuggingFaceSegmenter("grounding-dino-tiny", tiles=1, side=SIDE, device="cpu"),
        encoder=HuggingFaceEncoder(side=28, device="cpu"),
        modeler="hunyuan3d",
    )


def scene(session: Session) -> Generation:
    return generate(laid_table.TEXT, mix(session), CONFIG, seed=5)


def main(out: str, calls: str, workers: str) -> None:
    """Generate the scene, cache answers in ``calls``, publish it in ``out`` with its ledger."""
    logging.basicConfig(level=logging.DEBUG)
    session = Session(
        store=CallStore(calls), prices=PRICES, workers=int(workers), attempts=2,
        retry_policy=RetryPolicy(first=0.01),
    )  # fmt: skip
    made = scene(session)
    path = made.save(out)
    session.account.save(path, session.prices)
    print(path)


if __name__ == "__main__":
    main(*sys.argv[1:])
