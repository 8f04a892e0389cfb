"""Of tales and of the studio: wands and weapons, easels and stencils, desk gear."""
