"""Reading a pinned model from its folder: safetensors only, whole, and never from the network."""

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
    """Return the device that was chosen; if none was, "cuda" where there is one."""
    import torch

    return chosen or ("cuda" if torch.cuda.is_available() else "cpu")


def load_model(pin: Pin, folder: Path, what: str, *, device: str = "cpu") -> Any:
    """Read a model in float32, ready to answer; its weights take no gradients.

    ``what`` names backend and question, for the message of an error.

    Raises:
        BackendError: transformers is not installed or too old; the model is not there, damaged,
            or lacks weights.
    """
    import torch

    transformers = module("transformers", "huggingface", _HOW)
    kind = getattr(transformers, pin.kind, None)
    if kind is None:
        raise BackendError(
            f"{what} the installed transformers {transformers.__version__} has no {pin.kind}. "
            f"{_HOW} --upgrade"
        )
    home = find_model(pin, folder, what)
    try:
        with _quiet(transformers):
            network, report = kind.from_pretrained(
                str(home), local_files_only=True, use_safetensors=True,
                output_loading_info=True, dtype=torch.float32,
            )  # fmt: skip
    except Exception as error:  # whatever transformers, safetensors and torch raise
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
    """Read a model's tokenizer (BackendError: it is not there, or damaged)."""
    transformers = module("transformers", "huggingface", _HOW)
    file = find_model(pin, folder, what) / "tokenizer.json"
    try:
        return transformers.PreTrainedTokenizerFast(tokenizer_file=str(file))
    except Exception as error:  # tokenizers raises Exception itself
        raise BackendError(
            f"{what} {file} cannot be read ({error}). {_anew(pin, folder)}"
        ) from error


def _anew(pin: Pin, folder: Path) -> str:
    """Say how to fetch a damaged model anew: its files are links to others in the same folder."""
    return (
        f"Delete {snapshot(pin, folder).parents[1]} and run: "
        f"tabletopgen models pull {pin.name} --folder {folder}"
    )


@contextlib.contextmanager
def _quiet(transformers: Any) -> Iterator[None]:
    """Keep bars and reports of loading from standard error; what they tell is checked here."""
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
