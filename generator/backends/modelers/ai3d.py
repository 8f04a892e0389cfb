"""Client for Tencent Cloud's ai3d service: signed calls that submit and poll jobs."""

from __future__ import annotations

import json
import os
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from ...calls.http.redaction import excerpt
from ...calls.session import Session
from ...calls.store import Used
from ...errors import BackendError
from ...io.bounded import parse_object, printable, split_url

if TYPE_CHECKING:
    import httpx2

import hashlib
import hmac
from datetime import UTC, datetime
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import httpx2


SECRET_ID, SECRET_KEY = "TENCENTCLOUD_SECRET_ID", "TENCENTCLOUD_SECRET_KEY"
"""Environment variables with the two parts of the key."""

_VERSION = "2025-05-13"
_SUBMIT, _QUERY = "SubmitHunyuanTo3DProJob", "QueryHunyuanTo3DProJob"
_MODELS = {_SUBMIT: "hunyuan-3d-pro", _QUERY: "hunyuan-3d-query"}  # in ledgers
_BUSY = "RequestLimitExceeded"  # too many calls, or too many concurrent jobs
_EXPIRED = "AuthFailure.SignatureExpire"  # the clocks differ by more than five minutes
_GONE = ("NotFound", "NotExist", "Expire")  # in the error codes of jobs that are no longer stored


class LostJob(Exception):
    """The result of an earlier job is no longer available."""


def read_keys(what: str) -> tuple[str, str]:
    """Return the secret id and the secret key from the environment.

    Raises:
        BackendError: they are not set; ``what`` is the start of the message.
    """
    found = os.environ.get(SECRET_ID, ""), os.environ.get(SECRET_KEY, "")
    if not all(found):
        raise BackendError(
            f"{what} the key is missing. Set {SECRET_ID} and {SECRET_KEY} in the environment."
        )
    return found


@dataclass(frozen=True)
class Service:
    """The client for one instance; ``what`` starts error messages, and ``used`` records answers.

    While the service is busy, a call is repeated every ``interval`` seconds, for up to ``timeout``
    seconds.
    """

    client: httpx2.Client
    keys: tuple[str, str] = field(repr=False)
    endpoint: str
    region: str
    what: str
    session: Session
    interval: float
    timeout: float
    used: Used

    def submit(self, body: Mapping[str, Any], memo: str) -> str:
        """Submit a job and return its id; an earlier job with the same body is reused.

        With ``memo`` "renew", a new job is always submitted.

        Raises:
            BackendError: the service refuses the job or returns no id.
        """
        job = self._call(_SUBMIT, body, memo).get("JobId")
        with self.used.dropped_on(BackendError):
            if not isinstance(job, str) or not job:
                raise BackendError(f"{self.what} the response to the submission has no JobId.")
            return printable(job, f"{self.what} the JobId", BackendError)

    def look(self, job: str, memo: str) -> Mapping[str, Any]:
        """Return the state of a job or, with ``memo`` "yes", its last known state, if any.

        Raises:
            BackendError: the service refuses.
            LostJob: the job is no longer stored.
        """
        return self._call(_QUERY, {"JobId": job}, memo)

    def _call(self, action: str, body: Mapping[str, Any], memo: str) -> Mapping[str, Any]:
        until = time.monotonic() + self.timeout
        while True:
            reply = self._once(action, body, memo)
            error = reply.get("Error")
            if not isinstance(error, Mapping):
                return reply
            code = str(error.get("Code", ""))
            if not code.startswith(_BUSY) or time.monotonic() > until:
                break
            self.session.pause(self.interval)
        said = excerpt(f"{code[:200]}: {error.get('Message', '')}", 400, self.keys)
        if action == _QUERY and any(word in code for word in _GONE):
            raise LostJob(said)
        raise BackendError(f"{self.what} {action} was refused ({said}).{_hint(code)}")

    def _once(self, action: str, body: Mapping[str, Any], memo: str) -> Mapping[str, Any]:
        """Send a call, which the client signs, and return its Response."""
        headers = {
            "Content-Type": KIND,
            "Host": split_url(self.endpoint, "tencent: its address", BackendError).netloc,
            "X-TC-Action": action,
            "X-TC-Version": _VERSION,
            "X-TC-Region": self.region,
            "x-tabletopgen-question": "model",
            "x-tabletopgen-model": _MODELS[action],
            "x-tabletopgen-memo": memo,
            # only the submission of a job is billed
            "x-tabletopgen-free": "yes" if action == _QUERY else "no",
        }
        answer = self.client.post("/", content=json.dumps(body).encode(), headers=headers)
        self.used.add(answer.headers)
        try:
            reply = parse_object(answer.content, "The answer", BackendError).get("Response")
        except BackendError:
            reply = None
        if not isinstance(reply, Mapping):
            self.used.drop(last=True)
            raise BackendError(
                f"{self.what} {action} returned status {answer.status_code}, "
                f"{excerpt(answer.content, 80, self.keys)!r}. Check that {self.endpoint} is "
                "Tencent's address."
            )
        return reply


def _hint(code: str) -> str:
    """Return advice for the error code of a refused call."""
    if code == _EXPIRED:
        return " The signature was new, so check this machine's clock."
    if code.startswith("AuthFailure"):
        return f" Check {SECRET_ID} and {SECRET_KEY}."
    return ""


KIND = "application/json; charset=utf-8"
"""Content type of a signed body."""

_SIGNED = "content-type;host;x-tc-action"
_METHOD = "TC3-HMAC-SHA256"


def authorization(
    secret_id: str, secret_key: str, *, host: str, action: str, body: bytes, timestamp: int
) -> str:
    """Return the Authorization header of a POST to the root of ``host``.

    The service is the first label of the host. ``timestamp`` is Unix time in seconds; the server
    accepts it for five minutes.
    """
    service = host.partition(".")[0]
    day = datetime.fromtimestamp(timestamp, UTC).strftime("%Y-%m-%d")
    scope = f"{day}/{service}/tc3_request"
    headers = f"content-type:{KIND}\nhost:{host}\nx-tc-action:{action.lower()}\n"
    request = "\n".join(["POST", "/", "", headers, _SIGNED, _digest(body)])
    text = "\n".join([_METHOD, str(timestamp), scope, _digest(request.encode())])
    key = f"TC3{secret_key}".encode()
    for word in (day, service, "tc3_request"):
        key = _hmac(key, word)
    signature = _hmac(key, text).hex()
    return (
        f"{_METHOD} Credential={secret_id}/{scope}, SignedHeaders={_SIGNED}, Signature={signature}"
    )


def signature(request: httpx2.Request, secret_id: str, secret_key: str) -> Mapping[str, str]:
    """Return headers that sign a request now; the request must name its host and action."""
    timestamp = int(time.time())
    host, action = request.headers["host"], request.headers["x-tc-action"]
    signed = authorization(
        secret_id, secret_key, host=host, action=action, body=request.read(), timestamp=timestamp
    )
    return {"Authorization": signed, "X-TC-Timestamp": str(timestamp)}


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def _hmac(key: bytes, text: str) -> bytes:
    return hmac.new(key, text.encode(), hashlib.sha256).digest()
