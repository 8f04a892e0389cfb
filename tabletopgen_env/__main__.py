"""``python -m tabletopgen_env``: the same as ``tabletopgen``."""

from __future__ import annotations

from generator.cli import main

if __name__ == "__main__":
    main()
