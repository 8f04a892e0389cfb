"""Sources of the cloud backend's server, models and keys, and destinations of keys."""

import importlib.util
import sys

import pytest
from desk import reference
from openai_server import CHAT, IMAGES, Running

from generator.backends import Backends
from generator.backends.cloud.imager import CloudImager
from generator.backends.cloud.reasoner import CloudReasoner
from generator.backends.cloud.server import configuration
from generator.errors import BackendError

OPENAI = "https://api.openai.com/v1"
ARK = "https://ark.cn-beijing.volces.com/api/v3"
BASE, IMAGE_BASE = "TABLETOPGEN_CLOUD_BASE_URL", "TABLETOPGEN_CLOUD_IMAGE_BASE_URL"
CLOUD_KEY, IMAGE_KEY = "TABLETOPGEN_CLOUD_KEY", "TABLETOPGEN_CLOUD_IMAGE_KEY"


@pytest.fixture
def setting(server: Running, monkeypatch: pytest.MonkeyPatch):
    """Set one variable and no other of the cloud backend."""
    for name in (BASE, CLOUD_KEY, "TABLETOPGEN_CLOUD_CHAT_MODEL", "TABLETOPGEN_CLOUD_IMAGE_MODEL"):
        monkeypatch.delenv(name)
    return monkeypatch.setenv


def test_openai_is_asked_if_nothing_is_said(setting) -> None:
    reasoner, imager = CloudReasoner(), CloudImager()
    assert (reasoner.base_url, reasoner.model, reasoner.server) == (OPENAI, "gpt-6-luna", "openai")
    assert (imager.base_url, imager.form) == (OPENAI, "openai")
    assert imager.model == "gpt-image-2.6-sunburst"


def test_pictures_may_come_from_another_server(setting) -> None:
    setting(IMAGE_BASE, ARK)
    setting("TABLETOPGEN_CLOUD_IMAGE_MODEL", "ep-1")
    imager = CloudImager()
    assert (imager.base_url, imager.form, imager.server) == (ARK, "seedream", "ark")
    assert (imager.chat_base_url, imager.chat_model) == (OPENAI, "gpt-6-luna")


def test_the_environment_chooses(server: Running) -> None:
    backends = Backends.select("embedded", reasoner="cloud", imager="cloud")
    identity = backends.identity()
    assert identity["reasoner"]["base_url"] == server.url
    assert identity["reasoner"]["model"] == CHAT
    assert identity["imager"]["model"] == IMAGES
    assert identity["imager"]["chat_model"] == CHAT
    assert "session" not in identity["reasoner"]
    assert not any("sk-test" in str(value) for value in identity.values())


def test_a_model_must_be_named_elsewhere(setting) -> None:
    setting(BASE, "http://127.0.0.1:11434/v1")
    with pytest.raises(BackendError, match="Set TABLETOPGEN_CLOUD_CHAT_MODEL"):
        CloudReasoner()
    with pytest.raises(BackendError, match="Set TABLETOPGEN_CLOUD_IMAGE_MODEL"):
        CloudImager()


@pytest.mark.parametrize(
    "url",
    ["api.openai.com/v1", "ftp://x/v1", "", "https://me:pass@host/v1", "https://host/v1?key=x"],
)
def test_an_address_of_no_use_is_refused(server: Running, url: str) -> None:
    with pytest.raises(BackendError, match="cloud: the base URL") as caught:
        CloudReasoner(base_url=url)
    assert "pass@" not in str(caught.value)


def test_a_slash_at_the_end_makes_no_other_backend(server: Running) -> None:
    assert CloudReasoner(base_url=server.url + "/") == CloudReasoner(base_url=server.url)


@pytest.mark.parametrize(
    ("url", "names"),
    [
        (OPENAI, "TABLETOPGEN_CLOUD_KEY or OPENAI_API_KEY"),
        (ARK, "TABLETOPGEN_CLOUD_KEY or ARK_API_KEY"),
        ("https://openrouter.ai/api/v1", "TABLETOPGEN_CLOUD_KEY or OPENROUTER_API_KEY"),
        ("https://gpu.example:8000/v1", "TABLETOPGEN_CLOUD_KEY;"),
    ],
)
def test_a_missing_key_names_its_variables(setting, url: str, names: str) -> None:
    with pytest.raises(BackendError, match=f"Set {names}"):
        configuration.key(url, "chat")


