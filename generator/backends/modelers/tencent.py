"""Hunyuan3D-3.x as jobs of Tencent Cloud (service ai3d): submit, poll, download."""

from __future__ import annotations

import base64
import json
import os
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, get_args
from urllib.parse import urlsplit

from ...errors import BackendError, choices, require
from ...running.redaction import redacted
from ...running.session import Session
from ...scene import Instance, Model, SizePrior, View
from .cutout import cutout, png
from .normalising import Normal, foreign_model, normal_mesh
from .signing import signed_headers

SECRET_ID, SECRET_KEY = "TENCENTCLOUD_SECRET_ID", "TENCENTCLOUD_SECRET_KEY"
"""The environment's names for the two halves of the key."""

HOSTS = (".myqcloud.com", ".tencentcos.cn", ".tencentcos.com")
"""Where results may lie: Tencent's object storage."""

_VERSION = "2025-05-13"
_SUBMIT, _QUERY = "SubmitHunyuanTo3DProJob", "QueryHunyuanTo3DProJob"
_MODELS = {_SUBMIT: "hunyuan-3d-pro", _QUERY: "hunyuan-3d-query"}
_BUSY = "RequestLimitExceeded"  # too many calls, or too many jobs at once
_GONE = ("NotFound", "NotExist", "Expire")  # in the code of a job that is kept no longer
_MOST_BYTES = 256 * 2**20

Style = Literal["Normal", "LowPoly", "Geometry", "Sketch"]


class _LostJob(Exception):
    """A job submitted earlier of which nothing can be had any more."""


