"""Functions run in a child process with limits on time, memory and output.

Parsers of foreign files run here: a file that makes one loop, crash or fill the memory costs a
child process and ends as one :class:`SandboxError`. The child returns values that this process
decodes without pickle (:mod:`.packing`), works in a folder that no longer exists, and leaves no
file behind, however it ends.
"""

from .runner import CpuBudget as CpuBudget
from .runner import SandboxError as SandboxError
from .runner import SandboxLimits as SandboxLimits
from .runner import call as call
