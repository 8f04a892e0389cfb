"""The learned detector (eye) of the embedded backend: network, weights and decoding."""
