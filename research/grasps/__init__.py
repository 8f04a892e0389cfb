"""Training of the grasp detector."""
