import multiprocessing
import shutil
from pathlib import Path

import pytest
from bounded import LONG
from toy import toy_object, toy_scene

import assets_cache
from generator.bundle import save, verify
from generator.errors import BundleError, StorageError
from generator.scene import Scene


def scene(name: str, x: float = 0.0) -> Scene:
    return toy_scene((toy_object("cube_1", (0.05,) * 3, (x, 0)),), name=name)


@pytest.fixture
def store(tmp_path: Path, monkeypatch) -> Path:
    """An empty store, isolated from the environment and the user's home."""
    monkeypatch.delenv("TABLETOPGEN_CACHE", raising=False)
    monkeypatch.setattr("platformdirs.user_cache_dir", lambda *a, **k: str(tmp_path / "user"))
    shipped, tasks = tmp_path / "shipped", tmp_path / "tasks"
    monkeypatch.setattr("assets_cache.store._STARTERS", shipped)
    monkeypatch.setattr("assets_cache.store._SHIPPED", (shipped, tasks))
    return tmp_path / "store"


def put(name: str, folder: Path, x: float = 0.0) -> Path:
    return save(scene(name, x), folder, allow_failed=True)


def test_found_by_name_folder_digest_glob_and_path(store: Path) -> None:
    office, desk = put("office", store), put("office-desk", store)
    digest = office.name[-12:]
    for wanted in ("office", office.name, digest, digest[:6], str(office), office):
        assert assets_cache.find(wanted, store) == [office], wanted
    assert assets_cache.find("office*", store) == sorted([office, desk])
    assert assets_cache.find(str(store / "office-d*"), store) == [desk]
    assert assets_cache.find(str(store), store) == sorted([office, desk])
    assert assets_cache.entries(store) == sorted([office, desk])


