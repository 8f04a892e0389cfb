"""Where to grasp a thing, learned: from height maps, as a depth camera above the table has them."""

from __future__ import annotations
