"""The planner's vocabulary as data: numbers, relations, colours, tables and synonyms."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType


def _table(text: str) -> Mapping[str, str]:
    """Parse lines of ``key: word, word`` into a mapping from each word to its key."""
    entries: dict[str, str] = {}
    for line in text.strip().splitlines():
        key, words = line.split(":")
        entries |= {word.strip(): key.strip() for word in words.split(",")}
    return MappingProxyType(entries)


def _pairs(text: str) -> tuple[tuple[str, str], ...]:
    """Parse ``key: word, word`` lines into (word, key) pairs, with a word's best meaning first."""
    lines = [line.split(":") for line in text.strip().splitlines()]
    return tuple((word.strip(), key.strip()) for key, words in lines for word in words.split(","))


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


NUMBERS: Mapping[str, int] = MappingProxyType(
    {
        "a": 1, "an": 1, "one": 1, "single": 1, "another": 1, "two": 2, "three": 3, "four": 4,
        "five": 5, "six": 6, "seven": 7, "eight": 8, "nine": 9, "ten": 10, "eleven": 11,
        "twelve": 12, "thirteen": 13, "fourteen": 14, "fifteen": 15, "sixteen": 16,
        "seventeen": 17, "eighteen": 18, "nineteen": 19, "twenty": 20, "thirty": 30, "forty": 40,
        "fifty": 50, "sixty": 60, "hundred": 100, "hundreds": 200, "thousand": 1000,
        "thousands": 2000, "million": 1_000_000, "millions": 2_000_000, "dozen": 12, "pair": 2,
        "couple": 2, "trio": 3, "both": 2, "dozens": 36,
    }
)  # fmt: skip
"""Number words; the grammar multiplies "half a dozen", "two hundred" and "three pairs"."""

VAGUE: Mapping[str, tuple[int, int]] = MappingProxyType(
    {
        "some": (2, 3), "few": (3, 3), "several": (3, 4), "many": (5, 6), "various": (3, 4),
        "multiple": (3, 4), "lots": (5, 6), "assorted": (3, 4), "different": (2, 3),
        "numerous": (5, 6), "plenty": (4, 5),
    }
)  # fmt: skip
"""Vague amounts, with the minimum and maximum number that they mean."""

DEFINITE = _words("the this that these those its his her my your their our")
LOOSE_NOUNS = _words(
    "board brush tin ring case dish compact tube powder figure deck note paint "
    "cube cutter card server plug plane seal file lens clip roller driver"
)
"""Nouns that name a known object alone, but hardly after an unknown word ("arduino board")."""


COLORS = _words(
    "white cream ivory beige black charcoal gray grey silver red crimson maroon pink coral orange "
    "amber gold golden yellow mustard olive lime green sage mint teal turquoise cyan blue navy "
    "indigo purple violet lavender magenta brown tan terracotta copper bronze brass clear "
    "transparent"
)
SHADES = _words("dark light pale deep bright")
MATERIALS = _words(
    "wood wooden oak walnut pine beech maple cherry mahogany birch bamboo teak ebony steel "
    "stainless metal metallic aluminum aluminium iron brass copper bronze chrome ceramic porcelain "
    "glass plastic marble stone granite stoneware clay fabric cloth linen cotton felt wool leather "
    "paper cardboard rubber concrete wicker enamel silver gold"
)
SIZES: Mapping[str, str] = _table(
    """
    tiny: tiny, mini, miniature, minuscule
    small: small, little, short, compact, smaller, thin, slim
    large: large, big, tall, long, wide, larger, thick, oversized, bigger
    huge: huge, giant, enormous, gigantic, massive
    """
)
STATES = _words(
    "different identical similar separate individual "
    "open closed bare empty full half fresh ripe folded lit old new antique vintage rusty "
    "broken used "
    "worn steaming hot cold sliced stacked burning potted framed lidded striped spotted patterned "
    "checkered handmade modern rustic elegant simple cute colorful colourful colored coloured "
    "shiny matte matching beautiful nice clean dirty tidy messy cluttered cozy cosy minimalist "
    "round circular square rectangular oval triangular flat heavy soft decorative classic typical "
    "traditional fancy plain delicate pretty lovely standard ordinary wireless mechanical "
    "electric digital portable retro toy uncapped spiral sharp dull neat neatly "
    "packed filled unpacked rolled crumpled coiled crossed wrapped sealed washed dried carved "
    "peeled "
    "scented knitted crocheted engraved bound printed blank unlit wilted"
)
"""Descriptive words that become an object's "state" or are ignored; they are never objects."""

