"""The success criterion of an episode."""

from tabletopgen_env.episodes import HOLD, Held


def test_success_has_to_hold_without_a_break() -> None:
    held = Held(3)
    seen = [held.after({"success": s}) for s in (True, True, False, True, True, True, True, False)]
    assert seen == [False] * 5 + [True, True, False]


def test_unless_told_otherwise_it_holds_for_ten_steps() -> None:
    held = Held()
    assert [held.after({"success": True}) for _ in range(HOLD)] == [False] * 9 + [True]
