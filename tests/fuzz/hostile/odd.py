"""Unusual entries in place of files: pipes, links, folders, devices."""

import os
import random
from pathlib import Path

LINKS = ("/dev/zero", "../../precious/file.txt", "../../../precious/file.txt", "nowhere", ".")
"""What links of hostile folders lead to; read only, and outside."""


def put(path: Path, content: bytes, rng: random.Random, share: float = 0.05) -> None:
    """Write a file, or with a probability of ``share`` an unusual entry instead."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if rng.random() >= share:
        path.write_bytes(content)
        return
    kind = rng.randrange(6)
    if kind == 0:
        os.mkfifo(path)
    elif kind == 1:
        path.symlink_to(rng.choice((*LINKS, path.name)))
    elif kind == 2:
        path.mkdir()
    elif kind == 3:
        path.write_bytes(b"")
    elif kind == 4:
        path.write_bytes(content)
        path.chmod(0)
    else:
        with path.open("wb") as file:
            file.truncate(rng.choice((2**20, 3 * 2**30)))  # sparse: large without using space