PACKAGES = _words("bottle box bag jar tube can carton tin pack packet package canister")
"""Packages that are named with their contents: "a bottle of nail polish" is one object."""

DRAWN: Mapping[str, str] = MappingProxyType(
    {"cartoon": "cartoon", "cartoonish": "cartoon", "toon": "cartoon", "comic": "cartoon",
     "low poly": "low-poly", "lowpoly": "low-poly", "low polygon": "low-poly"}
)  # fmt: skip
"""Drawing styles, keyed by the phrases that request them."""

STYLES = _words(
    "modern rustic vintage minimalist cozy cosy elegant messy cluttered tidy retro scandinavian "
    "industrial bohemian classic traditional simple antique futuristic victorian japanese"
)

TABLE_NOUNS = _words(
    "table desk workbench bench counter countertop nightstand vanity tabletop sideboard "
    "worktop worktable tabletops tables desks desktop workstation workspace"
)
OUTLINES = _table(
    """
    round: round, circular, circle
    oval: oval, elliptical, ellipse
    square: square
    triangle: triangular, triangle, three cornered
    slatted: slatted, slats, slat, plank, planked
    rectangle: rectangular, rectangle, long
    """
)
TABLE_MATERIALS = _table(
    """
    oak: oak, wood, wooden
    walnut: walnut
    pine: pine
    beech: beech
    maple: maple
    cherry: cherry
    mahogany: mahogany
    birch: birch
    bamboo: bamboo
    teak: teak
    ebony: ebony
    steel: steel, metal, metallic, stainless, stainless steel
    aluminum: aluminum, aluminium
    iron: iron
    brass: brass
    copper: copper
    marble: marble, stone, granite, concrete
    glass: glass
    plastic: plastic, laminate, lacquered, painted
    """
)
LEGS = _table(
    """
    tapered: tapered
    splayed: splayed, angled, slanted
    trestle: trestle, trestles
    pedestal: pedestal
    hairpin: hairpin
    metal: metal, steel, iron
    straight: straight, wooden, square
    """
)

PARTS = _words(
    "leg legs handle handles top tops surface drawer drawers stripe stripes dot dots "
    "edge edges corner corners side sides base pattern patterns finish color colour "
    "shape rim logo cover covers foot front back left right middle center "
    "centre centerpiece spout feet frame"
)
"""Parts and aspects of objects, which are never objects themselves."""

PLACES = _words(
    "floor room kitchen office workshop studio bedroom home house garage laboratory restaurant "
    "cafe bathroom garden balcony window wall school classroom kindergarten nursery scene image "
    "picture photo photograph view background foreground day morning evening afternoon night "
    "dinner lunch supper party style person people guest guests child children kid work use "
    "breakfast brunch meal feast banquet picnic barbecue "
    "way things thing stuff items item objects object everything something life still nothing "
    "arrangement place setup light sunlight corner date time ground shelf hand light "
    "arm gripper distance order place reach lighting hours hour world programmer student artist "
    "writer setting settings layout flu homework session"
)
"""Words for places, times and topics, which are never objects."""

OCCASIONS = frozenset(
    {"afternoon tea", "high tea", "coffee break", "game night", "movie night", "home bar",
     "counter display", "shop display", "window display", "market display", "product display",
     "spa set"}
)  # fmt: skip
"""Occasions and places whose names have two words."""

VAGUE_THINGS = _words(
    "things thing stuff items item objects object everything supplies etc "
    "ingredients rubbish litter trash clutter junk waste bits odds mess contents "
    "products goods essentials belongings gear equipment kit"
)

VERBS = _words(
    "is are was were be been being am sits sit sitting stands stand standing lies lie lying lays "
    "rests rest resting placed put located positioned arranged lays laid leaning hangs hanging "
    "facing faces stays stay kept left seen visible appear appears make create generate show draw "
    "give build design render me want need would like please imagine shows showing depicts "
    "there here which who where when while then so also just only very really quite too as if "
    "i we you he she they could should will shall may must do does did let us stacked "
    "partially slightly directly right just closely carefully all each every either neither "
    "ready prepared scattered spread surrounded used using ready made painted looks look slightly "
    "everywhere somewhere together apart picks pick grasps grasp "
    "moves move lifts lift holding next goes go belongs up down out off away lined piled"
)
FILLERS = _words("of from for at to as or than about onto through per via during after until")

