"""``python -m tabletopgen_env``: an alias of the ``tabletopgen`` command."""

from __future__ import annotations

from generator.cli import main

if __name__ == "__main__":
    main()
