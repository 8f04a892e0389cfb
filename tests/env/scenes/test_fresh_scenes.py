"""Scenes generated on demand: dependence on seeds, and generation."""

import pickle
import sys
import types

import numpy as np
import pytest
from toy import toy_scene

from generator.errors import InputError, SceneError
from generator.language.distribution import SceneDistribution
from generator.scene import Failure, Report, Scene, ScenePlan
from tabletopgen_env.env import make_env
from tabletopgen_env.scenes import FreshScenes, SceneRecipe, SplitRule

LAB = SceneDistribution(themes=("lab",), objects=(2, 3))


@pytest.fixture
def composed(monkeypatch) -> list[tuple[ScenePlan, int]]:
    """Return the arguments of the calls of a fake ``compose``."""
    asked: list[tuple[ScenePlan, int]] = []

    def compose(plan: ScenePlan, seed: int) -> Scene:
        asked.append((plan, seed))
        return toy_scene(name=f"fresh_{seed}")

    monkeypatch.setattr("generator.composition.compose", compose)
    return asked


def test_a_scene_is_composed_when_it_is_loaded(composed) -> None:
    source = FreshScenes("an office desk")
    refs = [source.draw(np.random.default_rng(seed)) for seed in (0, 0, 1)]
    assert refs[0].key == refs[1].key != refs[2].key and not composed
    refs[0].load()
    plan, seed = composed[0]
    assert plan.prompt == "an office desk" and refs[0].key == f"fresh:{seed}:an office desk"
    assert make_env(source).reset(seed=3)[1]["scene"].startswith("fresh_")


def test_one_text_several_and_a_distribution() -> None:
    rng = np.random.default_rng(0)
    assert FreshScenes("a desk") == FreshScenes(["a desk"]) == FreshScenes(("a desk",))
    drawn = {FreshScenes(["a desk", "a lab"]).recipe(rng).what for _ in range(20)}
    assert drawn == {"a desk", "a lab"}
    recipe = FreshScenes(LAB).recipe(rng)
    assert recipe.what is LAB and recipe.plan() == recipe.plan()
    assert "microscope" in {o.category for o in recipe.plan().objects}


def test_few_variants_come_again() -> None:
    source, rng = FreshScenes(("a desk", "a kitchen table"), variants=2), np.random.default_rng(0)
    assert len({source.draw(rng).key for _ in range(60)}) == 4
    source = FreshScenes(LAB, variants=3)
    assert len({source.draw(rng).key for _ in range(60)}) == 3


def test_another_distribution_and_another_making_are_other_scenes() -> None:
    lab, tea = (SceneDistribution(themes=(name,)) for name in ("lab", "tea"))
    recipes = [
        SceneRecipe(lab, 1),
        SceneRecipe(tea, 1),
        SceneRecipe("a lab", 1),
        SceneRecipe("a lab", 1, "generate"),
    ]
    assert len({r.key for r in recipes}) == 4


def test_a_recipe_survives_pickle() -> None:
    rules = (SplitRule("train", "category", categories=("mug",)), SplitRule("held_out", share=0.3))
    for recipe in (
        SceneRecipe("a desk", 3, "generate", rules),
        SceneRecipe(LAB, 4, rules=rules[1:]),
    ):
        assert pickle.loads(pickle.dumps(recipe)) == recipe
    source = FreshScenes(LAB, rules=rules)
    assert pickle.loads(pickle.dumps(source)) == source


def test_what_cannot_be_made_at_first_is_tried_with_other_seeds() -> None:
    scene = SceneRecipe("x", 5, "makers:second_try").make()
    assert scene.name == f"toy_{5 + 2**30}"
    with pytest.raises(SceneError, match=r"3 attempts .*makers:failing:5:x.* nothing stands"):
        SceneRecipe("x", 5, "makers:failing").make()


def test_a_second_attempt_keeps_to_the_plan(composed, monkeypatch) -> None:
    from generator.composition import compose

    def unlucky(plan: ScenePlan, seed: int) -> Scene:
        scene = compose(plan, seed)
        if len(composed) < 3:
            raise SceneError("fell")
        return scene

    monkeypatch.setattr("generator.composition.compose", unlucky)
    for what in ("an office desk", LAB):
        composed.clear()
        SceneRecipe(what, 5).make()
        assert len({id(plan) for plan, _ in composed}) == 1
        assert [seed for _, seed in composed] == [5, 5 + 2**30, 5 + 2**31]


def test_scenes_are_generated_by_the_whole_pipeline(monkeypatch) -> None:
    asked = []
    sound, failed = (Report(0.0, 0.0, 0.0, failures=f)
                     for f in ((), (Failure("fell", ("it",)),)))  # fmt: skip

    def generate(what: str | ScenePlan, seed: int) -> types.SimpleNamespace:
        asked.append((what, seed))
        report = failed if len(asked) == 1 else sound
        return types.SimpleNamespace(scene=toy_scene().replace(report=report))

    module = types.ModuleType("generator.pipeline")
    module.generate = generate  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "generator.pipeline", module)
    source = FreshScenes("a desk", making="generate")
    ref = source.draw(np.random.default_rng(0))
    assert not asked
    assert ref.load().report is sound  # the first was not
    assert [what for what, _ in asked] == ["a desk", "a desk"]
    asked.clear()
    FreshScenes(LAB, making="generate").draw(np.random.default_rng(0)).load()
    assert isinstance(asked[0][0], ScenePlan)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"prompts": ()}, "one or more non-empty prompts"),
        ({"prompts": ["a desk", " "]}, "one or more non-empty prompts"),
        ({"prompts": [5]}, "one or more non-empty prompts"),
        ({"variants": 0}, "from 1 to 2"),
        ({"variants": 2**30 + 1}, "from 1 to 2"),
        ({"making": "composed"}, "Did you mean 'compose'"),
        ({"making": "no_module:make"}, "No module named 'no_module'"),
        ({"making": "makers:no_function"}, "no attribute 'no_function'"),
    ],
)
def test_wrong_settings_are_explained(settings, message) -> None:
    with pytest.raises(InputError, match=message):
        FreshScenes(**settings)


def test_texts_can_be_checked_before_anything_is_made() -> None:
    FreshScenes(["a desk", "a lab bench"]).check()
    FreshScenes("ein Tisch mit Tassen", making="makers:toy").check()  # who knows what it reads
    with pytest.raises(InputError, match="English"):
        FreshScenes(["a desk", "ein Tisch mit einer Tasse und einem Buch"]).check()
