"""The stages of the method, one file per section of the paper."""
