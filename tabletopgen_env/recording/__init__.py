"""The scripted expert's demonstrations as a dataset on disk: ``python -m tabletopgen_env record``.

Every format keeps of each episode:

================  ================================================================================
observations      (t + 1, ...): the flat state, or a dict of ``state`` and pictures; see
                  ``observations`` and ``views``
actions           (t, 5): what was done, in the action mode "ee_delta"
rewards           (t,): the dense reward
terminations      (t,): False, for these episodes never end by themselves
truncations       (t,): True in the last row, where success had held or time was up
infos             (t + 1,) each: ``success``, ``goal_index`` (of the active goal), ``target``,
                  ``goal``, ``instruction``, and ``reward_terms`` by name
facts             one each: ``seed``, ``instruction``, ``scene``, ``digest`` (of its table and
                  objects), ``target``, ``goal`` (both of the first goal, "" where there is
                  none), ``certified``, ``success``, ``steps``
================  ================================================================================

=========  =======================================================================================
minari     a Minari dataset; the facts are its episodes' metadata, and
           ``dataset.recover_environment()`` makes the environment again
hdf5       one file: a group ``episode_<k>`` each, its facts the group's attributes; pictures are
           compressed
npz        a folder: ``episode_<k>.npz`` each, its nested names joined by slashes, and all facts
           in ``dataset.json``
=========  =======================================================================================

Episodes start a little off, each in its own way (``RecordConfig.randomization``): without that
those of the same scene, target and goal would be the same to the bit.

Nothing is lossy and nothing is pickled. With the seed of an episode and its actions, the
environment plays it again, if its scenes and their certificates are the same (scenes that the clock
renews never are).
"""

from .config import FORMATS, Format, RecordConfig
from .recorder import record

__all__ = ["FORMATS", "Format", "RecordConfig", "record"]
