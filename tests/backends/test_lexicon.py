"""Words of similar categories map to the right one."""

import pytest

from generator.language.lexicon import category_of


@pytest.mark.parametrize(
    ("words", "key"),
    [
        ("open book", "open_book"), ("open notebook", "open_book"), ("book", "book"),
        ("map", "map"), ("treasure map", "map"), ("folded map", "folded_map"),
        ("placemat", "placemat"), ("place mats", "placemat"), ("mouse mat", "mousepad"),
        ("figurine", "figurine"), ("statue", "sculpture"), ("photo", "picture_frame"),
        ("polaroid", "photo_print"),
    ],
)  # fmt: skip
def test_words_lead_to_their_category(words: str, key: str) -> None:
    assert category_of(tuple(words.split())) == key
