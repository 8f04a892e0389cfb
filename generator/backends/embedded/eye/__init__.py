"""The learned eye of the embedded backend: network, weights, and what its maps mean."""
