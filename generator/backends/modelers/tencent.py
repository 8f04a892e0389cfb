"""Hunyuan3D-3.x on Tencent Cloud (service ai3d): jobs are submitted, polled and downloaded."""

from __future__ import annotations

import base64
import contextlib
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, get_args

from ...calls.http.address import check_link, local
from ...calls.http.redaction import excerpt
from ...calls.session import Session
from ...calls.store import Used
from ...errors import BackendError, choices, require
from ...io.pictures import encode_png
from ...meshes.canonical import Normal, foreign_model, normal_mesh
from ...meshes.reading.loader import check_glb
from ...scene import Instance, Model, SizePrior, View
from .ai3d import LostJob, Service, read_keys, signature
from .cutout import cutout

HOSTS = (".myqcloud.com", ".tencentcos.cn", ".tencentcos.com")
"""Hosts of results: Tencent's object storage."""

_MOST_BYTES = 256 * 2**20
_MOST_FILES = 100  # maximum number of files in a result

Style = Literal["Normal", "LowPoly", "Geometry", "Sketch"]


@dataclass(frozen=True)
class Tencent:
    """A modeler that uses Tencent's cloud to make one GLB per instance, as the paper does.

    Keys are read from ``TENCENTCLOUD_SECRET_ID`` and ``TENCENTCLOUD_SECRET_KEY`` at each call.
    Submissions are stored by their content: a resumed run polls the job that it has paid for.

    Attributes:
        endpoint: the service's address.
        region: the service's region.
        style: kind of result: "Normal" is textured, "Geometry" is not.
        pbr: whether to request physically based materials; only their base colour is used.
        asked_faces: requested number of triangles, 40,000 to 1,500,000.
        interval: seconds between polls of a job.
        timeout: maximum duration of a job in seconds.
        hosts: suffixes of the hosts from which results may be downloaded over https.
        faces: maximum number of triangles kept, see ``Normal``.
        texture: side of rebuilt textures in texels.
        session: state that all calls of one generation share.
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
                f"Tencent.style {self.style!r} is unknown." + choices(self.style, get_args(Style))
            )
        require(self, "asked_faces", minimum=40_000, maximum=1_500_000, integer=True)
        require(self, "interval", "timeout", above=0)

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Return the cloud's mesh of one instance; see ``protocols.Modeler``.

        If an earlier run's job failed or is no longer stored, one new job is submitted. A job whose
        result is unusable is forgotten: the next run submits, and pays for, another one.

        Raises:
            BackendError: no key, no answer, a failed job, or no usable GLB.
        """
        what = f"tencent, model of {instance.name!r}:"
        to = Normal(self.faces, self.texture)
        body = {
            "ImageBase64": base64.b64encode(encode_png(cutout(instance, "tencent"))).decode(),
            "GenerateType": self.style,
            "EnablePBR": self.pbr,
            "FaceCount": self.asked_faces,
        }
        used, keys = Used(self.session.store), read_keys(what)
        with self.session.client(
            "tencent", self.endpoint, secrets=keys, sign=lambda request: signature(request, *keys)
        ) as client:
            service = Service(
                client, keys, self.endpoint, self.region, what, self.session, self.interval,
                self.timeout, used,
            )  # fmt: skip
            try:
                raw = self._result(service, service.submit(body, "yes"))
            except LostJob:
                try:
                    raw = self._result(service, service.submit(body, "renew"))
                except LostJob as error:
                    raise BackendError(f"{what} {error}") from error
        with used.dropped_on(BackendError):
            mesh = normal_mesh(raw, f"{what} the answer", to=to)
        return foreign_model(mesh, instance, size)

    def _result(self, service: Service, job: str) -> bytes:
        """Wait for a job and return its GLB; a stored result is returned without network access.

        Raises:
            LostJob: an earlier run's job has failed, or its result is no longer available.
        """
        what, until = service.what, time.monotonic() + self.timeout
        reply = service.look(job, "yes")
        new = reply.get("Status") in ("WAIT", "RUN")
        while reply.get("Status") in ("WAIT", "RUN"):
            if time.monotonic() > until:
                raise BackendError(
                    f"{what} job {job} is not done after {self.timeout:g} s. The job continues "
                    "on the server; run the command again to resume waiting."
                )
            self.session.pause(self.interval)
            reply = service.look(job, "renew")
        if reply.get("Status") != "DONE":
            said = f"{reply.get('ErrorCode', '')} {reply.get('ErrorMessage', '')}".strip()
            said = excerpt(said, 300, service.keys)
            reason = f"job {job} ended as {str(reply.get('Status'))[:40]!r} ({said})."
            if not new:
                raise LostJob(reason)
            raise BackendError(f"{what} {reason} Run it again to submit a new job.")
        raw = self._download(reply, service)
        if raw is None:  # its URL has expired; another poll returns a new one
            raw = self._download(service.look(job, "renew"), service)
        if raw is None and not new:
            raise LostJob(f"the result of job {job} is no longer stored.")
        if raw is None:
            raise BackendError(
                f"{what} the result of job {job} cannot be downloaded. Run the command again."
            )
        return raw

    def _download(self, reply: Mapping[str, Any], service: Service) -> bytes | None:
        """Return the GLB of a finished job, or None if its URL has expired."""
        what = service.what
        files = dict(_files(reply))
        if "GLB" not in files:
            service.used.drop()
            raise BackendError(f"{what} the result contains no GLB." + choices("GLB", files))
        url = files["GLB"]
        try:
            parts = check_link(url, f"{what} the result's address", BackendError)
        except BackendError:
            service.used.drop(last=True)  # the job is paid for; the next run polls it again
            raise
        if not self._trusted(parts.scheme, parts.hostname or ""):
            raise BackendError(
                f"{what} the result is at {parts.scheme}://{parts.hostname}, which is not a "
                f"subdomain of {', '.join(self.hosts)}. If the host is trusted, add it to "
                "Tencent.hosts."
            )
        with self.session.client(
            "tencent", f"{parts.scheme}://{parts.netloc}", most_bytes=_MOST_BYTES
        ) as client:
            for memo in ("yes", "renew"):  # a damaged stored answer is downloaded once more
                headers = {"x-tabletopgen-question": "model", "x-tabletopgen-memo": memo}
                answer = client.get(url, headers=headers)
                service.used.add(answer.headers)
                if answer.status_code != 200:
                    break
                with contextlib.suppress(BackendError):
                    check_glb(answer.content, what)
                    break
        return answer.content if answer.status_code == 200 else None

    def _trusted(self, scheme: str, host: str) -> bool:
        """Return whether results may be downloaded from a host; only a local one may use http."""
        ends = tuple("." + end.lstrip(".") for end in self.hosts)
        safe = scheme == "https" or (scheme == "http" and local(host))
        return safe and f".{host}".endswith(ends)


def _files(reply: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield the type and the URL of each file of a job's result that has both."""
    listed = reply.get("ResultFile3Ds")
    for entry in listed[:_MOST_FILES] if isinstance(listed, list) else ():
        kind, url = (entry.get("Type"), entry.get("Url")) if isinstance(entry, Mapping) else (0, 0)
        if isinstance(kind, str) and isinstance(url, str) and len(kind) <= 20 and kind.isalnum():
            yield kind.upper(), url
