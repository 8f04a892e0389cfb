"""USD export with UsdPhysics: ``scene.usdc`` and its textures, or a single ``scene.usdz``.

Z up, metres, kilograms. /World holds PhysicsScene, floor, table, and an Xform for each object: a
rigid body with mass, centre of mass and principal inertia. Below it are Visual, which is a textured
mesh; Collision, which has one prim for each convex piece (a Cube, Cylinder or Sphere, or a Mesh
whose approximation is "convexHull"); and Looks, which has the materials of both.
"""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float, Int
from scipy.spatial.transform import Rotation

from ..errors import InputError
from ..io.pictures import encode_png
from ..physics.mjcf import texture_path
from .bodies import ExportBody, ExportPiece, ExportWorld

CRATE = "scene.usdc"
_AXES = "XYZ"


def usd_files(world: ExportWorld) -> Mapping[str, bytes]:
    """Return all bodies as a USD crate file and its textures, keyed by path.

    Raises:
        InputError: usd-core is not installed.
    """
    with tempfile.TemporaryDirectory() as folder:
        _write(world, Path(folder))
        return _read_all(Path(folder))


def usdz_files(world: ExportWorld) -> Mapping[str, bytes]:
    """Return all bodies as one USDZ package.

    Raises:
        InputError: usd-core is not installed.
    """
    with tempfile.TemporaryDirectory() as folder:
        _write(world, Path(folder))
        from pxr import Sdf, UsdUtils

        noon = time.mktime((2000, 1, 1, 12, 0, 0, 0, 0, -1))  # the package stores local times
        for name in _read_all(Path(folder)):
            os.utime(Path(folder) / name, (noon, noon))
        package = Path(folder) / "scene.usdz"
        asset = Sdf.AssetPath(str(Path(folder) / CRATE))
        if not UsdUtils.CreateNewUsdzPackage(asset, str(package)):
            raise InputError(f"USD could not package {world.name!r}. Export it to 'usd' instead.")
        return {"scene.usdz": package.read_bytes()}


def _read_all(folder: Path) -> dict[str, bytes]:
    paths = sorted(path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}


def _write(content: ExportWorld, folder: Path) -> None:
    """Write ``scene.usdc`` and its textures to a folder."""
    try:
        from pxr import Gf, Usd, UsdGeom, UsdPhysics
    except ImportError as error:
        raise InputError(
            "Exports to USD need usd-core. Run: pip install 'tabletopgen[usd]'"
        ) from error
    stage = Usd.Stage.CreateNew(str(folder / CRATE))
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    UsdPhysics.SetStageKilogramsPerUnit(stage, 1.0)
    world = UsdGeom.Xform.Define(stage, "/World")
    stage.SetDefaultPrim(world.GetPrim())
    gravity = UsdPhysics.Scene.Define(stage, "/World/PhysicsScene")
    gravity.CreateGravityDirectionAttr(Gf.Vec3f(0, 0, -1))
    gravity.CreateGravityMagnitudeAttr(9.81)
    floor = UsdGeom.Plane.Define(stage, "/World/floor")
    floor.CreateAxisAttr(UsdGeom.Tokens.z)
    floor.CreateWidthAttr(8.0)
    floor.CreateLengthAttr(8.0)
    floor.CreateExtentAttr([Gf.Vec3f(-4, -4, 0), Gf.Vec3f(4, 4, 0)])
    UsdPhysics.CollisionAPI.Apply(floor.GetPrim())
    for body in content.bodies:
        _put(stage, f"/World/{body.name}", body, folder)
    stage.GetRootLayer().Save()


