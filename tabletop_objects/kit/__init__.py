"""The toolkit for drawing objects: outlines, solids, parts, surfaces, prints and shapes."""