PEOPLE: Mapping[str, int] = MappingProxyType(
    {"one": 1, "two": 2, "three": 3, "four": 4, "1": 1, "2": 2, "3": 3, "4": 4}
)

SUBSTANCES = _words(
    "water tea coffee milk juice wine beer soup cereal sugar salt pepper flour rice pasta jam "
    "honey soda lemonade cocoa chocolate butter oil sauce paint ink salad soil sand cola coke "
    "chips crisps popcorn nuts candy sweets liquid fluid solution broth cider whisky whiskey vodka "
    "rum gin champagne espresso cappuccino latte smoothie milkshake sake gravel compost"
)
"""Contents of vessels, which become the vessel's "state" unless they are objects themselves."""

SYNONYMS = _pairs(
    """
    mug: beer mug, tea mug, tankard, travel mug
    teacup: tea cup, cappuccino cup, espresso cup, espresso, cappuccino, latte, americano
    teacup: macchiato, flat white, mocha, matcha latte
    mug: hot chocolate, hot cocoa
    cocktail glass: mojito, margarita, cosmopolitan, spritz
    cup: paper cup, tumbler
    glass: water glass, drinking glass, juice glass, beer glass, glass of water, glass of milk
    glass: glass of juice, drink, tumbler, lemonade, iced tea, iced coffee
    wine glass: goblet, wineglass, champagne glass, stemware, chalice
    bottle: water bottle, bottle of water, plastic bottle, beer bottle, soda bottle, flagon
    wine bottle: bottle of wine, wine, champagne bottle
    can: soda can, tin can, beer can, coke, coke can, soda, pop can, cola
    bowl: basin, fruit bowl, cereal bowl, salad bowl, soup bowl, mixing bowl, dish, ramen bowl
    plate: dinner plate, dish, side plate, dessert plate, platter
    fork: dinner fork, salad fork
    knife: table knife, butter knife, kitchen knife, chef's knife, chefs knife, steak knife
    knife: paring knife
    spoon: teaspoon, tablespoon, soup spoon, wooden spoon, ladle
    teapot: tea pot, tea kettle
    kettle: electric kettle, coffee pot
    pot: saucepan, cooking pot, sauce pan, stockpot, casserole
    pan: frying pan, skillet
    salt shaker: salt, salt cellar, salt and pepper shaker, shaker
    pepper shaker: pepper, pepper mill, pepper grinder
    cutting board: chopping board, breadboard, bread board, butcher block
    napkin: serviette, cloth napkin, paper napkin
    candle: candlelight, tea light, tealight, pillar candle
    vase: flower vase, flower, bouquet, rose, tulip, bouquet of flowers, vase of flowers
    plant: potted plant, houseplant, house plant, succulent, cactus, flower pot, flowerpot
    plant: plant pot
    orange: mandarin, tangerine, clementine, grapefruit
    lemon: lime
    banana: plantain
    pear: avocado
    bread: loaf, loaf of bread, baguette, bread loaf
    tomato: cherry tomato
    donut: doughnut, bagel
    egg: boiled egg
    cake: cupcake, muffin, pie
    croissant: pastry
    jam jar: pot of marmalade, pot of jam, pot of mustard, pot of relish, pot of chutney
    jar: jam jar, honey jar, jam, honey, mason jar, cookie jar, glass jar, spice jar, marmalade
    carton: milk carton, milk, carton of milk, juice carton, juice box
    cereal box: box of cereal, cereal
    laptop: notebook computer, macbook, laptop computer, computer
    monitor: screen, display, computer screen, computer monitor, tv
    keyboard: computer keyboard
    mouse: computer mouse, wireless mouse, gaming mouse
    mousepad: mouse pad, mouse mat
    phone: smartphone, cell phone, mobile phone, mobile, iphone, cellphone, telephone
    tablet: ipad, e reader, ereader
    headphones: headset, headphone, earphones
    speaker: loudspeaker, bluetooth speaker
    lamp: desk lamp, table lamp, reading lamp, night lamp, lantern
    book: novel, textbook, paperback, hardcover, cookbook, hardback, magazine, dictionary, journal
    notebook: notepad, note pad, sketchbook, diary, notepad, planner, sketch book, writing pad
    pen: ballpoint pen, fountain pen, ballpoint, biro
    pencil: crayon, colored pencil, coloured pencil
    marker: highlighter, felt tip pen, felt pen, sharpie
    eraser: rubber
    ruler: measuring stick
    scissors: pair of scissors, shears
    stapler: staple gun
    tape: adhesive tape, scotch tape, sticky tape, tape dispenser, roll of tape, duct tape
    tape: masking tape
    tape measure: measuring tape
    glue: glue bottle, glue stick, bottle of glue
    pencil holder: pen holder, pencil cup, pen cup, desk organizer, brush holder
    pencil case: pencil pouch
    clock: alarm clock, desk clock
    watch: wristwatch, wrist watch
    headphones: pair of headphones
    glasses: pair of glasses, pair of reading glasses, pair of sunglasses
    glasses: eyeglasses, reading glasses, spectacles, sunglasses
    calculator: pocket calculator
    camera: photo camera
    box: cardboard box, gift box, wooden box, package, parcel, storage box, carton box, tissue box
    tray: serving tray, wooden tray
    basket: fruit basket, bread basket, wicker basket
    paper: sheet of paper, document, sheet, letter, papers
    sticky notes: post it note, sticky note, post it, note
    photo frame: picture frame, framed photo, framed picture
    globe: desk globe
    hammer: claw hammer, mallet
    screwdriver: phillips screwdriver
    wrench: spanner, adjustable wrench
    pliers: pair of pliers, cutters
    drill: power drill, cordless drill, electric drill
    saw: hand saw, handsaw
    toolbox: tool box
    nut: bolt, screw
    paintbrush: paint brush, artist brush
    paint jar: pot of paint, paint, paint pot, paint can
    toy car: model car, car, race car, racing car, toy truck, model truck, truck, matchbox car
    toy train: model train
    toy block: building cube, wooden cube, wood block
    toy robot: robot toy, doll, model figure
    teddy bear: stuffed bear, stuffed toy, plush bear
    ball: tennis ball, baseball, toy ball, rubber ball
    building brick: lego block
    puzzle cube: rubiks cube, rubik s cube
    playing cards: card, pack of playing cards, deck of playing cards
    die: game die
    hairbrush: hair brush
    hand mirror: vanity mirror, makeup mirror
    makeup compact: eyeshadow, foundation, eye shadow
    cream jar: jar of face cream, hand cream
    soap dispenser: soap bottle, shampoo bottle
    ring box: jewellery box, jewelry case
    perfume bottle: bottle of perfume
    beaker: measuring beaker
    flask: volumetric flask
    test tube rack: test tube holder
    reagent bottle: chemical
    petri dish: petri plate
    sugar bowl: sugar, bowl of sugar
    pitcher: jug, water jug, carafe, milk jug, creamer
    whisk: egg beater
    dish soap: washing liquid, washing up liquid
    kitchen scale: scale, scales, digital scale, weighing scale
    bread roll: roll
    cake slice: slice
    sticky notes: pad of sticky notes, block of sticky notes, pad of post its
    place card: label card, name card, info card
    baseball cap: cap
    spatula: turner
    rolling pin: roller
    remote: remote control, tv remote
    coaster: drink coaster, beer mat
    cookie: biscuit
    placemat: mat, table mat
    cutting mat: desk mat, work mat, craft mat, antistatic mat, anti static mat, static mat
    cash register: till
    yarn ball: twine, string, ball of twine, ball of string
    headphones: ear defenders, earmuffs, ear muffs, ear defender
    blister pack: paracetamol, ibuprofen, painkillers, tablets of medicine, antibiotics
    tape dispenser: tape gun, packing tape gun
    price tag: label, tag
    paper stack: handout, worksheet, leaflet, flyer, form
    magazine: brochure, catalogue, catalog, booklet
    rolling pin: roller
    phone stand: stand, tablet stand
    dish rack: rack, drying rack, plate rack
    toy train: locomotive, engine, train engine, wagon, train car, railway carriage
    controller: game controller, gamepad, joystick
    """
)  # fmt: skip
"""Synonyms of catalogue words (keys, nouns or aliases), besides the catalogue's own aliases."""

