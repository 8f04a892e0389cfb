"""Local changes to finished scenes (Sec. 4.4, Fig. 7): swap, add, remove, move, restyle.

Only the objects that an edit names are rebuilt. All other objects keep identical meshes, textures,
collision parts and masses. New or displaced objects settle, together with objects that touch them,
and in turn objects that touch any object displaced by settling; all others keep bitwise identical
poses. The gate checks the scene again; its provenance names the edited bundle and the edit.

Objects on or in an edited object: they move with an object that is moved; they are set down on the
replacement in a swap, or the edit fails if it cannot hold them; when an object is removed, its
contents are removed too, and objects on it are set down on its own support.
"""

from .actions import add as add
from .actions import move as move
from .actions import remove as remove
from .actions import restyle as restyle
from .actions import swap as swap
from .edited import Edited as Edited
