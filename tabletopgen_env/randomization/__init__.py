"""Domain randomisation: what differs between episodes of the same scene.

Without it (``randomization=None``, the default) an episode's start follows from its scene, target
and goal alone. Episodes differ where one of these is drawn, as marked spots are, but Lift at one
table has only as many starts as the table has things to lift. ``randomization="starts"`` puts the
arm a little off and the things up to 3 cm along x and y and 15 degrees from where the scene has
them, as ``certify``, ``record`` and training recipes do; "light" randomises everything else a
little, except delays and distractors; "strong" randomises everything else strongly; a
``Randomization`` sets each switch.

Each switch is off until its settings say otherwise, and draws from a random stream of its own, so
that turning one on or changing it leaves the draws of the others as they were; which of the draws
of "start" has room depends on where "poses" and "table" have put things. ``reset`` applies
the draws to the compiled world, after putting back what the last episode changed, exactly.

===============  ==================================================================================
lights           the sun's direction (``light_turn``) and colour (``light_color``), the room's
                 light (``ambient``)
cameras          place (``camera_move``), direction (``camera_turn``) and field of view
                 (``camera_fov``) of each camera of the observations
colors           the tint of each object and of the table (``tint``)
mass             each object's mass and inertia; what the hand can carry never grows too heavy
friction         sliding friction of each object, of the table and of the fingers
gains            ``stiffness`` and ``damping`` of each of the arm's seven servos
delay            actions take effect 0 to ``delay`` steps late; until the first does, the robot
                 holds still
noise            of the readings in the state, anew at each step: joints, and with them the tool's
                 pose (``joint_noise``), object places (``position_noise``) and rotations
                 (``rotation_noise``); never of the goal, the reward or goal vectors
poses            place (``move``) and yaw (``turn``) of objects, together with all that they carry
                 or touch. The new scene is simulated: what overlaps, reaches over the edge or does
                 not rest stays where it was. With this a reset plans a grasp anew, too, and takes
                 a fifth of a second
table            the table's height with all that is on it, as against the robot's base and the
                 cameras (``table_height``); see below
distractors      how many objects that the task does not need stay on the table; the others are
                 taken away, together with all that they carry or touch, and have no slot
start            the arm's joints (``start_joints``), place (``start_move``) and yaw
                 (``start_turn``) of things with all that they carry or touch, once the goal is
                 drawn, as far as there is room: nothing comes to overlap, to stand at the edge, out
                 of reach or in the way of what the goal asks for. What a certificate says holds
                 for the scene's own start and for such starts. A start leaves what is to be
                 taken a grasp that the arm reaches, which takes some 10 milliseconds a reset;
                 grasp hints are planned anew for each
===============  ==================================================================================

The world frame is fixed to the table, so a higher table shows as a lower base, pedestal and
cameras; in the base frame, in which policies see the world, table and objects rise.

``info["randomization"]`` of ``reset`` holds what was drawn, by switch: numbers, lists, and dicts of
them by object or camera; of "start" ``joints`` (radians) and ``moved`` (an object's metres along x
and y, and its turn).
"""

from .randomizer import Randomizer
from .settings import PRESETS, SWITCHES, Randomization

__all__ = ["PRESETS", "SWITCHES", "Randomization", "Randomizer"]