@dataclass(frozen=True)
class Tencent:
    """Has Tencent's cloud make one GLB per instance, as the paper does.

    Keys are read from ``TENCENTCLOUD_SECRET_ID`` and ``TENCENTCLOUD_SECRET_KEY`` at each call. A
    submission is remembered by its content: a run that goes on polls the job that it paid for.

    Attributes:
        endpoint: the service's address.
        region: where it runs.
        style: what it makes: "Normal" is textured, "Geometry" is not.
        pbr: whether it makes physically based materials; only their base colour is used.
        asked_faces: triangles that it is asked for, 40,000 to 1,500,000.
        interval: seconds between two looks at a job.
        timeout: seconds that a job may take.
        hosts: ends of the names of hosts that results may be downloaded from, over https.
        faces: most triangles kept, see ``Normal``.
        texture: side of a texture made anew, texels.
        session: what the calls of one generation share.
    """

    endpoint: str = "https://ai3d.tencentcloudapi.com"
    region: str = "ap-guangzhou"
    style: Style = "Normal"
    pbr: bool = False
    asked_faces: int = 40_000
    interval: float = 5.0
    timeout: float = 1800.0
    hosts: tuple[str, ...] = HOSTS
    faces: int = Normal.faces
    texture: int = Normal.texture
    session: Session = field(default_factory=Session, repr=False, compare=False)

    def __post_init__(self) -> None:
        if self.style not in get_args(Style):
            raise BackendError(
                f"tencent makes no {self.style!r}." + choices(self.style, get_args(Style))
            )
        require(self, "asked_faces", least=40_000, most=1_500_000, whole=True)
        require(self, "interval", "timeout", above=0)

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Return the cloud's mesh of one instance; see ``protocols.Modeler``.

        Of an earlier run's job that failed or is kept no longer, another is submitted, once.

        Raises:
            BackendError: no key, no answer, a job that fails, or no usable GLB.
        """
        what = f"tencent, model of {instance.name!r}:"
        body = {
            "ImageBase64": base64.b64encode(png(cutout(instance, "tencent"))).decode(),
            "GenerateType": self.style,
            "EnablePBR": self.pbr,
            "FaceCount": self.asked_faces,
        }
        try:
            raw = self._result(self._submit(body, what, "yes"), what)
        except _LostJob:
            try:
                raw = self._result(self._submit(body, what, "renew"), what)
            except _LostJob as error:
                raise BackendError(f"{what} {error}") from error
        to = Normal(self.faces, self.texture)
        return foreign_model(normal_mesh(raw, f"{what} the answer", to=to), instance, size)

    def _submit(self, body: Mapping[str, Any], what: str, memo: str) -> str:
        job = self._call(_SUBMIT, body, what, memo).get("JobId")
        if not isinstance(job, str) or not job:
            raise BackendError(f"{what} the submission was answered without a JobId.")
        return job

    def _result(self, job: str, what: str) -> bytes:
        """Return a job's GLB, once it is done.

        The last look at a job is kept with its answer: what is downloaded once needs no network
        again.

        Raises:
            _LostJob: it was over before this look at it, and nothing can be had of it.
        """
        until = time.monotonic() + self.timeout
        told = self._look(job, what, "yes")
        new = told.get("Status") in ("WAIT", "RUN")
        while told.get("Status") in ("WAIT", "RUN"):
            if time.monotonic() > until:
                raise BackendError(
                    f"{what} job {job} is not done after {self.timeout:g} s. It goes on there; "
                    "run it again to look at it again."
                )
            self.session.pause(self.interval)
            told = self._look(job, what, "renew")
        if told.get("Status") != "DONE":
            self._failed(told, job, what, new)
        raw = self._download(told, what)
        if raw is None:  # its address has expired: another look gives another
            raw = self._download(self._look(job, what, "renew"), what)
        if raw is None and not new:
            raise _LostJob(f"the result of job {job} is kept no longer.")
        if raw is None:
            raise BackendError(f"{what} the result of job {job} cannot be fetched. Run it again.")
        return raw

    def _look(self, job: str, what: str, memo: str) -> Mapping[str, Any]:
        return self._call(_QUERY, {"JobId": job}, what, memo)

    def _failed(self, told: Mapping[str, Any], job: str, what: str, new: bool) -> None:
        said = f"{told.get('ErrorCode', '')} {told.get('ErrorMessage', '')}".strip()
        reason = f"job {job} ended as {told.get('Status')!r} ({said[:300]})."
        if not new:
            raise _LostJob(reason)
        raise BackendError(f"{what} {reason} Run it again to submit it anew.")

    def _download(self, told: Mapping[str, Any], what: str) -> bytes | None:
        """Return the GLB that a job's answer names; None if its address has expired."""
        files = {str(f.get("Type", "")).upper(): f.get("Url") for f in _dicts(told)}
        url = files.get("GLB")
        if not isinstance(url, str):
            raise BackendError(f"{what} the result has no GLB." + choices("GLB", files))
        parts = urlsplit(url)
        if not self._trusted(parts.scheme, parts.hostname or ""):
            raise BackendError(
                f"{what} the result lies at {parts.scheme}://{parts.hostname}, not below "
                f"{', '.join(self.hosts)}. If that is right, add the host to Tencent.hosts."
            )
        client = self.session.client(
            "tencent", f"{parts.scheme}://{parts.netloc}", most_bytes=_MOST_BYTES
        )
        with client:
            answer = client.get(url, headers={"x-tabletopgen-question": "model"})
        return answer.content if answer.status_code == 200 else None

    def _trusted(self, scheme: str, host: str) -> bool:
        """Return whether results may be fetched from there; plain http only from this machine."""
        ends = tuple("." + end.lstrip(".") for end in self.hosts)
        safe = scheme == "https" or (scheme == "http" and host in ("127.0.0.1", "localhost"))
        return safe and f".{host}".endswith(ends)

    def _call(
        self, action: str, body: Mapping[str, Any], what: str, memo: str
    ) -> Mapping[str, Any]:
        """Return the Response of an action, waiting while the service is busy.

        Raises:
            BackendError: it refuses.
            _LostJob: the job that is asked about is kept no longer.
        """
        until = time.monotonic() + self.timeout
        while True:
            told, secrets = self._once(action, body, what, memo)
            error = told.get("Error")
            if not isinstance(error, Mapping):
                return told
            code = str(error.get("Code", ""))
            said = redacted(f"{code}: {error.get('Message', '')}"[:400], secrets)
            if not code.startswith(_BUSY) or time.monotonic() > until:
                break
            self.session.pause(self.interval)
        if action == _QUERY and any(word in code for word in _GONE):
            raise _LostJob(said)
        hint = f" Check {SECRET_ID} and {SECRET_KEY}." if code.startswith("AuthFailure") else ""
        raise BackendError(f"{what} {action} was refused ({said}).{hint}")

    def _once(
        self, action: str, body: Mapping[str, Any], what: str, memo: str
    ) -> tuple[Mapping[str, Any], tuple[str, ...]]:
        """Sign and send a call; returns its Response, and the keys that no message may hold."""
        keys = _keys(what)
        data = json.dumps(body).encode()
        host = urlsplit(self.endpoint).netloc
        headers = {
            **signed_headers(
                *keys, host=host, action=action, version=_VERSION, region=self.region,
                body=data, timestamp=int(time.time()),
            ),
            "x-tabletopgen-question": "model",
            "x-tabletopgen-model": _MODELS[action],
            "x-tabletopgen-memo": memo,
        }  # fmt: skip
        with self.session.client("tencent", self.endpoint, secrets=keys) as client:
            answer = client.post("/", content=data, headers=headers)
        try:
            told = json.loads(answer.content)["Response"]
        except (ValueError, KeyError, TypeError):
            told = None
        if not isinstance(told, Mapping):
            raise BackendError(
                f"{what} {action} was answered by {answer.status_code}, "
                f"{redacted(answer.text[:80], keys)!r}. Is {self.endpoint} Tencent's?"
            )
        return told, keys


def _keys(what: str) -> tuple[str, str]:
    found = os.environ.get(SECRET_ID, ""), os.environ.get(SECRET_KEY, "")
    if not all(found):
        raise BackendError(f"{what} no key. Set {SECRET_ID} and {SECRET_KEY} in the environment.")
    return found


def _dicts(told: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    listed = told.get("ResultFile3Ds")
    return [f for f in listed if isinstance(f, Mapping)] if isinstance(listed, list) else []