_BALLS = ("baseball", "tennis_ball", "cricket_ball", "golf_ball", "ball", "easter_egg",
          "basketball")  # fmt: skip
_LONG = ("soldering_iron", "dagger", "baton", "flute", "chef_knife", "paint_brush")
"""Objects that can be put on a cradle."""

MEANT_WITH: Mapping[str, tuple[tuple[str, str], ...]] = MappingProxyType(
    {
        "piece": (("chess_board", "chess_piece"),),
        "set": (("chess_board", "chess_piece"),),
        "bean": (
            ("coffee_grinder", "coffee_bean"),
            ("espresso_machine", "coffee_bean"),
            ("moka_pot", "coffee_bean"),
        ),
        "slice": (
            ("pizza_box", "pizza_slice"),
            ("pizza", "pizza_slice"),
            ("bread", "toast"),
            ("cake", "cake_slice"),
            ("pie", "cake_slice"),
        ),
        "shaker": (
            ("jigger", "cocktail_shaker"),
            ("strainer", "cocktail_shaker"),
            ("martini", "cocktail_shaker"),
            ("muddler", "cocktail_shaker"),
        ),
        "card": (("poker_chips", "playing_cards"),),
        "stand": (
            *((ball, "ball_stand") for ball in _BALLS),
            *((long, "cradle_stand") for long in _LONG),
        ),
        "brush": (
            ("eyeshadow_palette", "makeup_brush"),
            ("lipstick", "makeup_brush"),
            ("powder_puff", "makeup_brush"),
            ("nail_polish", "makeup_brush"),
            ("paint_palette", "paint_brush"),
            ("paint_tube", "paint_brush"),
            ("easel", "paint_brush"),
        ),
        "chip": (("playing_cards", "poker_chips"),),
    }
)
"""Words whose category depends on other objects, such as pieces next to a chess board."""

