"""``tabletopgen doctor``: the capabilities of this machine."""
