"""Image-to-3D models that the project only calls, and meshes that others made.

``hunyuan3d`` asks a local server and ``tencent`` a cloud; ``trellis``, ``triposr`` and ``sam3d``
run in this process where they are installed; ``folder`` takes your own files. What they give is a
foreign mesh: ``normalising`` checks it and brings it to the project's ``Model``.
"""
