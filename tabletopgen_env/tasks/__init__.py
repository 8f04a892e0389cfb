"""What is asked of the robot: one file per task, made of the goals in ``goals``."""
