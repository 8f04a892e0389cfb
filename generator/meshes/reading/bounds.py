"""Limits on foreign meshes, checked in headers and raw bytes before anything is decoded.

The largest accepted file is read within 20 seconds and 2 GB.
"""

from __future__ import annotations

from ...sandbox import SandboxLimits

LIMITS = SandboxLimits(cpu_seconds=16.0)
"""Limits of the child process that reads a mesh, or a scene with all its files.

Reading a mesh of a million triangles takes 2 s and 0.5 GB from a GLB, 6 s and 1 GB from an OBJ, and
6 s and 1.3 GB from an MJCF. Including the start of both processes, a hostile file costs less than
20 s and 2 GB."""

MOST_BYTES = 256 * 2**20  # per file
MOST_FACES = 2_000_000  # triangles in all scenes of a file; vertices may be three times as many
MOST_PARTS = 5_000  # pieces in a file, including repetitions
MOST_TEXELS = 64 * 2**20  # pixels in a picture, since a small file may decompress to any size
MOST_TEXELS_TOGETHER = 128 * 2**20  # pixels in all distinct colour textures of a file

# Limits of a GLB file
MOST_HEADER = 32 * 2**20  # bytes of the JSON chunk
MOST_NODES = 20_000  # nodes in the tree, at any depth
MOST_MESHES = 20_000  # meshes, and primitives in all meshes, whether drawn or not
MOST_MATERIALS = 5_000  # materials, textures and pictures, each; also for an OBJ
MOST_COLUMNS = 100_000  # accessors and buffer views, each
CLAIMED = 4  # total size of the accessors, or of the buffer views, relative to the file's size

# Limits of an OBJ file
MOST_OBJ_BYTES = 128 * 2**20  # bytes of a file, a text that a parser splits into many words
MOST_GROUPS = 2_000  # changes of material, object or group
MOST_LINE = 2**16  # bytes per line of the file or of its material library
MOST_LIBRARY = 4 * 2**20  # bytes of a material library
