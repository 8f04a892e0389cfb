"""The function words of English that the grammar uses. This module contains only data."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType


def _table(text: str) -> Mapping[str, str]:
    """Parse lines of ``key: phrase, phrase`` into a mapping from each phrase to its key."""
    entries: dict[str, str] = {}
    for line in text.strip().splitlines():
        key, phrases = line.split(":")
        entries |= {phrase.strip(): key.strip() for phrase in phrases.split(",")}
    return MappingProxyType(entries)


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


NUMBERS: Mapping[str, float] = MappingProxyType(
    {
        "zero": 0, "one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7,
        "eight": 8, "nine": 9, "ten": 10, "eleven": 11, "twelve": 12, "thirteen": 13,
        "fourteen": 14, "fifteen": 15, "sixteen": 16, "seventeen": 17, "eighteen": 18,
        "nineteen": 19, "twenty": 20, "thirty": 30, "forty": 40, "fifty": 50, "sixty": 60,
        "seventy": 70, "eighty": 80, "ninety": 90, "hundred": 100, "hundreds": 200,
        "thousand": 1000, "thousands": 2000, "million": 1_000_000, "millions": 2_000_000,
        "dozen": 12, "dozens": 36, "brace": 2, "pair": 2, "pairs": 2, "couple": 2, "trio": 3,
        "both": 2,
        "single": 1, "another": 1, "twin": 2, "twins": 2, "quartet": 4, "lone": 1,
    }
)  # fmt: skip
"""Number words; the grammar multiplies "half a dozen", "two hundred" and "three pairs"."""

PARTICLES = _words("off over up down out away")

NEVER_INSIDE = _words("but although though however unless whether because until during via "
                      "than whilst instead")  # fmt: skip
"""Words at which a noun phrase ends."""

LEFT_OUT = frozenset(
    {("sold", "out"), ("not", "present"), ("not", "included"), ("not", "there"), ("not", "allowed"),
     ("left", "out"), ("left", "off"), ("not", "wanted"), ("not", "needed"), ("left", "away"),
     ("taken", "away"), ("taken", "off"), ("kept", "away"), ("not", "available"),
     ("not", "required")}
)  # fmt: skip
"""Phrases of two words that exclude objects."""
ELSEWHERE = _words("attic cupboard drawer kitchen cellar fridge freezer shed garage wardrobe car "
                   "basement pantry closet hall bag")  # fmt: skip
"""Places away from the table where objects "stay"."""

KINDS = _words("color colour kind type sort flavor flavour size shape one")

BOUNDS = tuple(
    tuple(phrase.split())
    for phrase in (
        "at least", "at most", "no more than", "not more than", "no less than", "not less than",
        "no fewer than", "not fewer than", "up to", "more than", "fewer than", "less than",
        "a maximum of", "a minimum of", "a total of", "as many as",
    )
)  # fmt: skip
"""Phrases that set a bound on a number."""

AWAY = frozenset({"away", "apart", "off", "further", "farther"})
"""Words that may follow a distance: "5 cm away"."""

ASPECTS = frozenset({("color",), ("colour",), ("size",), ("shape",), ("style",), ("height",)})
"""Nouns after "in" and an attribute: "blue in colour"."""

NOBODY = _words("nothing nobody somebody someone something anything everybody anybody everyone")

GETS = _words("gets get has have having receives needs is are should must will there sits")
"""Verbs that follow the people for whom objects are laid."""

ORDINALS: Mapping[str, int] = MappingProxyType(
    {"first": 1, "second": 2, "third": 3, "fourth": 4, "fifth": 5, "sixth": 6, "last": -1}
)
"""Ordinals as indices; -1 is the last."""

AMOUNTS: Mapping[str, tuple[int, int]] = MappingProxyType(
    {
        "some": (2, 3), "few": (3, 3), "several": (3, 4), "many": (5, 6), "various": (3, 4),
        "multiple": (3, 4), "lots": (5, 6), "lot": (5, 6), "assorted": (3, 4), "numerous": (5, 6),
        "plenty": (4, 5), "handful": (4, 5), "bunch": (3, 4), "mixed": (3, 4),
    }
)  # fmt: skip
"""Vague amounts, with the minimum and maximum number that they mean."""

DEFINITE = _words("the this that these those its his her my your their our")
INDEFINITE = _words("a an any")
PRONOUNS = _words("it them itself themselves they these those one")
SUBJECT_PRONOUNS = _words("it they these those")
PLURAL_PRONOUNS = _words("them themselves they these those")
EACH = _words("each every")

RELATIONS = _table(
    """
    left_of: to the left of, on the left of, at the left of, left of, to left of, on left of
    left_of: at left of, just left of
    left_of: leftwards of, left from
    right_of: to the right of, on the right of, at the right of, right of, to right of
    right_of: on right of, at right of, just right of
    in_front_of: in front of, at the front of, ahead of, just in front of, before
    behind: behind, in back of, at the back of, beyond, at the rear of, to the rear of
    next_to: next to, beside, near, close to, adjacent to, alongside, along side, by, nearby
    next_to: not far from, touching, by the side of, at the side of, to the side of
    next_to: together with, close by, right by, near to, accompanying, outside, outside of
    laid: at
    next_to: along, within reach of, off to the side of
    against: against, leaning against, propped against, propped up against, leaning on
    against: leaning up against, resting against, leant against, up against
    opposite: opposite, across from, opposite of, opposite to, facing, face to face with
    around: around, surrounding, all around, circling, encircling, arranged around
    around: gathered around, set around, placed around
    surrounded: surrounded by, flanked by, encircled by, ringed by
    flank: on either side of, on both sides of, to either side of, on each side of, at both ends of
    flank: each side of, at each side of, one each side of
    flank: either side of, both sides of, at each end of, at either end of
    between: between, in between, amid, among, amongst
    on: on, on top of, atop, upon, onto, above, over, over the top of, resting on top of
    on: balanced on, perched on, laid on, spread on, served on, stacked on top of, up on, on to
    on: mounted on, hung on, displayed on, resting on, across, lying across, laid across
    on: riding, riding on, riding on top of, astride, sitting astride, straddling, seated on
    in: in, inside, inside of, within, into, in to, sticking out of, poking out of, peeking out of
    under: under, beneath, underneath, below
    aim: towards, toward, without touching, without hitting, without moving, without knocking over
    flank: flanking, flank, flanks
    around: surrounds, surround, encircles, encircle
    """
)
"""Prepositions, and the relations they express; ``surrounded`` and ``under`` are inverted."""

HERE = _table(
    """
    left_of: to its left, on its left, at its left, to their left, on their left
    left_of: on its left side, to its left side, on its left hand side
    right_of: to its right, on its right, at its right, to their right, on their right
    right_of: on its right side, to its right side, on its right hand side
    in_front_of: in its front, at its front, in front, just in front, right in front
    behind: at its back, at its rear
    next_to: at its side, by its side, at their side, to its side, next door, close by, nearby
    next_to: on the side, to the side, off to the side, alongside, beside
    flank: on either side, on both sides, to either side, on each side, at both ends, at each end
    on: on top, atop, on the very top, at the very top, right on top
    otherside: on its other side, on the other side, to the other side, at the other side
    in: inside, within
    under: underneath, below, beneath
    """
)
"""Phrases that refer to the object mentioned last."""

CARRIES = _table(
    """
    with: composed of, made up of, consists of, consist of, comprising, comprises
    with: with, has, have, having, featuring, including, includes, include, bearing, plus
    with: such as, along with, complete with, as well as, accompanied by, paired with
    with: decorated with
    with: set with, equipped with, laid with, furnished with, arranged with, stocked with
    with: decked with, laden with, adorned with, strewn with, littered with, scattered with
    with: covered with, covered in, showing, lined with, cluttered with, dressed with, loaded with
    hold: containing, contains, contain, holding, holds, hold, that holds, filled with, full of
    hold: half full of, half full with, half filled with, full to the brim with, full with
    hold: stuffed with, packed with, carrying, carries, carry, supporting, supports, piled with
    hold: piled high with, stacked with, heaped with, housing, brimming with, consisting of
    top: topped with, topped by, garnished with, sprinkled with, crowned with, crowned by
    """
)
"""Phrases that attach other objects ("a bowl containing two apples")."""

FULL = _words("full filled stuffed packed brimming heaped piled")
"""First words of phrases about vessels that have several contents."""

NEGATIONS = _words("no without not never except excluding minus lacking neither nor none hardly")
NEGATED = ("free of", "but no", "but not", "and no", "not any", "no longer any", "with no",
           "with out", "other than", "instead of", "devoid of", "empty of", "not a",
           "apart from", "has no", "have no", "do not", "does not", "leave out", "leave off",
           "skip the", "hold the", "scrap the", "scratch the", "ditch the", "remove the",
           "lose the",
           "no need for", "get rid of", "take away", "omit", "forget the", "rather than",
           "free from", "no longer do", "no longer have", "nobody gets", "nobody wants",
           "nobody needs", "no one gets",
           "no one wants", "no one needs")  # fmt: skip

ARRANGED = _table(
    """
    stack: stacked, in a stack, on top of each other, on each other, on top of one another
    stack: one on top of the other, stacked up, stacked on top of each other, in a tower
    stack: stacked on each other, stacked on one another, piled on top of each other
    stack: in one stack, in a single stack, into a stack, in a neat pile on each other
    stack: one atop the other, one on the other, in a neat stack, one on top of another
    stack: stacked on top of one another, nested, nested in each other, nested inside each other
    heap: in one pile, into a pile, in one heap
    heap: piled, in a pile, in a heap, heaped, piled up, jumbled, in a jumble, piled high
    pyramid: in a pyramid, stacked in a pyramid, arranged in a pyramid, piled in a pyramid
    row: in a row, in a line, lined up, in line, side by side, next to each other, in a neat row
    row: in a straight line, next to one another, beside each other, in one row, aligned
    row: in a neat line, beside one another, lined up in a row, lined up side by side
    row: arranged in a row, ordered, sorted, arranged in a line, from left to right, in rows
    row: left to right, all in a row, in order, in sequence
    column: in a column, one behind the other, one behind another, behind each other
    column: opposite each other, facing each other, across from each other, face to face
    column: opposite one another, facing one another
    column: from front to back, from back to front, in single file
    circle: in a circle, in a ring, arranged in a circle, in a semicircle, in a half circle
    circle: in an arc, in a triangle, arranged in a ring
    fan: fanned out, fanned, in a fan, spread out like a fan
    scatter: scattered, scattered around, scattered about, spread out, strewn, strewn about
    scatter: spread around, spread across, randomly placed, at random, here and there, dotted
    scatter: scattered across, scattered all over, haphazardly, everywhere, all over
    grid: in a grid, in two rows, arranged in a grid, in three rows, in a square
    group: together, grouped, grouped together, in a group, clustered, in a cluster, huddled
    group: close together, bundled, bundled together
    """
)
"""Phrases for arrangements of several objects."""

GROUPS = _table(
    """
    stack: stack, stacks, tower, towers
    heap: pile, piles, heap, heaps, mound, mounds, jumble, mountain
    pyramid: pyramid, pyramids
    row: row, rows, line, lines, series, lineup, sequence
    column: column, columns
    circle: circle, ring, arc, semicircle
    fan: fan
    scatter: scattering, sprinkling
    grid: grid, matrix
    group: set, sets, group, groups, bunch, bunches, collection, cluster, clusters, assortment
    group: bundle, bundles, handful, arrangement, array, selection, variety, number, mix, mixture
    group: batch, medley, range, display, ensemble, piece, pieces, slice
    group: slices, type, types, kind, kinds, sort, sorts, lot, sheet, sheets, serving, portion
    group: clove, cloves, head, heads, stalk, stalks, strip, strips, wedge, wedges, chunk, chunks
    group: roll, rolls, reel, reels, thumb, pinch, dash, drizzle, pat, knob, stick, sticks
    group: half, halves, quarter, quarters, trio, lump, lumps, helping, unit, units, item
    group: items, plenty, spread, sprig, clump
    """
)
"""Nouns before "of" that state only a count or an arrangement."""

FORMING = ("in", "into", "as", "forming", "form", "forms", "to form", "making", "make", "makes",
           "to make", "to build", "building", "arranged in", "set in", "set out in",
           "laid out in", "standing in",
           "placed in", "all in", "making up")  # fmt: skip
FORM_ARTICLES = ("a", "one", "a single", "a straight", "a neat", "a little", "a small", "a big",
                 "a tidy", "a loose", "a long", "one long", "one single",
                 "one straight")  # fmt: skip
FORMS = ("stack", "tower", "pile", "heap", "pyramid", "row", "line", "column", "circle", "ring",
         "arc", "semicircle", "fan", "grid", "cluster", "bunch")  # fmt: skip
"""Patterns of arrangement phrases, one word from each set in order: "forming a neat circle"."""

SUPERLATIVES: Mapping[str, str] = MappingProxyType(
    {
        "smallest": "small", "shortest": "small", "tiniest": "small", "thinnest": "small",
        "largest": "large", "biggest": "large", "tallest": "large", "longest": "large",
        "thickest": "large", "widest": "large",
    }
)  # fmt: skip
"""Words for one of several objects of different sizes."""

COMPARED: Mapping[str, str] = MappingProxyType(
    {
        "smaller": "small", "shorter": "small", "narrower": "small", "thinner": "small",
        "lower": "small", "bigger": "large", "larger": "large", "taller": "large",
        "wider": "large", "longer": "large", "higher": "large", "thicker": "large",
    }
)  # fmt: skip
"""Phrases that compare an object with a neighbouring one."""

ORDERS = _table(
    """
    size: by size, from small to large, from smallest to largest, by height, in order of size
    size: from shortest to tallest, in ascending order, from small to big, from thin to thick
    size: from smallest to biggest, from short to tall, from short to long, smallest to largest
    size: from the smallest to the largest, by rank, in rank order, in ascending size
    size down: from large to small, from largest to smallest, from tallest to shortest
    size down: in descending order, from big to small, from biggest to smallest
    size down: from thick to thin, from tall to short, from long to short, largest to smallest
    size down: from the largest to the smallest, in descending size
    size: in order of increasing height, in order of increasing size, in increasing size
    size: in increasing height, in increasing order, by increasing size, by increasing height
    size down: in order of decreasing height, in order of decreasing size, in decreasing size
    size down: in decreasing height, in decreasing order
    size: smallest first, shortest first
    size down: largest first, biggest first, tallest first
    color: by color, by colour, in rainbow order
    """
)

POSTURES = _table(
    """
    lying: on its side, on their sides, on their side, lying on its side, lying on their sides
    lying: lying down, knocked over, tipped over, toppled over, toppled, laid on its side, fallen
    lying: laid on their sides, tipped on its side, fallen over, fallen on its side, tipped
    upside down: upside down, upturned, inverted, turned over, overturned, flipped over, face down
    upside down: bottom up, facing down, face downwards, lying face down, upended
    upright: upright, standing upright, standing up, on end, standing on end, stood on end
    """
)
"""Phrases for postures that differ from an object's usual one."""

