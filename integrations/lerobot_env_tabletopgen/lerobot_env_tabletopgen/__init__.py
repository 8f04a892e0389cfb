"""TabletopGen's environments for LeRobot's ``--env.type=tabletopgen``."""

from .config import TabletopGenEnvConfig
from .view import LeRobotView, make_lerobot_env

__all__ = ["LeRobotView", "TabletopGenEnvConfig", "make_lerobot_env"]
