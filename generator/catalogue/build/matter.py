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
    "cactus succulent ice_cream sink jelly roast_chicken noodles ramen salad spaghetti curry stew "
    "mashed_potatoes bowl_of_rice bowl_of_cereal oatmeal dip gravy_boat butter_dish tureen "
    "serving_platter cloche egg_cup baking_dish pie_dish tagine sake_bottle sake_cup "
    "chopstick_rest cookie_jar storage_jar honey_pot",
    "glass": "glass wine_glass bottle wine_bottle sauce_bottle jar french_press beaker flask "
    "petri_dish reagent_bottle perfume_bottle nail_polish hourglass magnifying_glass salt_shaker "
    "pepper_shaker cream_jar carafe cocktail_glass champagne_flute beer_mug shot_glass "
    "beer_bottle milk_bottle honey_jar jam_jar salad_dressing maple_syrup soy_sauce straw_holder "
    "measuring_cup light_bulb marbles standing_mirror camera_lens ashtray ice_cube spice_jar "
    "pint_glass whiskey_glass whiskey_bottle milkshake pickle_jar olive_jar mayonnaise hot_sauce "
    "oil_bottle vinegar_bottle",
    "metal": "fork spoon knife kettle pot pan whisk can meat_can tea_tin paint_can spray_can "
    "thermos hand_saw clamp wrench pliers screwdriver hammer scissors keys trophy dumbbell "
    "button_tin wristwatch toolbox spirit_level moka_pot ice_bucket soda_can tongs grater "
    "corkscrew bottle_opener pizza_cutter mixing_bowl colander baking_tray muffin_tin pie "
    "dish_rack soup_can tomato_can tuna_can coffee_can paper_clips binder_clip thumbtacks bookend "
    "pencil_set desk_bell candlestick watering_can garden_trowel ring necklace bracelet compass "
    "battery screw nail bolt nut hex_key metal_file chisel padlock coins razor ink_pad hole_punch "
    "usb_stick napkin_ring toast_rack chef_knife bread_knife steak_knife paring_knife "
    "butter_knife cleaver cake_server cheese_knife slotted_spoon serving_spoon teaspoon "
    "soup_spoon ice_cream_scoop scoop measuring_spoon sieve lid garlic_press potato_masher "
    "cookie_cutter nutcracker wok casserole roasting_tin loaf_tin cake_tin cooling_rack griddle "
    "tea_strainer bread_box lunch_box coffee_pod portafilter cocktail_shaker jigger ice_tongs "
    "hip_flask bottle_cap beer_can energy_drink",
    "wood": "tray cutting_board rolling_pin coaster chess_board toy_block pencil paint_brush "
    "picture_frame paint_palette thread_spool matryoshka test_tube_rack pencil_holder clipboard "
    "chess_piece hairbrush hand_mirror basket coffee_grinder wine_rack napkin_holder chopsticks "
    "cabinet drawer_box desk_caddy stamp violin ukulele metronome jewelry_box toothpicks "
    "serving_bowl lazy_susan wooden_spoon salad_servers honey_dipper pastry_brush trivet "
    "knife_block bamboo_steamer crate spice_rack skewer muddler cork pepper_mill",
    "stone": "sculpture",
    "plastic": "paint_bottle spray_bottle wipes_canister screw_box pipette_box pill_bottle "
    "soap_dispenser glue_stick marker pen ruler desk_tray tape_roll tape_dispenser tape_measure "
    "utility_knife stapler building_brick toy_car toy_robot toy_train stacking_rings puzzle_cube "
    "die lipstick makeup_compact syringe thermometer eyeglasses first_aid_kit tool_kit paint_tube "
    "spatula ladle peeler food_container dish_soap peanut_butter ketchup mustard_bottle yogurt "
    "pencil_sharpener waste_bin poker_chips dominoes stacking_cups toy_airplane toothbrush "
    "toothpaste comb nail_file paint_roller cable charger breadboard circuit_board crayon "
    "telescope binoculars tripod golf_ball rice_paddle funnel can_opener mandoline citrus_juicer "
    "kitchen_timer ice_cube_tray cool_box bento_box plastic_cup plastic_fork straw milk_frother "
    "baby_bottle",
    "paper": "napkins milk_carton cereal_box coffee_bag chips_bag tissue_box paper_cup egg_carton "
    "envelope binder folded_map book notebook box sticky_notes paper_stack playing_cards "
    "open_book photo_print map fries chips_can cream_cheese flour_bag sugar_bag rice_bag "
    "pasta_box tea_box juice_carton cookie_box pudding_box popcorn crayon_box folder calendar "
    "gift_box gift_bag paper_bag bouquet seed_packet magazine newspaper letter banknotes "
    "price_tag chewing_gum tea_bag pizza_box takeaway_box foil_roll cling_film paper_towel_roll "
    "paper_plate beer_mat instant_noodles juice_box oats",
    "wax": "candle soap_bar",
    "food": "apple orange lemon pear banana tomato egg cucumber carrot bread_loaf croissant donut "
    "cupcake cheese cake sandwich pineapple watermelon_slice grapes strawberry mushroom avocado "
    "onion garlic corn bell_pepper broccoli potato pizza burger hot_dog pancakes cookie "
    "chocolate_bar gourd peach plum mango kiwi eggplant cherries steak sushi_rolls toast baguette "
    "bread_roll bagel pretzel muffin waffle tart cinnamon_roll gingerbread_man brownie macaron "
    "eclair candy lollipop candy_cane marshmallow gummy_bear truffle ice_pop granola_bar "
    "ice_cream_cone licorice sausage bacon fried_egg ham chicken_leg meatball salami ribs "
    "chicken_nugget onion_ring fish salmon shrimp lobster crab oyster clam nigiri sashimi "
    "sushi_roll onigiri dumpling spring_roll taco burrito flatbread pizza_slice cake_slice "
    "pie_slice cheese_wheel cheese_slice tofu kebab lasagna lettuce cabbage celery leek "
    "spring_onion asparagus cauliflower artichoke basil mint parsley rosemary lime grapefruit "
    "lemon_slice melon watermelon coconut pumpkin papaya dragon_fruit raspberry blackberry "
    "blueberry fig pomegranate star_fruit passion_fruit date zucchini radish beetroot turnip "
    "parsnip sweet_potato ginger chili pea_pod green_bean bean pea walnut almond hazelnut peanut "
    "cashew pistachio chestnut acorn olive pickle sugar_cube",
    "leather": "wallet ring_box american_football baseball",
    "device": "toaster power_drill multimeter soldering_iron printer router vr_headset microphone "
    "desk_fan power_strip hard_drive action_camera handheld_console hair_dryer calculator laptop "
    "monitor keyboard computer_mouse smartphone tablet headphones speaker remote_control "
    "walkie_talkie camera game_controller earbuds_case alarm_clock globe desk_lamp night_light "
    "flashlight microscope microwave stove blender rice_cooker stand_mixer kitchen_scale "
    "espresso_machine oscilloscope webcam trackpad mini_pc telephone barcode_scanner "
    "cash_register card_reader phone_stand joystick headset blood_pressure_monitor sewing_machine "
    "waffle_iron air_fryer slow_cooker toaster_oven food_processor hand_mixer coffee_machine",
    "fabric": "cap folded_towel sponge teddy_bear yarn_ball bandage_roll pencil_case placemat hat "
    "blanket scarf tennis_ball tea_cosy oven_mitt pot_holder tea_towel apron",
    "rubber": "mousepad wrist_rest ball cutting_mat rubber_duck eraser basketball soccer_ball shoe "
    "stethoscope",
}