ARRANGING_VERBS = _table(
    """
    stack: stack, stack up, pile up
    heap: pile, heap
    row: line up, align, line
    scatter: scatter, spread out, sprinkle
    fan: fan out, fan
    group: group, cluster, gather, bundle
    """
)
"""Verbs at the start of a sentence that imply an arrangement."""

BE = _words("is are was were be been being sits sit stands stand lies lie lays rests rest lay sat "
            "stood remain remains stays stay goes go belongs belong appears appear hangs hang "
            "leans lean faces face should must can could shall will would may might")  # fmt: skip
"""Verbs that connect subjects to predicates."""

SINGULAR = _words(
    "is sits stands lies rests hangs leans goes stays belongs was remains faces being"
)
"""Singular verbs, which apply only to the last item of a list."""

MOVING = _words("pick push pull take move slide lift grab turn drop throw grasp drag place put "
                "bring "
                "sweep reach weigh rotate open close wipe hang insert press pour "
                "stack")  # fmt: skip
"""Verbs that instruct a robot."""
TASKS = MOVING - _words("place put drop stack open close hang turn bring take pour press")
"""Verbs that describe a task, so that the moved object is not yet at its goal."""
CARRYING = _words("move slide push pull bring drag sweep")
"""Verbs for which every place is a goal."""

