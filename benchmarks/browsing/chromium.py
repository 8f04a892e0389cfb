"""Headless Chromium without GPU and network access, and a server for local sites."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Playwright

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
"""Path of Chromium; None if it is not installed."""

ENGINE = "[...window.tabletopgen.values()][0]"
"""The first live scene of a page, in JavaScript."""

_OPTIONS = (
    "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--disable-quic", "--no-first-run",
    "--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1",  # this machine only
)  # fmt: skip


_LONGEST_TEMPORARY = 50
"""Maximum length of the temporary folder's path: socket addresses have at most 107 bytes."""


def launch(play: Playwright) -> Browser:
    """Start a browser; ``CHROMIUM`` must exist."""
    environment: dict[str, str | float | bool] = {**os.environ}
    if len(tempfile.gettempdir()) > _LONGEST_TEMPORARY:
        environment["TMPDIR"] = "/tmp"  # Chromium exits immediately if the address is longer
    return play.chromium.launch(executable_path=CHROMIUM, args=[*_OPTIONS], env=environment)


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, format: str, *args: object) -> None:
        pass


@contextmanager
def serve(folder: Path) -> Iterator[str]:
    """Serve a folder like `python -m http.server`; yield its address."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(folder)))
    thread = Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_address[1]}/"
    finally:
        server.shutdown()
        server.server_close()
        thread.join(5)
