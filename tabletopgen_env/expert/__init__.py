"""The scripted expert: grasp planning, placement, and motion of objects."""
