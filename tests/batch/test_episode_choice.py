"""Choice of the next episodes of a deck."""

import numpy as np
import pytest

from tabletopgen_env.parallel.batch.choice import EpisodeChoice, sampler_of
from tabletopgen_env.scenes import CurriculumScenes, DifficultySampler

EDGES = (0.0, 0.25, 0.5, 1.0)
DECK = np.array([0.6, 0.1, 0.3, 0.1, 0.3, 0.3, 0.7])
WORLDS = np.arange(4000)


def choice(seed: int = 0) -> EpisodeChoice:
    made = EpisodeChoice(DifficultySampler(EDGES, explore=0.1), len(WORLDS), seed)
    made.hold(DECK)
    return made


def learned(seed: int = 0) -> EpisodeChoice:
    """Episodes of the first bin always succeed, half of the second do, the third is unknown."""
    made = choice(seed)
    for k in range(200):
        rows = made.draw(WORLDS[:3])
        bins = made.sampler.bins(DECK[rows])
        made.record(WORLDS < 3, np.concatenate([(bins == 0) | ((bins == 1) & (k % 2 == 0)),
                                                np.zeros(len(WORLDS) - 3, bool)]))  # fmt: skip
    return made


def test_draws_shift_as_the_sampler_says() -> None:
    made = learned()
    chances = made.sampler.probabilities(np.bincount(made.sampler.bins(DECK), minlength=3))
    assert chances[1] > 3 * chances[0] and chances[1] > 3 * chances[2]
    rows = made.draw(WORLDS)
    shares = np.bincount(made.sampler.bins(DECK[rows]), minlength=3) / len(rows)
    assert shares == pytest.approx(chances, abs=0.03)
    each = np.bincount(rows, minlength=len(DECK)) / len(rows)
    assert each[[2, 4, 5]] == pytest.approx([chances[1] / 3] * 3, abs=0.03)


def test_equal_seeds_draw_alike() -> None:
    one, other, third = learned(3), learned(3), learned(4)
    assert np.array_equal(one.draw(WORLDS), other.draw(WORLDS))
    assert not np.array_equal(one.draw(WORLDS), third.draw(WORLDS))
    one.restart(5)
    other.restart(5)
    assert np.array_equal(one.draw(WORLDS), other.draw(WORLDS))


def test_another_deck_keeps_what_was_learned() -> None:
    made = learned()
    before = made.sampler.counts.copy()
    made.hold(np.array([0.1, 0.9]))
    made.record(WORLDS >= 0, np.ones(len(WORLDS)))
    assert np.array_equal(made.sampler.counts, before), "no world plays one of its episodes yet"
    rows = made.draw(WORLDS)
    assert set(rows.tolist()) == {0, 1}, "the second bin has no episode"
    made.record(WORLDS == 7, np.ones(len(WORLDS)))
    kind = made.sampler.bins(np.array([0.1, 0.9])[rows[7]])
    assert np.flatnonzero((made.sampler.counts != before).any(1)).tolist() == [kind]


def test_episodes_that_were_named_do_not_count() -> None:
    made = choice()
    made.draw(WORLDS)
    made.forget(WORLDS[1:])
    made.record(WORLDS >= 0, np.ones(len(WORLDS)))
    assert made.sampler.counts.sum() == 2.0


def test_scenes_say_which_sampler() -> None:
    own = CurriculumScenes("vanity", DifficultySampler(EDGES))
    assert sampler_of(own) is own.sampler
    assert len(sampler_of("curriculum:vanity").counts) == len(DifficultySampler().counts)
    uniform = sampler_of("vanity")
    assert len(uniform.counts) == 1 and uniform.probabilities().tolist() == [1.0]
