"""The embedded backend: plain CPU, no key, no network; its learned weights come with it."""
