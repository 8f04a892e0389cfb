"""Detection with open models: boxes from words, masks from boxes, and merging."""
