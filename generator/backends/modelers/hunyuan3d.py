"""Hunyuan3D-2.x on your own server, which runs ``api_server.py`` of version 2.0 or 2.1."""

from __future__ import annotations

import base64
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from ...calls.http.address import checked_address
from ...calls.session import Session
from ...calls.store import Used
from ...errors import BackendError, choices, require
from ...io.bounded import parse_object
from ...io.pictures import encode_png
from ...meshes.canonical import Normal, foreign_model, normal_mesh
from ...meshes.reading.loader import check_glb
from ...scene import Instance, Model, SizePrior, View
from .cutout import cutout

ADDRESS = "TABLETOPGEN_HUNYUAN3D_URL"
"""Environment variable that sets the server's address, used if ``Hunyuan3D.url`` is empty."""

_USUAL = "http://127.0.0.1:8081"  # the server's default address
_MOST_BYTES = 128 * 2**20
_HEALTH_SECONDS = 10.0
_ROUTE = "generate"  # the only route that reports failures

Version = Literal["2.0", "2.1"]


@dataclass(frozen=True)
class Hunyuan3D:
    """A modeler that calls a local Hunyuan3D server for one textured GLB per instance.

    The server processes one request at a time. Version 2.1 ignores seed, steps and resolution;
    version 2.0 needs ``--enable_tex`` for textures. Both receive a cut-out, because 2.1 never
    removes backgrounds.

    Attributes:
        url: the server's address; if empty, the environment variable ``TABLETOPGEN_HUNYUAN3D_URL``
            sets it, or else it is ``http://127.0.0.1:8081``.
        version: version of the request format.
        textured: whether to texture the mesh.
        seed: seed of the server's noise.
        octree: resolution of the surface, 64 to 512.
        steps: diffusion steps, 1 to 20.
        guidance: guidance scale of the diffusion.
        asked_faces: requested number of triangles.
        timeout: seconds per answer, including the server's work for other clients.
        faces: maximum number of triangles kept, see ``Normal``.
        texture: side of rebuilt textures in texels.
        session: state that all calls of one generation share.
    """

    url: str = ""
    version: Version = "2.1"
    textured: bool = True
    seed: int = 1234
    octree: int = 256
    steps: int = 5
    guidance: float = 5.0
    asked_faces: int = 40_000
    timeout: float = 1800.0
    faces: int = Normal.faces
    texture: int = Normal.texture
    session: Session = field(default_factory=Session, repr=False, compare=False)

    def __post_init__(self) -> None:
        if self.version not in ("2.0", "2.1"):
            raise BackendError(
                f"Hunyuan3D.version {self.version!r} is unknown." + choices(self.version, _BODIES)
            )
        if self.url:
            self._address()
        require(self, "octree", minimum=64, maximum=512, integer=True)
        require(self, "steps", minimum=1, maximum=20, integer=True)
        require(self, "asked_faces", minimum=1000, maximum=100_000, integer=True)
        require(self, "timeout", above=0)

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Return the server's mesh of one instance; see ``protocols.Modeler``.

        A damaged answer is requested once more. An answer that cannot be converted to a model is
        not stored.

        Raises:
            BackendError: no server, no answer, or no usable GLB.
        """
        what = f"hunyuan3d, model of {instance.name!r}:"
        to = Normal(self.faces, self.texture)
        body = self.body(encode_png(cutout(instance, "hunyuan3d")))
        used = Used(self.session.store)
        raw = self._ask(body, what, "yes", used)
        try:
            check_glb(raw, f"{what} the answer")
        except BackendError:
            raw = self._ask(body, what, "renew", used)
        with used.dropped_on(BackendError):
            mesh = normal_mesh(raw, f"{what} the answer", to=to)
        return foreign_model(mesh, instance, size)

    def body(self, picture: bytes) -> Mapping[str, Any]:
        """Return the request body for a PNG, in the format of the server's version."""
        return {
            "image": base64.b64encode(picture).decode(),
            "texture": self.textured,
            "seed": self.seed,
            "octree_resolution": self.octree,
            "num_inference_steps": self.steps,
            "guidance_scale": self.guidance,
            "face_count": self.asked_faces,
            **_BODIES[self.version],
        }

    def health(self) -> str:
        """Return the server's worker id; a busy server does not respond.

        Raises:
            BackendError: no response, or the server lacks this route, as version 2.0 does.
        """
        headers = {"x-tabletopgen-question": "health", "x-tabletopgen-memo": "no"}
        with self.session.client("hunyuan3d", self._address(), timeout=_HEALTH_SECONDS) as client:
            answer = client.get("health", headers=headers)
        reply = _object(answer.content)
        if answer.status_code != 200 or reply.get("status") != "healthy":
            raise BackendError(
                f"hunyuan3d, health: {self._address()} returned status {answer.status_code}, "
                f"{answer.content[:80]!r}. Check that this server is Hunyuan3D-2.1's api_server.py."
            )
        return str(reply.get("worker_id", ""))

    def _address(self) -> str:
        url = self.url or os.environ.get(ADDRESS, "") or _USUAL
        hint = f"Correct Hunyuan3D.url or {ADDRESS}."
        return checked_address(url, "hunyuan3d: its address", hint)

    def _ask(self, body: Mapping[str, Any], what: str, memo: str, used: Used) -> bytes:
        headers = {
            "x-tabletopgen-question": "model",
            "x-tabletopgen-model": f"hunyuan3d-{self.version}",
            "x-tabletopgen-memo": memo,
        }
        with self.session.client(
            "hunyuan3d", self._address(), timeout=self.timeout, most_bytes=_MOST_BYTES
        ) as client:
            answer = client.post(_ROUTE, json=body, headers=headers)
        used.add(answer.headers)
        if answer.status_code == 200:
            return answer.content
        raise BackendError(f"{what} {self._refusal(answer.status_code, answer.content)}")

    def _refusal(self, status: int, content: bytes) -> str:
        """Return the error in an answer that is not a mesh; the server reports failures as 404."""
        reply = _object(content)
        if "error_code" in reply:
            hint = " (2.0 needs --enable_tex for textures)" if self.version == "2.0" else ""
            return (
                f"the server failed ({status}, {str(reply.get('text', ''))[:200]!r}). The server's "
                "log states the reason, such as too little GPU memory or a missing texture "
                f"model{hint}."
            )
        if status == 422:
            return (
                f"the server rejected the request ({content[:300]!r}). The request used version "
                f"{self.version}; set Hunyuan3D.version to the server's version."
            )
        return (
            f"{self._address()} returned status {status}, {content[:80]!r}. Check that this server "
            f"is Hunyuan3D's api_server.py, or set {ADDRESS} to the correct address."
        )


_BODIES: Mapping[str, Mapping[str, Any]] = {
    "2.0": {"type": "glb"},
    "2.1": {"remove_background": False, "num_chunks": 8000},
}


def _object(content: bytes) -> Mapping[str, Any]:
    """Return a JSON object, or an empty one if the content is invalid."""
    try:
        return parse_object(content, "The answer", BackendError)
    except BackendError:
        return {}
