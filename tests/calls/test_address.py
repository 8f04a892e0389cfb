"""Recognition of local addresses, for proxies, prices, keys and downloads."""

import pytest

from generator.calls import Session
from generator.calls.http.address import check_link, checked_address, local
from generator.errors import BackendError


@pytest.mark.parametrize(
    ("host", "here"),
    [("localhost", True), ("127.0.0.9", True), ("::1", True), ("10.0.0.1", False),
     ("::ffff:127.0.0.1", True), ("::ffff:10.0.0.1", False), ("0.0.0.0", True), ("::", True),
     ("localhost.", True), ("a.localhost.", True), ("box.", False),
     ("localhost.example.com", False)],
)  # fmt: skip
def test_this_machine_is_known(host: str, here: bool) -> None:
    assert local(host) is here


@pytest.mark.parametrize(
    "url",
    [5.0, None, ["x"], "", "http://", "http://[::1", "https://a\u2100b/x", "ftp://a/b", "//a/b",
     "http://a:99999", "http://a:0", "http://a b/", "http://a\\.b/", "http://a\n/", "x" * 9000],
)  # fmt: skip
def test_what_is_no_address_is_told(url: object) -> None:
    with pytest.raises(BackendError, match=r"^It must "):
        checked_address(url, "It")  # type: ignore[arg-type]
    with pytest.raises(BackendError, match=r"^It "):
        check_link(url, "It", BackendError)
    with pytest.raises(BackendError):
        Session().client("cloud", url)  # type: ignore[arg-type]


def test_links_hold_no_user_and_stay_as_they_are() -> None:
    link = "https://a.example/b?Signature=x%2Fy&e=1"
    assert check_link(link, "It", BackendError).geturl() == link
    for user in ("me@", "me:pw@", "@"):
        with pytest.raises(BackendError, match="a user name or a password") as told:
            check_link(link.replace("//", "//" + user), "It", BackendError)
        assert "pw" not in str(told.value).partition("a user name")[0]
