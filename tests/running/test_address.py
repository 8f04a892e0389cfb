"""One notion of this machine, for proxies, prices, keys and downloads."""

from __future__ import annotations

import pytest

from generator.running.address import local


@pytest.mark.parametrize(
    ("host", "here"),
    [("localhost", True), ("127.0.0.9", True), ("::1", True), ("10.0.0.1", False),
     ("::ffff:127.0.0.1", True), ("::ffff:10.0.0.1", False), ("0.0.0.0", True), ("::", True),
     ("localhost.", True), ("a.localhost.", True), ("box.", False),
     ("localhost.example.com", False)],
)  # fmt: skip
def test_this_machine_is_known(host: str, here: bool) -> None:
    assert local(host) is here
