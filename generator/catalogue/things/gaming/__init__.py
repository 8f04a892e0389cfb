"""Games and gambling: chess men, dice of many sides, boards, wheels, chips and machines."""
