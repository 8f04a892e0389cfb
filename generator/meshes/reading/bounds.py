"""What a foreign mesh may have: the one table, held against headers and bytes before any decoding.

The largest file that passes is read within 20 seconds and 2 GB.
"""

from __future__ import annotations

from ...sandbox import SandboxLimits

LIMITS = SandboxLimits(cpu_seconds=16.0)
"""Limits of the child process that reads a mesh, or a scene with all its files.

A mesh of a million triangles takes 2 s and 0.5 GB as GLB, 6 s and 1 GB as OBJ, and 6 s and 1.3 GB
in a MJCF. With the start of both processes a hostile file costs less than 20 s and 2 GB.
"""

MOST_BYTES = 256 * 2**20  # of a file
MOST_FACES = 2_000_000  # triangles in all scenes of a file, and a third of the vertices
MOST_PARTS = 5_000  # pieces of a file, repeated ones counted each time
MOST_TEXELS = 64 * 2**20  # pixels of a picture: a small file may unpack to any size
MOST_TEXELS_TOGETHER = 128 * 2**20  # of a file's colour textures, equal ones counted once

# Of a GLB
MOST_HEADER = 32 * 2**20  # bytes of its JSON
MOST_NODES = 20_000  # places in its tree, however deep
MOST_MESHES = 20_000  # meshes, and the pieces of all of them, shown or not
MOST_MATERIALS = 5_000  # materials, textures and pictures, each; also of an OBJ
MOST_COLUMNS = 100_000  # accessors, and views of its bytes, each
CLAIMED = 4  # times the file's size that its numbers, or its views of its bytes, may take together

# Of an OBJ
MOST_OBJ_BYTES = 128 * 2**20  # of a file: it is text, of which a parser makes many words
MOST_GROUPS = 2_000  # changes of material, object or group
MOST_LINE = 2**16  # bytes of a line of it, or of its materials
MOST_LIBRARY = 4 * 2**20  # bytes of a file of its materials
