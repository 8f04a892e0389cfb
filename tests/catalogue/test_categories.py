"""Every category passes its checks.

Only categories whose code changed since they last passed run, and one in 40 of the others.
``make test-catalogue`` runs all; with ``TABLETOPGEN_RECORD_PROOFS=1`` what passes is recorded.
"""

from collections.abc import Callable

import pytest
from proofs import categories_to_check, digests

from generator.objects.checks import check_category
from tabletop_objects import CATEGORIES
from tabletop_objects.catalogue import find_source, load_category


@pytest.mark.slow
@pytest.mark.parametrize("key", categories_to_check())
def test_category_passes_its_checks(
    key: str, record_property: Callable[[str, object], None]
) -> None:
    record_property("category", key)
    record_property("proof", digests()[key])
    source, _ = find_source(CATEGORIES[key])
    results = check_category(load_category(CATEGORIES[key]), source)
    assert [f"{r.name}: {r.detail}" for r in results if not r.passed] == []
