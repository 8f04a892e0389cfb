"""For the sick and for teeth: tests, probes, trays, models, aids."""
