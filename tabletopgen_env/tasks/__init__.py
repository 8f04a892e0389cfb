"""What is asked of the robot: one file per task."""
