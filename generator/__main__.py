"""Entry point of ``python -m generator``, which runs the ``tabletopgen`` command."""

from __future__ import annotations

from .cli import main

if __name__ == "__main__":
    main()
