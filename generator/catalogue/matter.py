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
    "bonsai herb_pot oil_burner trinket_dish soap_dish dog_bone honey_pot piggy_bank "
    "coffee_dripper lamp_base ghost mummy gargoyle tofu_dish monstera african_violet "
    "venus_flytrap lucky_bamboo yucca dracaena ficus rubber_plant calathea aspidistra "
    "snake_plant spider_plant croton hoya poinsettia cyclamen kalanchoe lemon_tree palm "
    "spoon_rest gaiwan tea_warmer spoon_dish nachos enchilada easter_tree pottery_shard "
    "clay_tablet inkwell amphora bowl_of_crisps "
    "garden_gnome buddha_statue buddha_head virgin_mary_statue "
    "nativity_figure ganesha_statue shiva_statue mosque_model pagoda model_lighthouse "
    "model_windmill ocarina tabletop_fountain urn lucky_cat ceramic_tile hexagonal_tile "
    "triangular_tile pampas_grass tooth_model dental_mould bedpan",
    "glass": "empty_beaker glass_rod "
    "open_jar glass wine_glass bottle wine_bottle sauce_bottle jar french_press beaker "
    "flask petri_dish reagent_bottle perfume_bottle nail_polish hourglass "
    "magnifying_glass salt_shaker pepper_shaker cream_jar carafe cocktail_glass "
    "champagne_flute beer_mug shot_glass beer_bottle milk_bottle honey_jar jam_jar "
    "salad_dressing maple_syrup soy_sauce straw_holder measuring_cup light_bulb marbles "
    "standing_mirror camera_lens ashtray test_tube graduated_cylinder glass_prism dropper "
    "medicine_bottle go_stone ice_cube spice_jar bauble votive_candle aftershave "
    "foundation fish_bowl pint_glass whiskey_glass whiskey_bottle milkshake pickle_jar "
    "olive_jar mayonnaise hot_sauce oil_bottle vinegar_bottle "
    "chemex soda_siphon oil_lamp icicle evil_eye punch_bowl fish_tank trifle chocolate_mousse "
    "brandy_snifter growler paperweight mirror_tile display_case fuse vacuum_tube headlight "
    "ship_in_a_bottle message_in_a_bottle radiometer microscope_slide cover_slip condenser "
    "kipps_apparatus desiccator ampoule potion_bottle quill_and_ink",
    "metal": "empty_candlestick empty_candelabra empty_toast_rack empty_dish_rack "
    "open_ice_bucket open_pot open_can "
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
    "ice_tongs hip_flask bottle_cap beer_can energy_drink laptop_stand eiffel_tower "
    "cheese_plane paste_tube jar_lid collection_tin cash_tin receipt_spike cauldron "
    "coffee_tamper siphon_brewer drink_dispenser tabletop_grill disposable_barbecue "
    "chimney_starter burger_press corn_holder egg_topper candle_snuffer spotlight wall_sconce "
    "cocoa_tin syrup_tin fruit_tin caviar_tin sparkler cezve dallah masala_dabba hookah "
    "fluorescent_tube coffee_pot hook_hand kazoo chip_case slot_machine gold_bar silver_bar "
    "horseshoe cigar_cutter cigarette_case cat_food_tin dog_food_tin meat_tenderiser "
    "splatter_guard herb_stripper ricer mezzaluna jelly_mould piping_nozzle taco_holder "
    "tortilla_press samovar hot_water_urn fondue_set mincer pourer tap_handle bombilla dagger "
    "flintlock_pistol shackle astrolabe gramophone bike_horn crank derailleur brake_lever "
    "co2_cartridge ice_skate golf_club satellite sinker spoon_lure foil_ball ring_pull buckle "
    "gauntlet micrometer feeler_gauge centre_punch multitool coin_cell transformer inductor "
    "wind_chime tap fire_extinguisher try_square pocket_knife shoe_horn bevel_gauge "
    "toggle_switch shower_head gripper hexagram mezuzah yad chalice ciborium thurible "
    "monstrance icon shofar prayer_wheel vajra puja_thali ankh pentacle reliquary cowbell "
    "gong capo guitar_string triangle_beater trombone french_horn tuba mouthpiece "
    "trumpet_mute jaw_harp spark_plug brake_pad brake_disc oil_filter air_filter piston "
    "connecting_rod crankshaft camshaft cylinder_head carburettor turbocharger shock_absorber "
    "flywheel ignition_coil catalytic_converter alternator water_pump hubcap wheel_brace "
    "car_jack tyre_gauge foot_pump dipstick car_horn coin silver_dollar fifty_pence_piece "
    "gold_ingot money_clip safe tin_sign wire_tree bullet_casing paten slinky gyroscope rivet "
    "screw_eye thumbtack staple staple_strip hose_clip circlip bushing standoff latch hasp "
    "turnbuckle castor door_knob door_handle drawer_pull pulley circular_saw_blade "
    "jigsaw_blade drill_chuck sextant weather_vane sundial geometry_set skeleton_model "
    "otoscope gold_tooth pacemaker speculum watch_link mainspring sceptre cutlass manacles "
    "lightsaber watercolour_set airbrush docket_spike pen_nib",
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
    "smoking_pipe mantel_clock "
    "cheese_wire gift_hamper shop_sign witch_broom nativity_set christmas_pyramid card_holder "
    "stirrer charcoal_briquette firelighter wood_chips coffin spirit_board planchette "
    "cone_holder chess_king chess_queen chess_bishop chess_knight chess_rook chess_pawn "
    "tic_tac_toe_board mill_board cribbage_board carrom_board chinese_checkers_board "
    "mancala_board marble_solitaire tile_rack dice_tower shogi_piece pick_up_stick "
    "roulette_wheel prize_wheel croupier_rake bird_perch matcha_whisk signboard picnic_hamper "
    "toothpick cocktail_pick stereoscope butterfly_case totem_pole lolly_stick cricket_stumps "
    "arrow cup_and_ball marble_maze glider landing_net shoe_tree clog marking_gauge awl "
    "folding_rule mouse_trap orrery plunger hand_brush broom_head single_drawer butter_churn "
    "easel clapperboard tetrahedron octahedron dodecahedron icosahedron cuboctahedron "
    "rhombic_dodecahedron truncated_icosahedron stellated_octahedron antiprism parallelepiped "
    "frustum hemisphere paraboloid ellipsoid ovoid helix moebius_strip hollow_cube "
    "menger_sponge u_block s_block z_block bar_block disc torah_scroll book_rest cross "
    "crucifix rosary prayer_beads totem church_model temple_model djembe tabla conga bongos "
    "castanets kalimba baton electric_guitar banjo mandolin lute sitar harp lyre dulcimer "
    "bassoon pan_pipes concertina didgeridoo clarinet_reed miniature_house dollhouse "
    "toy_theatre wooden_sign letterboard zen_garden table_flag pirate_flag furniture_leg "
    "barometer hygrometer planet_model volcano_model t_square soma_cube galton_board "
    "seismograph pantograph slide_rule plant_press tongue_depressor magic_wand wizard_staff "
    "toy_shield toy_sword toy_cannon toy_trebuchet toy_catapult silkscreen blotter lectern "
    "washboard toy_chair"
    " small_shelf ball_stand cradle_stand",
    "stone": "sculpture pebble rock seashell starfish coral crystal "
    "tombstone cuttlebone aquarium_castle slab plinth arrowhead scarab obelisk moai "
    "house_brick fossil whetstone gemstone diamond ruby emerald sapphire topaz garnet "
    "aquamarine opal tigers_eye pearl jade turquoise_stone onyx jasper labradorite "
    "rhodochrosite amber lapis_lazuli malachite obsidian flint pumice granite_sample "
    "marble_sample sandstone slate_piece coal basalt meteorite iron_ore silver_ore "
    "gold_nugget copper_nugget fluorite pyrite galena agate_slice geode stalactite "
    "petrified_wood ammonite fish_fossil trilobite shark_tooth megalodon_tooth dinosaur_tooth "
    "dinosaur_claw mammoth_tooth belemnite crinoid brachiopod grinding_disc",
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
    "headphone_stand cable_reel travel_adapter "
    "stock_cube cup_lid sign_holder leaflet_holder price_gun spider toy_bat raven rat snake "
    "pitchfork vampire_fangs string_lights cake_topper aeropress meat_claw cream_tub "
    "margarine_tub ice_cream_tub skeleton severed_hand severed_finger eyeball sleigh "
    "balloon_pump led_strip light_switch dimmer_switch bulb_holder ticket_dispenser "
    "devil_horns foil_balloon twenty_sided_die twelve_sided_die ten_sided_die eight_sided_die "
    "four_sided_die mastermind_board game_house connect_four tangram tangram_piece kerplunk "
    "poker_chip casino_plaque bingo_dauber hamster guinea_pig chick budgie hen tortoise "
    "turtle gecko lizard tarantula stick_insect pet_carrier hamster_wheel slicker_brush "
    "ball_thrower cat_wand clicker muzzle fish_net aquarium_heater air_pump aquarium_plant "
    "fish_food_tub bag_roll melon_baller apple_corer zester citrus_zester sharpening_steel "
    "pasta_server fly_swatter spork egg_separator turkey_baster jar_opener butter_curler "
    "dough_scraper salad_spinner egg_slicer cherry_pitter spiralizer gumball_machine "
    "candy_dispenser hummus_tub coleslaw_tub bubble_tea punnet bunny_ears cake_pillar "
    "ice_pack wet_wipes wine_aerator optic_measure pedal reflector bike_pump bike_light "
    "tyre_lever handlebar_grip skateboard roller_skate goggles snorkel juggling_club "
    "googly_eye astronaut alien ufo rover periscope diabolo wind_turbine zoetrope "
    "fishing_reel fishing_float fishing_lure fishing_rod fishing_fly six_pack_ring chalk_line "
    "rocker_switch potentiometer knob relay transistor solar_panel segment_display lcd_module "
    "crocodile_clip banana_plug battery_holder smoke_alarm thermostat doorbell wall_socket "
    "mains_plug ladybird beetle bee butterfly dragonfly ant caterpillar snail toilet_brush "
    "squeegee lint_roller bottle_brush robot_arm task_board calibration_board lever megaphone "
    "camcorder phone_case earbud potty volcano guitar_tuner accordion melodica vuvuzela "
    "steering_wheel rear_view_mirror wiper_blade gear_knob filler_cap engine_oil car_fuse "
    "key_fob toy_castle card_display model_tank lego_figure vinyl_figure bobblehead toy_gun "
    "water_pistol fidget_spinner fidget_cube pop_it magic_8_ball etch_a_sketch view_master "
    "jack_in_the_box jacks magnetic_tile balloon_animal mr_potato_head furby toy_crane "
    "pez_dispenser marble_run toy_kitchen toy_phone wall_plug magnet_catch cable_clip "
    "power_plug network_plug phono_plug jack_plug cable_organiser orbital_sander sheet_sander "
    "detail_sander belt_sander plunge_router electric_planer rotary_tool heat_gun nail_gun "
    "spray_gun soldering_gun oscillating_tool polisher chainsaw biscuit_jointer anemometer "
    "rain_gauge theodolite french_curve fraction_circle linking_cubes newton_meter "
    "van_de_graaff_generator trundle_wheel pipette_tip eppendorf_tube cryovial well_plate "
    "six_well_plate pcr_strip cryobox butterfly_net brain_model eye_model anatomical_model "
    "ant_farm owl_pellet quadrat reagent_reservoir sharps_container covid_test pregnancy_test "
    "test_strip hearing_aid tooth denture false_teeth retainer ultrasound_probe "
    "prosthetic_hand peak_flow_meter spacer_device cold_pack wipe_packet cleansing_wipes "
    "jade_roller pill_cutter false_eyelashes rotary_cutter staple_remover rolodex guillotine "
    "magazine_file plastic_sleeve pencil_grip laundry_pod washing_line_reel collar_stiffener",
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
    "passport boarding_pass ticket photo_album folding_fan cigarette "
    "pressed_flower cupcake_case food_packet spaghetti_packet sachet ready_meal "
    "open_paper_bag cup_carrier cobweb tinsel party_banner streamer trading_card "
    "baseball_card tarot_card tarot_deck trading_card_deck bingo_card scratch_card "
    "coffee_filter cup_sleeve matchbook till_roll receipt menu place_card sticker wrapper "
    "scorecard voucher snowflake party_blower party_horn cake_board photo_prop charcoal_bag "
    "paper_crown monopoly_board game_board cluedo_board risk_board hex_tile game_spinner "
    "cigarette_packet pinata table_number menu_card certificate order_of_service egg_dye_kit "
    "table_plan scroll origami_crane paper_plane paper_boat pinwheel crumpled_paper "
    "cardboard_tube cigarette_butt scrap bible quran grimoire parchment palm_cross "
    "car_air_freshener tax_disc invoice contract official_letter resume cheque chequebook "
    "coupon blueprint floor_plan star_chart telegram ransom_note shopping_list xray_film "
    "eye_chart colour_chart poster report memo_pad bank_note heart_box planisphere stencil "
    "safety_pin_card",
    "wax": "long_candle candle soap_bar chalk pastel charcoal_stick taper_candle bath_bomb "
    "wax_melt birthday_candle",
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
    "lily carnation lavender orchid dried_flower posy bare_cactus seedling flower_bulb "
    "gingerbread_house "
    "jack_o_lantern potato_crisp birthday_cake easter_egg cigar "
    "daffodil iris poppy peony chrysanthemum dahlia gerbera marigold zinnia camellia gardenia "
    "magnolia dandelion cornflower edelweiss anemone hibiscus petunia primrose pansy "
    "hydrangea geranium forget_me_not hyacinth gladiolus foxglove hollyhock freesia bluebell "
    "crocus snowdrop thistle bird_of_paradise protea lotus petal holly mistletoe fern_frond "
    "blossom_branch corsage ciabatta focaccia bloomer challah breadstick crumpet "
    "yorkshire_pudding cheese_twist poppadom cracker panettone scone brioche danish_pastry "
    "hot_cross_bun turnover samosa strudel cannoli profiterole palmier bear_claw rum_baba "
    "baklava borek jalebi halva kouign_amann swiss_roll yule_log battenberg bundt_cake "
    "victoria_sponge cheesecake christmas_pudding cake_pop meringue blue_cheese hard_cheese "
    "cheese_block cheese_cube goat_cheese babybel edam mozzarella quince_paste wasabi mussel "
    "scallop squid octopus octopus_tentacle sea_urchin eel flatfish fish_skeleton "
    "burger_patty roast_beef meatloaf lamb_chop chicken_breast omelette scrambled_eggs "
    "black_pudding kofta hot_dog_bun pineapple_hedgehog crouton cardamom_pod star_anise "
    "sunflower_seed pumpkin_seed brazil_nut coffee_bean pecan flapjack blondie crispy_square "
    "shortbread biscotti madeleine stroopwafel teacake eccles_cake crab_claw lobster_tail "
    "crayfish fish_finger fishcake rollmop calamari_ring fish_and_chips smoked_salmon "
    "onion_bhaji falafel kibbeh gulab_jamun laddu vada idli dosa turkish_delight barfi dolma "
    "pani_puri stollen gooseberry lychee guava persimmon quince kumquat rambutan durian "
    "jackfruit soursop longan mangosteen loquat greengage kohlrabi celeriac taro_root "
    "physalis nutmeg peppercorn juniper_berry raisin new_potato tamarind_pod vanilla_pod okra "
    "daikon horseradish cassava marrow lemongrass bean_sprout endive bamboo_shoot baby_corn "
    "turmeric clove cinnamon_stick kibble peppercorn_heap lemon_zest chopped_parsley "
    "chopped_onion chopped_carrot chopped_pepper chopped_nuts sliced_spring_onion "
    "grated_cheese breadcrumbs sea_salt ground_spice sesame_seeds bird_seed chocolate_chips "
    "sprinkles raisin_heap croutons desiccated_coconut lemon_half orange_half watermelon_half "
    "pineapple_ring apple_ring lotus_root orange_segment apple_slice melon_wedge banana_peel "
    "apple_core orange_peel candied_peel dried_apricot pickle_spear pak_choi chard spinach "
    "radicchio brussels_sprout romanesco herb_bundle sage_bundle bay_leaf sage_leaf "
    "four_leaf_clover pampas_stem redcurrant blackcurrant goldfish jelly_bean gumball "
    "gobstopper peppermint fudge nougat liquorice_allsort humbug stick_of_rock peanut_brittle "
    "candyfloss gummy_worm cola_bottle_sweet fruit_pastille ice_cream_sandwich croquembouche "
    "quesadilla empanada cornish_pasty tostada tamale churro elote concha temaki mochi "
    "dorayaki takoyaki scotch_egg taiyaki shumai sausage_roll pita_pocket panini banh_mi "
    "boutonniere prickly_pear fruit_peel bread_crust fish_bone corn_husk matzo "
    "communion_wafer",
    "leather": "wallet ring_box american_football baseball dice_cup volleyball cricket_ball "
    "rugby_ball baseball_glove boxing_glove handbag purse clutch suitcase belt boot "
    "sandal high_heel glasses_case dog_collar luggage_tag "
    "saddle satchel quiver tefillin drawstring_pouch",
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
    "docking_station "
    "card_shuffler bread_maker contact_grill sandwich_toaster raclette_grill food_dehydrator "
    "yoghurt_maker egg_cooker deep_fryer popcorn_maker ice_cream_maker soda_maker mini_fridge "
    "chocolate_fountain candyfloss_machine crepe_maker vacuum_sealer sous_vide pasta_machine "
    "meat_slicer electric_knife typewriter robot_vacuum hand_vacuum conference_phone "
    "audio_interface guitar_pedal amplifier theremin walkman mp3_player sat_nav note_counter "
    "coin_sorter neon_sign humidifier drill_press air_compressor wood_lathe centrifuge "
    "incubator water_bath thermocycler spectrophotometer defibrillator nebuliser watch_winder "
    "headset_receiver",
    "fabric": "cloth canvas cap folded_towel sponge teddy_bear yarn_ball bandage_roll pencil_case "
    "placemat hat blanket scarf tennis_ball rope gauze_pad cotton_swab cotton_ball face_mask "
    "whiteboard_eraser band_aid tea_cosy oven_mitt pot_holder tea_towel apron bib diaper "
    "baby_shoes doll puppet garden_glove stocking witch_hat bow ribbon pin_cushion "
    "embroidery_hoop zipper pompom yarn_skein cushion pillow rug table_runner tablecloth "
    "fabric_square felt_sheet doily quilt mannequin makeup_bag powder_puff cotton_pad "
    "loofah rolled_towel washcloth hair_tie headband t_shirt shirt sweater jeans sock "
    "glove mitten beanie tie bow_tie backpack duffel_bag umbrella slipper leash cat_toy "
    "duster travel_pillow eye_mask "
    "bunting sash canteen lampshade eye_patch santa_hat elf_hat lavender_sachet "
    "roulette_layout blackjack_felt rabbit_foot pet_bed scratching_post rope_toy puppy_pad "
    "sombrero garter veil napkin_swan rosette pipe_cleaner dreamcatcher tassel knee_pad "
    "beanbag shorts briefs bra swimsuit bikini waistcoat vest bodysuit braces top_hat "
    "bowler_hat fez mortarboard sun_visor wig flat_cap earmuffs waist_bag tote_bag shoelace "
    "insole patch mop_head kippah prayer_flags prayer_shawl rosin bagpipes fuzzy_dice "
    "seat_belt_buckle ratchet_strap money_bag hobby_horse velcro_strap tourniquet ear_plug "
    "toe_separator ironing_board sleeve_board",
    "rubber": "mousepad wrist_rest ball cutting_mat rubber_duck eraser basketball soccer_ball shoe "
    "stethoscope foam_brick hockey_puck yoga_block rubber_band rubber_glove "
    "clown_nose tyre foam_roller resistance_band foam_finger worm sink_plug rubber_stopper "
    "gasket o_ring grommet mouth_guard",
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
     "wooden_box",
     "amphora", "bedpan", "bongos", "bowler_hat", "brandy_snifter", "cardboard_tube", "cauldron",
     "cezve", "chalice", "chemex", "chimney_starter", "coffee_dripper", "coffee_filter",
     "coffee_pot", "conga", "cup_lid", "cup_sleeve", "cupcake_case", "dallah", "dice_tower",
     "display_case", "djembe", "dollhouse", "elf_hat", "fez", "flat_cap", "ghost", "gong",
     "hamster_wheel", "hubcap", "jar_lid", "kippah", "lampshade", "lucky_cat", "magic_8_ball",
     "megaphone", "miniature_house", "muzzle", "open_paper_bag", "paper_crown", "paten",
     "pet_bed", "pet_carrier", "picnic_hamper", "pinata", "potty", "punch_bowl",
     "reagent_reservoir", "salad_spinner", "santa_hat", "satchel", "single_drawer", "sombrero",
     "spoon_dish", "tabla", "top_hat", "tote_bag", "toy_castle", "tyre", "urn", "vinyl_figure",
     "waist_bag"}
)  # fmt: skip
"""Things that are walls around air."""

