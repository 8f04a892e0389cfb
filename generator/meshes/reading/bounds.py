"""Limits on foreign meshes, checked on headers and bytes before any decoding.

The largest accepted file is read within 20 seconds and 2 GB.
"""

from __future__ import annotations

from ...sandbox import SandboxLimits

LIMITS = SandboxLimits(cpu_seconds=16.0)
"""Limits of the child process that reads a mesh, or a scene with all its files.

A mesh of a million triangles takes 2 s and 0.5 GB as GLB, 6 s and 1 GB as OBJ, and 6 s and 1.3 GB
in an MJCF. Including the start of both processes, a hostile file costs less than 20 s and 2 GB."""

MOST_BYTES = 256 * 2**20  # per file
MOST_FACES = 2_000_000  # triangles in all scenes of a file; vertices may be three times as many
MOST_PARTS = 5_000  # pieces of a file, including repetitions
MOST_TEXELS = 64 * 2**20  # pixels of a picture: a small file may decompress to any size
MOST_TEXELS_TOGETHER = 128 * 2**20  # pixels of a file's distinct colour textures

# Limits of a GLB
MOST_HEADER = 32 * 2**20  # bytes of the JSON chunk
MOST_NODES = 20_000  # nodes of the tree, at any depth
MOST_MESHES = 20_000  # meshes, and primitives of all meshes, drawn or not
MOST_MATERIALS = 5_000  # materials, textures and pictures, each; also of an OBJ
MOST_COLUMNS = 100_000  # accessors, and buffer views, each
CLAIMED = 4  # total size of accessors, or of buffer views, relative to the file's size

# Limits of an OBJ
MOST_OBJ_BYTES = 128 * 2**20  # bytes of a file: it is text, which a parser splits into many words
MOST_GROUPS = 2_000  # changes of material, object or group
MOST_LINE = 2**16  # bytes per line of the file or its material library
MOST_LIBRARY = 4 * 2**20  # bytes of a material library
