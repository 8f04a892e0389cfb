"""Texts with what a fair reader expects of their tables, and judges that look at the bundle."""
