"""The stages of the method, one file a section of the paper."""
