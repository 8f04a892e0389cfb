"""Scene sources of an environment: existing, generated or continuously renewed scenes.

A source draws *references*: a key, by which a compiled world is reused, and a function that loads
the scene if it is not cached. Draws depend only on the given generator, so that a seeded
environment repeats its tables; the only exception is scenes renewed by the clock
(``RefreshingScenes`` with ``per_minute``).

====================  =============================================================================
``FixedScenes``       bundles and scenes in memory, drawn uniformly
``FreshScenes``       a new scene for each draw: from texts, or from a ``SceneDistribution``
``RefreshingScenes``  a pool that background processes keep renewing
``CurriculumScenes``  scenes of another source, preferably where the policy currently learns most
``SharedScenes``      scenes of another source, for several threads as in ``TabletopVectorEnv``
``split``             the training scenes or the held-out scenes of any source
====================  =============================================================================

``"fresh"`` and ``"refreshing"`` draw tables of every theme for the current task, including the
objects listed in ``Task.needs``. A source object is used unchanged, so include the needs yourself:
``FreshScenes(SceneDistribution(needs=task.needs))``.
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
