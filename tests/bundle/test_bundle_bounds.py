"""Oversized bundles, or ones with damaged meshes or pictures: one error before decoding."""

import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from forging import png, put, put_mesh, put_texture, refused, rewrite
from toy import toy_scene

import assets_cache
from generator import bundle
from generator.bundle import derived
from generator.bundle.bounds import BOUNDS, Bounds, check_counts
from generator.bundle.contents import decode_obj, decode_png, mesh_counts, picture_size
from generator.errors import BundleError
from generator.physics.gate import judge
from generator.physics.mjcf import encode_obj

LINE = b"v 0.000000 0.000000 0.000000\n"


@pytest.fixture
def path(tmp_path: Path) -> Path:
    scene = toy_scene()
    return bundle.save(scene.replace(report=judge(scene)), tmp_path / "store")


def repeat(payload: dict[str, Any], count: int) -> None:
    thing, table = payload["objects"][0], payload["table"]
    used = (thing["model"], table["model"])
    payload["models"] = {key: payload["models"][key] for key in used}
    payload["objects"] = [
        {**thing, "name": f"o_{k}", "placement": {**thing["placement"], "name": f"o_{k}"}}
        for k in range(count)
    ]


@pytest.mark.slow
@pytest.mark.parametrize(
    "change",
    [
        lambda p: repeat(p, 1000),
        lambda p: p["models"].update({str(k): {"parts": []} for k in range(5000)}),
        lambda p: p["table"].update(parts=p["table"]["parts"] * 20_000),
        lambda p: p["objects"][0]["parts"][0].update(vertices=[[0, 0, 0]] * 100_000),
        lambda p: p["files"].update({f"{k}.png": {"bytes": 1} for k in range(5000)}),
        lambda p: p["files"]["scene.xml"].update(bytes=10**12),
        lambda p: p["files"].update({f"{k}": {"bytes": BOUNDS.file_bytes} for k in range(5)}),
        lambda p: p.update(name="x" * (BOUNDS.truth_bytes + 1)),
    ],
    ids=["objects", "models", "parts", "points", "files", "bytes", "all bytes", "scene.json"],
)
def test_counts_out_of_bounds_are_refused(
    path: Path, change: Callable[[dict[str, Any]], None]
) -> None:
    refused(rewrite(path, change), r"at most \d+|not \d+")


@pytest.mark.parametrize("name", ["objects", "models", "all_parts", "all_part_vertices"])
def test_each_count_is_taken(name: str) -> None:
    part = {"vertices": [[0, 0, 0]] * 4}
    payload = {"models": {"a": {"parts": [part]}}, "table": {"parts": [part]}, "objects": [
        {"parts": [part]}]}  # fmt: skip
    check_counts(payload)
    most = {"objects": 0, "models": 0, "all_parts": 2, "all_part_vertices": 11}[name]
    with pytest.raises(BundleError, match=f"at most {most}"):
        check_counts(payload, Bounds(**{name: most}))


@pytest.mark.slow
def test_a_picture_that_claims_to_be_huge_is_never_decoded(path: Path) -> None:
    refused(put_texture(path, png(65535, 65535, zlib.compress(b"\0" * 1000))), "4294836225 pixels")


@pytest.mark.slow
def test_a_preview_that_claims_to_be_huge_is_refused(path: Path) -> None:
    forged = put(path, "preview.png", png(65535, 65535))
    refused(forged, "pixels")
    with pytest.raises(BundleError, match="pixels"):
        bundle.load_picture(forged, "preview")


def test_a_picture_without_pixels_or_with_two_headers_is_none() -> None:
    good = png(2, 2, zlib.compress(b"\0\1\2" * 2))
    assert decode_png(good, "good").shape == (2, 2, 3)
    for raw in (b"", b"GIF89a" + good, png(0, 2), png(2, 2), good[:40], good[:33] + png(9, 9)[8:]):
        with pytest.raises(BundleError, match="name"):
            decode_png(raw, "name")
    with pytest.raises(BundleError, match="PNG"):
        picture_size(good[:20], "name")


