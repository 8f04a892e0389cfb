"""TC3-HMAC-SHA256 against the worked example of Tencent Cloud's documentation, "Signature v3".

Its keys are masked on the page: the signature is that of the mask itself, in both of its forms.
"""

import hashlib

import pytest

from generator.backends.modelers.ai3d import authorization

BODY = b'{"Limit": 1, "Filters": [{"Values": ["\\u672a\\u547d\\u540d"], "Name": "instance-name"}]}'
MASKED = [
    ("*" * 32, "10b1a37a7301a02ca19a647ad722d5e43b4b3cff309d421d85b46093f6ab6c4f"),
    (
        "Gu5t9xGARNpq86cd98joQYCN3*******",
        "be4f67d323c78ab9acb7395e43c0dbcf822a9cfac32fea2449a7bc7726b770a3",
    ),
]


def sign(secret_id: str, key: str, timestamp: int = 1551113065) -> str:
    return authorization(
        secret_id, key, host="cvm.tencentcloudapi.com", action="DescribeInstances", body=BODY,
        timestamp=timestamp,
    )  # fmt: skip


def test_the_example_s_body_is_as_printed():
    printed = "35e9c5b0e3ae67532d3c9f17ead6c90222632e5b1ff7f6e89887f1398934f064"
    assert hashlib.sha256(BODY).hexdigest() == printed


@pytest.mark.parametrize(("key", "signature"), MASKED)
def test_the_published_signatures_come_out(key, signature):
    assert sign("AKID", key) == (
        "TC3-HMAC-SHA256 Credential=AKID/2019-02-25/cvm/tc3_request, "
        f"SignedHeaders=content-type;host;x-tc-action, Signature={signature}"
    )


def test_the_day_is_that_of_greenwich():
    assert "/2019-02-25/" in sign("AKID", "x", 1551139199)
    assert "/2019-02-26/" in sign("AKID", "x", 1551139200)
