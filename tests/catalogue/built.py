"""Models of a category by their seeds; not to be changed, as several tests share them."""

from generator.catalogue import build
from generator.scene import Model


class Models:
    """The plain models of a category, each built when it is first asked for."""

    def __init__(self, key: str) -> None:
        self.key = key
        self._built: dict[int, Model] = {}

    def __getitem__(self, seed: int) -> Model:
        if seed not in self._built:
            self._built[seed] = build(self.key, seed)
        return self._built[seed]

    def first(self, count: int) -> list[Model]:
        return [self[seed] for seed in range(count)]
