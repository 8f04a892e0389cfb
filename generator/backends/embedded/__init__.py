"""The embedded backend, which needs no GPU, key or network, and includes its learned weights."""