COLLECTIVES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "tools": ("hammer", "screwdriver", "wrench", "pliers"),
        "hand tools": ("hammer", "screwdriver", "wrench", "pliers"),
        "cutlery": ("fork", "knife", "spoon"),
        "silverware": ("fork", "knife", "spoon"),
        "utensils": ("fork", "knife", "spoon"),
        "cooking utensils": ("spatula", "spoon", "whisk"),
        "kitchen utensils": ("spatula", "spoon", "whisk"),
        "stationery": ("pen", "notebook", "stapler", "tape"),
        "office supplies": ("pen", "notebook", "stapler", "tape"),
        "school supplies": ("pencil", "notebook", "ruler", "eraser"),
        "art supplies": ("paintbrush", "paint tube", "paint palette", "pencil"),
        "craft supplies": ("scissors", "glue", "yarn ball", "thread spool"),
        "sewing supplies": ("scissors", "thread spool", "button tin"),
        "painting supplies": ("paintbrush", "paint tube", "paint palette"),
        "fruit": ("apple", "banana", "orange"),
        "fruits": ("apple", "banana", "orange"),
        "vegetables": ("tomato", "lemon", "avocado"),
        "toys": ("toy car", "toy block", "teddy bear", "rubber duck"),
        "cosmetics": ("lipstick", "cream jar", "nail polish", "makeup compact"),
        "makeup": ("lipstick", "nail polish", "makeup compact"),
        "toiletries": ("toothbrush cup", "soap dispenser", "cream jar"),
        "lab equipment": ("beaker", "flask", "test tube rack"),
        "laboratory equipment": ("beaker", "flask", "test tube rack"),
        "glassware": ("glass", "wine glass", "glass"),
        "lab glassware": ("beaker", "flask", "test tube rack"),
        "laboratory glassware": ("beaker", "flask", "test tube rack"),
        "dishes": ("plate", "bowl", "mug"),
        "tableware": ("plate", "bowl", "glass"),
        "crockery": ("plate", "bowl", "mug"),
        "dinnerware": ("plate", "bowl", "glass"),
        "condiments": ("salt shaker", "pepper shaker", "jar"),
        "spices": ("salt shaker", "pepper shaker", "jar"),
        "snacks": ("donut", "cookie", "can"),
        "food": ("bread", "apple", "bowl"),
        "drinks": ("glass", "can", "bottle"),
        "electronics": ("laptop", "phone", "headphones"),
        "gadgets": ("phone", "headphones", "tablet"),
        "games": ("playing cards", "die", "puzzle cube"),
        "supplies": ("pen", "notebook", "tape"),
        "accessories": ("glasses", "watch", "phone"),
        "place setting": ("plate", "fork", "knife", "glass"),
        "place settings": ("plate", "fork", "knife", "glass"),
        "table setting": ("plate", "fork", "knife", "glass"),
        "tea set": ("teapot", "teacup", "teacup", "saucer"),
        "tea service": ("teapot", "teacup", "teacup", "saucer"),
        "coffee set": ("kettle", "cup", "cup"),
        "salt and pepper": ("salt shaker", "pepper shaker"),
        "salt and pepper shakers": ("salt shaker", "pepper shaker"),
    }
)
"""Words for mixed groups, and the categories they stand for."""
