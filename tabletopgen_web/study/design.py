"""What a study asks, and its settings."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from generator.errors import InputError, require_number, require_seed
from generator.io.bounded import printable

CRITERIA = ("visual_fidelity", "image_alignment", "physical_plausibility", "overall")
"""What each result is rated for, from 1 (very poor) to 7 (excellent)."""

SHORT = ("VF", "IA", "PP", "Overall")
"""What tables call the criteria."""

LEVELS = range(1, 8)

SCHEMA = 1
"""Version of the page's data, of keys and of answers."""

MAX_SCENES, MAX_METHODS = 200, 8

SECONDS_A_SCENE = 25.0
"""The paper's minimum time, 200 s for 8 scenes, by scene."""

_METHOD = re.compile(r"\w[\w .,+()/-]{0,58}[\w)+]|\w")
_POST = re.compile(r"(?:/[A-Za-z0-9_.~-]+|/\{study\})+")


@dataclass(frozen=True)
class StudyOptions:
    """How a study is held.

    Attributes:
        title: What the page is headed with; its own title in the rater's language if left out.
        scenes: Scenes that each rater sees, drawn at random; 8, or all if there are fewer, if left
            out.
        seed: What the codes are made from, by which results are known.
        min_seconds: Time below which a rater's answers do not count; 25 a scene if left out.
        attention: Attention checks for each rater: in so many scenes one more item that says which
            number to choose.
        post: Path on the page's own server that answers are sent to, in place of a file, when the
            page comes from a server. {study} in it stands for the study's id.
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
            require_number("study needs scenes", self.scenes, minimum=1, integer=True)
        if self.min_seconds is not None:
            require_number("study needs min-seconds", self.min_seconds, minimum=0, maximum=86400)
        require_number("study needs attention", self.attention, minimum=0, integer=True)
        if self.post is not None and not is_post_path(self.post):
            raise InputError(
                f"--post {self.post!r} is no path on the page's own server. Use a path such as "
                "/api/studies/{study}/answers, of letters, digits and '_.~-'."
            )

    def scenes_of(self, available: int) -> int:
        """Return how many scenes a rater sees of so many.

        Raises:
            InputError: there are fewer scenes than asked for, or fewer than attention checks.
        """
        count = min(8, available) if self.scenes is None else self.scenes
        if count > available:
            raise InputError(f"--scenes {count}: there are {available}. Ask for at most as many.")
        if self.attention > count:
            raise InputError(
                f"--attention {self.attention}: a rater sees {count} "
                f"scene{'s' * (count != 1)}, with at most one check in each. Ask for fewer."
            )
        return count


@dataclass(frozen=True)
class Drawing:
    """How results are shown; ``side`` bounds the longer side of a picture, pixels.

    Attributes:
        above: Show each result from straight above, too; plain pictures need SCENE.above.png.
        side: Longest side of a picture in the page, pixels.
    """

    above: bool = False
    side: int = 960

    def __post_init__(self) -> None:
        if not 128 <= self.side <= 2048:
            raise InputError(f"--side {self.side}: use 128 to 2048 pixels.")


def is_post_path(path: str) -> bool:
    """Tell whether a path is absolute on its own server and leads nowhere else."""
    return len(path) <= 200 and bool(_POST.fullmatch(path)) and not {".", ".."} & {*path.split("/")}


def check_methods(names: Iterable[str]) -> tuple[str, ...]:
    """Return methods' names once they are checked.

    Raises:
        InputError: there are fewer than two or too many, one is there twice, or is no plain name.
    """
    found = tuple(names)
    for name in found:
        if not (isinstance(name, str) and _METHOD.fullmatch(name)):
            raise InputError(
                f"{name!r:.90} is no method's name: use at most 60 letters, digits, spaces and "
                "'_.,+()/-', a letter or a digit first."
            )
    folded = [name.casefold() for name in found]
    if len(set(folded)) < len(found):
        raise InputError(f"A method is there twice: {', '.join(found)}. Give each its own name.")
    if not 2 <= len(found) <= MAX_METHODS:
        raise InputError(
            f"A study compares 2 to {MAX_METHODS} methods, got {len(found)}. Name each as "
            "METHOD=FOLDER."
        )
    return found
