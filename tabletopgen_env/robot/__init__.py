"""The robot: a Franka Panda, its kinematics, and the placement of its base."""
