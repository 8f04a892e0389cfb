"""Files and texts from elsewhere: bounded readers, atomic writers, what a terminal may show."""
