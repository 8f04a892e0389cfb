"""Vector environments.

- ``vector.TabletopVectorEnv``: a Gymnasium vector environment on the CPU. Each slot has its own
  scene, task and options. Use it for Stable-Baselines3, for pictures and for everything that
  ``gymnasium.make`` supports. The package ``workers`` steps its slots on threads or in processes.
- ``batch.env.TabletopBatchEnv``: a vector environment of up to thousands of worlds on MuJoCo Warp,
  with torch tensors as input and output. Use it for on-policy training on a GPU, where all worlds
  share one task and its settings.
- ``core``: actions, states, goals and rewards of n worlds as NumPy arrays or torch tensors, used by
  both environments.
"""
