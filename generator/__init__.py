"""Text or one picture of a tabletop in, a simulated table out (TabletopGen). Knows no robots."""
