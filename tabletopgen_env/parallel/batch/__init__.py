"""Thousands of worlds at once, a different table in each, on MuJoCo Warp."""
