"""How things are made: solids, outlines, shapes, styles, collision parts, materials."""
