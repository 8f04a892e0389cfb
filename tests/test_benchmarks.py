"""The benchmark scripts' own logic: names compared, interrupted tables resumed, pictures paired."""

import dataclasses
import importlib.util
import json
import subprocess
import sys
from pathlib import Path
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.bundle import save
from generator.composition import compose
from generator.errors import InputError
from generator.scene import PlannedObject, PlannedTable, Scene, ScenePlan
from tabletopgen_env.certificates.certificate import Certificate, Terms
from tabletopgen_env.certificates.certificate import TaskInstance as Seen
from tabletopgen_env.env import make_env


def script(name: str) -> ModuleType:
    path = Path(__file__).parents[1] / "benchmarks" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(f"benchmark_{name}", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def built(*labels: str) -> Scene:
    size = (0.05, 0.05, 0.05)
    things = [toy_object(f"{w}_{k}", size, (0.1 * k, 0)) for k, w in enumerate(labels)]
    asked = ("mug", "mug", "smartphone", "generic")
    nouns = ("mug", "cup", "phone", "zorb")
    plan = ScenePlan(
        "four things",
        PlannedTable(),
        tuple(
            PlannedObject(f"{c}_{k}", n, c)
            for k, (c, n) in enumerate(zip(asked, nouns, strict=True))
        ),
    )
    return toy_scene(tuple(things)).replace(plan=plan)


@pytest.mark.parametrize(
    ("labels", "expected"),
    [
        (("mug", "coffee mug", "phone", "zorb"), 4),
        (("mug", "phone", "phone", "object"), 2),
        (("zorb", "mug", "mug", "mug"), 3),
        (("object",), 0),
    ],
)
def test_names_are_compared_by_what_they_mean(labels: tuple[str, ...], expected: int) -> None:
    assert script("end_to_end").count_named(built(*labels)) == expected


def test_a_table_of_an_older_version_gets_the_new_columns(tmp_path: Path) -> None:
    bench = script("end_to_end")
    table = tmp_path / "compose.csv"
    table.write_text("text,seed,published,planned,built\na mug,0,1,1,1\n")
    rows = bench.resume(table)
    assert [(r["text"], r["built"]) for r in rows] == [("a mug", "1")]
    again = bench.resume(table)
    assert list(again[0]) == list(bench.FIELDS)
    assert again[0]["named"] == ""
    assert bench.resume(tmp_path / "none.csv") == []


def test_the_summary_reports_names_of_the_rows_that_have_them() -> None:
    bench = script("end_to_end")
    row = {"published": 1, "planned": 4, "built": 4, "penetration_mm": 0, "drift_mm": 0,
           "tilt_deg": 0, "floating": 0, "fallen": 0, "seconds": 1}  # fmt: skip
    text = bench.summary([row | {"named": 4}, row | {"named": 3}, row], "compose", "bench")
    assert "| planned names = built names | 50.0 % of scenes, 87.5 % of objects |" in text
    assert "| planned names = built names | - |" in bench.summary([row], "compose", "bench")


def test_pictures_find_their_depth_and_intrinsics(tmp_path: Path) -> None:
    bench = script("pictures")
    for name in ("desk_color.png", "desk_depth.png", "table.jpg", "notes.txt"):
        (tmp_path / name).write_bytes(b"")
    found = bench.pictures(tmp_path)
    assert [(name, depth is not None) for name, _, depth in found] == [
        ("desk", True),
        ("table", False),
    ]
    assert bench.intrinsics_of(tmp_path, None) is None
    (tmp_path / "intrinsics.json").write_text('{"fx": 600, "fy": 601, "cx": 320, "cy": 240}')
    assert bench.intrinsics_of(tmp_path, None) == {"fx": 600, "fy": 601, "cx": 320, "cy": 240}
    assert bench.intrinsics_of(tmp_path, [1, 2, 3, 4])["cy"] == 4


def test_seconds_per_stage_are_summed_up() -> None:
    bench = script("efficiency")
    rows = []
    for number, rotation in enumerate((4.0, 6.0, 8.0)):
        row = dict.fromkeys(bench.FIELDS, 0.0) | {"text": f"desk {number}", "error": "", "built": 8}
        row |= {"wall_rotation": rotation, "wall_modeling": 10.0, "cpu_rotation": 5.0}
        rows.append(row | {"wall_total": 10 + rotation, "cpu_total": 5.0})
    failed = dict.fromkeys(bench.FIELDS, "") | {"text": "a lab", "error": "no table"}
    text = bench.summary([*rows, failed], "bench", "busy")
    assert "# Seconds per stage: 3 texts" in text
    assert "; busy" in text
    assert "| rotation | 6.0 | 7.6 | 38 % | 5.0 | ≈ 810 |" in text
    assert "| **all** | 16.0 | 17.6 | 100 % | 5.0 | ≈ 1920 |" in text
    assert "8.0 objects per scene (median), 2.0 s per object." in text
    assert "- 'a lab' failed: no table" in text
    assert bench.bars([*rows, failed]).shape > bench.bars(rows[:1]).shape
    assert "| **all** | - | - |" in bench.summary([failed], "bench")


def test_texts_are_taken_by_their_plans_count() -> None:
    bench = script("efficiency")
    found = bench.texts_of(bench.HERE / "table78.json", 5, 0)
    assert len(found) == 5
    assert found == bench.texts_of(bench.HERE / "table78.json", 9, 0)[:5]
    assert all(bench.FEWEST <= count <= bench.MOST for _, count in found)


@pytest.mark.slow
def test_soundness_is_that_of_the_saved_bundle(tmp_path: Path) -> None:
    bench = script("soundness")
    sides = (0.05, 0.05, 0.05)
    apart = (toy_object("mug_1", sides, (0.0, 0.0)), toy_object("mug_2", sides, (0.2, 0.0)))
    sound = bench.measure(save(toy_scene(apart), tmp_path, allow_failed=True))
    assert (sound["objects"], sound["pairs"], sound["published"]) == (2, 1, 1)
    assert not sound["colliding"] and not sound["unstable"] and not sound["error"]
    close = (apart[0], toy_object("mug_2", sides, (0.03, 0.0)))
    faulty = bench.measure(save(toy_scene(close), tmp_path, allow_failed=True))
    assert faulty["colliding"] == 1 and faulty["overlap_mm"] == pytest.approx(20.0, abs=0.5)
    assert "plain: mug_1, mug_2" in faulty["unstable"]
    key = {"text": "mugs", "seconds": 1.0}
    failed = dict.fromkeys(bench.FIELDS, "") | {"published": 0, "error": "no room"} | key
    rows = [sound | key | {"seed": 0}, faulty | key | {"seed": 1}, failed | {"seed": 2}]
    text = bench.summary(rows, "compose", "bench")
    assert "| published | 2 / 3 |" in text
    assert "overlap by more than 0.5 mm | 50.00 % (1 of 2) |" in text
    assert "| scenes without any of these faults | 1 / 3 |" in text
    assert "- 'mugs' seed 2: no room" in text


def test_rotation_speed_shows_wall_and_cpu_seconds() -> None:
    text = script("rotation_speed").table(np.array([[1.0, 0.5], [3.0, 0.7], [2.0, 0.6]]), "head")
    assert "| wall | 3 | 2.00 | 2.00 | 2.80 | 3.00 |" in text
    assert "| CPU | 3 | 0.60 | 0.60 | 0.68 | 0.70 |" in text


def test_speeds_are_compared_as_ratios_to_the_first_peer() -> None:
    bench = script("speed")
    rates = {"FetchPickAndPlace-v4": 20.0, "ours": 50.0}
    rows = [
        bench.row("stepping", name, kind, rate, "per s")
        for name, rate in rates.items()
        for kind in ("wall", "cpu", "reset")
    ]
    text = bench.summary(rows, "python benchmarks/speed.py", "shared")
    assert "| ours | 2.50 | 2.50 | 50.0 | 50.0 | 50 |" in text and "shared" in text
    assert text.index("ratio, clock") < text.index("per second, clock")


def test_renewing_costs_what_the_median_round_loses() -> None:
    parts = script("speed").parts
    fixed = [{"steps": 100.0, "with resets": 80.0}] * 2 + [{"steps": 900.0, "with resets": 9.0}]
    renewed = [{"steps": 95.0, "with resets": 60.0}, {"steps": 1.0, "with resets": 60.0}] * 2
    found = parts.compare({"fixed": fixed, "renewed": [renewed[0], *renewed[:2]]})
    costs = {kind: (value, unit) for what, kind, value, unit in found if what.startswith("cost")}
    assert costs == {"steps": (pytest.approx(5.0), "%"), "with resets": (pytest.approx(25.0), "%")}
    assert ("fixed tables", "steps", 100.0, "steps per s") in found


@pytest.mark.slow
def test_renewed_tables_are_timed_beside_fixed_ones(monkeypatch: pytest.MonkeyPatch) -> None:
    parts = script("speed").parts
    for name, value in {"TABLES": 1, "ROUNDS": 1, "ROUND": 0.05, "PAUSE": 0.0}.items():
        monkeypatch.setattr(parts, name, value)
    found = parts.refreshing(compose("a mug on a desk", seed=0), 0)
    rates = {what: value for what, kind, value, _ in found if kind == "with resets, clock"}
    assert rates["fixed tables"] > 0 and rates["renewed tables"] > 0
    assert rates["cost of renewing"] == pytest.approx(
        100 * (1 - rates["renewed tables"] / rates["fixed tables"])
    )
    alone = {what: value for what, kind, value, _ in found if kind == "steps, clock"}
    assert alone["fixed tables"] >= rates["fixed tables"]


@pytest.mark.slow
def test_memory_is_watched_from_when_caches_are_full(monkeypatch: pytest.MonkeyPatch) -> None:
    parts = script("speed").parts
    sizes = iter(100.0 + k for k in range(99))
    small = {"STARTER": [toy_scene()], "WARM": 3, "TABLES": 1, "_resident": lambda: next(sizes)}
    for name, value in small.items():
        monkeypatch.setattr(parts, name, value)
    found = parts.memory(compose("a mug on a desk", seed=0), 20)
    first = [row[1:] for row in found if row[0] == "cached scenes"]
    after = [(f"after {k} resets", 100.0 + n, "MB") for n, k in enumerate(range(3, 24, 4))]
    assert first == [*after, ("growth from 3 resets on", pytest.approx(5.0), "%")]
    growing = [what for what, setting, *_ in found if setting == "growth from 3 resets on"]
    assert len(growing) == len(set(growing)) == 4
    assert {"cached scenes, randomised", "tables renewed every 4 resets"} < set(growing)


def test_a_soak_counts_what_goes_wrong() -> None:
    bench = script("soak")
    env = make_env(toy_scene((toy_object("pen_1", (0.02, 0.02, 0.05), (0.0, 0.0)),)))
    row = dict.fromkeys(bench.FIELDS, 0)
    bench.soak(env, np.random.default_rng(0), 20, row)
    assert row["done"] == 20 and not any(row[k] for k in bench.COUNTS)
    env.world.teleport("pen_1", np.array([0.0, 2.0, 0.03]))
    env.world.step(500)
    assert bench.beside(env.world) == {"pen_1"} == set(env.world.off_table())
    env.world.teleport("pen_1", np.array([0.0, 2.0, -3.0]))
    assert bench.find_escaped(env.world) == ["pen_1"]
    env.world.teleport("pen_1", np.array([np.nan, 0.0, 1.0]))
    env.reset = lambda seed: None
    bench.soak(env, np.random.default_rng(0), 1, row)
    assert row["warnings"] > 0


def test_a_soak_of_shards_looks_at_each_slot() -> None:
    bench = script("soak")
    env = make_env(toy_scene((toy_object("pen_1", (0.02, 0.02, 0.05), (0.0, 0.0)),)))
    env.reset(seed=0)
    look = bench.sharded.look
    assert not any(look(env).values())
    env.world.teleport("pen_1", np.array([0.0, 2.0, -3.0]))
    assert look(env) | {"unnoticed": 0} == {
        "not_finite": 0, "warnings": 0, "unnoticed": 0, "escaped": 1, "fell": 1
    }  # fmt: skip
    env.world.data.qvel[:] = np.nan
    assert look(env)["not_finite"] == 1


@pytest.mark.slow
def test_a_soak_of_shards_watches_their_memory(tmp_path: Path) -> None:
    path = Path(__file__).parents[1] / "benchmarks" / "soak.py"
    words = ["--steps", "44", "--scenes", "1", "--processes", "2", "--slots", "2"]
    command = [sys.executable, str(path), *words, "--out", str(tmp_path)]
    said = subprocess.run(command, capture_output=True, text=True, check=True, timeout=200).stdout
    assert "# Soak: 44 random steps in 2 processes" in said
    rows = (tmp_path / "soak_shards.csv").read_text().splitlines()
    assert len(rows) == 2 and rows[0].endswith(",shards_mb") and float(rows[1].split(",")[-1]) > 50
    assert (tmp_path / "soak_shards.md").read_text().startswith("# Soak")


def test_other_packages_are_timed_without_this_one() -> None:
    code = (Path(__file__).parents[1] / "benchmarks" / "pace" / "episodes.py").read_text()
    assert not any(name in code for name in ("generator", "tabletopgen", "posing"))
    command = [sys.executable, "-c", code, "gymnasium", "CartPole-v1", "50"]
    told = subprocess.run(command, capture_output=True, text=True, check=True, timeout=300).stdout
    seen = json.loads(told)
    assert set(seen) == {"wall", "cpu", "reset"} and seen["wall"] > 0


def test_the_expert_is_never_developed_on_held_out_scenes() -> None:
    bench = script("expert")
    shown = bench.composed_scenes("Lift", 60, held_out=False)
    kept = bench.composed_scenes("Lift", 60, held_out=True)
    assert len(set(shown)) == len(set(kept)) == 60
    assert not {text for text, _ in shown} & {text for text, _ in kept}
    assert min(seed for _, seed in kept) >= bench.HELD_OUT > max(seed for _, seed in shown)
    presets = bench.composed_scenes("Sequence:kitchen", 3, held_out=True)
    (kitchen,) = bench.OWN["Sequence:kitchen"]
    assert presets == [(kitchen, bench.HELD_OUT + k) for k in range(3)]
    tidy = [bench.composed_scenes("Tidy", 40, held_out) for held_out in (False, True)]
    assert len({*tidy[0], *tidy[1]}) == 80
    assert {text for text, _ in tidy[1][:7]} == set(bench.OWN["Tidy"])
    assert max(s for _, s in tidy[0]) < bench.HELD_OUT <= min(s for _, s in tidy[1])


@pytest.mark.slow
def test_a_baseline_is_trained_once_and_played_at_tables_of_its_own(tmp_path) -> None:
    bench = script("baselines")
    recipe = tmp_path / "tiny.toml"
    recipe.write_text(
        """
        task = "Reach"
        algorithm = "clone"
        scenes = "coffee-square"
        held_out = "lab"
        network = { layers = [8] }
        cloning = { rounds = 1, episodes = 1, steps = 2, last_steps = 2 }
        """
    )
    (row,) = bench.work((str(recipe), 3), tmp_path, episodes=1, validation=1)
    assert (row["seed"], row["episodes"], row["tables"]) == (3, 1, 1)
    kept = (tmp_path / "tiny-3" / "policy.safetensors").read_bytes()
    assert bench.work((str(recipe), 3), tmp_path, episodes=1, validation=1) == [row]
    assert (tmp_path / "tiny-3" / "policy.safetensors").read_bytes() == kept
    told = bench.summary([row | {"recipe": "tiny", "solved": 1}], "bench", "")
    assert "| 1 of 1 | 100.0 % | 21 to 100 % |" in told
    assert "| `tiny` | 1 | 100.0 % | 100.0 to 100.0 % |" in told


def test_a_run_of_an_older_recipe_is_not_taken_for_one_of_this(tmp_path, monkeypatch) -> None:
    bench = script("baselines")
    recipe = bench.recipe_named("lift-clone")
    old = dataclasses.replace(recipe, env={"grasp_hint": True})
    (tmp_path / "lift-clone-0").mkdir()
    monkeypatch.setattr(bench, "open_run", lambda _: SimpleNamespace(recipe=old))
    with pytest.raises(InputError, match="another recipe lift-clone; move it away"):
        bench.train_baseline("lift-clone", 0, tmp_path, 1)


def test_rows_say_by_which_detector_they_were_played() -> None:
    bench = script("baselines")
    kinds = {name: bench.hint_of(name) for name in ("reach-clone", "rule-lift", "lift-clone")}
    assert kinds["reach-clone"] == "" and kinds["rule-lift"] == kinds["lift-clone"]
    assert kinds["lift-clone"] == f"detected {bench.shipped_digest()}"
    assert bench.hint_of("rule-lift-planned") == bench.hint_of("lift-clone-planned") == "planned"


def test_a_baseline_that_was_cut_off_is_trained_anew(tmp_path, monkeypatch) -> None:
    bench = script("baselines")

    def cut_off(recipe, out, plan, resume):
        out.mkdir(parents=True, exist_ok=resume)
        (out / "policy.safetensors").touch()
        return SimpleNamespace(interrupted=True)

    monkeypatch.setattr(bench, "train", cut_off)
    for _ in range(2):
        with pytest.raises(KeyboardInterrupt):
            bench.train_baseline("reach-clone", 0, tmp_path, 1)
    assert [path.name for path in tmp_path.iterdir()] == ["reach-clone-0.part"]


@pytest.mark.parametrize("lets_go", [False, True])
def test_the_rule_goes_where_the_hint_points(lets_go: bool) -> None:
    rule = script("baselines").HintRule(lets_go)
    seen = np.zeros(287, np.float32)
    seen[-8:] = [0.1, 0.0, -0.1, 0.0, 0.06, 0.03, 0.0, 1.0]
    away = rule.predict(seen, deterministic=True)[0]
    assert away[0] == 1.0 and away[4] > 0.0
    seen[-8:-5] = 0.0
    assert rule.predict(seen, deterministic=True)[0][4] == -1.0, "there: it closes"
    seen[-1] = -1.0
    assert (rule.predict(seen, deterministic=True)[0][4] > 0.0) == lets_go


def test_the_expert_summary_counts_what_was_run() -> None:
    bench = script("expert")
    row = dict.fromkeys(bench.FIELDS, "") | {
        "task": "Push", "scene": "a desk", "seed": 0, "episode": 0, "success": 1, "steps": 50,
        "phase": "retreat", "category": "mug",
    }  # fmt: skip
    failed = row | {"episode": 1, "success": 0, "phase": "stroke", "steps": 120}
    empty = row | {"scene": "a shelf", "success": "", "error": "nothing to do"}
    text = bench.summary([row, failed, empty], "bench")
    assert "# Expert: 1 of 2 episodes" in text
    assert "| Push | 1 of 2 | 50.0 % | 9 to 91 % | 1 | 50 | 1 of 2 |" in text
    assert "| Push | stroke 1 |" in text and "| Push | mug 1 of 2 |" in text


@pytest.mark.slow
def test_the_experts_episodes_differ_where_there_is_one_thing_to_do() -> None:
    bench = script("expert")
    rows = bench.work(bench.EpisodesJob("Lift", "A die.", 0, 2), composed=True)
    assert [r["success"] for r in rows] == [1, 1]
    assert len({r["instruction"] for r in rows}) == 1 and len({r["start"] for r in rows}) == 2
    assert rows == bench.work(bench.EpisodesJob("Lift", "A die.", 0, 2), composed=True)


def test_a_table_without_anything_to_do_is_a_row() -> None:
    bench = script("expert")
    rows = bench.work(bench.EpisodesJob("Swap", "A die.", 0, 2), composed=True)
    assert [(r["success"], r["rows"]) for r in rows] == [("", 1)]
    assert "no valid target" in rows[0]["error"]
    assert bench.say(rows) == "Swap at 'A die.' seed 0: nothing to do"


def test_batches_are_compared_with_the_first_one() -> None:
    bench = script("batch")
    one = bench.BatchRun("processes", 1, 1, 60.0, 2, frozenset({"a", "b"}))
    two = bench.BatchRun("processes", 2, 1, 30.0, 2, frozenset({"a", "c"}))
    rows = bench.table([one, two], "head").splitlines()[-2:]
    assert rows == [
        "| processes | 1 | 1 | 2 | 60.0 | 2.0 | 1.00 | yes |",
        "| processes | 2 | 1 | 2 | 30.0 | 4.0 | 2.00 | NO |",
    ]


def test_the_share_of_a_pool_is_that_of_the_same_work() -> None:
    parallel = script("parallel")
    one = parallel.ParallelRow((8.0, 10.0, 7.0), (7.0, 7.0, 7.0), 40.0)
    many = parallel.ParallelRow((2.0, 2.5, 1.0), (1.0, 2.5, 1.0), 20.0)
    lines = parallel.table(one, many, 8, "head").splitlines()
    assert "| completing and modelling | 18.0 | 4.5 | 0.25 |" in lines
    assert "| the same, while a server was at work | 14.0 | 3.5 | 0.25 |" in lines
    assert "| whole scene | 40.0 | 20.0 | 0.50 |" in lines


def test_calls_that_overlap_count_once() -> None:
    calls = [("model", 0.0, 2.0), ("model", 1.0, 3.0), ("model", 1.5, 1.7), ("model", 5.0, 6.0)]
    assert script("parallel").at_work([*calls, ("draw", 3.0, 5.0)], "model") == 4.0


def test_certificates_are_held_against_starts_of_another_seed(tmp_path, monkeypatch) -> None:
    bench = script("certificates")
    seen = [Seen("Lift", "a_1", None, 30, 30), Seen("Lift", "b_1", None, 31, 31),
            Seen("Push", "a_1", "spot", 29, 30)]  # fmt: skip
    made = Certificate("0" * 64, Terms(("Lift", "Push")), {}, tuple(seen))
    monkeypatch.setattr(bench, "certificate_of", lambda bundle: made)
    again = [
        dataclasses.replace(i, successes=k, episodes=10)
        for i, k in zip(seen, (10, 8), strict=False)
    ]
    monkeypatch.setattr(bench, "played_again", lambda *_: iter(again))
    with pytest.raises(InputError, match="certified with seed 0"):
        list(bench.jobs([tmp_path], seed=0, starts=10))
    (job,) = bench.jobs([tmp_path], seed=7, starts=10)
    assert job.task == "Lift", "what is not certified is not played"
    rows = bench.work(job)
    assert [(r["target"], r["solved"], bench.holds(r)) for r in rows] == [
        ("a_1", 10, True), ("b_1", 8, False),
    ]  # fmt: skip
    assert bench.is_current(job, rows) and not bench.is_current(job, rows[:1])
    text = bench.summary(rows, [tmp_path], "bench")
    assert "1 of 2 certified instances hold" in text and "18 of 20 attempts" in text
    assert "| Lift | b_1 |  | 31 of 31 | 8 of 10 (does not hold) |" in text


def test_a_curriculum_is_compared_with_uniform_scenes_episode_by_episode() -> None:
    bench = script("curriculum")

    def row(mode: str, seed: int, each: list[int]) -> dict[str, object]:
        return {
            "recipe": "reach-sac", "changes": "steps=100", "variants": 9, "episodes": 4,
            "mode": mode, "seed": seed, "minutes": "0.1", "solved": sum(each),
            "each": json.dumps(each),
        }  # fmt: skip

    rows = [
        row("uniform", 0, [0, 0, 1, 1]), row("curriculum", 0, [1, 0, 1, 1]),
        row("uniform", 1, [0, 1, 0, 1]), row("curriculum", 1, [1, 1, 0, 0]),
        row("uniform", 2, [1, 1, 1, 1]),
    ]  # fmt: skip
    assert bench.differences(rows).tolist() == [[1, 0, 0, 0], [1, 0, 0, -1]]
    low, high = bench.interval(bench.differences(rows))
    assert low < 0.125 < high and low >= -0.5
    assert "| `reach-sac` | steps=100 | 2 | +12.5 points |" in bench.summary(rows, "command", "")


@pytest.mark.slow
def test_both_ways_of_drawing_scenes_can_be_trained_and_played() -> None:
    bench = script("curriculum")
    recipe = dataclasses.replace(bench.recipe_named("reach-sac"), steps=20, variants=3)
    for mode in bench.MODES:
        [row] = bench.work((mode, 0), recipe, "", 2)
        assert (row["mode"], row["episodes"], len(json.loads(row["each"]))) == (mode, 2, 2)


@pytest.mark.parametrize(("more", "measured"), [((), True), (("--resume",), False)])
def test_parity_measures_again_unless_it_resumes(
    more: tuple[str, ...], measured: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    parity = script("parity")
    row = dict.fromkeys(parity.FIELDS, "") | {
        "bundle": "vanity", "engine": "MuJoCo", "objects": "4", "drift_mm": "0.5", "angle": "27.0",
    }  # fmt: skip
    parity.tables.write(tmp_path / "parity.csv", parity.FIELDS, [row])
    monkeypatch.setattr(parity.tables, "alone", lambda: None)
    monkeypatch.setattr(parity, "work", lambda job: [row | {"drift_mm": "0.25"}])
    monkeypatch.setattr(
        sys, "argv",
        ["parity.py", "--bundles", "vanity", "--engines", "MuJoCo", "--out", str(tmp_path), *more],
    )  # fmt: skip
    with pytest.raises(SystemExit) as ended:
        parity.main()
    assert ended.value.code == 0
    assert ("0.25" in (tmp_path / "parity.csv").read_text()) == measured
    assert ("0.25 mm" in (tmp_path / "parity.md").read_text()) == measured
