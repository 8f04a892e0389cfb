"""Geometric bodies: polyhedra, round and open shapes, slabs and tiles."""
