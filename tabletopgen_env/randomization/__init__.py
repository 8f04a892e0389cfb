"""Domain randomisation: variation between episodes of the same scene.

Without it (``randomization=None``, the default) the start of an episode depends only on its scene,
target and goal. Episodes differ if one of these is drawn at random, as marked spots are; Lift at
one table has only as many starts as there are liftable objects. ``randomization="starts"`` slightly
perturbs the arm joints, and moves objects by up to 3 cm along x and y and by up to 15 degrees, as
``certify``, ``record`` and the training recipes do; "light" slightly randomises everything else,
except delays and distractors; "strong" strongly randomises everything else; a ``Randomization``
sets each switch.

Each switch is off by default and draws from a separate random stream, so enabling or changing one
does not affect the draws of the others. (There is one exception: "poses" and "table" affect which
of the draws of "start" has enough room.) ``reset`` restores the compiled world exactly and then
applies the new draws.

===============  ==================================================================================
lights           the sun's direction (``light_turn``) and colour (``light_color``), and the
                 ambient light (``ambient``)
cameras          position (``camera_move``), direction (``camera_turn``) and field of view
                 (``camera_fov``) of each camera of the observations
colors           the tint of each object and of the table (``tint``)
mass             each object's mass and inertia; objects that the hand can carry stay light enough
friction         sliding friction of each object, of the table and of the fingers
gains            ``stiffness`` and ``damping`` of each of the arm's seven servos
delay            actions take effect 0 to ``delay`` steps late; until the first one does, the
                 robot holds still
noise            noise of the readings in the state, drawn at each step: joints, and with them the
                 tool's pose (``joint_noise``), object positions (``position_noise``) and
                 rotations (``rotation_noise``); the goal, the reward and goal vectors are exact
poses            position (``move``) and yaw (``turn``) of objects, together with everything that
                 they carry or touch. The new scene is simulated: objects that overlap, project
                 over the edge or are not at rest stay at their original pose. A reset then also
                 plans a new grasp, and takes a fifth of a second
table            height of the table and everything on it, relative to the robot's base and the
                 cameras (``table_height``); see below
distractors      number of objects on the table that the task does not need; the others are removed
                 together with everything that they carry or touch, and have no slot
start            the arm's joints (``start_joints``), and position (``start_move``) and yaw
                 (``start_turn``) of objects with everything that they carry or touch, after the
                 goal is drawn. Moves that would lead to overlaps, to objects at the edge or out of
                 reach, or to obstacles for the goal are rejected. Certificates hold for the scene's
                 original start and for such starts. The target keeps a reachable grasp; the check
                 takes some 10 milliseconds per reset. Grasp hints are planned for each start
===============  ==================================================================================

The world frame is fixed to the table, so a higher table is represented by a lower base, pedestal
and cameras; in the base frame, which observations use, table and objects rise.

``info["randomization"]`` of ``reset`` holds the draws by switch: numbers, lists, and dicts of them
by object or camera; for "start" it holds ``joints`` (radians) and ``moved`` (the displacement of
each object along x and y, metres, and its rotation, radians).
"""

from .randomizer import Randomizer
from .settings import PRESETS, SWITCHES, Randomization

__all__ = ["PRESETS", "SWITCHES", "Randomization", "Randomizer"]
