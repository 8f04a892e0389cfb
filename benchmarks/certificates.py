"""Certificates tested with new starts: solved attempts of each certified instance.

    python benchmarks/certificates.py --workers 2

Every instance in a bundle's certificate is played by the scripted expert from starts
(``randomization="starts"``) drawn with another seed than the certificate's; no attempt is skipped.
An instance holds if the share of solved attempts is at least ``HOLDS``. Rows are written to
``certificates.csv`` as they finish (a second run resumes; instances with a new certificate are
played again), the table to the corresponding ``.md``. The exit code is nonzero if an instance does
not hold.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from posing import tables
from posing.tables import Row

import assets_cache
from generator.errors import InputError
from tabletopgen_env.certificates.certificate import STARTS, Certificate, read_certificate
from tabletopgen_env.certificates.certify import played_again

HERE = Path(__file__).parent
KEY = ("bundle", "task", "seed", "starts")
FIELDS = (
    *KEY, "rows", "preset", "target", "goal", "certified", "certified_of", "solved", "attempts",
)  # fmt: skip

OF = ("preset", "target", "goal", "certified", "certified_of")
"""Columns that describe the instance and its certificate."""

HOLDS = 0.9
"""Minimum share of new starts from which a certified instance must be solved."""

SHIPPED = tuple(str(HERE.parent / "assets_cache" / name / "*") for name in ("starter", "tasks"))
"""The package's bundles, as globs."""


class CertificateJob(NamedTuple):
    """The certified instances of one task at one bundle, each with ``starts`` drawn by ``seed``."""

    bundle: Path
    task: str
    seed: int
    starts: int

    @property
    def key(self) -> tuple[str, ...]:
        """Key of the job's rows."""
        return (self.bundle.name, self.task, str(self.seed), str(self.starts))


def work(job: CertificateJob) -> list[Row]:
    """Play the certified instances of a job; return a row for each."""
    instances = [i for i in certificate_of(job.bundle).certified if i.task == job.task]
    again = played_again(job.bundle, instances, job.starts, job.seed)
    return [
        dict(zip(KEY, job.key, strict=True)) | {
            "rows": len(instances),
            "preset": was.preset or "",
            "target": was.target or "",
            "goal": was.goal or "",
            "certified": was.successes,
            "certified_of": was.episodes,
            "solved": now.successes,
            "attempts": now.episodes,
        }
        for was, now in zip(instances, again, strict=True)
    ]  # fmt: skip


def certificate_of(bundle: Path) -> Certificate:
    """Return a bundle's certificate.

    Raises:
        InputError: the bundle has none.
        BundleError: it is damaged.
    """
    found = read_certificate(bundle)
    if found is None:
        raise InputError(
            f"{bundle.name} has no certificate; run python -m tabletopgen_env certify."
        )
    return found


def jobs(bundles: Sequence[Path], seed: int, starts: int) -> Iterator[CertificateJob]:
    """Yield a job for each task with a certified instance at each bundle.

    Raises:
        InputError: a certificate was made with the same seed, or there is none.
        BundleError: a certificate is damaged.
    """
    for bundle in bundles:
        certificate = certificate_of(bundle)
        if certificate.terms.seed == seed:
            raise InputError(f"{bundle.name} was certified with seed {seed}; choose another.")
        for task in dict.fromkeys(i.task for i in certificate.certified):
            yield CertificateJob(bundle, task, seed, starts)


def is_current(job: CertificateJob, rows: Sequence[Row]) -> bool:
    """Return whether rows belong to the currently certified instances."""
    now = {
        (i.preset or "", i.target or "", i.goal or "", str(i.successes), str(i.episodes))
        for i in certificate_of(job.bundle).certified
        if i.task == job.task
    }
    return {tuple(str(row[k]) for k in OF) for row in rows} == now


# ------------------------------------------------------------------------------------- reporting


def holds(row: Row) -> bool:
    """Return whether a row's instance was solved in enough attempts."""
    return int(row["solved"]) >= HOLDS * int(row["attempts"])


def say(rows: list[Row]) -> str:
    """Return the progress line of a finished job."""
    solved, attempts = (sum(int(r[k]) for r in rows) for k in ("solved", "attempts"))
    return f"{rows[0]['bundle']}, {rows[0]['task']}: {solved} of {attempts}"


def summary(rows: Sequence[Row], bundles: Sequence[Path], command: str) -> str:
    """Return the table as Markdown."""
    solved, attempts = (sum(int(r[k]) for r in rows) for k in ("solved", "attempts"))
    held = sum(map(holds, rows))
    offered = sum(len(certificate_of(bundle).instances) for bundle in bundles)
    lines = [
        f"# Certificates: {held} of {len(rows)} certified instances hold",
        f"`{command}`, {tables.where()}",
        "",
        f"{offered} instances are offered at {len(bundles)} bundles; those that the expert solved "
        f"from each of at least {STARTS} starts are certified. Here each is played from other "
        f"starts, drawn with another seed: {solved} of {attempts} attempts were solved. An "
        f"instance holds if the share is at least {HOLDS:.0%}.",
        "",
        "| bundle | task | target | goal | certified with | new starts |",
        "|---|---|---|---|---|---|",
    ]
    for row in rows:
        task = f"{row['task']}:{row['preset']}" if row["preset"] else row["task"]
        mark = "" if holds(row) else " (does not hold)"
        lines.append(
            f"| {row['bundle']} | {task} | {row['target']} | {row['goal']} "
            f"| {row['certified']} of {row['certified_of']} "
            f"| {row['solved']} of {row['attempts']}{mark} |"
        )
    return "\n".join([*lines, ""])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--bundles", action="append", help="bundles as a glob; may be repeated")
    parser.add_argument("--starts", type=int, default=10, help="attempts per instance")
    parser.add_argument("--seed", type=int, default=1000, help="seed of the starts")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--out", type=Path, default=HERE / "results")
    args = parser.parse_args()
    bundles = sorted({p.resolve() for b in args.bundles or SHIPPED for p in assets_cache.find(b)})
    args.out.mkdir(parents=True, exist_ok=True)
    path = args.out / "certificates.csv"
    asked = {job.key: job for job in jobs(bundles, args.seed, args.starts)}
    known: dict[tuple[str, ...], list[Row]] = {}
    for row in tables.resume(path, FIELDS, KEY, of="rows"):
        known.setdefault(tuple(str(row[k]) for k in KEY), []).append(row)
    done = {k for k, rows in known.items() if k in asked and is_current(asked[k], rows)}
    kept = [row for key in done for row in known[key]]
    tables.write(path, FIELDS, kept)
    rows = tables.run(
        path, FIELDS, KEY, kept, [j for k, j in asked.items() if k not in done], work,
        args.workers, say,
    )  # fmt: skip
    text = summary(rows, bundles, tables.command_line("--workers", "--out"))
    path.with_suffix(".md").write_text(text, encoding="utf-8")
    print(text)
    return 0 if all(map(holds, rows)) else 1


if __name__ == "__main__":
    raise SystemExit(main())
