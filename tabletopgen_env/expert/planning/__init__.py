"""Planning of grasps, placements and pushes, before any motion."""
