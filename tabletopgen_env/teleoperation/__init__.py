"""Driving the arm by hand, and what was done as a dataset: ``tabletopgen teleop``.

====================  ============================================================================
``inputs``            what a person holds down, and what it asks of the arm
``session``           episodes that a person and a policy play in turns
``page``              a page of this machine: keyboard, or a gamepad, in a browser
``window``            a window of this machine
``command``           the command
====================  ============================================================================
"""
