"""Keys never appear in texts, in whatever form a server returns them."""

import base64
import json
from urllib.parse import quote

import pytest

from generator.calls.http.redaction import holds, plain_url, redact

KEY = 'mark/er+"7f3a'


@pytest.mark.parametrize(
    "written", [KEY, quote(KEY, safe=""), json.dumps(KEY), base64.b64encode(KEY.encode()).decode()]
)
def test_a_secret_goes_in_every_form(written: str) -> None:
    text = redact(f"Incorrect key provided: {written}. Look it up.", (KEY,))
    assert written.strip('"') not in text
    assert holds(written, (KEY,)) and not holds(text, (KEY,))
    assert text.startswith("Incorrect key provided: ") and text.endswith(". Look it up.")


@pytest.mark.parametrize(
    "text",
    [
        "Authorization: Bearer abcDEF123",
        "key sk-proj-abcdefgh12345 is wrong",
        "https://host/file.glb?q-signature=abcdef0123",
    ],
)
def test_what_is_shaped_like_a_key_goes_unasked(text: str) -> None:
    clean = redact(text)
    assert "[redacted]" in clean
    assert not {"abcDEF123", "sk-proj-abcdefgh12345", "abcdef0123"} & set(
        clean.replace("=", " ").split()
    )


@pytest.mark.parametrize(
    ("start", "length"),
    [("sk-", 32), ("sk-", 48), ("sk-proj-", 148), ("sk-ant-api03-", 95), ("sk-or-v1-", 64),
     ("sk_live_", 24), ("rk_live_", 24), ("hf_", 34), ("r8_", 37), ("gsk_", 52), ("xai-", 80)],
)  # fmt: skip
def test_keys_of_known_makers_go_unasked(start: str, length: int) -> None:
    key = start + ("a1B2c3D4e5F6" * 20)[:length]
    assert redact(f"key {key} is wrong") == "key [redacted] is wrong"


@pytest.mark.parametrize(
    "name", ["xai-grok-4-fast", "hf-internal-model-1", "pk-something-long", "r8_model_abcdef"]
)
def test_names_of_models_stay(name: str) -> None:
    assert redact(f"no model {name} here") == f"no model {name} here"


def test_a_longer_secret_goes_before_one_that_it_contains() -> None:
    assert redact("abcdef", ("abc", "abcdef")) == "[redacted]"


@pytest.mark.parametrize(
    ("secret", "text", "clean"),
    [
        ("e", "the key e, or e: see here", "the key [redacted], or [redacted]: see here"),
        ("EMPTY", "key EMPTY, not EMPTYING", "key [redacted], not EMPTYING"),
        ("12345678", "a123456789", "a[redacted]9"),
    ],
)
def test_a_short_secret_is_a_word_by_itself(secret: str, text: str, clean: str) -> None:
    assert redact(text, (secret,)) == clean
    assert holds(text, (secret,)) and not holds("here", (secret,))


def test_an_empty_secret_changes_nothing() -> None:
    assert redact("plain words", ("", " ")) == "plain words"


def test_links_signed_at_other_times_are_the_same() -> None:
    one = "https://me:pw@host:81/a/b.glb?size=2&q-sign-time=1&X-Amz-Date=3&sig=ab#part"
    two = "https://host:81/a/b.glb?size=2&q-sign-time=9&X-Amz-Date=4&sig=cd"
    assert plain_url(one) == plain_url(two) == "https://host:81/a/b.glb?size=2"
    assert plain_url(two) != plain_url(two.replace("size=2", "size=3"))


@pytest.mark.parametrize("name", ["key", "token", "id", "versionId", "q"])
def test_what_leads_elsewhere_is_another_link(name: str) -> None:
    assert plain_url(f"https://host/a?{name}=1") != plain_url(f"https://host/a?{name}=2")
