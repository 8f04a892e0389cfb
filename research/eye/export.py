"""Export a trained eye: averaged weights in half precision, names calibrated on other pictures.

python -m research.eye.export --run DIR/run --data DIR/tuning
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import numpy as np
import torch
from rich.progress import track
from torch.nn import functional

from generator.backends.embedded.eye.network import Eye
from generator.backends.embedded.eye.weights import PATH, save_weights
from generator.errors import InputError

from .train import STATE, Crops, collate


def load_averaged(run: Path) -> tuple[Eye, tuple[str, ...], int, float]:
    """Load a run's averaged eye, its categories, its steps and its training seconds.

    Raises:
        InputError: the folder contains no run.
    """
    path = run / STATE
    if not path.is_file():
        raise InputError(f"No training run in {run}: {STATE} is missing. Train one first.")
    state = torch.load(path, map_location="cpu", weights_only=True)
    eye = Eye(len(state["categories"]) + 1)
    eye.load_state_dict(state["average"])
    eye.eval()
    return eye, tuple(state["categories"]), state["steps"], state["spent"]


def calibrate(eye: Eye, data: Path, batches: int, seed: int) -> float:
    """Return the temperature that calibrates the names' probabilities on pictures not trained on.

    It minimises the cross entropy: Guo et al., "On Calibration of Modern Neural Networks", ICML
    2017.
    """
    crops = Crops(data, 256, seed)
    logits, wished = [], []
    with torch.inference_mode():
        for k in track(range(batches), "calibrating"):
            batch = collate([crops.crop(8 * k + j) for j in range(8)])
            if not len(batch.looks):
                continue
            named = eye.names(batch.looks, batch.shown, batch.hints)
            logits.append(named)
            wished.append(torch.where(batch.category < 0, named.shape[1] - 1, batch.category))
    found, right = torch.cat(logits), torch.cat(wished)
    choices = np.geomspace(0.4, 3.0, 60)
    costs = [float(functional.cross_entropy(found / t, right)) for t in choices]
    return float(choices[int(np.argmin(costs))])


TEMPLATE = Path(__file__).with_name("card.md")
"""Template of the model card, with placeholders for a run's values."""


def card(run: Path, eye: Eye, categories: tuple[str, ...], temperature: float) -> str:
    """Return the model card of a run."""
    state = torch.load(run / STATE, map_location="cpu", weights_only=True)
    names = [Path(name).stem.split("-") for name in state["shards"]]
    count = sum(p.numel() for p in eye.parameters())
    return TEMPLATE.read_text().format(
        size=PATH.stat().st_size / 1e6,
        parameters=count / 1e6,
        categories=len(categories),
        pictures=f"about {100 * len(names):,}",
        seeds=", ".join(sorted({name[1] for name in names if len(name) > 1})),
        steps=f"{state['steps']:,}",
        minutes=state["spent"] / 60,
        temperature=temperature,
    )


def main() -> None:
    """Parse the command line and export."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--run", type=Path, required=True)
    parser.add_argument(
        "--data", type=Path, required=True, help="folder of shards not used for training"
    )
    parser.add_argument("--batches", type=int, default=40)
    parser.add_argument("--seed", type=int, default=0)
    args = parser.parse_args()
    eye, categories, steps, seconds = load_averaged(args.run)
    temperature = calibrate(eye, args.data, args.batches, args.seed)
    notes = {"categories": json.dumps(list(categories)), "temperature": f"{temperature:.4f}"}
    save_weights(PATH, eye.state_dict(), notes)
    PATH.with_name("CARD.md").write_text(card(args.run, eye, categories, temperature))
    print(f"{PATH.name}: {steps} steps, {seconds / 60:.0f} min, temperature {temperature:.2f}")


if __name__ == "__main__":
    main()
