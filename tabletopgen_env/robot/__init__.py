"""The robot: a Franka Panda, its kinematics, and where its base goes."""
