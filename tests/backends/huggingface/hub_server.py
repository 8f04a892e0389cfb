"""A local server with the part of Hugging Face's protocol that downloads need."""

import hashlib
import json
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler
from urllib.parse import unquote, urlsplit


@dataclass
class Hub:
    """One repository at one commit, and its planned failures.

    ``asked`` holds the path of every request. ``status`` replaces responses to file requests, with
    ``code`` as Hugging Face's reason; ``cut`` is the number of responses that break off in the
    middle.
    """

    repository: str
    revision: str
    files: dict[str, bytes]
    status: int = 200
    code: str = ""
    cut: int = 0
    asked: list[str] = field(default_factory=list)

    def handler(self) -> type[BaseHTTPRequestHandler]:
        hub = self

        class Handler(BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def log_message(self, format: str, *args: object) -> None:
                pass

            def do_HEAD(self) -> None:
                self._answer(body=False)

            def do_GET(self) -> None:
                self._answer(body=True)

            def _answer(self, *, body: bool) -> None:
                path = unquote(urlsplit(self.path).path)
                hub.asked.append(f"{self.command} {path}")
                api = f"/api/models/{hub.repository}/tree/{hub.revision}"
                home = f"/{hub.repository}/resolve/{hub.revision}/"
                if hub.status != 200:
                    self._send(b"{}", body, hub.status, {"X-Error-Code": hub.code})
                elif path == api:
                    self._send(json.dumps(hub.tree()).encode(), body)
                elif path.startswith(home) and path.removeprefix(home) in hub.files:
                    self._file(hub.files[path.removeprefix(home)], body)
                else:
                    self._send(b"{}", body, 404, {"X-Error-Code": "EntryNotFound"})

            def _file(self, content: bytes, body: bool) -> None:
                tags = {"ETag": f'"{_digest(content)}"', "X-Repo-Commit": hub.revision}
                start, status = 0, 200
                if (wanted := self.headers.get("Range")) and body:
                    start = int(wanted.removeprefix("bytes=").split("-")[0])
                    tags["Content-Range"] = f"bytes {start}-{len(content) - 1}/{len(content)}"
                    status = 206
                if body and hub.cut:
                    hub.cut -= 1
                    self._send(
                        content[start:], body, status, tags, most=(len(content) - start) // 2
                    )
                    self.close_connection = True
                else:
                    self._send(content[start:], body, status, tags)

            def _send(
                self,
                content: bytes,
                body: bool,
                status: int = 200,
                headers: dict[str, str] | None = None,
                most: int | None = None,
            ) -> None:
                self.send_response(status)
                for name, value in (headers or {}).items():
                    self.send_header(name, value)
                self.send_header("Content-Length", str(len(content)))
                self.end_headers()
                if body:
                    self.wfile.write(content[:most])

        return Handler

    def tree(self) -> list[dict[str, object]]:
        return [
            {"type": "file", "oid": _digest(content), "size": len(content), "path": path}
            for path, content in self.files.items()
        ]


def _digest(content: bytes) -> str:
    return hashlib.sha1(content).hexdigest()