def test_a_folder_of_bundles_is_found_by_one_part(
    store: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = sorted(put(name, tmp_path / "tables").name for name in ("office", "lab"))
    monkeypatch.chdir(tmp_path)
    assert [path.name for path in assets_cache.find("tables", store)] == names
    put("tables", store)  # a name comes first
    assert assets_cache.find("tables", store)[0].parent == store
    monkeypatch.chdir(tmp_path / "tables")
    assert [path.name for path in assets_cache.find("./*", store)] == names
    assert [path.name for path in assets_cache.find(".", store)] == names


@pytest.mark.parametrize("wanted", ["", " ", "."])
def test_what_names_no_bundle_removes_none(
    wanted: str, store: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    put("office", store)
    monkeypatch.chdir(store)
    with pytest.raises(BundleError, match=r"No bundle matches|folder of bundles"):
        assets_cache.remove(wanted, store)
    with pytest.raises(BundleError, match="folder of bundles"):
        assets_cache.remove(store, store)
    assert len(assets_cache.entries(store)) == 1


def test_a_name_may_have_several_bundles(store: Path) -> None:
    both = {put("office", store), put("office", store, x=0.1)}
    assert set(assets_cache.find("office", store)) == both
    with pytest.raises(BundleError, match="matches 2 bundles"):
        assets_cache.remove("office", store)


def test_argument_before_environment_before_shipped_before_user(
    store, tmp_path, monkeypatch
) -> None:
    places = [store, tmp_path / "env", tmp_path / "shipped", tmp_path / "user" / "scenes"]
    for place in places:
        put("same", place)
    assert assets_cache.find("same", store) == [next(store.iterdir())]
    assert assets_cache.roots() == (places[2], places[3])
    monkeypatch.setenv("TABLETOPGEN_CACHE", str(places[1]))
    assert assets_cache.roots(store) == (places[0], places[1], places[2])
    assert assets_cache.find("same")[0].parent == places[1]
    assert assets_cache.user_root() == places[1]
    assert assets_cache.user_root(store) == store
    assert assets_cache.find("starter")[0].parent == places[2]


def test_tables_for_one_task_are_found_by_name_and_are_no_starters(store, tmp_path) -> None:
    starter, special = put("office", tmp_path / "shipped"), put("tea-task-1", tmp_path / "tasks")
    assert assets_cache.find("starter", store) == [starter]
    assert assets_cache.find("tea-task-*", store) == [special]
    assert assets_cache.entries(store) == [starter, special]
    with pytest.raises(StorageError, match="must contain only your own bundles"):
        assets_cache.clear(tmp_path / "tasks")


def test_an_unknown_name_suggests_the_near_match(store: Path) -> None:
    put("workbench", store)
    with pytest.raises(BundleError, match=r"Did you mean 'workbench'\? Available: workbench\."):
        assets_cache.find("workbensh", store)


@pytest.mark.parametrize("wanted", ["", "x" * 400, "a/**b", "~nobody-at-all/office", "\0", "["])
def test_what_is_no_path_finds_nothing(store: Path, wanted: str) -> None:
    put("office", store)
    with pytest.raises(BundleError, match="No bundle matches"):
        assets_cache.find(wanted, store)


def test_an_empty_store_says_so(store: Path) -> None:
    with pytest.raises(BundleError, match="Available: nothing"):
        assets_cache.find("anything", store)
    assert assets_cache.entries(store) == []


def test_remove_takes_one_and_leaves_the_rest(store: Path) -> None:
    office, desk = put("office", store), put("desk", store)
    assert assets_cache.remove("office", store) == office
    assert assets_cache.entries(store) == [desk]
    assert [p.name for p in store.iterdir()] == [desk.name]


def test_what_is_not_in_the_users_store_is_not_removed(store: Path, tmp_path: Path) -> None:
    shipped, other = put("shipped", tmp_path / "shipped"), put("other", tmp_path / "other")
    for wanted in (shipped, other):
        with pytest.raises(StorageError, match="not in the store"):
            assets_cache.remove(wanted, store)
        assert verify(wanted) == []


def test_clear_refuses_a_folder_with_foreign_things(store: Path) -> None:
    put("office", store)
    (store / "thesis.txt").write_text("precious")
    with pytest.raises(StorageError, match=r"thesis\.txt"):
        assets_cache.clear(store)
    assert len(assets_cache.entries(store)) == 1
    (store / "thesis.txt").unlink()
    assert assets_cache.clear(store) == 1
    assert assets_cache.entries(store) == []


def test_verify_names_the_damaged(store: Path) -> None:
    good, bad = put("good", store), put("bad", store)
    next((bad / "meshes").iterdir()).write_bytes(b"v 0 0 0\n")
    reasons = assets_cache.verify(store)
    assert reasons[good.name] == []
    assert "was changed" in reasons[bad.name][0] or "bytes" in reasons[bad.name][0]


def test_add_publishes_into_the_store(store: Path) -> None:
    path = assets_cache.add(scene("new"), store, allow_failed=True)
    assert assets_cache.find("new", store) == [path]


def _write(folder: str, barrier, count: int) -> None:
    barrier.wait(LONG)
    for _ in range(count):
        put("raced", Path(folder))


@pytest.mark.slow
def test_concurrent_writers_publish_one_whole_bundle(store: Path) -> None:
    context = multiprocessing.get_context("fork")
    barrier = context.Barrier(4)
    writers = [context.Process(target=_write, args=(str(store), barrier, 5)) for _ in range(4)]
    for writer in writers:
        writer.start()
    for writer in writers:
        writer.join(LONG)
    assert [w.exitcode for w in writers] == [0] * 4
    assert len(list(store.iterdir())) == 1
    assert verify(next(store.iterdir())) == []


def test_a_bundle_copied_elsewhere_is_still_found_there(store: Path, tmp_path: Path) -> None:
    office = put("office", store)
    copy = tmp_path / "renamed"
    shutil.copytree(office, copy)
    assert assets_cache.find(copy, store) == [copy]
    assert verify(copy) == []
