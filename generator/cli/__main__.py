"""Entry point of ``python -m generator.cli``."""

from __future__ import annotations

from . import main

main()