HANDLED = _words("sorted moved grasped picked handled cleaned cleared used seen made tidied "
                 "collected "
                 "done packed eaten washed left arranged")  # fmt: skip
"""Participles that describe actions: "sorted by the robot"."""

PARTICIPLES = _words(
    "sitting standing lying resting placed put located positioned laying leaning hanging seen "
    "visible kept left set situated arranged neatly carefully slightly directly just right "
    "closely partially partly still also then now lain laid stood found displayed propped nicely "
    "currently immediately exactly precisely roughly approximately nearly almost casually loosely "
    "conveniently politely flat turned flipped somewhere far further slightly close very quite "
    "rather so too only even both all alone usually always normally going guard proudly"
)
"""Words between a noun and its place that do not affect the plan."""

STARTERS = _words(
    "make create generate show draw give build design render want need like please imagine shows "
    "depicts depict there here place put set add arrange prepare get bring display lay position "
    "compose produce simulate i we you me us he she let lets could would can should will have "
    "am just also then and so well ok okay hi hello hey thanks thank to be is are it this that "
    "think "
    "picture consider suppose visualize visualise assume what how about provide do try load plan "
    "setup up out help ll d with scene showing includes including ideally maybe perhaps finally "
    "lastly next now additionally furthermore moreover besides first second third drop throw toss "
    "use stick park leave keep hide tuck see find pick grab push pull take move slide lift pour "
    "turn spread start begin place putting balance wash clean clear tidy sort build pack"
)
"""Words that only open a sentence; they are skipped up to its first object."""

