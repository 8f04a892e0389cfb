"""House plants in pots, each with its leaves and flowers."""

from __future__ import annotations

from ...build.category import Category
from .growth import PlantForm, plant

_P = ("living", "office")


def _row(
    key: str, kind: PlantForm, mass: float, size: tuple[float, float, float], *aliases: str
) -> Category:
    noun = key.replace("_", " ")
    return Category(key, plant(kind), size, mass, (*aliases, f"potted {noun}"), _P, ("tall",),
                    ("terracotta", "white"))  # fmt: skip


CATEGORIES = (
    _row("monstera", PlantForm("stems", (0.1, 0.085), 9, 0.13, skin="split", steep=0.8), 0.8,
         (0.289, 0.271, 0.218), "swiss cheese plant", "monstera plant",
         "cheese plant", "monstera deliciosa"),
    _row("african_violet", PlantForm("rosette", (0.06, 0.044), 16, 0.045, ("green", "olive"),
                                 bloom="violets", hues=("violet", "purple", "pink", "indigo"),
                                 steep=0.35), 0.5,
         (0.119, 0.112, 0.131), "saintpaulia", "african violet plant", "potted violet"),
    _row("venus_flytrap", PlantForm("trap", (0.06, 0.02), 11, green=("crimson", "red", "coral"),
                                skin="spots", mark="lime"), 0.4, (0.14, 0.133, 0.144),
         "venus fly trap", "flytrap", "fly trap", "carnivorous plant"),
    _row("lucky_bamboo", PlantForm("bamboo", (0.075, 0.017), 7, 0.17, ("green", "lime"), "plain",
                               "green"), 0.5, (0.144, 0.141, 0.254), "bamboo plant",
         "lucky bamboo plant", "bamboo stalk", "bamboo"),
    _row("yucca", PlantForm("cane", (0.13, 0.014), 20, 0.13, ("green", "sage", "olive"), "plain",
                        "sage", steep=0.3), 1.0, (0.264, 0.242, 0.296), "yucca plant",
                        "yucca palm"),
    _row("dracaena", PlantForm("cane", (0.12, 0.02), 18, 0.15, ("green", "olive"), "edge",
             "crimson",
                           steep=0.25), 1.0, (0.253, 0.223, 0.299), "dragon tree", "corn plant",
         "dracaena plant"),
    _row("ficus", PlantForm("tree", (0.045, 0.022), 44, 0.12), 0.9, (0.182, 0.18, 0.286),
         "weeping fig", "ficus tree", "ficus plant", "olive tree", "mini tree", "small tree"),
    _row("rubber_plant", PlantForm("stems", (0.1, 0.05), 13, 0.16, ("green", "maroon", "green"),
                               "leaf", steep=1.1), 0.9, (0.27, 0.26, 0.275), "fiddle leaf fig",
                               "rubber tree",
         "rubber fig"),
    _row("calathea", PlantForm("stems", (0.09, 0.05), 14, 0.1, ("green", "teal"), "bars", "sage",
                           steep=1.0), 0.7, (0.261, 0.243, 0.198), "prayer plant", "maranta",
                           "zebra plant",
         "calathea plant"),
    _row("aspidistra", PlantForm("rosette", (0.19, 0.042), 11, green=("green",), steep=0.95), 0.8,
         (0.188, 0.154, 0.231), "cast iron plant", "peace lily plant"),
    _row("snake_plant", PlantForm("rosette", (0.19, 0.03), 9, green=("green", "sage"), skin="edge",
                              mark="yellow", steep=1.25), 0.7, (0.111, 0.106, 0.262), "sansevieria",
         "mother in law's tongue", "mother-in-law's tongue"),
    _row("spider_plant", PlantForm("rosette", (0.16, 0.012), 26, green=("lime", "green"),
             skin="edge",
                               mark="white", steep=0.55), 0.5, (0.277, 0.256, 0.177),
                               "chlorophytum"),
    _row("croton", PlantForm("stems", (0.085, 0.035), 16, 0.12, ("green", "olive"), "veins",
             "orange",
                         steep=1.0), 0.8, (0.263, 0.245, 0.218), "croton plant", "joseph's coat",
         "coleus", "aluminium plant"),
    _row("hoya", PlantForm("stems", (0.05, 0.024), 20, 0.07, ("green", "sage"), "edge", "cream",
                       "cluster", ("pink", "white"), 0.7), 0.6, (0.211, 0.198, 0.164), "wax plant",
                       "hoya plant",
         "peperomia"),
    _row("poinsettia", PlantForm("stems", (0.07, 0.034), 14, 0.1, bloom="bracts",
                             hues=("red", "crimson", "red", "white", "pink"), steep=0.7), 0.6,
                             (0.244, 0.234, 0.205),
         "christmas star plant", "poinsettia plant", "christmas flower"),
    _row("cyclamen", PlantForm("stems", (0.045, 0.044), 15, 0.055, ("green", "teal"), "veins",
             "sage",
                           "cyclamen", ("magenta", "pink", "white", "red"), 0.6), 0.5,
                           (0.19, 0.181, 0.178),
         "cyclamen plant"),
    _row("kalanchoe", PlantForm("stems", (0.04, 0.028), 20, 0.06, ("green",), bloom="cluster",
                            hues=("red", "orange", "yellow", "pink"), steep=0.7), 0.5,
                            (0.188, 0.179, 0.151),
         "flaming katy", "kalanchoe plant",
         "potted geranium", "busy lizzie"),
    _row("lemon_tree", PlantForm("tree", (0.045, 0.022), 40, 0.12, bloom="fruit",
                             hues=("yellow", "gold", "orange", "lime")), 1.0,
                             (0.179, 0.177, 0.285), "orange tree", "citrus tree",
         "kumquat tree", "mini lemon tree", "calamondin"),
    _row("palm", PlantForm("frond", (0.2, 0.07), 9, green=("green", "lime", "olive"), steep=0.75),
             0.8,
         (0.313, 0.291, 0.237), "parlour palm", "areca palm", "palm plant", "palm tree",
         "kentia palm", "parlor palm", "indoor palm", "bamboo palm"),
)  # fmt: skip
"""The module's categories."""