MATERIALS: Mapping[str, str] = MappingProxyType(
    {key: material for material, keys in _MADE_OF.items() for key in keys.split()}
)
"""The material that a category's underside, or most of it, is made of."""

HOLLOW = frozenset(
    {"mug", "teacup", "glass", "wine_glass", "bowl", "plate", "saucer", "tray", "teapot", "kettle",
     "french_press", "pot", "pan", "sugar_bowl", "basket", "vase", "cake_stand", "pet_bowl",
     "desk_tray", "pencil_holder", "box", "beaker", "flask", "petri_dish", "toothbrush_cup",
     "thermos", "toolbox", "globe", "ball", "rubber_duck", "cap", "trophy", "figurine",
     "pencil_case", "test_tube_rack", "matryoshka", "pitcher", "ramekin", "soup", "beer_mug",
     "shot_glass", "cocktail_glass", "champagne_flute", "mixing_bowl", "colander", "measuring_cup",
     "baking_tray", "muffin_tin", "ice_bucket", "watering_can", "plant_pot", "waste_bin",
     "basketball", "soccer_ball", "tennis_ball", "american_football", "stacking_cups",
     "desk_caddy", "food_container", "paper_bag", "gift_bag", "cabinet", "drawer_box",
     "candlestick", "violin", "ukulele", "gravy_boat", "serving_bowl", "serving_platter", "wok",
     "casserole", "roasting_tin", "loaf_tin", "baking_dish", "cake_tin", "pie_dish", "griddle",
     "tagine", "bamboo_steamer", "crate", "sake_cup", "sake_bottle", "plastic_cup", "paper_plate",
     "tureen", "butter_dish", "cloche", "sieve", "funnel", "bread_box", "cool_box", "lunch_box",
     "tea_cosy", "pint_glass", "whiskey_glass", "cocktail_shaker", "jigger"}
)  # fmt: skip
"""Things that are walls around air."""

ASSEMBLED = frozenset(
    {"potted_plant", "picture_frame", "eyeglasses", "keys", "wristwatch", "candle", "bandage_roll",
     "pencil_holder", "vase", "chess_board", "basket", "pill_bottle", "map", "folded_map",
     "photo_print", "cap", "figurine", "dish_rack", "wine_rack", "napkin_holder", "straw_holder",
     "popcorn", "toothpicks", "crayon_box", "pencil_set", "paper_clips", "thumbtacks", "bookend",
     "calendar", "ink_pad", "cable", "poker_chips", "dominoes", "marbles", "cactus", "succulent",
     "bouquet", "jewelry_box", "necklace", "bracelet", "ring", "tripod", "telescope", "compass",
     "candlestick", "standing_mirror", "coins", "nail", "screw", "nut", "bolt", "banknotes",
     "letter", "price_tag", "breadboard", "circuit_board", "charger", "light_bulb", "battery",
     "soap_bar", "kiwi", "tea_box", "coffee_grinder", "ladle", "tongs", "paint_roller",
     "stethoscope", "padlock", "toy_airplane", "hex_key", "basketball", "soccer_ball",
     "american_football", "cherries", "sushi_rolls", "pencil_sharpener", "tomato_can", "lollipop",
     "coconut", "papaya", "noodles", "bowl_of_cereal", "grapefruit", "napkin_ring", "toast_rack",
     "straw", "takeaway_box", "cooling_rack", "spice_rack", "knife_block", "tea_strainer",
     "tea_bag", "measuring_spoon", "trivet", "potato_masher", "skewer", "paper_towel_roll",
     "kitchen_timer", "egg_cup", "soup_spoon", "mandoline", "ice_tongs", "hip_flask", "juice_box"}
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
