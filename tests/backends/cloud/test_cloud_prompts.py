"""Prompts as data files: all exist, and take exactly the variables that they name."""

from importlib.resources import files
from string import Template

import pytest

from generator.backends.cloud.prompts import prompt
from generator.backends.protocols import Judge, PoseGuesser, Reasoner
from generator.errors import BackendError

STORED = sorted(
    f.name.removesuffix(".md")
    for f in files("generator.backends.cloud.prompts").iterdir()
    if f.name.endswith(".md")
)


def variables(name: str) -> set[str]:
    text = files("generator.backends.cloud.prompts").joinpath(f"{name}.md").read_text()
    template = Template(text)
    assert template.is_valid(), name
    return set(template.get_identifiers())


def test_each_question_has_a_prompt() -> None:
    asked = {
        name for p in (Reasoner, Judge, PoseGuesser) for name in vars(p) if not name.startswith("_")
    }
    assert asked | {"draw", "complete", "top_view"} <= set(STORED)


@pytest.mark.parametrize("name", STORED)
def test_variables_are_exactly_those_named(name: str) -> None:
    given = {v: f"<{v}>" for v in variables(name)}
    text = prompt(name, **given)
    assert all(value in text for value in given.values())
    assert "$" not in text
    with pytest.raises(BackendError, match=r"unexpected \['surplus'\]"):
        prompt(name, **given, surplus="x")
    for left_out in given:
        with pytest.raises(BackendError, match=rf"missing \['{left_out}'\]"):
            prompt(name, **{k: v for k, v in given.items() if k != left_out})


def test_what_is_filled_in_is_not_filled_in_again() -> None:
    assert "costs $seed dollars" in prompt("plan_scene", text="costs $seed dollars", seed="7")


def test_an_unknown_prompt_lists_what_exists() -> None:
    with pytest.raises(BackendError, match="Did you mean 'plan_scene'"):
        prompt("plan_scenes")