@pytest.mark.slow
def test_textures_count_together_and_are_decoded_once(path: Path, monkeypatch) -> None:
    """Many models share one picture: it is read once, and their total memory is bounded."""
    decoded = []
    real = decode_png
    monkeypatch.setattr(
        "generator.bundle.decoder.decode_png", lambda *a: decoded.append(a[1]) or real(*a)
    )
    large = zlib.compress(b"\0" * (2049 * 2048), 1)
    forged = put_texture(path, png(2048, 2048, large))

    def models(payload: dict[str, Any]) -> None:
        """Every object has a distinct model, each more transparent than the others."""
        repeat(payload, 40)
        model = payload["models"][payload["objects"][0]["model"]]
        payload["models"] = {payload["table"]["model"]: model}
        for k, thing in enumerate(payload["objects"]):
            payload["models"][f"m{k}"] = {**model, "opacity": 1 - k / 100}
            thing["model"] = f"m{k}"

    refused(rewrite(forged, models), "textures together")
    assert not decoded


@pytest.mark.slow
def test_textures_are_built_one_by_one(path: Path, monkeypatch) -> None:
    """MuJoCo keeps several copies of each: built together, they would dominate the memory."""
    seen = []
    real = derived.spec_of
    monkeypatch.setattr(
        derived, "spec_of", lambda made, name: seen.append(made) or real(made, name)
    )
    assert bundle.verify(path) == []
    *single, whole = seen
    pictures = {p.name: p.read_bytes() for p in (path / "textures").iterdir()}
    assert sorted(made.files["t.png"] for made in single) == sorted(pictures.values())
    sizes = {picture_size(raw, n) for n, raw in whole.files.items() if n.startswith("textures/")}
    assert sizes == {(1, 1)}


@pytest.mark.slow
def test_meshes_count_for_every_body_that_shows_them(path: Path) -> None:
    mesh = encode_obj(toy_scene().table.model.mesh)
    many = mesh.replace(b"\nvt ", b"\n" + LINE * 100_000 + b"vt ", 1)
    assert mesh_counts(many) == (100_008, 12)
    forged = put_mesh(path, many)
    refused(rewrite(forged, lambda p: repeat(p, 20)), "meshes together have")


@pytest.mark.slow
@pytest.mark.parametrize(
    "raw",
    [
        b"",
        b"v 0 0 0\n" * 9,
        b"v " + b"0" * 3_000_000,
        LINE * 300_001,
        b"v nan 0.000000 0.000000\n",
        LINE * 4 + b"usemtl x\n",
        LINE * 4 + b"vt 0.00000 0.00000\n" * 4 + b"f 1/1 2/2 9/9\n",
        LINE * 4 + b"vt 0.00000 0.00000\n" * 4 + b"f 1/1 2/2 3/1\n",
        LINE * 4 + b"vt 0.00000 0.00000\n" * 4 + b"f 1/1 2/2 3/3\n",
        LINE * 4 + b"vt 0.00000 0.00000\n" * 3 + b"f 1/1 2/2 3/3\n",
        LINE * 4 + b"f 1/1 2/2 3/3\n",
    ],
)
def test_other_meshes_than_ours_are_refused(path: Path, raw: bytes) -> None:
    refused(put_mesh(path, raw), r"mesh|surface")


def test_a_mesh_comes_back_from_its_file() -> None:
    mesh = toy_scene().table.model.mesh
    vertices, faces, uv = decode_obj(encode_obj(mesh), "mesh")
    assert (vertices == mesh.vertices).all()
    assert (faces == mesh.faces).all()
    assert (uv == mesh.uv).all()


@pytest.mark.slow
def test_files_are_named_by_their_content(path: Path) -> None:
    name = next((path / "textures").iterdir()).relative_to(path).as_posix()
    refused(put(path, name, png(1, 1, zlib.compress(b"\0\0"))), "match the digest of the file")


@pytest.mark.slow
def test_one_bad_bundle_ends_neither_list_nor_verify_for_all(path: Path, monkeypatch) -> None:
    from command import command

    store = path.parent
    monkeypatch.setenv("TABLETOPGEN_CACHE", str(store))
    monkeypatch.setattr("assets_cache.store._SHIPPED", ())
    good = bundle.save(bundle.load(path).replace(name="good"), store)
    bad = put_texture(path, png(65535, 65535)).rename(store / "bad-000000000000")
    (store / "worse-000000000000").mkdir()
    (store / "worse-000000000000" / "scene.json").write_bytes(b"[" * 100_000)
    found = assets_cache.verify()
    assert found[good.name] == []
    assert found[bad.name]
    assert len(assets_cache.entries()) == 3
    assert command("cache", "list") == 0
    assert command("cache", "verify") == 1
