"""Parts of ``benchmarks/pose.py``: cases with a known pose, perturbations, metrics."""
