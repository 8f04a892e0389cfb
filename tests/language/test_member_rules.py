"""Every rule for phrases such as "the other two" resolves a phrase of its own example."""

from __future__ import annotations

from dataclasses import replace

import pytest

from generator.language.planner import plan_scene
from generator.language.semantics import members
from generator.language.semantics.members import RULES, MemberReader, Members, Rule, Skip
from generator.language.syntax.phrases.tree import Noun


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.example)
def test_the_example_of_a_rule_uses_it(rule: Rule, monkeypatch: pytest.MonkeyPatch) -> None:
    used: list[str] = []

    def record(each: Rule) -> Rule:
        def resolve(reader: MemberReader, noun: Noun) -> Members:
            answer = each.resolve(reader, noun)
            if not isinstance(answer, Skip):
                used.append(each.example)
            return answer

        return replace(each, resolve=resolve)

    monkeypatch.setattr(members, "RULES", tuple(record(each) for each in RULES))
    plan_scene(rule.example, 0)
    assert rule.example in used
