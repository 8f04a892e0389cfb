"""Exports at work in the physics engines that they are for."""
