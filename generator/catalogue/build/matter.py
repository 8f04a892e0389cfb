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
    "ceramic": "utensil_crock "
    "empty_vase mug teacup bowl plate saucer teapot sugar_bowl vase cake_stand pet_bowl "
    "mortar sushi_plate potted_plant figurine toothbrush_cup pitcher ramekin soup butter "
    "plant_pot cactus succulent ice_cream sink crucible jelly roast_chicken noodles ramen "
    "salad spaghetti curry stew mashed_potatoes bowl_of_rice bowl_of_cereal oatmeal dip "
    "gravy_boat butter_dish tureen serving_platter cloche egg_cup baking_dish pie_dish "
    "tagine sake_bottle sake_cup chopstick_rest cookie_jar storage_jar frog bird fern ivy "
    "bonsai herb_pot oil_burner trinket_dish soap_dish dog_bone honey_pot piggy_bank",
    "glass": "empty_beaker glass_rod "
    "open_jar glass wine_glass bottle wine_bottle sauce_bottle jar french_press beaker "
    "flask petri_dish reagent_bottle perfume_bottle nail_polish hourglass "
    "magnifying_glass salt_shaker pepper_shaker cream_jar carafe cocktail_glass "
    "champagne_flute beer_mug shot_glass beer_bottle milk_bottle honey_jar jam_jar "
    "salad_dressing maple_syrup soy_sauce straw_holder measuring_cup light_bulb marbles "
    "standing_mirror camera_lens ashtray test_tube graduated_cylinder glass_prism dropper "
    "medicine_bottle go_stone ice_cube spice_jar bauble votive_candle aftershave "
    "foundation fish_bowl pint_glass whiskey_glass whiskey_bottle milkshake pickle_jar "
    "olive_jar mayonnaise hot_sauce oil_bottle vinegar_bottle",
    "metal": "empty_toast_rack empty_dish_rack open_ice_bucket open_pot open_can "
    "fork spoon knife kettle pot pan whisk can meat_can tea_tin paint_can spray_can "
    "thermos hand_saw clamp wrench pliers screwdriver hammer scissors keys trophy "
    "dumbbell button_tin wristwatch toolbox spirit_level moka_pot ice_bucket soda_can "
    "tongs grater corkscrew bottle_opener pizza_cutter mixing_bowl colander baking_tray "
    "muffin_tin pie dish_rack soup_can tomato_can tuna_can coffee_can paper_clips "
    "binder_clip thumbtacks bookend pencil_set desk_bell candlestick watering_can "
    "garden_trowel ring necklace bracelet compass battery screw nail bolt nut hex_key "
    "metal_file chisel padlock coins razor ink_pad hole_punch usb_stick kettlebell "
    "weight_plate medal golf_tee stopwatch whistle trumpet saxophone flute harmonica "
    "triangle hand_bell cymbal axe crowbar hand_plane caliper drill_bit vise wire_cutters "
    "tin_snips wire_stripper staple_gun oil_can socket_wrench pipe_wrench hacksaw "
    "metal_rod pipe pipe_fitting valve gear bearing spring washer hinge bracket wall_hook "
    "chain horseshoe_magnet bar_magnet bunsen_burner lab_tripod retort_stand "
    "balance_scale newtons_cradle scalpel tweezers kidney_dish drawing_compass paper_clip "
    "push_pin heatsink electric_motor cpu resistor dart xylophone napkin_ring toast_rack "
    "chef_knife bread_knife steak_knife paring_knife butter_knife cleaver cake_server "
    "cheese_knife slotted_spoon serving_spoon teaspoon soup_spoon ice_cream_scoop scoop "
    "measuring_spoon sieve lid garlic_press potato_masher cookie_cutter nutcracker wok "
    "casserole roasting_tin loaf_tin cake_tin cooling_rack griddle tea_strainer bread_box "
    "lunch_box hand_fork hand_rake secateurs bird_cage star tea_light candelabra menorah "
    "lantern thimble needle pin safety_pin crochet_hook bobbin nail_clippers "
    "eyelash_curler bobby_pin shaving_foam hairspray earring brooch cufflink tie_clip "
    "pocket_watch crown pendant iron coffee_pod portafilter cocktail_shaker jigger "
    "ice_tongs hip_flask bottle_cap beer_can energy_drink laptop_stand eiffel_tower",
    "wood": "letter_rack empty_wine_rack empty_knife_block empty_tube_rack open_steamer "
    "tray cutting_board rolling_pin coaster chess_board toy_block pencil paint_brush "
    "picture_frame paint_palette thread_spool matryoshka test_tube_rack pencil_holder "
    "clipboard chess_piece hairbrush hand_mirror basket coffee_grinder wine_rack "
    "napkin_holder chopsticks cabinet drawer_box desk_caddy stamp violin ukulele "
    "metronome jewelry_box toothpicks cube cuboid cylinder sphere cone pyramid wedge "
    "triangular_prism hexagonal_prism half_cylinder arch_block l_block t_block "
    "cross_block star_block heart_block torus peg square_peg pegboard tower_of_hanoi "
    "shape_sorter tumbling_tower jenga_block checkers_set go_board backgammon_board "
    "ludo_board scrabble_board snakes_and_ladders letter_tile meeple game_pawn "
    "spinning_top slingshot boomerang baseball_bat table_tennis_bat guitar recorder "
    "clarinet drum tambourine drumstick maraca mallet putty_knife plank wood_block dowel "
    "tube_stand abacus gavel toy_piano serving_bowl lazy_susan wooden_spoon salad_servers "
    "honey_dipper pastry_brush trivet knife_block bamboo_steamer crate spice_rack skewer "
    "toy_boat train_track twig driftwood pine_cone acorn birdhouse terrarium "
    "bird_feeder nutcracker wreath nest snow_globe easter_basket incense_holder match "
    "dreidel knitting_needle makeup_brush shaving_brush scrub_brush clothes_peg "
    "clothes_hanger muddler cork pepper_mill treasure_chest wooden_box music_box "
    "smoking_pipe mantel_clock",
    "stone": "sculpture pebble rock seashell starfish coral crystal",
    "plastic": "tool_caddy open_suitcase open_lunch_box empty_pencil_holder paint_bottle "
    "spray_bottle "
    "wipes_canister screw_box pipette_box pill_bottle soap_dispenser glue_stick marker "
    "pen ruler desk_tray tape_roll tape_dispenser tape_measure utility_knife stapler "
    "building_brick toy_car toy_robot toy_train stacking_rings puzzle_cube die lipstick "
    "makeup_compact syringe thermometer eyeglasses first_aid_kit tool_kit paint_tube "
    "spatula ladle peeler food_container dish_soap peanut_butter ketchup mustard_bottle "
    "yogurt pencil_sharpener waste_bin poker_chips dominoes stacking_cups toy_airplane "
    "toothbrush toothpaste comb nail_file paint_roller cable charger breadboard "
    "circuit_board crayon telescope binoculars tripod golf_ball hollow_cylinder "
    "checkers_piece mahjong_tile domino yo_yo kite frisbee shuttlecock ping_pong_ball "
    "skipping_rope bubbles_tub bowling_ball bowling_pin sports_bottle helmet "
    "tennis_racket guitar_pick vinyl_record cd cd_case cassette floppy_disk "
    "game_cartridge film_roll led capacitor ic_chip jumper_wire case_fan ram_stick "
    "memory_card servo propeller solder_spool sensor push_button glue_gun paint_tray "
    "funnel wash_bottle micropipette weighing_boat molecule_model blister_pack "
    "pill_organizer eye_drops inhaler reflex_hammer oximeter protractor set_square "
    "credit_card id_card whiteboard highlighter rice_paddle can_opener mandoline "
    "citrus_juicer kitchen_timer ice_cube_tray cool_box bento_box plastic_cup "
    "plastic_fork straw toy_horse toy_unicorn toy_zebra toy_cow toy_pig toy_sheep "
    "toy_elephant toy_giraffe toy_lion toy_tiger toy_dog toy_cat toy_rabbit toy_fox "
    "toy_dinosaur toy_dragon toy_truck fire_truck toy_bus toy_tractor toy_rocket "
    "toy_helicopter rattle pacifier baby_bottle play_dough toy_soldier toy_spade "
    "beach_ball plant_label seed_tray hose_nozzle fertilizer_bag christmas_tree santa "
    "snowman mask balloon skull lighter button bead shampoo conditioner body_lotion "
    "sunscreen mouthwash hand_cream face_wash deodorant bleach mascara eyeliner "
    "eyeshadow_palette blusher dental_floss hair_clip hair_roller bucket laundry_basket "
    "dustpan hair_straightener curling_iron milk_frother ring_light laser_pointer "
    "headphone_stand cable_reel travel_adapter",
    "paper": "open_box napkins milk_carton cereal_box coffee_bag chips_bag tissue_box paper_cup "
    "egg_carton envelope binder folded_map book notebook box sticky_notes paper_stack "
    "playing_cards open_book photo_print map fries chips_can cream_cheese flour_bag "
    "sugar_bag rice_bag pasta_box tea_box juice_carton cookie_box pudding_box popcorn "
    "crayon_box folder calendar gift_box gift_bag paper_bag bouquet seed_packet magazine "
    "newspaper letter banknotes price_tag playing_card puzzle_piece jigsaw_puzzle "
    "board_game dartboard sheet_music record_sleeve sandpaper glove_box business_card "
    "index_card postcard greeting_card dictionary textbook atlas cookbook chewing_gum "
    "tea_bag pizza_box takeaway_box foil_roll cling_film paper_towel_roll paper_plate "
    "leaf feather party_hat party_popper christmas_cracker wrapping_paper "
    "gift_tag matchbox toilet_roll tissue_pack beer_mat instant_noodles juice_box oats "
    "passport boarding_pass ticket photo_album folding_fan cigarette",
    "wax": "candle soap_bar chalk pastel charcoal_stick taper_candle bath_bomb",
    "food": "apple orange lemon pear banana tomato egg cucumber carrot bread_loaf croissant donut "
    "cupcake cheese cake sandwich pineapple watermelon_slice grapes strawberry mushroom "
    "avocado onion garlic corn bell_pepper broccoli potato pizza burger hot_dog pancakes "
    "cookie chocolate_bar gourd peach plum mango kiwi eggplant cherries steak sushi_rolls "
    "pill toast baguette bread_roll bagel pretzel muffin waffle tart cinnamon_roll "
    "gingerbread_man brownie macaron eclair candy lollipop candy_cane marshmallow "
    "gummy_bear truffle ice_pop granola_bar ice_cream_cone licorice sausage bacon "
    "fried_egg ham chicken_leg meatball salami ribs chicken_nugget onion_ring fish salmon "
    "shrimp lobster crab oyster clam nigiri sashimi sushi_roll onigiri dumpling "
    "spring_roll taco burrito flatbread pizza_slice cake_slice pie_slice cheese_wheel "
    "cheese_slice tofu kebab lasagna lettuce cabbage celery leek spring_onion asparagus "
    "cauliflower artichoke basil mint parsley rosemary lime grapefruit lemon_slice melon "
    "watermelon coconut pumpkin papaya dragon_fruit raspberry blackberry blueberry fig "
    "pomegranate star_fruit passion_fruit date zucchini radish beetroot turnip parsnip "
    "sweet_potato ginger chili pea_pod green_bean bean pea walnut almond hazelnut peanut "
    "cashew pistachio chestnut acorn olive pickle sugar_cube rose tulip daisy sunflower "
    "lily carnation lavender orchid dried_flower posy seedling flower_bulb gingerbread_house "
    "jack_o_lantern birthday_cake easter_egg cigar",
    "leather": "wallet ring_box american_football baseball dice_cup volleyball cricket_ball "
    "rugby_ball baseball_glove boxing_glove handbag purse clutch suitcase belt boot "
    "sandal high_heel glasses_case dog_collar luggage_tag",
    "device": "toaster power_drill multimeter soldering_iron printer router vr_headset microphone "
    "desk_fan power_strip hard_drive action_camera handheld_console hair_dryer calculator "
    "laptop monitor keyboard computer_mouse smartphone tablet headphones speaker "
    "remote_control walkie_talkie camera game_controller earbuds_case alarm_clock globe "
    "desk_lamp night_light flashlight microscope microwave stove blender rice_cooker "
    "stand_mixer kitchen_scale espresso_machine oscilloscope webcam trackpad mini_pc "
    "telephone barcode_scanner cash_register card_reader phone_stand joystick headset "
    "blood_pressure_monitor sewing_machine synthesizer drum_pad record_player radio "
    "boombox clock_radio smart_speaker projector retro_television graphics_card "
    "forehead_thermometer electric_shaver waffle_iron air_fryer slow_cooker toaster_oven "
    "food_processor hand_mixer coffee_machine television game_console drone power_bank "
    "usb_hub power_supply e_reader scanner graphics_tablet security_camera label_maker "
    "docking_station",
    "fabric": "canvas cap folded_towel sponge teddy_bear yarn_ball bandage_roll pencil_case "
    "placemat hat blanket scarf tennis_ball rope gauze_pad cotton_swab cotton_ball face_mask "
    "whiteboard_eraser band_aid tea_cosy oven_mitt pot_holder tea_towel apron bib diaper "
    "baby_shoes doll puppet garden_glove stocking witch_hat bow ribbon pin_cushion "
    "embroidery_hoop zipper pompom yarn_skein cushion pillow rug table_runner tablecloth "
    "fabric_square felt_sheet doily quilt mannequin makeup_bag powder_puff cotton_pad "
    "loofah rolled_towel washcloth hair_tie headband t_shirt shirt sweater jeans sock "
    "glove mitten beanie tie bow_tie backpack duffel_bag umbrella slipper leash cat_toy "
    "duster travel_pillow eye_mask",
    "rubber": "mousepad wrist_rest ball cutting_mat rubber_duck eraser basketball soccer_ball shoe "
    "stethoscope foam_brick hockey_puck yoga_block rubber_band rubber_glove",
}

