"""What things are made of: how slippery that is, and how weight grows with size.

Friction is the sliding coefficient of a dry thing on a plain wooden top, after the usual handbook
ranges (wood on wood 0.25-0.5, metal on wood 0.2-0.6, leather on wood 0.3-0.6), towards their upper
end: things on tables rest for hours. Glazed and glass ones are smoother than wood, rubber and felt
are not. In a contact MuJoCo takes the larger coefficient of the two: on a wooden top nothing slides
as easily as plastic does there (0.2-0.4).

Weight: a *solid* thing, and a package with its contents, grows with its volume. A *hollow* one has
walls of usual thickness whatever its size, and grows with their area. *Devices* and other things
assembled from parts weigh about the same however their variants are built.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

FRICTION: Mapping[str, float] = MappingProxyType(
    {
        "ceramic": 0.5,
        "glass": 0.45,
        "metal": 0.45,
        "wood": 0.5,
        "stone": 0.5,
        "plastic": 0.45,
        "paper": 0.5,
        "wax": 0.5,
        "food": 0.55,
        "leather": 0.6,
        "device": 0.65,
        "fabric": 0.7,
        "rubber": 0.85,
    }
)
"""Sliding friction by material; "device" is plastic or metal on rubber feet."""

_MADE_OF: Mapping[str, str] = {
    "ceramic": "mug teacup bowl plate saucer teapot sugar_bowl vase cake_stand pet_bowl mortar "
    "sushi_plate potted_plant figurine toothbrush_cup pitcher ramekin soup butter plant_pot "
    "cactus succulent ice_cream sink frog bird fern ivy bonsai herb_pot oil_burner "
    "trinket_dish soap_dish dog_bone piggy_bank",
    "glass": "glass wine_glass bottle wine_bottle sauce_bottle jar french_press beaker flask "
    "petri_dish reagent_bottle perfume_bottle nail_polish hourglass magnifying_glass "
    "salt_shaker pepper_shaker cream_jar carafe cocktail_glass champagne_flute beer_mug "
    "shot_glass beer_bottle milk_bottle honey_jar jam_jar salad_dressing maple_syrup "
    "soy_sauce straw_holder measuring_cup light_bulb marbles standing_mirror camera_lens "
    "ashtray bauble votive_candle aftershave foundation fish_bowl",
    "metal": "fork spoon knife kettle pot pan whisk can meat_can tea_tin paint_can spray_can "
    "thermos hand_saw clamp wrench pliers screwdriver hammer scissors keys trophy dumbbell "
    "button_tin wristwatch toolbox spirit_level moka_pot ice_bucket soda_can tongs grater "
    "corkscrew bottle_opener pizza_cutter mixing_bowl colander baking_tray muffin_tin pie "
    "dish_rack soup_can tomato_can tuna_can coffee_can paper_clips binder_clip thumbtacks "
    "bookend pencil_set desk_bell candlestick watering_can garden_trowel ring necklace "
    "bracelet compass battery screw nail bolt nut hex_key metal_file chisel padlock coins "
    "razor ink_pad hole_punch usb_stick hand_fork hand_rake secateurs bird_cage star "
    "tea_light candelabra menorah lantern thimble needle pin safety_pin crochet_hook bobbin "
    "tweezers nail_clippers eyelash_curler bobby_pin shaving_foam hairspray earring brooch "
    "cufflink tie_clip pocket_watch crown pendant iron eiffel_tower",
    "wood": "tray cutting_board rolling_pin coaster chess_board toy_block pencil paint_brush "
    "picture_frame paint_palette thread_spool matryoshka test_tube_rack pencil_holder "
    "clipboard chess_piece hairbrush hand_mirror basket coffee_grinder wine_rack "
    "napkin_holder chopsticks cabinet drawer_box desk_caddy stamp violin ukulele metronome "
    "jewelry_box toothpicks toy_boat train_track skittle twig driftwood pine_cone acorn crate "
    "birdhouse terrarium bird_feeder nutcracker wreath nest snow_globe easter_basket "
    "incense_holder match dreidel knitting_needle makeup_brush shaving_brush scrub_brush "
    "clothes_peg clothes_hanger treasure_chest wooden_box music_box smoking_pipe mantel_clock",
    "stone": "sculpture pebble rock seashell starfish coral crystal",
    "plastic": "paint_bottle spray_bottle wipes_canister screw_box pipette_box pill_bottle "
    "soap_dispenser glue_stick marker pen ruler desk_tray tape_roll tape_dispenser "
    "tape_measure utility_knife stapler building_brick toy_car toy_robot toy_train "
    "stacking_rings puzzle_cube die lipstick makeup_compact syringe thermometer eyeglasses "
    "first_aid_kit tool_kit paint_tube spatula ladle peeler food_container dish_soap "
    "peanut_butter ketchup mustard_bottle yogurt pencil_sharpener waste_bin poker_chips "
    "dominoes stacking_cups toy_airplane toothbrush toothpaste comb nail_file paint_roller "
    "cable charger breadboard circuit_board crayon telescope binoculars tripod golf_ball "
    "toy_horse toy_unicorn toy_zebra toy_cow toy_pig toy_sheep toy_elephant toy_giraffe "
    "toy_lion toy_tiger toy_dog toy_cat toy_rabbit toy_fox toy_dinosaur toy_dragon toy_truck "
    "fire_truck toy_bus toy_tractor toy_rocket toy_helicopter rattle pacifier baby_bottle "
    "play_dough toy_soldier toy_spade beach_ball plant_label seed_tray hose_nozzle "
    "fertilizer_bag christmas_tree santa snowman mask balloon skull lighter button bead "
    "shampoo conditioner body_lotion sunscreen mouthwash hand_cream face_wash deodorant "
    "bleach mascara eyeliner eyeshadow_palette blusher dental_floss hair_clip hair_roller "
    "bucket laundry_basket dustpan hair_straightener curling_iron travel_adapter",
    "paper": "napkins milk_carton cereal_box coffee_bag chips_bag tissue_box paper_cup "
    "egg_carton envelope binder folded_map book notebook box sticky_notes paper_stack "
    "playing_cards open_book photo_print map fries chips_can cream_cheese flour_bag sugar_bag "
    "rice_bag pasta_box tea_box juice_carton cookie_box pudding_box popcorn crayon_box folder "
    "calendar gift_box gift_bag paper_bag bouquet seed_packet magazine newspaper letter "
    "banknotes price_tag jigsaw_piece jigsaw_puzzle leaf feather party_hat party_popper "
    "christmas_cracker wrapping_paper gift_tag matchbox toilet_roll tissue_pack passport "
    "boarding_pass ticket postcard greeting_card photo_album folding_fan cigarette",
    "wax": "candle soap_bar taper_candle bath_bomb",
    "food": "apple orange lemon pear banana tomato egg cucumber carrot bread_loaf croissant "
    "donut cupcake cheese cake sandwich pineapple watermelon_slice grapes strawberry mushroom "
    "avocado onion garlic corn bell_pepper broccoli potato pizza burger hot_dog pancakes "
    "cookie chocolate_bar gourd peach plum mango kiwi eggplant cherries steak sushi_rolls "
    "rose tulip daisy sunflower lily carnation lavender orchid dried_flower flower_bulb "
    "gingerbread_house jack_o_lantern pumpkin birthday_cake easter_egg cigar",
    "leather": "wallet ring_box american_football baseball handbag purse clutch suitcase belt "
    "boot sandal high_heel glasses_case dog_collar luggage_tag",
    "device": "toaster power_drill multimeter soldering_iron printer router vr_headset "
    "microphone desk_fan power_strip hard_drive action_camera handheld_console hair_dryer "
    "calculator laptop monitor keyboard computer_mouse smartphone tablet headphones speaker "
    "remote_control walkie_talkie camera game_controller earbuds_case alarm_clock globe "
    "desk_lamp night_light flashlight microscope microwave stove blender rice_cooker "
    "stand_mixer kitchen_scale espresso_machine oscilloscope webcam trackpad mini_pc "
    "telephone barcode_scanner cash_register card_reader phone_stand joystick headset "
    "blood_pressure_monitor sewing_machine electric_shaver",
    "fabric": "cap folded_towel sponge teddy_bear yarn_ball bandage_roll pencil_case placemat "
    "hat blanket scarf tennis_ball bib diaper baby_shoes doll puppet garden_glove stocking "
    "witch_hat bow ribbon pin_cushion embroidery_hoop zipper pompom yarn_skein cushion pillow "
    "rug table_runner tablecloth fabric_square felt_sheet doily quilt mannequin makeup_bag "
    "powder_puff cotton_ball cotton_swab cotton_pad loofah rolled_towel washcloth hair_tie "
    "headband t_shirt shirt sweater jeans sock glove mitten beanie tie bow_tie backpack "
    "duffel_bag umbrella slipper leash cat_toy duster travel_pillow eye_mask",
    "rubber": "mousepad wrist_rest ball cutting_mat rubber_duck eraser basketball soccer_ball "
    "shoe stethoscope rubber_glove",
}

MATERIALS: Mapping[str, str] = MappingProxyType(
    {key: material for material, keys in _MADE_OF.items() for key in keys.split()}
)
"""The material that a category's underside, or most of it, is made of."""

