"""Adapters of external image-to-3D models, and of existing meshes.

``hunyuan3d`` calls a local server and ``tencent`` a cloud service; ``trellis``, ``triposr`` and
``sam3d`` run in this process if they are installed; ``folder`` uses your own files. Their results
are untrusted meshes: ``normalising`` checks them and converts them to the project's ``Model``.
"""
