"""Where an environment's tables come from: scenes that are there, made again, or ever renewed.

A source draws *references*: a key, by which a compiled world is reused, and a function that loads
the scene when it is not there yet. Drawing uses the generator it is given and nothing else, so
that a seeded environment sees the same tables again; only what is renewed by the clock does not
(``RefreshingScenes`` with ``per_minute``).

====================  =============================================================================
``FixedScenes``       bundles and scenes in memory, all equally likely
``FreshScenes``       a new one for each draw: of texts, or of a ``SceneDistribution``
``RefreshingScenes``  a pool that processes keep renewing in the background
``CurriculumScenes``  those of another source at which the policy learns most now
``SharedScenes``      those of another source, for several threads, as ``TabletopVectorEnv`` has it
``split``             the scenes of any source to train on, or those held out
====================  =============================================================================

``"fresh"`` and ``"refreshing"`` draw tables for the task at hand: of every theme, with what
``Task.needs`` lists on them besides. A source that is passed in draws what it says:
``FreshScenes(SceneDistribution(needs=task.needs))`` has the needs, too.
"""

from generator.language.distribution import SceneDistribution as SceneDistribution

from .curriculum import CurriculumScenes as CurriculumScenes
from .difficulty import difficulty as difficulty
from .difficulty import difficulty_terms as difficulty_terms
from .fixed import FixedScenes as FixedScenes
from .fresh import FreshScenes as FreshScenes
from .lookup import CURRICULUM as CURRICULUM
from .lookup import FRESH as FRESH
from .lookup import REFRESHING as REFRESHING
from .lookup import STARTER as STARTER
from .production.recipe import SceneRecipe as SceneRecipe
from .refresh import RefreshingScenes as RefreshingScenes
from .sampler import DifficultySampler as DifficultySampler
from .selection import SceneChoice as SceneChoice
from .selection import resolve as resolve
from .selection import split as split
from .source import SceneRef as SceneRef
from .source import SceneSource as SceneSource
from .source import SharedScenes as SharedScenes
from .splits import SplitRule as SplitRule
