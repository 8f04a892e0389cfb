"""What a foreign mesh may have: the one table, held against headers and bytes before any decoding.

The largest file that passes is read within 20 seconds and 2 GB.
"""

from __future__ import annotations

MOST_BYTES = 256 * 2**20
"""Larger files are refused."""

MOST_FACES = 2_000_000
"""Meshes of more triangles are refused, and of more than three vertices for each of these."""

MOST_PARTS = 5_000
"""Files of more pieces, repeated ones counted each time, are refused."""

MOST_NODES = 20_000
"""Places in a GLB's tree, however deep."""

MOST_MESHES = 20_000
"""Meshes of a GLB, and the pieces of all of them, shown or not."""

MOST_MATERIALS = 5_000
"""Materials, textures and pictures, each."""

MOST_COLUMNS = 100_000
"""Accessors of a GLB, and views of its bytes, each."""

MOST_TEXELS = 64 * 2**20
"""Pictures of more pixels are refused: a small file may unpack to any size."""

MOST_TEXELS_TOGETHER = 128 * 2**20
"""Files whose colour textures have more pixels together, equal ones counted once, are refused."""

MOST_HEADER = 32 * 2**20
"""Bytes of a GLB's JSON."""

CLAIMED = 4
"""Times the file's size that the numbers of a GLB, or its views of its bytes, may take together."""

MOST_OBJ_BYTES = 128 * 2**20
"""An OBJ file is text, of which a parser makes many words."""

MOST_GROUPS = 2_000
"""Times that an OBJ file changes its material, object or group."""

MOST_LINE = 2**16
"""Bytes of a line of an OBJ file, or of its materials."""

MOST_LIBRARY = 4 * 2**20
"""Bytes of a file of an OBJ's materials."""
