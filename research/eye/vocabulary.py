"""The categories that the eye learns to name: the most common objects on tables.

The catalogue has many more. They appear in the pictures too, so that they are detected, but their
names are not trained: too few pictures show each of them, and many resemble one of these.
"""

from __future__ import annotations

_WORDS = """
mug teacup glass wine_glass bowl plate saucer napkins tray fork spoon knife teapot kettle
french_press pot pan cutting_board toaster rolling_pin whisk coaster bottle wine_bottle
sauce_bottle paint_bottle jar can milk_carton salt_shaker pepper_shaker sugar_bowl basket apple
orange lemon pear banana tomato egg cucumber carrot bread_loaf croissant donut cupcake cheese
cake sandwich cereal_box pineapple watermelon_slice grapes strawberry mushroom avocado onion
garlic corn bell_pepper broccoli potato meat_can coffee_bag chips_bag tea_tin wipes_canister
tissue_box paper_cup spray_bottle egg_carton pizza burger hot_dog sushi_plate fries pancakes
cookie chocolate_bar power_drill hand_saw clamp spirit_level multimeter soldering_iron tool_kit
paint_can printer router vr_headset microphone desk_fan power_strip hard_drive action_camera
wristwatch handheld_console mousepad keys wallet tape_dispenser envelope clipboard binder
folded_map cap ball dumbbell pet_bowl chess_board hourglass trophy gourd folded_towel hair_dryer
sponge first_aid_kit pill_bottle thermos cake_stand book notebook box sticky_notes paper_stack
stapler ruler calculator desk_tray pen pencil marker pencil_holder laptop monitor keyboard
computer_mouse smartphone tablet headphones speaker remote_control walkie_talkie camera
game_controller earbuds_case vase sculpture potted_plant alarm_clock picture_frame globe
eyeglasses desk_lamp night_light candle screwdriver hammer wrench pliers tape_measure
utility_knife tape_roll magnifying_glass flashlight toolbox paint_brush screw_box spray_can
toy_car toy_block building_brick toy_robot teddy_bear rubber_duck toy_train stacking_rings
puzzle_cube die playing_cards chess_piece scissors glue_stick yarn_ball thread_spool pencil_case
paint_palette paint_tube button_tin perfume_bottle lipstick hairbrush hand_mirror cream_jar
soap_dispenser nail_polish makeup_compact toothbrush_cup ring_box beaker flask test_tube_rack
petri_dish microscope reagent_bottle pipette_box mortar open_book photo_print map placemat
cutting_mat syringe thermometer bandage_roll figurine matryoshka projector record_player
game_console headset webcam ring_light tripod succulent cactus rose lantern doll blender
microwave stove rice_cooker hand_mixer moka_pot espresso_machine dish_rack ladle spatula tongs
grater colander peeler can_opener corkscrew pizza_cutter knife_block measuring_cup kitchen_scale
chopsticks ramen salad steak fish shrimp noodles butter honey_jar soda_can beer_bottle beer_mug
juice_box milk_bottle yogurt peach plum mango kiwi lime coconut pumpkin eggplant lettuce cabbage
chili ginger candlestick candelabra snow_globe music_box radio telephone typewriter calendar
magazine newspaper letter stamp postcard ticket credit_card coin handbag backpack hat
scarf shoe sock shirt umbrella lighter ashtray matchbox guitar violin ukulele flute trumpet
harmonica drum metronome basketball baseball tennis_ball golf_ball skateboard helmet medal
domino poker_chips crayon chalk eraser hole_punch paper_clip binder_clip highlighter compass
protractor desk_caddy bookend usb_stick charger cable battery light_bulb oscilloscope gear nut
bolt screw nail drill_bit chisel axe watering_can seed_packet dog_bone cat_toy fish_bowl
robot_arm drone balloon gift_box ribbon christmas_tree stocking wreath pipe stethoscope mask
medicine_bottle soap_dish toothbrush toothpaste comb razor shaving_brush bucket iron
sewing_machine needle button pin_cushion jewelry_box ring necklace bracelet coffee_grinder
carafe pitcher shot_glass champagne_flute cocktail_glass oil_bottle mayonnaise soy_sauce
hot_sauce spice_jar pepper_mill rope chain passport telescope binoculars crystal skull abacus
hand_bell whistle
"""

VOCABULARY: tuple[str, ...] = tuple(_WORDS.split())
"""Keys of the catalogue, in the order of a network's outputs."""
