"""Questions and settings of a study."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from generator.errors import InputError, require_number, require_seed
from generator.io.bounded import printable

CRITERIA = ("visual_fidelity", "image_alignment", "physical_plausibility", "overall")
"""Criteria for each result, rated from 1 (very poor) to 7 (excellent)."""

SHORT = ("VF", "IA", "PP", "Overall")
"""Names of the criteria in tables."""

LEVELS = range(1, 8)

SCHEMA = 1
"""Version of the page's data, of keys and of answers."""

MAX_SCENES, MAX_METHODS = 200, 8

SECONDS_A_SCENE = 25.0
"""The paper's minimum time per scene: 200 s for 8 scenes."""

_METHOD = re.compile(r"\w[\w .,+()/-]{0,58}[\w)+]|\w")
_POST = re.compile(r"(?:/[A-Za-z0-9_.~-]+|/\{study\})+")


@dataclass(frozen=True)
class StudyOptions:
    """Settings of a study.

    Attributes:
        title: Heading of the page; by default a title in the rater's language.
        scenes: Number of random scenes per rater; by default 8, or all if there are fewer.
        seed: Seed of the codes that stand for results.
        min_seconds: Minimum time of a rater; by default 25 s per scene.
        attention: Attention checks per rater: the number of scenes with an additional item that
            tells the rater which number to choose.
        post: Path on the page's own server to which a page from a server sends the answers, instead
            of saving a file. {study} in it stands for the study's id.
    """

    title: str = ""
    scenes: int | None = None
    seed: int = 0
    min_seconds: float | None = None
    attention: int = 1
    post: str | None = None

    def __post_init__(self) -> None:
        printable(self.title, "The title", InputError)
        require_seed(self.seed)
        if self.scenes is not None:
            require_number("--scenes", self.scenes, minimum=1, integer=True)
        if self.min_seconds is not None:
            require_number("--min-seconds", self.min_seconds, minimum=0, maximum=86400)
        require_number("--attention", self.attention, minimum=0, integer=True)
        if self.post is not None and not is_post_path(self.post):
            raise InputError(
                f"--post {self.post!r} must be a path on the page's own server, such as "
                "/api/studies/{study}/answers, made of letters, digits and '_.~-'."
            )

    def scenes_of(self, available: int) -> int:
        """Return how many scenes a rater sees, given the number of available scenes.

        Raises:
            InputError: there are fewer scenes than requested, or fewer than attention checks.
        """
        count = min(8, available) if self.scenes is None else self.scenes
        if count > available:
            raise InputError(
                f"--scenes must be at most {available}, the number of scenes, got {count}."
            )
        if self.attention > count:
            raise InputError(
                f"--attention must be at most {count}, the number of scenes that a rater sees, "
                f"got {self.attention}."
            )
        return count


@dataclass(frozen=True)
class Drawing:
    """Settings for displaying results; ``side`` limits the longer side of pictures, in pixels.

    Attributes:
        above: Also show each result from above; plain pictures need SCENE.above.png.
        side: Maximum length of a picture's longer side, pixels.
    """

    above: bool = False
    side: int = 960

    def __post_init__(self) -> None:
        if not 128 <= self.side <= 2048:
            raise InputError(f"--side must be from 128 to 2048 pixels, got {self.side}.")


def is_post_path(path: str) -> bool:
    """Return whether a URL path is absolute and cannot refer to another server."""
    return len(path) <= 200 and bool(_POST.fullmatch(path)) and not {".", ".."} & {*path.split("/")}


def check_methods(names: Iterable[str]) -> tuple[str, ...]:
    """Return validated names of methods.

    Raises:
        InputError: there are fewer than two names or too many, a name occurs twice, or is not
            valid.
    """
    found = tuple(names)
    for name in found:
        if not (isinstance(name, str) and _METHOD.fullmatch(name)):
            raise InputError(
                f"{name!r:.90} is not a valid method name: use at most 60 letters, digits, spaces "
                f"and '_.,+()/-', starting with a letter or a digit."
            )
    folded = [name.casefold() for name in found]
    if len(set(folded)) < len(found):
        raise InputError(
            f"Two methods have the same name: {', '.join(found)}. Choose distinct names."
        )
    if not 2 <= len(found) <= MAX_METHODS:
        raise InputError(
            f"A study compares 2 to {MAX_METHODS} methods, got {len(found)}. Pass each as "
            f"METHOD=FOLDER."
        )
    return found