def _put(stage: Any, path: str, body: ExportBody, folder: Path) -> None:
    """Write one body to a USD stage, at the given prim path."""
    from pxr import Gf, UsdGeom, UsdPhysics

    xform = UsdGeom.Xform.Define(stage, path)
    xform.AddTranslateOp().Set(Gf.Vec3d(*map(float, body.position)))
    xform.AddOrientOp(UsdGeom.XformOp.PrecisionDouble).Set(_quaternion(body.quaternion))
    xform.GetPrim().SetDisplayName(body.label)
    if not body.fixed:
        UsdPhysics.RigidBodyAPI.Apply(xform.GetPrim())
        moments, axes = principal(body.inertia)
        mass = UsdPhysics.MassAPI.Apply(xform.GetPrim())
        mass.CreateMassAttr(float(body.mass))
        mass.CreateCenterOfMassAttr(Gf.Vec3f(*map(float, body.com)))
        mass.CreateDiagonalInertiaAttr(Gf.Vec3f(*map(float, moments)))
        mass.CreatePrincipalAxesAttr(Gf.Quatf(_quaternion(axes)))
    UsdGeom.Scope.Define(stage, f"{path}/Looks")
    visual = _mesh(stage, f"{path}/Visual", body.vertices, body.mesh.faces)
    _paint(stage, path, body, visual, folder)
    UsdGeom.Scope.Define(stage, f"{path}/Collision")
    rubbing = _friction(stage, f"{path}/Looks/Friction", body)
    for k, piece in enumerate(body.pieces):
        solid = _solid(stage, f"{path}/Collision/part_{k}", piece)
        UsdPhysics.CollisionAPI.Apply(solid.GetPrim())
        solid.CreatePurposeAttr(UsdGeom.Tokens.guide)
        _bind(solid, rubbing, "physics")


def _mesh(
    stage: Any, path: str, vertices: Float[np.ndarray, "n 3"], faces: Int[np.ndarray, "m 3"]
) -> Any:
    from pxr import UsdGeom, Vt

    mesh = UsdGeom.Mesh.Define(stage, path)
    points = Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(vertices, np.float32))
    mesh.CreatePointsAttr(points)
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(faces), 3, np.int32)))
    corners = np.ascontiguousarray(faces, np.int32).ravel()
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(corners))
    mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
    mesh.CreateExtentAttr(UsdGeom.PointBased.ComputeExtent(points))
    return mesh


def _solid(stage: Any, path: str, piece: ExportPiece) -> Any:
    """Write the geometry of a convex piece to a USD stage."""
    from pxr import Gf, UsdGeom, UsdPhysics

    if piece.kind in ("mesh", "ellipsoid"):
        hull = _mesh(stage, path, piece.vertices, piece.faces)
        api = UsdPhysics.MeshCollisionAPI.Apply(hull.GetPrim())
        api.CreateApproximationAttr(UsdPhysics.Tokens.convexHull)
        return hull
    x, y, z = map(float, piece.half)
    if piece.kind == "box":
        solid = UsdGeom.Cube.Define(stage, path)
        solid.CreateSizeAttr(2.0)
        solid.CreateExtentAttr([Gf.Vec3f(-1, -1, -1), Gf.Vec3f(1, 1, 1)])
    elif piece.kind == "sphere":
        solid = UsdGeom.Sphere.Define(stage, path)
        radius = float(piece.half.mean())
        solid.CreateRadiusAttr(radius)
        solid.CreateExtentAttr([Gf.Vec3f(-radius), Gf.Vec3f(radius)])
    else:
        solid = UsdGeom.Cylinder.Define(stage, path)
        solid.CreateAxisAttr(_AXES[piece.axis])
        solid.CreateRadiusAttr(piece.radius)
        solid.CreateHeightAttr(2 * float(piece.half[piece.axis]))
        solid.CreateExtentAttr([Gf.Vec3f(-x, -y, -z), Gf.Vec3f(x, y, z)])
    solid.AddTranslateOp().Set(Gf.Vec3d(*map(float, piece.center)))
    if piece.kind == "box":
        solid.AddScaleOp().Set(Gf.Vec3f(x, y, z))
    return solid


