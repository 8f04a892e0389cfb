"""The scripted expert's demonstrations as a dataset on disk: ``tabletopgen record``.

Every format keeps of each episode:

================  ================================================================================
observations      (t + 1, ...): the flat state, or a dict of pictures and ``state``, or of pictures,
                  ``proprio`` and ``instruction``; see ``observations`` and ``views``
actions           (t, 5): what was done, in the action mode "ee_delta"
rewards           (t,): the dense reward
terminations      (t,): False, for these episodes never end by themselves
truncations       (t,): True in the last row, where success had held or time was up
infos             (t + 1,) each: ``success``, ``goal_index`` (of the active goal), ``target``,
                  ``goal``, ``instruction``, ``reward_terms`` by name, ``proprio`` (33: what the
                  robot feels of itself, apart from the privileged state) and, with pictures,
                  ``cameras`` by name: ``intrinsics`` (3, 3) and ``extrinsics`` (4, 4) at that step,
                  see ``views.camera_calibration``
facts             one each: ``seed``, ``instruction``, ``scene``, ``digest`` (of its table and
                  objects), ``target``, ``goal`` (both of the first goal, "" where there is
                  none), ``certified``, ``success``, ``steps``
================  ================================================================================

and of the dataset ``environment`` (its Gymnasium spec), ``expert``, ``fps`` (actions per second),
``settings``, ``versions`` and ``statistics``: min, max, mean, std, count and the quantiles q01,
q10, q50, q90 and q99 of actions, rewards, proprio and observations (colours in [0, 1] by channel;
see ``summaries``).

=========  =======================================================================================
minari     a Minari dataset; the facts are its episodes' metadata, what is known of the dataset its
           metadata ``tabletopgen``; ``dataset.recover_environment()`` makes the environment again
hdf5       one file: a group ``episode_<k>`` each, its facts the group's attributes; pictures are
           compressed; what is known of the dataset is in the file's attributes, as JSON, and in
           the group ``statistics``
npz        a folder: ``episode_<k>.npz`` each, its nested names joined by slashes, and all facts
           in ``dataset.json``
robomimic  one HDF5 file in robomimic's layout: ``data/demo_<k>`` with ``actions``, ``rewards``,
           ``dones`` (1 in the last row) and ``obs`` of the t steps: ``proprio``, ``state``,
           ``<camera>_image``, ``<camera>_depth`` (height, width, 1), ``<camera>_intrinsics`` and
           ``<camera>_extrinsics``; every tenth demonstration is in ``mask/valid``, the others are
           in ``mask/train``
lerobot    a LeRobot v3.0 dataset, see below
=========  =======================================================================================

Episodes start a little off, each in its own way (``RecordConfig.randomization``): without that
those of the same scene, target and goal would be the same to the bit.

Nothing is pickled, and nothing is lossy but colours in a LeRobot dataset's videos. With the seed of
an episode and its actions, the environment plays it again, if its scenes and their certificates are
the same (scenes that the clock renews never are).

LeRobot
-------
==================================  ==============================================================
``observation.state``               float32 (33): what the robot feels of itself, see
                                    ``proprioception``
``observation.environment_state``   float32 (247, with ``grasp_hint`` 255): the flat state's other
                                    entries, with ``LeRobotConfig.privileged``, or where there are
                                    no pictures: policies of LeRobot take it as an input if it is
                                    there
``observation.images.<picture>``    a picture by its key: colours as a video, depth as a video of 12
                                    bits without further loss (1.5 mm at 1 m), labels as PNG; with
                                    ``video="none"`` all to the bit, as PNG and TIFF
``action``                          float32 (5)
``next.reward``, ``next.success``   of what the action led to
``next.done``, ``next.truncated``   True in an episode's last row
``camera.<camera>.extrinsics``      float32 (16): the matrix (4, 4), row by row
``task``                            the instruction
==================================  ==============================================================

The table of episodes has the facts as further columns, and ``cameras/<camera>/intrinsics`` (9).
Rows are the t steps: what was seen last is not kept. An episode is encoded as soon as it was
played, and what was interrupted, however abruptly, is resumed (``record(..., resume=True)``) to
the same bytes. Until it is put together at the end, a dataset takes up to twice its room.
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