MATERIALS: Mapping[str, str] = MappingProxyType(
    {key: material for material, keys in _MADE_OF.items() for key in keys.split()}
)
"""The material that a category's underside, or most of it, is made of."""

HOLLOW = frozenset(
    {"american_football", "baking_dish", "baking_tray", "ball", "bamboo_steamer", "basket",
     "basketball", "beach_ball", "beaker", "beer_mug", "bird_cage", "birdhouse", "bowl",
     "bowling_pin", "box", "bread_box", "bucket", "butter_dish", "cabinet", "cake_stand",
     "cake_tin", "candlestick", "cap", "casserole", "champagne_flute", "cloche",
     "cocktail_glass", "cocktail_shaker", "colander", "cool_box", "crate", "crown", "crucible",
     "desk_caddy", "desk_tray", "dice_cup", "drawer_box", "drum", "easter_basket", "empty_vase",
     "figurine", "flask", "food_container", "french_press", "funnel", "gift_bag", "glass",
     "globe", "graduated_cylinder", "gravy_boat", "griddle", "guitar", "hand_bell", "helmet",
     "hollow_cylinder", "ice_bucket", "jigger", "kettle", "kidney_dish", "laundry_basket",
     "loaf_tin", "lunch_box", "matryoshka", "measuring_cup", "mixing_bowl", "muffin_tin", "mug",
     "nest", "open_box", "open_jar", "open_lunch_box", "open_suitcase", "paint_tray", "pan",
     "paper_bag", "paper_plate", "party_hat", "empty_pencil_holder", "pencil_case", "pencil_holder",
     "pet_bowl", "petri_dish", "pie_dish", "piggy_bank", "ping_pong_ball", "pint_glass",
     "pitcher", "plant_pot", "plastic_cup", "plate", "pot", "ramekin", "roasting_tin",
     "rubber_duck", "sake_bottle", "sake_cup", "saucer", "serving_bowl", "serving_platter",
     "shot_glass", "sieve", "soap_dish", "soccer_ball", "soup", "stacking_cups", "sugar_bowl",
     "tagine", "tambourine", "tea_cosy", "teacup", "teapot", "tennis_ball", "test_tube_rack",
     "thermos", "tool_caddy", "toolbox", "toothbrush_cup", "tray", "trinket_dish", "trophy",
     "tube_stand", "tureen", "ukulele", "vase", "violin", "volleyball", "waste_bin",
     "watering_can", "weighing_boat", "whiskey_glass", "wine_glass", "witch_hat", "wok",
     "wooden_box"}
)  # fmt: skip
"""Things that are walls around air."""

