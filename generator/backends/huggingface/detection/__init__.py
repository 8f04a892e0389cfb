"""Detections by open models: boxes by words, masks by boxes, merged."""