HOLLOW = frozenset(
    {"mug", "teacup", "glass", "wine_glass", "bowl", "plate", "saucer", "tray", "teapot",
     "kettle", "french_press", "pot", "pan", "sugar_bowl", "basket", "vase", "cake_stand",
     "pet_bowl", "desk_tray", "pencil_holder", "box", "beaker", "flask", "petri_dish",
     "toothbrush_cup", "thermos", "toolbox", "globe", "ball", "rubber_duck", "cap", "trophy",
     "figurine", "pencil_case", "test_tube_rack", "matryoshka", "pitcher", "ramekin", "soup",
     "beer_mug", "shot_glass", "cocktail_glass", "champagne_flute", "mixing_bowl", "colander",
     "measuring_cup", "baking_tray", "muffin_tin", "ice_bucket", "watering_can", "plant_pot",
     "waste_bin", "basketball", "soccer_ball", "tennis_ball", "american_football",
     "stacking_cups", "desk_caddy", "food_container", "paper_bag", "gift_bag", "cabinet",
     "drawer_box", "candlestick", "violin", "ukulele",
     "crate", "nest", "beach_ball", "bird_cage", "birdhouse", "easter_basket", "trinket_dish",
     "soap_dish", "bucket", "laundry_basket", "crown", "party_hat", "witch_hat", "piggy_bank",
     "wooden_box"}
)  # fmt: skip
"""Things that are walls around air."""