def test_a_missing_key_names_backend_and_question(setting) -> None:
    setting(BASE, "https://gpu.example/v1")
    with pytest.raises(BackendError, match=r"^cloud \(m at gpu.example\): list_objects: no key"):
        CloudReasoner(model="m").list_objects(reference())


def test_what_cannot_be_selected_names_the_role(setting) -> None:
    setting(BASE, "http://127.0.0.1:11434/v1")
    with pytest.raises(BackendError, match=r"^imager: cloud: no image model is set"):
        Backends.select("embedded", imager="cloud")


@pytest.mark.parametrize("host", ["localhost", "127.0.0.1", "127.0.0.2", "[::1]", "gpu.localhost"])
def test_no_key_is_needed_here(setting, host: str) -> None:
    assert configuration.key(f"http://{host}:11434/v1", "chat") == "none-needed"


def test_keys_go_to_their_own_hosts_alone(setting) -> None:
    setting("OPENAI_API_KEY", "key-of-openai")
    setting("ARK_API_KEY", "key-of-ark")
    assert configuration.key(OPENAI, "chat") == "key-of-openai"
    assert configuration.key(ARK, "image") == "key-of-ark"
    with pytest.raises(BackendError):
        configuration.key("https://gpu.example/v1", "chat")
    setting(CLOUD_KEY, "key-of-chat")
    assert configuration.key(OPENAI, "chat") == "key-of-chat"
    assert configuration.key(OPENAI, "image") == "key-of-chat"  # the same host
    assert configuration.key(ARK, "image") == "key-of-ark"
    with pytest.raises(BackendError, match="Set TABLETOPGEN_CLOUD_IMAGE_KEY;"):
        configuration.key("https://gpu.example/v1", "image")
    setting(IMAGE_KEY, "key-of-pictures")
    assert configuration.key("https://gpu.example/v1", "image") == "key-of-pictures"
    assert configuration.key("https://gpu.example/v1", "chat") == "key-of-chat"


@pytest.mark.parametrize(
    ("address", "base", "may"),
    [
        ("https://api.openai.com/x.png", OPENAI, True),
        ("https://abc.blob.core.windows.net/x.png?sig=1", OPENAI, True),
        ("https://ark-project.tos-cn-beijing.volces.com/x.png", ARK, True),
        ("https://volces.com.evil.example/x.png", ARK, False),
        ("https://evilvolces.com/x.png", ARK, False),
        ("http://ark-project.tos-cn-beijing.volces.com/x.png", ARK, False),
        ("https://me:pass@api.openai.com/x.png", OPENAI, False),
        ("https://169.254.169.254/latest", OPENAI, False),
        ("file:///etc/passwd", OPENAI, False),
        ("", OPENAI, False),
        ("http://127.0.0.1:8000/x.png", "http://127.0.0.1:8000/v1", True),
        ("http://127.0.0.1:9000/x.png", "http://127.0.0.1:8000/v1", False),
    ],
)
def test_where_pictures_may_be_fetched(setting, address: str, base: str, may: bool) -> None:
    assert configuration.may_fetch(address, base) is may


def test_more_hosts_can_be_named(setting) -> None:
    setting("TABLETOPGEN_CLOUD_IMAGE_HOSTS", "cdn.example, .store.example")
    assert configuration.may_fetch("https://cdn.example/x", OPENAI)
    assert configuration.may_fetch("https://a.store.example/x", OPENAI)
    assert not configuration.may_fetch("https://a.cdn.example/x", OPENAI)


@pytest.mark.parametrize(
    ("missing", "told"),
    [({"openai"}, "needs openai: pip"), ({"openai", "pydantic"}, "needs openai and pydantic: pip")],
    ids=("one", "both"),
)
def test_a_missing_extra_names_the_pip_line(
    monkeypatch: pytest.MonkeyPatch, missing: set[str], told: str
) -> None:
    there = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util, "find_spec", lambda name: None if name in missing else there(name)
    )
    for name in ("", ".reasoner"):
        monkeypatch.delitem(sys.modules, f"generator.backends.cloud{name}")
    with pytest.raises(BackendError, match=rf"{told} install 'tabletopgen\[cloud\]'"):
        Backends.select("embedded", reasoner="cloud")
