"""The paper's Table 3: the contribution of DRO and TSA, measured by ablation (Sec. 4.3).

    python benchmarks/ablation.py --split test --cases 12

Composes tables, draws each, and passes only the picture to ``generator.pipeline.generate``: in
full, with and without the joint refinement, and with ``Config.without`` DRO, TSA, or both. Queries
that the variants share (segmentation, completion, models) run once per scene. Each object is
compared with the truth as placed; collisions are measured before and after separation.

Each split has its own catalogue variants and random numbers: develop on "dev", report "test". Rows
are written to ``ablation_<split>.csv`` as scenes finish (a second run resumes), then the table to
``ablation_<split>.md`` and the scenes ``--sheet`` as placed, seen from the picture's camera, to
``ablation_<split>.png``; the pictures of all scenes go to ``--pictures``/ablation_<split>/. With
``--text`` every scene has that text, which is appended to the file names.
"""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from posing import ablations
from posing.cases import STREAMS
from posing.tables import alone, command_line

from generator.errors import TabletopError
from generator.io.pictures import write_picture

HERE = Path(__file__).parent


def main() -> None:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument("--cases", type=int, default=12)
    p.add_argument("--split", choices=tuple(STREAMS), default="dev")
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--text", default="", help="text of every scene; by default themes")
    p.add_argument("--workers", type=int, default=1)
    p.add_argument("--sheet", type=int, nargs="*", default=(0, 1, 2), help="scenes on the sheet")
    p.add_argument("--note", default="", help="observations, printed below the table")
    p.add_argument(
        "--pictures",
        type=Path,
        default=HERE.parent / "out",
        help="folder for the pictures of all scenes",
    )
    p.add_argument("--out", type=Path, default=HERE / "results")
    args = p.parse_args()
    if args.cases < 1 or args.workers < 1:
        raise SystemExit("--cases and --workers must be at least 1.")
    alone()
    name = f"ablation_{args.split}" + (f"_seed{args.seed}" if args.seed != 1 else "")
    if args.text:
        name += "_" + "_".join(re.findall(r"\w+", args.text.lower()))[:40]
    how = ablations.AblationRun(args.split, args.seed, args.pictures / name, args.text)
    try:
        args.out.mkdir(parents=True, exist_ok=True)
        table = args.out / f"{name}.csv"
        text = ablations.run(
            how, args.cases, args.workers, table, command_line("--note"), args.note
        )
        shown = ablations.sheet(args.sheet, how.strips)
        if shown is not None:
            write_picture(shown, args.out / f"{name}.png")
    except TabletopError as error:
        raise SystemExit(str(error)) from error
    (args.out / f"{name}.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
