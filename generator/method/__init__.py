"""The stages of the method: one module or package per section of the paper."""
