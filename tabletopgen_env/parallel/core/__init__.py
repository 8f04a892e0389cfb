"""The environment's numbers for many worlds at once, on NumPy arrays or on torch tensors.

What ``tasks``, ``goals``, ``observations`` and ``actions`` compute of one world is computed here of
n worlds, by the same formulas, on whatever device the arrays are: with NumPy for the slots of one
process, with torch for worlds on a GPU. Arrays are of the array API standard, each function takes
its namespace from what it is given. Float arrays are of one type; float64 gives the numbers of the
single environment to rounding, float32 to about 1e-6.

===============  =================================================================================
``readings``     what is read of n worlds after a step
``goal_rows``    the goals of n episodes as arrays of parameters; regions, states, goal vectors
``vectors``      how goal vectors agree, and the reward's terms that follow from them
``rewards``      all terms, and the reward
``flat_states``  the flat state and the order of its slots
``arms``         kinematics of n arms and their inverse
``controls``     the action modes
===============  =================================================================================
"""
