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
    "cactus succulent ice_cream sink crucible",
    "glass": "glass wine_glass bottle wine_bottle sauce_bottle jar french_press beaker flask "
    "petri_dish reagent_bottle perfume_bottle nail_polish hourglass magnifying_glass salt_shaker "
    "pepper_shaker cream_jar carafe cocktail_glass champagne_flute beer_mug shot_glass "
    "beer_bottle milk_bottle honey_jar jam_jar salad_dressing maple_syrup soy_sauce straw_holder "
    "measuring_cup light_bulb marbles standing_mirror camera_lens ashtray test_tube "
    "graduated_cylinder glass_prism dropper medicine_bottle go_stone",
    "metal": "laptop_stand fork spoon knife kettle pot pan whisk can meat_can tea_tin "
    "paint_can spray_can "
    "thermos hand_saw clamp wrench pliers screwdriver hammer scissors keys trophy dumbbell "
    "button_tin wristwatch toolbox spirit_level moka_pot ice_bucket soda_can tongs grater "
    "corkscrew bottle_opener pizza_cutter mixing_bowl colander baking_tray muffin_tin pie "
    "dish_rack soup_can tomato_can tuna_can coffee_can paper_clips binder_clip thumbtacks bookend "
    "pencil_set desk_bell candlestick watering_can garden_trowel ring necklace bracelet compass "
    "battery screw nail bolt nut hex_key metal_file chisel padlock coins razor ink_pad hole_punch "
    "usb_stick kettlebell weight_plate medal golf_tee stopwatch whistle trumpet saxophone flute "
    "harmonica triangle hand_bell cymbal axe crowbar hand_plane caliper drill_bit vise "
    "wire_cutters tin_snips wire_stripper staple_gun oil_can socket_wrench pipe_wrench hacksaw "
    "metal_rod pipe pipe_fitting valve gear bearing spring washer hinge bracket wall_hook chain "
    "horseshoe_magnet bar_magnet bunsen_burner lab_tripod retort_stand balance_scale "
    "newtons_cradle scalpel tweezers kidney_dish drawing_compass paper_clip push_pin heatsink "
    "electric_motor cpu resistor dart xylophone",
    "wood": "tray cutting_board rolling_pin coaster chess_board toy_block pencil paint_brush "
    "picture_frame paint_palette thread_spool matryoshka test_tube_rack pencil_holder clipboard "
    "chess_piece hairbrush hand_mirror basket coffee_grinder wine_rack napkin_holder chopsticks "
    "cabinet drawer_box desk_caddy stamp violin ukulele metronome jewelry_box toothpicks cube "
    "cuboid cylinder sphere cone pyramid wedge triangular_prism hexagonal_prism half_cylinder "
    "arch_block l_block t_block cross_block star_block heart_block torus peg square_peg pegboard "
    "tower_of_hanoi shape_sorter tumbling_tower jenga_block checkers_set go_board "
    "backgammon_board ludo_board scrabble_board snakes_and_ladders letter_tile meeple game_pawn "
    "spinning_top slingshot boomerang baseball_bat table_tennis_bat guitar recorder clarinet drum "
    "tambourine drumstick maraca mallet putty_knife plank wood_block dowel tube_stand abacus "
    "gavel toy_piano",
    "stone": "sculpture",
    "plastic": "ring_light laser_pointer headphone_stand cable_reel paint_bottle "
    "spray_bottle wipes_canister screw_box pipette_box pill_bottle "
    "soap_dispenser glue_stick marker pen ruler desk_tray tape_roll tape_dispenser tape_measure "
    "utility_knife stapler building_brick toy_car toy_robot toy_train stacking_rings puzzle_cube "
    "die lipstick makeup_compact syringe thermometer eyeglasses first_aid_kit tool_kit paint_tube "
    "spatula ladle peeler food_container dish_soap peanut_butter ketchup mustard_bottle yogurt "
    "pencil_sharpener waste_bin poker_chips dominoes stacking_cups toy_airplane toothbrush "
    "toothpaste comb nail_file paint_roller cable charger breadboard circuit_board crayon "
    "telescope binoculars tripod golf_ball hollow_cylinder checkers_piece mahjong_tile domino "
    "yo_yo kite frisbee shuttlecock ping_pong_ball skipping_rope bubbles_tub bowling_ball "
    "bowling_pin sports_bottle helmet tennis_racket guitar_pick vinyl_record cd cd_case cassette "
    "floppy_disk game_cartridge film_roll led capacitor ic_chip jumper_wire case_fan ram_stick "
    "memory_card servo propeller solder_spool sensor push_button glue_gun paint_tray funnel "
    "wash_bottle micropipette weighing_boat molecule_model blister_pack pill_organizer eye_drops "
    "inhaler reflex_hammer oximeter protractor set_square credit_card id_card whiteboard "
    "highlighter",
    "paper": "napkins milk_carton cereal_box coffee_bag chips_bag tissue_box paper_cup egg_carton "
    "envelope binder folded_map book notebook box sticky_notes paper_stack playing_cards "
    "open_book photo_print map fries chips_can cream_cheese flour_bag sugar_bag rice_bag "
    "pasta_box tea_box juice_carton cookie_box pudding_box popcorn crayon_box folder calendar "
    "gift_box gift_bag paper_bag bouquet seed_packet magazine newspaper letter banknotes "
    "price_tag playing_card puzzle_piece jigsaw_puzzle board_game dartboard sheet_music "
    "record_sleeve sandpaper glove_box business_card index_card postcard greeting_card dictionary "
    "textbook atlas cookbook",
    "wax": "candle soap_bar chalk pastel charcoal_stick",
    "food": "apple orange lemon pear banana tomato egg cucumber carrot bread_loaf croissant donut "
    "cupcake cheese cake sandwich pineapple watermelon_slice grapes strawberry mushroom avocado "
    "onion garlic corn bell_pepper broccoli potato pizza burger hot_dog pancakes cookie "
    "chocolate_bar gourd peach plum mango kiwi eggplant cherries steak sushi_rolls pill",
    "leather": "wallet ring_box american_football baseball dice_cup volleyball cricket_ball "
    "rugby_ball baseball_glove boxing_glove",
    "device": "toaster power_drill multimeter soldering_iron printer router vr_headset microphone "
    "desk_fan power_strip hard_drive action_camera handheld_console hair_dryer calculator laptop "
    "monitor keyboard computer_mouse smartphone tablet headphones speaker remote_control "
    "walkie_talkie camera game_controller earbuds_case alarm_clock globe desk_lamp night_light "
    "flashlight microscope microwave stove blender rice_cooker stand_mixer kitchen_scale "
    "espresso_machine oscilloscope webcam trackpad mini_pc telephone barcode_scanner "
    "cash_register card_reader phone_stand joystick headset blood_pressure_monitor "
    "sewing_machine television game_console "
    "drone power_bank usb_hub power_supply e_reader scanner graphics_tablet security_camera "
    "label_maker docking_station "
    "synthesizer drum_pad record_player radio boombox clock_radio smart_speaker projector "
    "retro_television graphics_card forehead_thermometer",
    "fabric": "cap folded_towel sponge teddy_bear yarn_ball bandage_roll pencil_case placemat hat "
    "blanket scarf tennis_ball rope gauze_pad cotton_swab cotton_ball face_mask whiteboard_eraser "
    "band_aid",
    "rubber": "mousepad wrist_rest ball cutting_mat rubber_duck eraser basketball soccer_ball "
    "shoe stethoscope foam_brick hockey_puck yoga_block rubber_band",
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
     "hollow_cylinder", "dice_cup", "volleyball", "ping_pong_ball", "bowling_pin", "helmet",
     "drum", "tambourine", "guitar", "hand_bell", "graduated_cylinder", "funnel", "crucible",
     "kidney_dish", "weighing_boat", "paint_tray", "tube_stand"}
)  # fmt: skip
"""Things that are walls around air."""

