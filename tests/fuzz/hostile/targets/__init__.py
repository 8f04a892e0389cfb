"""The attacked inputs: a function per kind of input, found by name.

A target is called with random numbers and an empty folder, crafts its input there, and returns a
function that hands it to the product: True says that all of it was accepted. What crafting raises
is a fault of the target, what the function raises one of the product.
"""

import functools
import importlib
import random
from collections.abc import Callable, Mapping
from pathlib import Path
from types import MappingProxyType

Run = Callable[[], bool]
Craft = Callable[[random.Random, Path], Run]

KINDS: Mapping[str, str] = MappingProxyType(
    {
        "bundle-values": "bundles:values",
        "bundle-files": "bundles:files",
        "certificate": "bundles:certificates",
        "glb": "meshes:glb",
        "obj": "meshes:obj",
        "external": "meshes:external",
        "mjcf": "models:mjcf",
        "glb-scene": "models:glb_scenes",
        "poses": "models:folders",
        "limited-model": "models:limited",
        "picture": "pictures:pictures",
        "picture-structure": "structures:structures",
        "depth": "pictures:depths",
        "http": "network:http",
        "chat-answer": "network:chat",
        "image-answer": "network:images",
        "hunyuan3d-answer": "network:hunyuan3d",
        "tencent-answer": "network:tencent",
        "address": "network:addresses",
        "prompts": "files:prompts",
        "batch-records": "files:batches",
        "spending": "files:budgets",
        "ledger": "files:ledgers",
        "prices": "files:prices",
        "call-store": "files:calls",
        "bundle-names": "files:stores",
        "policy": "learning:policies",
        "recipe": "learning:recipes",
        "run-folder": "learning:run_folders",
        "arrays": "learning:arrays",
        "reset-options": "environments:options",
        "settings": "environments:settings",
        "scene-names": "environments:scene_names",
        "text": "environments:texts",
        "paper-json": "environments:papers",
        "generate-options": "pictures:cameras",
    }
)
"""The module and the function of each kind of input."""


@functools.cache
def target(kind: str) -> Craft:
    """Return the target of a kind; "module:function" selects an unlisted one."""
    module, _, name = KINDS.get(kind, kind).partition(":")
    place = f"{__name__}.{module}" if kind in KINDS else module
    return getattr(importlib.import_module(place), name)
