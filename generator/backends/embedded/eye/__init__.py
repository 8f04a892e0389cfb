"""The embedded backend's learned detector (the "eye"): network, weights and decoding."""
