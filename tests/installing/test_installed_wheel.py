"""The wheel works alone, without the checkout and its extras."""

import shutil
import zipfile
from pathlib import Path

import built_wheel
import pytest

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return built_wheel.build(tmp_path_factory.mktemp("wheel"))


def test_it_holds_every_file_of_the_packages(wheel: Path) -> None:
    assert built_wheel.left_out(wheel) == set()


def test_its_packages_say_that_they_are_typed(wheel: Path) -> None:
    names = zipfile.ZipFile(wheel).namelist()
    packages = built_wheel.PACKAGES
    assert {f"{name}/py.typed" for name in packages} <= {*names}
    assert not [name for name in names if name.startswith("research")]


def test_it_works_by_itself(wheel: Path, tmp_path: Path) -> None:
    built_wheel.install(wheel, tmp_path / "installed")
    built_wheel.attempt(tmp_path / "installed")


def test_what_is_missing_in_it_is_told(wheel: Path, tmp_path: Path) -> None:
    built_wheel.install(wheel, tmp_path / "installed")
    shutil.rmtree(tmp_path / "installed" / "assets_cache" / "starter")
    with pytest.raises(AssertionError, match="starter"):
        built_wheel.attempt(tmp_path / "installed")
