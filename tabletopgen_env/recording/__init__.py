"""Datasets of demonstrations by the scripted expert: ``tabletopgen record``.

Every format stores for each episode:

================  ================================================================================
observations      (t + 1, ...): the flat state, or a dict of pictures and ``state``, or of pictures,
                  ``proprio`` and ``instruction``; see ``observations`` and ``views``
actions           (t, 5): the actions, in the action mode "ee_delta"
rewards           (t,): the dense reward
terminations      (t,): always False, since these episodes never terminate
truncations       (t,): True in the last row, when success has held or time is up
infos             (t + 1,) each: ``success``, ``goal_index`` (of the active goal), ``target``,
                  ``goal``, ``instruction``, ``reward_terms`` by name, ``proprio`` (33: the robot's
                  proprioception, without the privileged state) and, with pictures, ``cameras`` by
                  name: ``intrinsics`` (3, 3) and ``extrinsics`` (4, 4) at that step, see
                  ``views.camera_calibration``
facts             one value each: ``seed``, ``instruction``, ``scene``, ``digest`` (of its table and
                  objects), ``target``, ``goal`` (both of the first goal, "" if there is none),
                  ``certified``, ``success``, ``steps``
================  ================================================================================

For the dataset it stores ``environment`` (its Gymnasium spec), ``expert``, ``fps`` (actions per
second), ``settings``, ``versions`` and ``statistics``: min, max, mean, std, count and the quantiles
q01, q10, q50, q90 and q99 of actions, rewards, proprio and observations (colours in [0, 1] per
channel; see ``summaries``).

=========  =======================================================================================
minari     a Minari dataset; the facts are its episodes' metadata, the dataset's entries its
           metadata ``tabletopgen``; ``dataset.recover_environment()`` recreates the environment
hdf5       one file: a group ``episode_<k>`` each, with the facts as the group's attributes;
           pictures are compressed; the dataset's entries are the file's attributes, as JSON, and
           the group ``statistics``
npz        a folder: ``episode_<k>.npz`` each, with nested names joined by slashes, and all facts
           in ``dataset.json``
robomimic  one HDF5 file in robomimic's layout: ``data/demo_<k>`` with ``actions``, ``rewards``,
           ``dones`` (1 in the last row) and ``obs`` of the t steps: ``proprio``, ``state``,
           ``<camera>_image``, ``<camera>_depth`` (height, width, 1), ``<camera>_intrinsics`` and
           ``<camera>_extrinsics``; every tenth demonstration is in ``mask/valid``, the others are
           in ``mask/train``
lerobot    a LeRobot v3.0 dataset, see below
=========  =======================================================================================

The initial state of each episode is perturbed (``RecordConfig.randomization``); otherwise all
episodes with the same scene, target and goal would be identical.

Nothing is pickled, and only the colours in a LeRobot dataset's videos are compressed lossily. An
environment can replay an episode from its seed and its actions if the scenes and their certificates
are the same (never for scenes that are renewed by the clock).

LeRobot
-------
==================================  ==============================================================
``observation.state``               float32 (33): the robot's proprioception, see
                                    ``proprioception``
``observation.environment_state``   float32 (247, with ``grasp_hint`` 255): the flat state's other
                                    entries, with ``LeRobotConfig.privileged`` or without pictures;
                                    LeRobot's policies use it as an input if it exists
``observation.images.<picture>``    a picture by its key: colours as a video; depth as a 12-bit
                                    video, lossless after quantisation (1.5 mm at 1 m); labels as
                                    PNG; with ``video="none"`` everything lossless, as PNG and TIFF
``action``                          float32 (5)
``next.reward``, ``next.success``   the results of the action
``next.done``, ``next.truncated``   True in an episode's last row
``camera.<camera>.extrinsics``      float32 (16): the matrix (4, 4), row by row
``task``                            the instruction
==================================  ==============================================================

The table of episodes has the facts as further columns, and ``cameras/<camera>/intrinsics`` (9).
There is one row for each of the t steps; the last observation is not stored. An episode is encoded
as soon as it is complete. An interrupted recording can be resumed (``record(..., resume=True)``),
even after a crash, and the result has identical bytes. Until the final assembly, a dataset takes up
to twice its size on disk.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from generator.io.lazy import lazy_names

if TYPE_CHECKING:
    from .config import FORMATS as FORMATS
    from .config import VIDEO_CODECS as VIDEO_CODECS
    from .config import Format as Format
    from .config import LeRobotConfig as LeRobotConfig
    from .config import RecordConfig as RecordConfig
    from .config import VideoCodec as VideoCodec
    from .recorder import record as record

_HOMES = {
    "FORMATS": "config",
    "Format": "config",
    "LeRobotConfig": "config",
    "RecordConfig": "config",
    "VIDEO_CODECS": "config",
    "VideoCodec": "config",
    "record": "recorder",
}

__all__ = [
    "FORMATS",
    "VIDEO_CODECS",
    "Format",
    "LeRobotConfig",
    "RecordConfig",
    "VideoCodec",
    "record",
]

__getattr__, __dir__ = lazy_names(__name__, _HOMES)
