"""Teleoperation of the arm, recorded as a dataset: ``tabletopgen teleop``.

====================  ============================================================================
``inputs``            keys, sticks and buttons, and the commands that they give
``session``           episodes that a person and a policy play in turns
``page``              a local web page with keyboard or gamepad control
``window``            a local window with keyboard or gamepad control
``command``           the command
====================  ============================================================================
"""
