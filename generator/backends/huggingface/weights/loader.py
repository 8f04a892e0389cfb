"""Loading of a complete pinned model from safetensors in its folder, without the network."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ....errors import BackendError
from ...requirements import module
from .pins import WEIGHTS, Pin, find_model, snapshot

_HOW = "Run: pip install 'tabletopgen[huggingface]'"


def device_for(chosen: str) -> str:
    """Return the chosen device; the default is "cuda" if it is available, or else "cpu"."""
    import torch

    return chosen or ("cuda" if torch.cuda.is_available() else "cpu")


def load_model(pin: Pin, folder: Path, what: str, *, device: str = "cpu") -> Any:
    """Load a model in float32, in inference mode; its weights have no gradients.

    ``what`` names the backend and the question in error messages.

    Raises:
        BackendError: transformers is not installed or too old; or the model is missing, damaged or
            incomplete.
    """
    import torch

    transformers = module("transformers", "huggingface", _HOW)
    kind = getattr(transformers, pin.kind, None)
    if kind is None:
        raise BackendError(
            f"{what} the installed transformers {transformers.__version__} has no class "
            f"{pin.kind}. {_HOW} --upgrade"
        )
    home = find_model(pin, folder, what)
    try:
        with _quiet(transformers):
            network, report = kind.from_pretrained(
                str(home), local_files_only=True, use_safetensors=True,
                output_loading_info=True, dtype=torch.float32,
            )  # fmt: skip
    except Exception as error:  # any error of transformers, safetensors and torch
        said = " ".join(str(error).split())[:300]
        raise BackendError(
            f"{what} model {pin.name} in {home} cannot be read ({type(error).__name__}: {said}). "
            f"{_anew(pin, folder)}"
        ) from error
    wrong = sorted({str(k) for k in (*report["missing_keys"], *report["mismatched_keys"])})
    if wrong:
        some = ", ".join(wrong[:3])
        raise BackendError(
            f"{what} {home / WEIGHTS} lacks {len(wrong)} weights of {pin.kind} ({some}). "
            f"{_anew(pin, folder)}"
        )
    return network.to(device).eval().requires_grad_(False)


def load_tokenizer(pin: Pin, folder: Path, what: str) -> Any:
    """Load a model's tokenizer.

    Raises:
        BackendError: the tokenizer is missing or damaged.
    """
    transformers = module("transformers", "huggingface", _HOW)
    file = find_model(pin, folder, what) / "tokenizer.json"
    try:
        return transformers.PreTrainedTokenizerFast(tokenizer_file=str(file))
    except Exception as error:  # tokenizers raises plain Exception
        raise BackendError(
            f"{what} {file} cannot be read ({error}). {_anew(pin, folder)}"
        ) from error


def _anew(pin: Pin, folder: Path) -> str:
    """Return advice for replacing a damaged model, whose folder contains links to its files."""
    return (
        f"Delete {snapshot(pin, folder).parents[1]} and run: "
        f"tabletopgen models pull {pin.name} --folder {folder}"
    )


@contextlib.contextmanager
def _quiet(transformers: Any) -> Iterator[None]:
    """Suppress progress bars and loading reports; this module checks their content instead."""
    log = transformers.utils.logging
    level, bars = log.get_verbosity(), log.is_progress_bar_enabled()
    log.set_verbosity_error()
    log.disable_progress_bar()
    try:
        yield
    finally:
        log.set_verbosity(level)
        if bars:
            log.enable_progress_bar()