ASSEMBLED = frozenset(
    {"potted_plant", "picture_frame", "eyeglasses", "keys", "wristwatch", "candle",
     "bandage_roll", "pencil_holder", "vase", "chess_board", "basket", "pill_bottle", "map",
     "folded_map", "photo_print", "cap", "figurine", "dish_rack", "wine_rack", "napkin_holder",
     "straw_holder", "popcorn", "toothpicks", "crayon_box", "pencil_set", "paper_clips",
     "thumbtacks", "bookend", "calendar", "ink_pad", "cable", "poker_chips", "dominoes",
     "marbles", "cactus", "succulent", "bouquet", "jewelry_box", "necklace", "bracelet", "ring",
     "tripod", "telescope", "compass", "candlestick", "standing_mirror", "coins", "nail", "screw",
     "nut", "bolt", "banknotes", "letter", "price_tag", "breadboard", "circuit_board", "charger",
     "light_bulb", "battery", "soap_bar", "kiwi", "tea_box", "coffee_grinder", "ladle", "tongs",
     "paint_roller", "stethoscope", "padlock", "toy_airplane", "hex_key", "basketball",
     "soccer_ball", "american_football", "cherries", "sushi_rolls", "pencil_sharpener",
     "tomato_can",
     "rose", "tulip", "daisy", "sunflower", "lily", "carnation", "lavender", "orchid",
     "dried_flower", "toy_horse", "toy_unicorn", "toy_zebra", "toy_giraffe", "toy_helicopter",
     "twig", "leaf", "feather", "hand_fork", "hand_rake", "secateurs", "fern", "ivy", "bonsai",
     "herb_pot", "wreath", "terrarium", "bird_feeder", "christmas_tree", "bauble", "mask",
     "toy_boat", "coral", "pine_cone", "acorn", "balloon", "bow", "ribbon", "candelabra",
     "menorah", "lantern", "incense_holder", "taper_candle", "umbrella", "earring", "pendant",
     "pocket_watch", "dog_collar", "leash", "safety_pin", "needle", "pin", "clothes_hanger",
     "hair_clip", "headband", "duster", "mascara", "belt", "backpack", "handbag", "dustpan",
     "cotton_swab", "loofah", "pompom", "greeting_card", "luggage_tag", "eye_mask", "folding_fan",
     "eiffel_tower", "smoking_pipe"}
)  # fmt: skip
"""Things whose box says little of their weight: handles, stems, lids and folds make it up."""


def friction(key: str) -> float:
    """Return the sliding friction coefficient of a category's usual material."""
    return FRICTION[MATERIALS.get(key, "wood")]


def growth(key: str) -> float:
    """Return the power of a variant's box volume with which its mass grows."""
    if key in ASSEMBLED or MATERIALS.get(key) == "device":
        return 0.0
    return 2 / 3 if key in HOLLOW else 1.0
