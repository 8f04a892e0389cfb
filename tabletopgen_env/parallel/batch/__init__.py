"""Batches of thousands of worlds on MuJoCo Warp, with a different table in each."""
