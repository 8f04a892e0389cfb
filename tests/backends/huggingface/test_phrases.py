"""Words in Grounding DINO's prompts: the answer is one complete word."""

import numpy as np
import pytest
import tiny_models
import torch
import transformers

from generator.backends.huggingface.detection.phrases import best_words, plain, questions

WORDS = ("table", "stuffed toy", "magnifying glass", "glass")


@pytest.fixture(scope="module")
def tokenizer() -> transformers.PreTrainedTokenizerFast:
    """A tokenizer that knows only single letters, so that every word has many tokens."""
    return transformers.PreTrainedTokenizerFast(tokenizer_object=tiny_models.letters_tokenizer())


def logits(question, words: dict[int, dict[str, float]], rows: int) -> torch.Tensor:
    """Return logits that give each row's words the same probability at all of their tokens."""
    made = torch.full((rows, len(question.ids)), -20.0)
    for row, chances in words.items():
        for word, chance in chances.items():
            made[row, list(question.tokens[question.words.index(word)])] = np.log(
                chance / (1 - chance)
            )
    return made


def test_each_word_has_its_own_tokens(tokenizer: transformers.PreTrainedTokenizerFast) -> None:
    (question,) = questions(WORDS, tokenizer, 24, 256)
    assert question.text == "table. stuffed toy. magnifying glass. glass."
    letters = tokenizer.convert_ids_to_tokens(list(question.ids))
    spelt = ["".join(letters[k].removeprefix("##") for k in t) for t in question.tokens]
    assert spelt == ["table", "stuffedtoy", "magnifyingglass", "glass"]
    assert list(question.ids) == tokenizer(question.text)["input_ids"]


def test_an_answer_is_the_word_that_fits_best_and_no_piece_of_it(
    tokenizer: transformers.PreTrainedTokenizerFast,
) -> None:
    """Joining the tokens above a threshold would give "##fying glass" for the second row."""
    (question,) = questions(WORDS, tokenizer, 24, 256)
    made = logits(question, {0: {"glass": 0.6}, 2: {"stuffed toy": 0.3, "table": 0.25}}, 3)
    first, *rest = question.tokens[2]
    made[1, [first, *rest[:3]]] = -0.5
    made[1, rest[3:]] = 1.0
    scores, best = best_words(made, question)
    assert [question.words[k] for k in best] == ["glass", "magnifying glass", "stuffed toy"]
    np.testing.assert_allclose(scores, [0.6, 1 / (1 + np.exp(-1)), 0.3], atol=1e-6)


def test_texts_hold_no_more_words_and_tokens_than_they_may(
    tokenizer: transformers.PreTrainedTokenizerFast,
) -> None:
    asked = questions(WORDS, tokenizer, 2, 256)
    assert [q.words for q in asked] == [WORDS[:2], WORDS[2:]]
    short = questions(WORDS, tokenizer, 24, 20)
    assert [q.words for q in short] == [WORDS[:2], WORDS[2:3], WORDS[3:]]
    assert all(len(q.ids) <= 20 for q in short)
    assert questions((), tokenizer, 24, 256) == ()


def test_a_word_longer_than_a_text_is_asked_about_in_part(
    tokenizer: transformers.PreTrainedTokenizerFast,
) -> None:
    (question,) = questions(("a" * 40,), tokenizer, 24, 16)
    assert len(question.ids) == 16
    assert question.ids[-1] == tiny_models.MARKS["[SEP]"]
    assert question.tokens == (tuple(range(1, 15)),)
    scores, _ = best_words(torch.zeros(1, 16), question)
    assert scores[0] == 0.5


def test_a_word_without_letters_is_not_asked_about(
    tokenizer: transformers.PreTrainedTokenizerFast,
) -> None:
    (question,) = questions(("mug", "...", "\u200b"), tokenizer, 24, 256)
    assert question.words == ("mug",)
    assert questions(("...",), tokenizer, 24, 256) == ()


def test_what_parts_words_is_taken_out_of_them() -> None:
    assert plain(" Dr. Pepper can?  ") == "dr pepper can"
