"""A custom backend: a class that implements one of the backend protocols.

This modeler makes every object a box of its commonsense size in the crop's mean colour. Any class
with the methods of a protocol in ``generator.backends.protocols`` can be passed in.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from generator.backends import Backends
from generator.backends.embedded.modeler import EmbeddedModeler
from generator.pipeline import generate
from generator.scene import TABLE, ConvexPart, Instance, Mesh, Model, SizePrior, View

CORNERS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
FACES = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
         [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])  # fmt: skip


@dataclass(frozen=True)
class BoxModeler:
    """Models every object as a box; leaves the table to the embedded modeler."""

    revision: str = "1"

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Return a box of the prior's size in the mean colour of the crop's visible pixels."""
        if instance.name == TABLE:
            return EmbeddedModeler().model(instance, size, view)
        pixels = instance.crop[instance.crop[..., 3] > 127][:, :3]
        color = pixels.mean(0).astype(np.uint8)[None, None]
        mesh = Mesh(CORNERS, FACES, np.zeros((8, 2)), color)
        part = ConvexPart(CORNERS, "box")
        return Model(instance.name, instance.label, mesh, size.extent, parts=(part,))


def main() -> None:
    backends = Backends.select("embedded", modeler=BoxModeler())
    generation = generate("a desk with a mug and a book", backends)
    print("bundle:", generation.save("out/own_backend"))
    print("answered by:", generation.scene.provenance.backends["modeler"])


if __name__ == "__main__":
    main()