def _paint(stage: Any, path: str, body: ExportBody, visual: Any, folder: Path) -> None:
    """Apply a body's texture to its mesh with UsdPreviewSurface, which every renderer supports."""
    from pxr import Gf, Sdf, UsdGeom, UsdShade, Vt

    uv = UsdGeom.PrimvarsAPI(visual).CreatePrimvar(
        "st", Sdf.ValueTypeNames.TexCoord2fArray, UsdGeom.Tokens.vertex
    )
    uv.Set(Vt.Vec2fArray.FromNumpy(np.ascontiguousarray(body.mesh.uv, np.float32)))
    encoded = encode_png(body.mesh.texture)
    picture = texture_path(encoded)
    (folder / picture).parent.mkdir(exist_ok=True)
    (folder / picture).write_bytes(encoded)
    look = UsdShade.Material.Define(stage, f"{path}/Looks/Surface")
    reader = UsdShade.Shader.Define(stage, f"{path}/Looks/Surface/Coordinates")
    reader.CreateIdAttr("UsdPrimvarReader_float2")
    reader.CreateInput("varname", Sdf.ValueTypeNames.String).Set("st")
    found = reader.CreateOutput("result", Sdf.ValueTypeNames.Float2)
    texture = UsdShade.Shader.Define(stage, f"{path}/Looks/Surface/Texture")
    texture.CreateIdAttr("UsdUVTexture")
    texture.CreateInput("file", Sdf.ValueTypeNames.Asset).Set(f"./{picture}")
    texture.CreateInput("st", Sdf.ValueTypeNames.Float2).ConnectToSource(found)
    texture.CreateInput("sourceColorSpace", Sdf.ValueTypeNames.Token).Set("sRGB")
    for side in ("wrapS", "wrapT"):
        texture.CreateInput(side, Sdf.ValueTypeNames.Token).Set("clamp")
    texture.CreateInput("fallback", Sdf.ValueTypeNames.Float4).Set(Gf.Vec4f(0.8, 0.8, 0.8, 1))
    color = texture.CreateOutput("rgb", Sdf.ValueTypeNames.Float3)
    shader = UsdShade.Shader.Define(stage, f"{path}/Looks/Surface/Shader")
    shader.CreateIdAttr("UsdPreviewSurface")
    shader.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f).ConnectToSource(color)
    shader.CreateInput("roughness", Sdf.ValueTypeNames.Float).Set(0.7)
    shader.CreateInput("metallic", Sdf.ValueTypeNames.Float).Set(0.0)
    shader.CreateInput("opacity", Sdf.ValueTypeNames.Float).Set(float(body.mesh.opacity))
    out = shader.CreateOutput("surface", Sdf.ValueTypeNames.Token)
    look.CreateSurfaceOutput().ConnectToSource(out)
    _bind(visual, look, "")


def _friction(stage: Any, path: str, body: ExportBody) -> Any:
    """Write a body's physics material; in a contact, the larger friction applies, as in MuJoCo."""
    from pxr import Sdf, UsdPhysics, UsdShade

    material = UsdShade.Material.Define(stage, path)
    api = UsdPhysics.MaterialAPI.Apply(material.GetPrim())
    api.CreateStaticFrictionAttr(float(body.friction))
    api.CreateDynamicFrictionAttr(float(body.friction))
    api.CreateRestitutionAttr(0.0)
    prim = material.GetPrim()
    prim.AddAppliedSchema("PhysxMaterialAPI")
    kind = Sdf.ValueTypeNames.Token
    prim.CreateAttribute("physxMaterial:frictionCombineMode", kind, custom=False).Set("max")
    return material


def _bind(shape: Any, material: Any, purpose: str) -> None:
    from pxr import UsdShade

    binding = UsdShade.MaterialBindingAPI.Apply(shape.GetPrim())
    binding.Bind(material, materialPurpose=purpose or UsdShade.Tokens.allPurpose)


def _quaternion(wxyz: Float[np.ndarray, "4"]) -> Any:
    from pxr import Gf

    w, x, y, z = map(float, wxyz)
    return Gf.Quatd(w, x, y, z)


def principal(
    inertia: Float[np.ndarray, "3 3"],
) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "4"]]:
    """Return the principal moments of inertia, and the rotation to principal axes (unit wxyz)."""
    moments, axes = np.linalg.eigh(inertia)
    if np.linalg.det(axes) < 0:
        axes[:, 2] *= -1
    return moments, Rotation.from_matrix(axes).as_quat(scalar_first=True)
