"""The embedded backend: plain CPU, no key, no network, no learned weights."""