ASSEMBLED = frozenset(
    {"abacus", "acorn", "american_football", "axe", "backpack", "balance_scale", "balloon",
     "bandage_roll", "banknotes", "baseball_glove", "basket", "basketball", "battery", "bauble",
     "belt", "bird_feeder", "bolt", "bonsai", "bookend", "boomerang", "bouquet", "bow",
     "bowl_of_cereal", "boxing_glove", "bracelet", "bracket", "breadboard", "bunsen_burner",
     "cable", "cable_reel", "cactus", "calendar", "caliper", "candelabra", "candle",
     "candlestick", "cap", "carnation", "chain", "charger", "checkers_set", "cherries",
     "chess_board", "christmas_tree", "circuit_board", "clothes_hanger", "coconut",
     "coffee_grinder", "coins", "compass", "cooling_rack", "coral", "cotton_ball", "cotton_swab",
     "crayon_box", "crowbar", "daisy", "dart", "dish_rack", "dog_collar", "dominoes",
     "drawing_compass", "dried_flower", "dropper", "drumstick", "duster", "dustpan", "earring",
     "egg_cup", "eiffel_tower", "eye_mask", "eyeglasses", "face_mask", "feather", "fern",
     "figurine", "film_roll", "folded_map", "folding_fan", "gavel", "glue_gun", "grapefruit",
     "greeting_card", "hacksaw", "hair_clip", "hand_fork", "hand_plane", "hand_rake", "handbag",
     "headband", "headphone_stand", "herb_pot", "hex_key", "hip_flask", "ice_tongs",
     "incense_holder", "inhaler", "ink_pad", "ivy", "jewelry_box", "juice_box", "jumper_wire",
     "kettlebell", "keys", "kitchen_timer", "kite", "kiwi", "knife_block", "lab_tripod", "ladle",
     "lantern", "laptop_stand", "lavender", "leaf", "leash", "led", "letter", "light_bulb",
     "lily", "lollipop", "loofah", "luggage_tag", "mallet", "mandoline", "map", "maraca",
     "marbles", "mascara", "mask", "measuring_spoon", "medal", "menorah", "micropipette",
     "molecule_model", "nail", "napkin_holder", "napkin_ring", "necklace", "needle",
     "newtons_cradle", "noodles", "nut", "oil_can", "orchid", "padlock", "paint_roller",
     "papaya", "paper_clip", "paper_clips", "paper_towel_roll", "pegboard", "pencil_holder",
     "pencil_set", "pencil_sharpener", "pendant", "photo_print", "picture_frame", "pill_bottle",
     "pin", "pine_cone", "pipe_fitting", "pipe_wrench", "pocket_watch", "poker_chips", "pompom",
     "popcorn", "potato_masher", "potted_plant", "price_tag", "propeller", "push_pin",
     "putty_knife", "radio", "reflex_hammer", "resistor", "retort_stand", "ribbon", "ring",
     "ring_light", "rope", "rose", "rubber_band", "safety_pin", "sandpaper", "saxophone",
     "screw", "secateurs", "sensor", "servo", "shuttlecock", "skewer", "skipping_rope",
     "slingshot", "smoking_pipe", "soap_bar", "soccer_ball", "socket_wrench", "soup_spoon",
     "spice_rack", "spinning_top", "spring", "standing_mirror", "staple_gun", "stethoscope",
     "stopwatch", "straw", "straw_holder", "succulent", "sunflower", "sushi_rolls",
     "takeaway_box", "taper_candle", "tea_bag", "tea_box", "tea_strainer", "telescope",
     "tennis_racket", "terrarium", "thumbtacks", "tin_snips", "toast_rack", "tomato_can",
     "tongs", "toothpicks", "tower_of_hanoi", "toy_airplane", "toy_boat", "toy_giraffe",
     "toy_helicopter", "toy_horse", "toy_unicorn", "toy_zebra", "triangle", "tripod", "trivet",
     "trumpet", "tulip", "tweezers", "twig", "umbrella", "valve", "vase", "vise", "wall_hook",
     "wash_bottle", "whistle", "whiteboard", "wine_rack", "wire_cutters", "wire_stripper",
     "wreath", "wristwatch", "xylophone", "yo_yo"}
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
