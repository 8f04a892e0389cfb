"""The store of scene bundles: shipped bundles, and a user cache.

``starter/`` holds tables for any task, ``tasks/`` tables for specific tasks ("kitchen-task-*",
"coffee-table-task-*", "tidy-task-*").

Bundles are found by name, digest, glob or path. The search order is the ``cache`` argument, the
environment variable ``TABLETOPGEN_CACHE``, the bundles of this package, and the user's cache
folder. New bundles go to the first of these that is not part of the package. A bundle is published
by a single rename, so readers and writers need no lock.
"""

from .store import STARTER as STARTER
from .store import add as add
from .store import check_own as check_own
from .store import check_removable as check_removable
from .store import clear as clear
from .store import entries as entries
from .store import find as find
from .store import remove as remove
from .store import roots as roots
from .store import user_root as user_root
from .store import verify as verify
