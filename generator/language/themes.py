"""Kinds of table and their typical objects, with the functional relations between them.

An entry of ``things`` is ``object`` or ``object relation target``; the target is an earlier object
of the list, or "table". The first ``core`` entries are always present; the others are drawn at
random, by the seed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from ..scene import OutlineKind


@dataclass(frozen=True)
class Theme:
    """A kind of table: its names, usual outlines, materials and size (metres), and its objects."""

    words: tuple[str, ...]
    outlines: tuple[OutlineKind, ...]
    materials: tuple[str, ...]
    size: tuple[float, float, float]
    things: tuple[str, ...]
    core: int = 3
    legs: tuple[str, ...] = ("straight", "tapered")


def _list(text: str) -> tuple[str, ...]:
    return tuple(part.strip() for part in text.split(","))


THEMES: Mapping[str, Theme] = MappingProxyType(
    {
        "office": Theme(
            _list(
                "office desk, office table, work desk, computer desk, home office, study desk, "
                "writing desk, workstation, office, student desk, study table, workspace, "
                "programmer, desk setup, working desk"
            ),
            ("rectangle",),
            ("oak", "white", "walnut", "birch"),
            (1.25, 0.65, 0.74),
            _list(
                "laptop center table, mouse right_of laptop, mug right_of mouse, "
                "notebook left_of laptop, pen right_of notebook, desk lamp behind notebook, "
                "plant behind mug, phone in_front_of mug, book left_of notebook, "
                "stapler behind laptop, pencil holder behind mouse"
            ),
            3,
            ("straight", "metal", "trestle"),
        ),
        "gaming": Theme(
            _list("gaming desk, gaming setup, gamer desk, gaming table, gaming station, gamer"),
            ("rectangle",),
            ("black", "walnut", "charcoal"),
            (1.3, 0.65, 0.74),
            _list(
                "keyboard center table, monitor behind keyboard, mouse right_of keyboard, "
                "headphones left_of keyboard, controller left_of keyboard, can right_of mouse, "
                "speaker left_of monitor, phone right_of mouse, toy robot right_of monitor, "
                "microphone left_of speaker"
            ),
            3,
            ("metal", "trestle"),
        ),
        "dining": Theme(
            _list(
                "dining table, dinner table, dinner, place setting, restaurant table, dining, "
                "supper, lunch table, set table, lunch, dining room table"
            ),
            ("round", "rectangle", "square", "oval"),
            ("oak", "walnut", "mahogany", "pine"),
            (1.2, 0.8, 0.74),
            _list(
                "plate in_front_of table, fork left_of plate, knife right_of plate, "
                "spoon right_of knife, wine glass behind knife, napkin left_of fork, "
                "candle center table, bread left_of candle, salt shaker right_of candle, "
                "wine bottle right_of salt shaker, bowl left_of candle"
            ),
            3,
            ("tapered", "pedestal", "straight"),
        ),
        "breakfast": Theme(
            _list("breakfast table, breakfast, brunch, brunch table, breakfast bar"),
            ("round", "square", "rectangle"),
            ("pine", "white", "oak"),
            (0.95, 0.7, 0.74),
            _list(
                "plate in_front_of table, mug right_of plate, croissant on plate, "
                "bowl behind plate, spoon right_of bowl, jar left_of bowl, banana left_of plate, "
                "milk carton behind mug, egg in bowl, cereal box behind bowl"
            ),
            3,
        ),
        "tea": Theme(
            _list("tea table, tea party, tea set, tea time, afternoon tea, high tea"),
            ("round", "oval", "square"),
            ("walnut", "mahogany", "marble"),
            (0.9, 0.75, 0.7),
            _list(
                "teapot center table, saucer in_front_of teapot, teacup on saucer, "
                "sugar bowl left_of teapot, spoon right_of saucer, donut right_of teapot, "
                "cake behind teapot, napkin left_of saucer, vase behind teapot"
            ),
            3,
            ("pedestal", "tapered", "splayed"),
        ),
        "kitchen": Theme(
            _list(
                "kitchen table, kitchen counter, kitchen, countertop, counter, cooking, "
                "kitchen island, kitchen worktop, baking"
            ),
            ("rectangle", "slatted", "oval"),
            ("oak", "pine", "marble"),
            (1.2, 0.7, 0.8),
            _list(
                "cutting board center table, knife right_of cutting board, "
                "tomato on cutting board, "
                "bowl left_of cutting board, apple in bowl, kettle behind cutting board, "
                "bottle behind bowl, salt shaker right_of kettle, mug right_of knife, "
                "pan behind knife, lemon left_of bowl, bell pepper right_of kettle"
            ),
            3,
            ("straight", "tapered", "trestle"),
        ),
        "coffee": Theme(
            _list(
                "coffee table, living room table, lounge table, side table, living room, "
                "low table, cafe table, cafe, end table"
            ),
            ("oval", "round", "rectangle", "slatted"),
            ("walnut", "glass", "oak", "marble"),
            (1.0, 0.6, 0.45),
            _list(
                "mug in_front_of table, book left_of mug, remote right_of mug, vase behind book, "
                "glasses on book, candle right_of vase, phone right_of remote, "
                "bowl behind remote, orange in bowl, "
                "playing cards left_of book, tissue box left_of vase"
            ),
            3,
            ("hairpin", "splayed", "tapered"),
        ),
        "sewing": Theme(
            _list("sewing table, sewing desk, sewing room, knitting table, sewing, knitting"),
            ("rectangle", "slatted", "square"),
            ("birch", "maple", "white"),
            (1.1, 0.65, 0.74),
            _list(
                "scissors center table, thread spool left_of scissors, button tin behind scissors, "
                "yarn ball right_of scissors, tape measure in_front_of scissors, "
                "notebook right_of yarn ball, pencil on notebook, "
                "desk lamp behind thread spool, mug behind notebook, box behind button tin"
            ),
            3,
            ("straight", "tapered"),
        ),
        "outdoor": Theme(
            _list(
                "picnic table, garden table, patio table, camping table, balcony table, "
                "terrace table, outdoor table, veranda table, barbecue table, beer garden table, "
                "picnic, barbecue, camping, patio, terrace, veranda, outdoor, outdoors"
            ),
            ("slatted", "round", "rectangle"),
            ("pine", "teak", "white"),
            (1.2, 0.75, 0.72),
            _list(
                "basket center table, bread loaf in_front_of basket, watermelon left_of basket, "
                "bottle right_of basket, glass right_of bottle, plate in_front_of table, "
                "sandwich on plate, napkin left_of plate, apple in basket, "
                "sunglasses right_of plate, potted plant behind table, playing cards left_of plate"
            ),
            3,
            ("straight", "trestle", "splayed"),
        ),
        "workbench": Theme(
            _list(
                "workbench, work bench, tool bench, workshop table, carpenter bench, workshop, "
                "garage table, tool table, worktable, carpentry, repair table"
            ),
            ("rectangle", "slatted"),
            ("pine", "oak", "steel"),
            (1.3, 0.7, 0.85),
            _list(
                "hammer in_front_of table, screwdriver right_of hammer, toolbox behind hammer, "
                "wrench left_of hammer, pliers right_of screwdriver, tape measure behind wrench, "
                "drill right_of toolbox, box left_of toolbox, pencil left_of wrench, "
                "glue right_of drill"
            ),
            3,
            ("straight", "trestle", "metal"),
        ),
        "craft": Theme(
            _list(
                "craft desk, craft table, hobby desk, hobby table, art table, art desk, "
                "painting table, crafting table, studio table, drawing table, "
                "artist desk, drawing desk, hobby, arts and crafts, artist"
            ),
            ("rectangle", "slatted", "square"),
            ("pine", "birch", "maple"),
            (1.2, 0.7, 0.74),
            _list(
                "notebook center table, scissors right_of notebook, glue left_of notebook, "
                "paintbrush right_of scissors, paint palette left_of glue, "
                "thread spool behind scissors, yarn ball behind notebook, paint tube behind glue, "
                "pencil holder right_of yarn ball, ruler in_front_of notebook, "
                "mug behind paint palette"
            ),
            3,
            ("straight", "trestle"),
        ),
        "vanity": Theme(
            _list(
                "vanity table, vanity, dressing table, makeup table, vanity desk, make up table, "
                "beauty table, bathroom counter, dresser, makeup desk"
            ),
            ("rectangle", "oval", "slatted"),
            ("white", "marble", "walnut", "cream"),
            (1.0, 0.55, 0.74),
            _list(
                "hand mirror center table, perfume bottle right_of hand mirror, "
                "hairbrush left_of hand mirror, lipstick right_of perfume bottle, "
                "cream jar behind hairbrush, nail polish right_of lipstick, "
                "makeup compact behind hand mirror, ring box behind perfume bottle, "
                "candle behind cream jar, vase behind makeup compact, "
                "hair dryer right_of nail polish"
            ),
            3,
            ("tapered", "hairpin", "splayed"),
        ),
        "lab": Theme(
            _list(
                "lab bench, laboratory bench, lab table, laboratory table, laboratory, lab desk, "
                "science table, chemistry table, lab, chemistry bench, chemistry lab"
            ),
            ("rectangle",),
            ("white", "steel", "gray"),
            (1.3, 0.7, 0.85),
            _list(
                "microscope behind table, test tube rack right_of microscope, "
                "beaker in_front_of test tube rack, flask right_of test tube rack, "
                "petri dish in_front_of microscope, reagent bottle left_of microscope, "
                "notebook left_of petri dish, pen right_of notebook, pipette box right_of beaker, "
                "mortar left_of reagent bottle"
            ),
            3,
            ("metal", "straight"),
        ),
        "toys": Theme(
            _list(
                "toy table, kids table, children table, play table, nursery table, kid table, "
                "playroom table, kids desk, playroom, kindergarten table, child desk, "
                "toddler table, "
                "game table, games table, kids toys table"
            ),
            ("round", "square", "rectangle"),
            ("birch", "yellow", "white", "pine"),
            (0.95, 0.75, 0.5),
            _list(
                "toy car in_front_of table, toy block right_of toy car, teddy bear behind toy car, "
                "rubber duck left_of toy car, building brick right_of toy block, "
                "toy robot right_of teddy bear, stacking rings left_of teddy bear, "
                "ball behind toy block, toy train left_of rubber duck"
            ),
            3,
            ("splayed", "straight"),
        ),
    }
)
"""All themes by name; the first with a phrase in the text applies, longer phrases first."""

DEFAULT_TABLES: Mapping[str, str] = MappingProxyType(
    {"desk": "office", "workbench": "workbench", "bench": "workbench", "counter": "kitchen",
     "countertop": "kitchen", "nightstand": "coffee", "vanity": "vanity", "table": "coffee",
     "worktop": "kitchen", "workstation": "office", "workspace": "office", "desktop": "office",
     "worktable": "workbench", "tabletop": "coffee", "sideboard": "dining"}
)  # fmt: skip
"""Objects on a table whose text names neither an object nor a theme."""
