"""Batched computations of the environment, on NumPy arrays or torch tensors.

This package computes for n worlds what ``tasks``, ``goals``, ``observations`` and ``actions``
compute for one world, with the same formulas, on the device of the arrays: NumPy for the slots of
one process, torch for worlds on a GPU. Arrays follow the array API standard; each function takes
its namespace from its arguments. All floats have the same type; results agree with the single
environment up to rounding in float64, and to about 1e-6 in float32.

===============  =================================================================================
``readings``     quantities read from n worlds after a step
``goal_rows``    the goals of n episodes as parameter arrays; regions, states, goal vectors
``vectors``      agreement of goal vectors, and the reward terms that depend on it
``rewards``      all reward terms, and the reward
``flat_states``  the flat state and the order of its slots
``arms``         forward and inverse kinematics of n arms
``controls``     the action modes
===============  =================================================================================
"""
