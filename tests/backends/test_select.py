from __future__ import annotations

from dataclasses import dataclass

import pytest

from generator.backends import Backends
from generator.errors import BackendError


@dataclass(frozen=True)
class MyModeler:
    revision: str = "r1"

    def model(self, instance, size, view):
        raise AssertionError


def test_embedded_answers_every_question() -> None:
    backends = Backends.select("embedded")
    assert set(backends.identity()) == {"reasoner", "imager", "segmenter", "modeler", "encoder"}


def test_your_own_class_takes_one_role() -> None:
    backends = Backends.select("embedded", modeler=MyModeler())
    assert backends.identity()["modeler"]["revision"] == "r1"
    assert isinstance(backends.modeler, MyModeler)


def test_names_and_roles_are_checked() -> None:
    with pytest.raises(BackendError, match="Did you mean 'embedded'"):
        Backends.select("embeded")
    with pytest.raises(BackendError, match="Did you mean 'modeler'"):
        Backends.select("embedded", modeller=MyModeler())


def test_an_object_without_the_methods_is_refused() -> None:
    with pytest.raises(BackendError, match="lacks draw, complete, top_view"):
        Backends.select("embedded", imager=MyModeler())