ASSEMBLED = frozenset(
    {"ring_light", "headphone_stand", "cable_reel", "laptop_stand", "potted_plant",
        "picture_frame", "eyeglasses", "keys", "wristwatch", "candle",
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
     "kite", "slingshot", "shuttlecock", "skipping_rope", "baseball_glove", "boxing_glove",
     "stopwatch", "medal", "kettlebell", "tennis_racket", "trumpet", "saxophone", "maraca",
     "xylophone", "triangle", "radio", "dart", "yo_yo", "film_roll", "resistor", "led",
     "jumper_wire", "servo", "propeller", "sensor", "mallet", "axe", "crowbar", "hand_plane",
     "caliper", "vise", "glue_gun", "sandpaper", "putty_knife", "wire_cutters", "tin_snips",
     "wire_stripper", "staple_gun", "oil_can", "socket_wrench", "pipe_wrench", "hacksaw",
     "pipe_fitting", "valve", "spring", "bracket", "wall_hook", "chain", "rope", "bunsen_burner",
     "lab_tripod", "wash_bottle", "dropper", "micropipette", "retort_stand", "balance_scale",
     "molecule_model", "newtons_cradle", "cotton_swab", "cotton_ball", "tweezers", "inhaler",
     "face_mask", "reflex_hammer", "drawing_compass", "abacus", "greeting_card", "rubber_band",
     "gavel", "whiteboard", "paper_clip", "push_pin", "tower_of_hanoi", "pegboard",
     "checkers_set", "spinning_top", "drumstick", "boomerang", "whistle"}
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
