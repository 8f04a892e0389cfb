"""Fixtures of the cloud backend's tests: a protocol server, keys and sessions."""

import os
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from openai_server import CHAT, IMAGES, KEY, Running, start

from generator.backends.cloud.imager import CloudImager
from generator.backends.cloud.reasoner import CloudReasoner
from generator.backends.embedded.imager import EmbeddedImager as EmbeddedImager
from generator.calls.http.retries import RetryPolicy
from generator.calls.session import Session

QUICK = RetryPolicy(first=0.01, longest=0.02, rest=0.05)


@pytest.fixture
def server(monkeypatch: pytest.MonkeyPatch) -> Iterator[Running]:
    for name in list(os.environ):
        if name.startswith("TABLETOPGEN_CLOUD") or name.endswith("_API_KEY"):
            monkeypatch.delenv(name)
    monkeypatch.setenv("TABLETOPGEN_CLOUD_KEY", KEY)
    running = start()
    monkeypatch.setenv("TABLETOPGEN_CLOUD_BASE_URL", running.url)
    monkeypatch.setenv("TABLETOPGEN_CLOUD_CHAT_MODEL", CHAT)
    monkeypatch.setenv("TABLETOPGEN_CLOUD_IMAGE_MODEL", IMAGES)
    yield running
    running.stop()


@pytest.fixture
def session() -> Session:
    return Session(retry_policy=QUICK, attempts=3)


@pytest.fixture
def reasoner(server: Running, session: Session) -> CloudReasoner:
    return CloudReasoner(session=session)


@pytest.fixture
def make_imager(server: Running, session: Session) -> Callable[..., CloudImager]:
    def make(**fields: Any) -> CloudImager:
        return CloudImager(**{"session": session, "fallback": EmbeddedImager(), **fields})

    return make
