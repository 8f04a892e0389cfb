"""The embedded backend: CPU only, no key, no network; its learned weights are included."""
