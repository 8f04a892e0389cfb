"""One notion of this machine, for proxies, prices, keys and downloads."""

from __future__ import annotations

import pytest

from generator.running.address import local


@pytest.mark.parametrize(
    ("host", "here"),
    [("localhost", True), ("127.0.0.9", True), ("::1", True), ("10.0.0.1", False),
     ("localhost.example.com", False)],
)  # fmt: skip
def test_this_machine_is_known(host: str, here: bool) -> None:
    assert local(host) is here
