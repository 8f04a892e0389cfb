"""Scenes: list, view, save, and remove."""

from __future__ import annotations

import asyncio

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from ..server.bodies import read_json
from ..server.services import services_of
from .responses import answer, answer_file, answer_picture


async def list_scenes(request: Request) -> Response:
    """Return all scenes."""
    return answer({"scenes": await asyncio.to_thread(services_of(request).scenes.list_rows)})


async def get_scene(request: Request) -> Response:
    """Return one scene's row."""
    row = services_of(request).scenes.row
    return answer(await asyncio.to_thread(row, request.path_params["scene"]))


async def delete_scene(request: Request) -> Response:
    """Remove a scene from the workspace."""
    delete = services_of(request).scenes.delete
    await asyncio.to_thread(delete, request.path_params["scene"])
    return Response(status_code=204)


async def save_scene(request: Request) -> Response:
    """Copy a scene of the workspace into the user's store."""
    from ..fields import Fields

    Fields(await read_json(request), "The body").end()
    save = services_of(request).scenes.save
    return answer(await asyncio.to_thread(save, request.path_params["scene"]), 201)


async def get_history(request: Request) -> Response:
    """Return the editing steps that led to a scene, and the scenes that were edited from it."""
    scene = request.path_params["scene"]
    steps, later = await asyncio.to_thread(services_of(request).scenes.history, scene)
    return answer({"scene": scene, "steps": steps, "later": later})


async def get_thumbnail(request: Request) -> Response:
    """Return a scene's thumbnail."""
    read = services_of(request).scenes.read_thumbnail
    return answer_picture(await asyncio.to_thread(read, request.path_params["scene"]))


async def get_view(request: Request) -> Response:
    """Return a viewer file of a scene; ``view.json`` lists the other files."""
    find = services_of(request).scenes.view_file
    scene, path = request.path_params["scene"], request.path_params["path"]
    return answer_file(await asyncio.to_thread(find, scene, path))


ROUTES = (
    Route("/api/scenes", list_scenes, methods=["GET"]),
    Route("/api/scenes/{scene}", get_scene, methods=["GET"]),
    Route("/api/scenes/{scene}", delete_scene, methods=["DELETE"]),
    Route("/api/scenes/{scene}/save", save_scene, methods=["POST"]),
    Route("/api/scenes/{scene}/history", get_history, methods=["GET"]),
    Route("/api/scenes/{scene}/thumbnail.png", get_thumbnail, methods=["GET"]),
    Route("/api/scenes/{scene}/{path:path}", get_view, methods=["GET"]),
)
