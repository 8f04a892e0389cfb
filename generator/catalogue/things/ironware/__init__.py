"""Small iron things and power tools: fixings, catches, plugs, saws, sanders."""
