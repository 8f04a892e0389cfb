"""The settings of environments: ``EnvConfig``, its groups, and their keywords.

========================  ========================================================================
``ObservationConfig``     the observation
``ActionConfig``          the action space
``RenderConfig``          the pictures of ``render``, and the renderer
``WorldConfig``           the robot, and the cache of compiled worlds
``EnvConfig``             all of these, the reward, and the randomisation
``Settings``              the keywords of ``gymnasium.make``: groups, or their fields
========================  ========================================================================
"""

from ..actions import ActionConfig as ActionConfig
from ..rendering.config import ObservationConfig as ObservationConfig
from ..rendering.config import RenderConfig as RenderConfig
from ..world.worlds import WorldConfig as WorldConfig
from .config import EnvConfig as EnvConfig
from .config import RewardMode as RewardMode
from .keywords import KEYWORDS as KEYWORDS
from .keywords import Settings as Settings
from .keywords import check_settings as check_settings
from .keywords import read_settings as read_settings
