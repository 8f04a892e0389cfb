"""Finished scenes changed in one place (Sec. 4.4, Fig. 7): swap, add, remove, move, restyle.

Only what an edit names is made again. Every other thing keeps its mesh, texture, collision parts
and mass to the byte. What is new or elsewhere settles, with what touches it, and in turn with what
touches a thing that this moves; all other things keep their poses to the bit. The scene is judged
again; its provenance names what it was edited from, and the edit.

What stands on or in a thing: it goes where the thing is moved; it is set down on what takes the
thing's place, if that holds it, else the edit is refused; where a thing is removed, what is in it
goes with it, and what stood on it stands on what that stood on.
"""

from .actions import add as add
from .actions import move as move
from .actions import remove as remove
from .actions import restyle as restyle
from .actions import swap as swap
from .edited import Edited as Edited
