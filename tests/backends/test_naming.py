"""Names from probabilities, sizes and the words of a text."""

import numpy as np

from generator.language import names as naming

KEYS = ("mug", "bowl", "apple")


def test_a_size_that_no_mug_has_takes_its_name_away():
    names = np.array([[0.5, 0.1, 0.3, 0.1]])
    fitting = naming.weigh(names, [{0: (1.0, 0.0)}])
    huge = naming.weigh(names, [{0: (6.0, 0.0)}])
    assert naming.free_labels(fitting, KEYS) == ["mug"]
    assert naming.free_labels(huge, KEYS) == [None]
    np.testing.assert_allclose([fitting.sum(), huge.sum()], 1)


def test_a_shape_that_no_bowl_has_makes_it_a_mug():
    names = np.array([[0.35, 0.45, 0.1, 0.1]])
    seen = naming.weigh(names, [{0: (1.1, 0.1), 1: (0.9, 1.2), 2: (1.0, 0.5)}])
    assert naming.free_labels(seen, KEYS) == ["mug"]


def test_one_table_scale_must_do_for_all():
    # Half as large as usual, all three: on a small table. One of them alone: not what it seems.
    names = np.tile([0.5, 0.1, 0.3, 0.1], (3, 1))
    small = naming.weigh(names, [{0: (0.6, 0.0)}] * 3)
    assert naming.free_labels(small, KEYS) == ["mug"] * 3
    assert (
        naming.free_labels(naming.weigh(names, [{0: (0.3, 0.0)}] * 3, metric=True), KEYS)
        == [None] * 3
    )
    odd = naming.weigh(names, [{0: (0.4, 0.0)}, {0: (1.0, 0.0)}, {0: (1.0, 0.0)}])
    assert naming.free_labels(odd, KEYS) == [None, "mug", "mug"]


def test_a_look_that_is_sure_does_not_make_a_monitor_a_toaster():
    # Nothing else is likely, but the things beside it say how large it is.
    names = np.array([[0.98, 0.005, 0.005, 0.01], *[[0.0, 0.9, 0.0, 0.1]] * 3])
    looks = [{0: (2.1, 0.2)}, *[{1: (1.0, 0.0)}] * 3]
    assert naming.free_labels(naming.weigh(names, looks), KEYS) == [None, *["bowl"] * 3]
    looks[0] = {0: (1.5, 0.2)}
    assert naming.free_labels(naming.weigh(names, looks), KEYS) == ["mug", *["bowl"] * 3]


def test_a_thing_that_the_frame_cuts_keeps_its_name():
    names = np.array([[0.6, 0.1, 0.2, 0.1]])
    np.testing.assert_allclose(naming.weigh(names, [None]), names)


def test_unknown_things_get_no_category():
    assert naming.free_labels(np.array([[0.2, 0.2, 0.2, 0.4]]), KEYS) == [None]


def sizes(*rows: list[float]) -> np.ndarray:
    """Return apparent sizes relative to the usual ones, by word; shapes are equal."""
    scales = np.array(rows, float)
    return np.stack([scales, np.zeros_like(scales)], 2)


def test_words_are_given_out_all_together():
    likely = np.array([[0.6, 0.3, 0.05], [0.7, 0.01, 0.09], [0.1, 0.1, 0.7]])
    unknown = np.full((3, 3, 2), np.nan)
    assert dict(naming.assign(likely, np.ones(3), unknown)) == {0: 1, 1: 0, 2: 2}
    fewer = naming.assign(
        np.array([[0.05], [0.2], [0.1]]), np.array([0.9, 0.9, 0.2]), unknown[:, :1]
    )
    assert fewer == [(1, 0)]


def test_of_words_that_look_alike_the_size_decides():
    alike = np.full((2, 2), 0.3)
    pairs = naming.assign(alike, np.ones(2), sizes([2.0, 1.0], [1.0, 0.5]))
    assert dict(pairs) == {0: 1, 1: 0}


def test_sizes_are_compared_on_one_scale_unless_it_was_measured():
    # What the last two are is plain, and they are half as large as usual: so is all else.
    likely = np.array([[0.3, 0.3, 0.0, 0.0]] * 2 + [[0.0, 0.0, 0.9, 0.9]] * 2)
    looks = sizes([0.5, 1.0, 9, 9], [0.9, 0.5, 9, 9], [9, 9, 0.5, 0.5], [9, 9, 0.5, 0.5])
    chosen = dict(naming.assign(likely, np.ones(4), looks))
    assert (chosen[0], chosen[1]) == (0, 1)
    measured = dict(naming.assign(likely, np.ones(4), looks, metric=True))
    assert (measured[0], measured[1]) == (1, 0)


def test_what_is_in_doubt_gets_no_word_that_it_does_not_look_like():
    likely = np.array([[0.9], [0.02]])
    nothing = np.full((2, 1, 2), np.nan)
    doubtful = np.array([False, True])
    assert naming.assign(likely[1:], np.ones(1), nothing[1:], doubtful[1:]) == []
    assert naming.assign(likely, np.ones(2), nothing, doubtful) == [(0, 0)]
