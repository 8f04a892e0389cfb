"""Many environments at once.

- ``vector.TabletopVectorEnv``: a Gymnasium vector environment on the CPU, each slot with its own
  scene, task and options. Use it for Stable-Baselines3, pictures and everything that
  ``gymnasium.make`` supports. ``workers`` steps its slots on threads or in processes.
- ``batch.env.TabletopBatchEnv``: one vector environment of up to thousands of worlds on MuJoCo
  Warp, with torch tensors in and out. Use it for on-policy training on a GPU, where all worlds
  share one task and its settings.
- ``core``: actions, states, goals and rewards of n worlds as arrays of NumPy or torch; both
  environments compute with it.
"""
