"""Building blocks: solids, outlines, shapes, styles, collision parts, materials."""
