"""Checks of certificates: detection of impossible values, and replay of some episodes.

``tabletopgen verify --replay`` runs them through the entry point in ``tabletopgen.verifiers``.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from generator.errors import require_number
from generator.scene.provenance import versions

from ..robot.panda import Panda
from ..tasks.names import NAMES
from ..world.worlds import Masters
from .certificate import Certificate, TaskInstance, read_certificate
from .certify import STARTING, VERSIONS, environment_of, has_solved

FigureKind = Literal["played after a failure", "given up early", "too many"]


@dataclass(frozen=True)
class CertificateDoubt:
    """A claimed result that an instance cannot have; ``limit`` is the maximum episode count."""

    kind: FigureKind
    instance: TaskInstance
    limit: int

    def __str__(self) -> str:
        """Describe the problem in a sentence."""
        seen = self.instance
        return (
            f"{_name_of(seen)}: {seen.successes} of {seen.episodes} successful episodes is an "
            f"impossible result ({self.kind}: an instance ends at its first failure, after at most "
            f"{self.limit} episodes)"
        )


@dataclass(frozen=True)
class StartReplay:
    """The replay of an instance's episode, for comparison with the certificate.

    Attributes:
        instance: the instance.
        number: index of the episode, from 0.
        solved: whether the expert solved the replay.
        versions: package versions of the certificate that differ from the installed ones.
    """

    instance: TaskInstance
    number: int
    solved: bool
    versions: tuple[str, ...] = ()

    @property
    def listed(self) -> bool:
        """Whether the certificate lists the episode as solved."""
        return self.number < self.instance.successes

    def __str__(self) -> str:
        """Describe the outcome in a sentence."""
        said, now = (("" if solved else "not ") + "solved" for solved in (self.listed, self.solved))
        other = (
            f"; the certificate was made with {', '.join(self.versions)}" if self.versions else ""
        )
        name = _name_of(self.instance)
        return f"{name}: episode {self.number} is {now}, but is listed as {said}{other}"


def check_certificate(path: Path, count: int, seed: int) -> tuple[int, Sequence[object]]:
    """Check a bundle's certificate; return the number of replayed episodes and the problems found.

    Episodes listed as solved must be solved again. A listed failure that is solved now is accepted,
    since the certificate then claims too little. Impossible figures are reported without a replay.

    Args:
        path: the bundle.
        count: number of episodes to replay, drawn from all that the certificate counts.
        seed: seed of the choice.

    Raises:
        InputError: ``count`` is less than one.
        BundleError: the bundle or its certificate is damaged.
    """
    require_number("--replay", count, minimum=1, integer=True)
    certificate = read_certificate(path)
    if certificate is None or not certificate.instances:
        return 0, ()
    if found := doubts(certificate):
        return 0, found
    played = list(replay(path, certificate, count, seed))
    return len(played), [again for again in played if again.listed and not again.solved]


def doubts(certificate: Certificate) -> tuple[CertificateDoubt, ...]:
    """Return the results in a certificate that ``certify`` cannot produce."""
    limit = certificate.terms.episodes
    found = (_doubt(seen, limit) for seen in certificate.instances)
    return tuple(doubt for doubt in found if doubt is not None)


def replay(path: Path, certificate: Certificate, count: int, seed: int) -> Iterator[StartReplay]:
    """Replay ``count`` randomly drawn episodes of a bundle's certificate, and yield each replay."""
    listed = certificate.instances
    episodes = [(k, number) for k, seen in enumerate(listed) for number in range(seen.episodes)]
    drawn = np.random.default_rng(seed).choice(
        len(episodes), min(count, len(episodes)), replace=False
    )
    here = versions(VERSIONS)
    other = tuple(
        f"{name} {version}, here {here[name]}"
        for name, version in certificate.versions.items()
        if here.get(name, version) != version
    )
    masters, places = Masters(Panda(), 1), _places(listed)
    for at in sorted(map(int, drawn)):
        k, number = episodes[at]
        solved = _play(path, listed[k], number, (certificate.terms.seed, *places[k]), masters)
        yield StartReplay(listed[k], number, solved, other)


def _play(
    path: Path, instance: TaskInstance, number: int, key: tuple[int, ...], masters: Masters
) -> bool:
    """Return whether the expert solves an instance's episode, replayed with its seed."""
    rng = np.random.default_rng(key)
    for _ in range(number):  # one by one, in the original order
        rng.integers(2**31)
    with closing(environment_of(path, instance.name, masters, STARTING if number else None)) as env:
        return has_solved(env, instance, rng)


def _places(listed: Sequence[TaskInstance]) -> list[tuple[int, int]]:
    """Return the task index of each instance, and its index among that task's instances."""
    seen: Counter[str] = Counter()
    places = []
    for instance in listed:
        places.append((NAMES.index(instance.task), seen[instance.task]))
        seen[instance.task] += 1
    return places


def _doubt(seen: TaskInstance, limit: int) -> CertificateDoubt | None:
    if seen.episodes > limit:
        return CertificateDoubt("too many", seen, limit)
    if seen.successes < seen.episodes - 1:
        return CertificateDoubt("played after a failure", seen, limit)
    if seen.successes == seen.episodes < limit:
        return CertificateDoubt("given up early", seen, limit)
    return None


def _name_of(instance: TaskInstance) -> str:
    asked = {"preset": instance.preset} if instance.preset else instance.options
    return f"{instance.task} ({', '.join(f'{k} {v}' for k, v in asked.items()) or 'as drawn'})"
