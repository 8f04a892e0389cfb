"""The objects page matches the output of its script, and its sheets exist."""

import importlib.util
import sys

from blocks import ROOT

from generator.objects.thumbnails import by_folder


def test_the_page_of_objects_is_current() -> None:
    path = ROOT / "docs/make_object_sheets.py"
    spec = importlib.util.spec_from_file_location("docs_make_object_sheets", path)
    assert spec is not None and spec.loader is not None
    script = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = script
    spec.loader.exec_module(script)
    page = (ROOT / "docs/reference/objects.md").read_text(encoding="utf-8")
    assert page == script.page(by_folder()), "Run: python docs/make_object_sheets.py"


def test_the_sheets_are_small_enough_for_a_repository() -> None:
    sizes = [path.stat().st_size for path in (ROOT / "docs/images/objects").glob("*.webp")]
    assert len(sizes) > 20 and sum(sizes) < 6e6