ASSEMBLED = frozenset(
    {"empty_candlestick", "empty_candelabra", "abacus", "acorn", "american_football", "axe",
     "backpack", "balance_scale", "balloon",
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
     "wreath", "wristwatch", "xylophone", "yo_yo",
     "accordion", "african_violet", "airbrush", "anemometer", "anemone", "ant", "arrow",
     "aspidistra", "bagpipes", "balloon_animal", "balloon_pump", "banana_peel", "banjo", "bee",
     "beetle", "bird_of_paradise", "bird_perch", "blackcurrant", "blossom_branch", "bluebell",
     "boutonniere", "bubble_tea", "budgie", "bulb_holder", "bunny_ears", "bunting", "butterfly",
     "butterfly_net", "cake_pop", "cake_topper", "calathea", "camellia", "candle_snuffer",
     "candyfloss", "canteen", "car_jack", "card_holder", "cat_wand", "chainsaw", "chard",
     "cheese_plane", "cheese_wire", "chess_king", "chess_queen", "chip_case",
     "christmas_pyramid", "chrysanthemum", "cobweb", "cocktail_pick", "coffee_tamper",
     "concertina", "connect_four", "corn_holder", "cornflower", "corsage", "crayfish",
     "cricket_stumps", "crocus", "cross", "croton", "croupier_rake", "crucifix", "cup_and_ball",
     "cup_carrier", "cutlass", "cyclamen", "daffodil", "dagger", "dahlia", "daikon", "dandelion",
     "devil_horns", "disposable_barbecue", "dracaena", "dragonfly", "dreamcatcher",
     "drink_dispenser", "easel", "easter_tree", "edelweiss", "egg_slicer", "egg_topper",
     "electric_guitar", "elote", "evil_eye", "eye_patch", "fern_frond", "ficus", "fish_net",
     "fish_skeleton", "fishing_reel", "fishing_rod", "fluorescent_tube", "fly_swatter",
     "foil_balloon", "fondue_set", "foot_pump", "forget_me_not", "four_leaf_clover", "foxglove",
     "freesia", "french_horn", "gardenia", "garter", "gecko", "geranium", "gerbera",
     "gift_hamper", "gladiolus", "glider", "goggles", "goldfish", "golf_club", "gramophone",
     "gripper", "guitar_string", "gyroscope", "harp", "heat_gun", "herb_bundle", "hibiscus",
     "hobby_horse", "holly", "hollyhock", "hook_hand", "hookah", "horseshoe", "hoya", "hyacinth",
     "hydrangea", "inkwell", "iris", "ironing_board", "jack_plug", "jacks", "jar_opener",
     "kalanchoe", "kofta", "kohlrabi", "lamp_base", "landing_net", "leaflet_holder", "led_strip",
     "lemon_tree", "lemongrass", "lizard", "lotus", "lucky_bamboo", "lute", "lyre", "magnolia",
     "mains_plug", "mancala_board", "mandolin", "marble_run", "marigold", "matcha_whisk",
     "meat_claw", "mincer", "mistletoe", "monstera", "monstrance", "nachos", "nail_gun",
     "napkin_swan", "nativity_set", "network_plug", "oil_lamp", "orange_peel", "origami_crane",
     "orrery", "pak_choi", "palm", "pampas_grass", "pampas_stem", "pansy", "paper_boat",
     "paper_plane", "party_banner", "party_blower", "party_horn", "peony", "peppermint",
     "persimmon", "petal", "petunia", "phono_plug", "photo_prop", "pineapple_hedgehog",
     "pinwheel", "pitchfork", "place_card", "plunger", "poinsettia", "poppy", "power_plug",
     "prayer_beads", "prayer_flags", "pressed_flower", "price_gun", "primrose", "prize_wheel",
     "protea", "quill_and_ink", "quiver", "rabbit_foot", "rambutan", "ratchet_strap",
     "receipt_spike", "redcurrant", "robot_arm", "rollmop", "rope_toy", "rosary",
     "rotary_cutter", "rotary_tool", "roulette_wheel", "rover", "rubber_plant", "sage_bundle",
     "sash", "satellite", "scratching_post", "sea_urchin", "segment_display", "sextant",
     "shackle", "shop_sign", "sign_holder", "signboard", "sink_plug", "siphon_brewer", "sitar",
     "skeleton", "skeleton_model", "sleeve_board", "sleigh", "slinky", "slot_machine", "snake",
     "snake_plant", "snowdrop", "snowflake", "soda_siphon", "soldering_gun", "sparkler",
     "spider", "spider_plant", "spinach", "spiralizer", "splatter_guard", "spotlight",
     "spray_gun", "squeegee", "steering_wheel", "stereoscope", "stick_insect", "streamer",
     "string_lights", "table_flag", "tabletop_grill", "tap_handle", "tarantula", "theremin",
     "thistle", "thurible", "tinsel", "toilet_brush", "toy_bat", "toy_catapult", "toy_chair",
     "toy_sword", "toy_trebuchet", "trombone", "trundle_wheel", "tuba", "turnbuckle", "turtle",
     "vanilla_pod", "veil", "venus_flytrap", "wall_sconce", "washboard", "washing_line_reel",
     "weather_vane", "wheel_brace", "wind_chime", "wind_turbine", "wire_tree", "witch_broom",
     "wrapper", "yucca", "zinnia"}
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
