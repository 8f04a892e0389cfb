"""Loading of a bundle from an earlier version, which recorded backends by module."""

import subprocess
import sys
from pathlib import Path

from generator.bundle import load

KEPT = Path(__file__).parent / "kept" / "a-table-with-a-book-a88c64461be2"


def test_a_bundle_of_an_earlier_version_loads() -> None:
    scene = load(KEPT)
    assert [thing.label for thing in scene.objects] == ["book"]
    modeler = scene.provenance.backends["modeler"]["class"]
    assert modeler == "generator.backends.embedded.modeler.Modeler"


def test_it_is_sound_and_as_it_was_written() -> None:
    words = [sys.executable, "-m", "generator", "verify", str(KEPT)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr
