"""Goals: when they are met, how they are drawn, and their instructions."""
