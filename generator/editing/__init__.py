"""Local changes to finished scenes (Sec. 4.4, Fig. 7): swap, add, remove, move, restyle.

Only the objects that an edit names are rebuilt. All other objects keep identical meshes, textures,
collision parts and masses. New and displaced objects settle together with the objects that touch
them. If settling displaces an object, those that touch it settle as well. All others keep bitwise
identical poses. The gate checks the scene again; its provenance records the edited bundle and the
edit.

When an object moves, the objects on or in it move with it. In a swap they are set down on the
replacement; if it cannot hold them, the edit fails. When an object is removed, its contents are
removed too, and objects on it are set down on its support.
"""

from .actions import add as add
from .actions import move as move
from .actions import remove as remove
from .actions import restyle as restyle
from .actions import swap as swap
from .edited import Edited as Edited