FILLERS = _words(
    "of from for at to as or than about onto through per via during after until while when where "
    "there here again too also just only very really quite then so if because since ready using "
    "used made seen look looks looking please well etc eg ie such like respectively namely "
    "hiya heya heyo howdy ta cheers greetings dear thx ty yo ciao oops hm hmm er uh um oh ah "
    "kidding hang init approximately roughly exactly own same whole next ll d"
)

NO_NOUNS = _words(
    "but otherwise toward towards across away apart along although though however instead "
    "unless whether because yet still even ever never always often sometimes usually maybe "
    "perhaps else almost enough quite rather too much more most less least many few several "
    "such both either neither nor not get gets got gotten give gives gave take takes taken took "
    "make makes made go goes went gone come comes came grow grows grew grown put puts keep "
    "keeps kept let lets say says said see sees saw seen know knows think thinks thought want "
    "wants wanted need needs use uses find finds found become becomes became seem seems seemed "
    "remain remains contain contains include includes hold holds held bring brings brought buy "
    "bought eat eats ate eaten drink drinks drank sit sits sat stand stands stood lie lies lay "
    "lain lean leans hang hangs hung fall falls fell fallen drop drops throw throws threw "
    "thrown break breaks broke broken cut cuts leave leaves open closed shut empty full ready "
    "able possible impossible available whatever whichever whoever wherever whenever somehow "
    "anyhow anyway anywhere nowhere elsewhere overall altogether meanwhile hence thus therefore "
    "indeed actually really simply basically probably definitely please thanks sorry hello hey "
    "hmm hm oh ah um ok okay yes yeah no ve ll re m s t d my mine your yours her hers our ours "
    "their theirs who whom whose which what why how when where ago already soon later early "
    "late once twice again since until till while during before after above below beneath "
    "beside besides beyond inside outside within without upon onto into off out up down over "
    "under through throughout via per than as if so then there here"
)
"""Words that are never the head of a noun phrase unless they are in the catalogue."""

