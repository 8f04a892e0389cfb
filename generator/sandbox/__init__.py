"""Functions that run in a child process with limits on time, memory and output.

Parsers of untrusted files run here: if a file makes a parser loop, crash or exhaust the memory,
only a child process is lost, and a :class:`SandboxError` is raised. The child returns values that
this process decodes without pickle (:mod:`.serialization`). Its working directory is already
deleted, so it leaves no files behind, however it ends.
"""

from .runner import CpuBudget as CpuBudget
from .runner import SandboxError as SandboxError
from .runner import SandboxLimits as SandboxLimits
from .runner import call as call
