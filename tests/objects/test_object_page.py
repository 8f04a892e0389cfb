"""The static page of all objects: complete, self-contained, searchable, usable by keyboard."""

from __future__ import annotations

import io
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from command import Shell
from PIL import Image

from generator.objects.page import mass_text, page_files
from generator.objects.thumbnails import COLUMNS, SIDE, by_folder, draw_thumbnails, sheet
from tabletop_objects import CATEGORIES


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A page of two themes with grey thumbnails."""
    folder = tmp_path_factory.mktemp("page")
    groups = by_folder(("bedroom", "tea"))
    grey = np.full((SIDE, SIDE, 3), 200, np.uint8)
    drawn = {category.key: grey for group in groups.values() for category in group}
    for name, content in page_files(groups, drawn).items():
        (folder / name).write_bytes(content)
    return folder


def test_every_category_is_in_one_folder() -> None:
    groups = by_folder()
    assert sorted(c.key for group in groups.values() for c in group) == sorted(CATEGORIES)
    assert all(c.themes[0] == theme for theme, group in groups.items() for c in group)


def test_the_page_names_every_object_and_its_source(page: Path) -> None:
    text = (page / "index.html").read_text()
    for group in by_folder(("bedroom", "tea")).values():
        for category in group:
            assert f'<code class="key">{category.key}</code>' in text
    assert text.count("tabletop_objects/<wbr>objects/<wbr>tea/") == len(by_folder(("tea",))["tea"])
    assert "{{" not in text


def test_the_page_loads_nothing_from_elsewhere(page: Path) -> None:
    text = (page / "index.html").read_text()
    assert not re.search(r"https?:|//[a-z]", text)
    assert {*re.findall(r'url\("([^"]+)"\)', text)} == {"bedroom.webp", "tea.webp"}
    assert {path.name for path in page.iterdir()} == {"index.html", "bedroom.webp", "tea.webp"}


def test_masses_are_readable() -> None:
    assert [mass_text(mass) for mass in (0.005, 0.3, 1.25)] == ["5 g", "300 g", "1.25 kg"]


def test_a_sheet_shows_each_object() -> None:
    group = by_folder(("tea",))["tea"][:3]
    drawn = draw_thumbnails([category.key for category in group])
    with Image.open(io.BytesIO(sheet("tea", group, drawn))) as picture:
        assert picture.width == COLUMNS * SIDE <= 1600
        pixels = np.asarray(picture)[40 : 40 + SIDE]
    for k in range(3):
        assert (pixels[:, k * SIDE : (k + 1) * SIDE].min(axis=2) < 200).mean() > 0.03


@pytest.mark.slow
def test_the_command_writes_a_page(shell: Shell, tmp_path: Path) -> None:
    out = shell("objects", "page", "--theme", "bedroom", "--workers", "2", "--out", str(tmp_path))
    assert Path(out.out.strip()) == tmp_path / "index.html"
    with Image.open(tmp_path / "bedroom.webp") as sprite:
        assert sprite.width % SIDE == 0 and (np.asarray(sprite).min(axis=2) < 200).mean() > 0.01


@pytest.mark.slow
def test_the_page_is_searched_by_keyboard(page: Path, browser: Any) -> None:
    view = browser.new_page()
    view.goto((page / "index.html").as_uri())
    total = view.locator("li:visible").count()
    view.keyboard.press("/")
    view.keyboard.type("tea strainer")
    shown = view.locator("li:visible")
    assert 0 < shown.count() < total
    assert all(
        "strainer" in text for text in shown.evaluate_all("all => all.map(x => x.dataset.words)")
    )
    assert view.locator("#found").inner_text() == (
        f"{shown.count()} object" + ("s" if shown.count() > 1 else "")
    )
    view.keyboard.type(" zzz")
    assert view.locator("#none").is_visible() and view.locator("#found").inner_text() == "0 objects"
    view.get_by_label("Search by name").fill("")
    view.get_by_label("Theme").select_option("bedroom")
    assert view.locator("li:visible").count() == len(by_folder(("bedroom",))["bedroom"])
    view.close()