RELATIVE = _words("that which who whose where")
JOINING = _words("and plus or")
PEOPLE_WORDS = _words("people persons guests diners children kids adults players friends person "
                      "guest us everyone couples students pupils participants")  # fmt: skip
SEATED = _words("person guest diner child kid adult player friend place seat setting student pupil "
                "participant head cover")  # fmt: skip
"""Nouns for people or seats that follow "each" and "per"."""

AT_SEATS = frozenset(
    {"on each side", "on either side", "on both sides", "at each end", "at both ends"}
)
"""Phrases that mean all seats, once the number of people is known."""

WEIGHTS = _words(
    "kg g gram grams kilo kilos kilogram kilograms ml l litre litres liter liters oz "
    "degree degrees percent ounce ounces lb lbs pound pounds pint pints cl dl watt w v volt "
    "volts gb tb"
)
"""Units of weight, volume and the like, which affect neither positions nor shapes."""

MEASURES: Mapping[str, float] = MappingProxyType(
    {
        "mm": 0.001, "millimeter": 0.001, "millimetre": 0.001, "cm": 0.01, "centimeter": 0.01,
        "centimetre": 0.01, "dm": 0.1, "m": 1.0, "meter": 1.0, "metre": 1.0, "inch": 0.0254,
        "inches": 0.0254, "ft": 0.3048, "foot": 0.3048, "feet": 0.3048, "millimeters": 0.001,
        "millimetres": 0.001, "centimeters": 0.01, "centimetres": 0.01, "meters": 1.0,
        "metres": 1.0, "km": 1000.0, "kilometer": 1000.0, "kilometre": 1000.0,
        "kilometers": 1000.0, "kilometres": 1000.0, "yard": 0.9144, "yards": 0.9144, "yd": 0.9144,
        "mile": 1609.344, "miles": 1609.344,
    }
)  # fmt: skip

SIDES: Mapping[str, tuple[int | None, int | None]] = MappingProxyType(
    {
        "left": (-1, None), "lefthand": (-1, None), "right": (1, None), "righthand": (1, None),
        "front": (None, -1), "near": (None, -1), "nearest": (None, -1), "closest": (None, -1),
        "bottom": (None, -1), "lower": (None, -1), "foreground": (None, -1), "back": (None, 1),
        "rear": (None, 1), "far": (None, 1), "top": (None, 1), "upper": (None, 1),
        "background": (None, 1), "farthest": (None, 1), "furthest": (None, 1),
        "middle": (0, 0), "center": (0, 0), "centre": (0, 0), "central": (0, 0), "centered": (0, 0),
        "centrally": (0, 0),
    }
)  # fmt: skip
"""Words for zones of the table; "far" and "near" count only before another zone."""

ZONE_NOUNS = _words("side sides corner corners edge edges half part end area portion section third "
                    "zone region hand quarter spot position border margin ends")  # fmt: skip
EDGES = _words("corner corners edge edges end border margin ends")
