"""What people make and play with: folded paper, crafts, sports, bicycles, fishing, science toys."""
