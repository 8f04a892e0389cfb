"""Proximal policy optimisation for batches of worlds, on NumPy or torch, on a CPU or a GPU."""
