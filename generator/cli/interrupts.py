"""Reliable handling of Ctrl-C, exactly once."""

from __future__ import annotations

import signal
import sys
import threading

AGAIN = 0.05  # seconds until a lost interrupt is sent again


def heed() -> None:
    """Send an interrupt again if it arrived where Python cannot raise it.

    In a destructor or a callback of the import system, Python reports a ``KeyboardInterrupt`` as
    ignored and continues, so that Ctrl-C would have no effect.
    """
    others = sys.unraisablehook

    def hook(ignored: sys.UnraisableHookArgs) -> None:
        if ignored.exc_type is not KeyboardInterrupt:
            others(ignored)
            return
        main = threading.main_thread().ident
        timer = threading.Timer(AGAIN, signal.pthread_kill, (main, signal.SIGINT))
        timer.daemon = True
        timer.start()

    sys.unraisablehook = hook


def ignore() -> None:
    """Ignore interrupts from now on, because the command has finished."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
