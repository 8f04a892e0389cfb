"""The settings of environments: ``EnvConfig`` and its groups, and the keywords that mean them.

========================  ========================================================================
``ObservationConfig``     what a policy sees
``ActionConfig``          how it moves the robot
``RenderConfig``          what ``render`` returns, and what draws
``WorldConfig``           the robot, and how many compiled worlds are kept
``EnvConfig``             all of these, the reward, and how episodes differ
``Settings``              the keywords of ``gymnasium.make``: a group each, or its fields alone
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
