"""Names from probabilities, sizes and the words of a text."""

from __future__ import annotations

import numpy as np
import pytest

from generator.backends.embedded import naming
from generator.catalogue import CATEGORIES

KEYS = ("mug", "bowl", "apple")


def span(key: str) -> float:
    return float(np.cbrt(np.prod(CATEGORIES[key].size)))


def test_a_size_that_no_mug_has_takes_its_name_away():
    names = np.array([[0.5, 0.1, 0.3, 0.1]])
    fitting = naming.weighed(names, KEYS, np.array([span("mug")]))
    huge = naming.weighed(names, KEYS, np.array([6 * span("mug")]))
    assert naming.free_labels(fitting, KEYS) == ["mug"]
    assert naming.free_labels(huge, KEYS) == [None]
    np.testing.assert_allclose([fitting.sum(), huge.sum()], 1)


def test_unknown_things_get_no_category():
    assert naming.free_labels(np.array([[0.2, 0.2, 0.2, 0.4]]), KEYS) == [None]


def test_sure_names_tell_the_tables_scale():
    names = np.array([[0.9, 0.0, 0.0, 0.1], [0.0, 0.9, 0.0, 0.1], [0.3, 0.3, 0.3, 0.1]])
    spans = np.array([span("mug"), span("bowl"), 5.0]) / 1.3
    assert naming.table_scale(names, KEYS, spans) == pytest.approx(1.3)
    assert naming.table_scale(names[2:], KEYS, spans[2:]) == 1.0


def test_words_are_given_out_all_together():
    names = np.array([[0.6, 0.3, 0.05, 0.05], [0.7, 0.01, 0.2, 0.09], [0.1, 0.1, 0.1, 0.7]])
    pairs = naming.assigned(names, KEYS, np.ones(3), ("mug", "bowl", "gizmo"))
    assert dict(pairs) == {0: 1, 1: 0, 2: 2}
    fewer = naming.assigned(names, KEYS, np.array([0.9, 0.9, 0.2]), ("apple",))
    assert fewer == [(1, 0)]
