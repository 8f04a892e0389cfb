"""The simulated world of an environment: robot, table and objects, compiled."""
