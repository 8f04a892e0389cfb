"""Speed of the pages in Chromium, and agreement of their physics with MuJoCo.

    python benchmarks/pages.py
    python benchmarks/pages.py --scenes coffee-oval --rounds 1

A page of the shipped tables is written and served from this machine. For each table a fresh browser
opens its address: "first" is the time from the start of the navigation until the scene is simulated
and drawn, with empty caches; "again" is the same a second time in that browser. Then the table is
simulated for two seconds there and in Python, and positions and rotations are compared. The gallery
is shown with 200 entries and searched word by word. Times are medians over the rounds; the browser
renders in software. The table is written to ``pages.md``.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np
from browsing.chromium import CHROMIUM, ENGINE, launch, serve
from posing import tables

import assets_cache
from generator.bundle import load
from tabletopgen_web.frontend import static_folder
from tabletopgen_web.page.options import FolderOptions
from tabletopgen_web.page.site import GALLERY, write_site

if TYPE_CHECKING:
    from playwright.sync_api import Playwright

HERE = Path(__file__).parent

SHIPPED = ("starter", "kitchen-task-*", "coffee-table-task-*", "tidy-task-*")

STEPS = 1000
"""Number of 2 ms steps that are simulated in both."""

ENTRIES = 200
"""Number of entries of the searched gallery."""

_READY = "() => [...(window.tabletopgen?.values() ?? [])].some(e => e.ready.value)"
_NOW = "() => performance.now()"  # since the navigation began
SEARCH = """async () => {
  const field = document.querySelector('input[type=search]');
  const times = [];
  for (const words of ['t', 'ta', 'table 1', 'table 19', 'table 199', '']) {
    const begun = performance.now();
    field.value = words;
    field.dispatchEvent(new Event('input', { bubbles: true }));
    await new Promise(requestAnimationFrame);
    await new Promise(requestAnimationFrame);
    times.push(performance.now() - begun);
  }
  return times;
}"""


def time_scene(play: Playwright, site: str, scene: str) -> tuple[float, float, Any]:
    """Return the seconds of the first and of a later opening, and qpos after ``STEPS``."""
    browser = launch(play)
    page = browser.new_page()
    page.goto(f"{site}#/scene/{scene}")
    page.wait_for_function(_READY, timeout=60_000)
    first = page.evaluate(_NOW)
    page.goto(f"{site}?again#/scene/{scene}")
    page.wait_for_function(_READY, timeout=60_000)
    again = page.evaluate(_NOW)
    page.evaluate(f"{ENGINE}.run(false)")
    page.evaluate(f"{ENGINE}.reset()")
    qpos = page.evaluate(f"{ENGINE}.advance({STEPS})")["qpos"]
    browser.close()
    return first / 1e3, again / 1e3, np.array(qpos)


def simulate(bundle: Path) -> Any:
    """Return qpos after ``STEPS`` of MuJoCo in Python."""
    model = mujoco.MjModel.from_xml_path(str(bundle / "scene.xml"))
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    for _ in range(STEPS):
        mujoco.mj_step(model, data)
    return data.qpos


def apart(one: Any, other: Any) -> tuple[float, float]:
    """Return the maximum difference of free bodies' poses, micrometres and degrees."""
    a, b = one.reshape(-1, 7), other.reshape(-1, 7)
    far = float(np.linalg.norm(a[:, :3] - b[:, :3], axis=1).max())
    turn = 2 * np.arccos(np.clip(np.abs((a[:, 3:] * b[:, 3:]).sum(1)), 0, 1)).max()
    return 1e6 * far, float(np.degrees(turn))


def time_search(play: Playwright, folder: Path, site: str) -> list[float]:
    """Return the milliseconds of searches in a gallery of ``ENTRIES`` entries."""
    listed = json.loads((folder / GALLERY).read_text(encoding="utf-8"))
    rows = listed["scenes"]
    many = [{**rows[k % len(rows)], "id": f"table-{k}", "name": f"table {k}"}
            for k in range(ENTRIES)]  # fmt: skip
    (folder / GALLERY).write_text(json.dumps({**listed, "scenes": many}), encoding="utf-8")
    browser = launch(play)
    page = browser.new_page()
    page.goto(site)
    page.locator("a.card").first.wait_for()
    times = page.evaluate(SEARCH)
    browser.close()
    (folder / GALLERY).write_text(json.dumps(listed), encoding="utf-8")
    return times


def summary(rows: Sequence[Sequence[Any]], searches: Sequence[float], sizes: Sequence[str]) -> str:
    """Return the table."""
    lines = [
        "# The pages in Chromium",
        f"`{tables.command_line('--out')}`, {tables.where()}",
        "",
        *sizes,
        f"- a gallery of {ENTRIES} entries is searched and drawn in {np.median(searches):.0f} ms "
        f"(median), at most {max(searches):.0f} ms",
        "",
        "| table | objects | first, s | again, s | position difference, µm | rotation "
        "difference, ° |",
        "|---|---|---|---|---|---|",
    ]
    for name, objects, first, again, far, turn in rows:
        lines.append(f"| {name} | {objects} | {first:.2f} | {again:.2f} | {far:.3g} | {turn:.2g} |")
    figures = np.array([row[2:] for row in rows])
    for word, of in (("median", np.median), ("largest", np.max)):
        first, again, far, turn = of(figures, axis=0)
        lines.append(f"| **{word}** | | {first:.2f} | {again:.2f} | {far:.3g} | {turn:.2g} |")
    return "\n".join([*lines, ""])


def main() -> None:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument("--scenes", nargs="+", default=[*SHIPPED], help="names or globs of bundles")
    p.add_argument("--rounds", type=int, default=3)
    p.add_argument("--out", type=Path, default=HERE / "results")
    args = p.parse_args()
    if args.rounds < 1 or CHROMIUM is None:
        raise SystemExit("--rounds must be at least 1, and Chromium installed.")
    from playwright.sync_api import sync_playwright

    bundles = [path for name in args.scenes for path in assets_cache.find(name)]
    rows: list[tuple[Any, ...]] = []
    searches: list[float] = []
    with tempfile.TemporaryDirectory() as scratch, sync_playwright() as play:
        written = write_site(bundles, Path(scratch) / "site", options=FolderOptions())
        with serve(written.path) as site:
            for bundle in bundles:
                timed = [time_scene(play, site, bundle.name) for _ in range(args.rounds)]
                first, again = (float(np.median([t[k] for t in timed])) for k in (0, 1))
                far, turn = apart(timed[0][2], simulate(bundle))
                rows.append((bundle.name[:-13], len(load(bundle).objects), first, again, far, turn))
                print(*rows[-1], file=sys.stderr, flush=True)
            for _ in range(args.rounds):
                searches += time_search(play, written.path, site)
    built = sum(f.stat().st_size for f in static_folder().rglob("*") if f.is_file())
    sizes = [
        f"- the front end has {built / 1e6:.1f} MB, the page of {len(bundles)} tables with "
        f"exports and episodes {written.bytes / 1e6:.1f} MB",
    ]
    text = summary(rows, searches, sizes)
    args.out.mkdir(parents=True, exist_ok=True)
    (args.out / "pages.md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
