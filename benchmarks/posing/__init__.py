"""What ``benchmarks/pose.py`` is made of: cases with a known pose, their spoiling, figures."""
