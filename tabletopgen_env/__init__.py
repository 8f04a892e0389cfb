"""Gymnasium environments: a Franka Panda at generated tables."""
