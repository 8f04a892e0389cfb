"""Records the categories that pass: ``TABLETOPGEN_RECORD_PROOFS=1`` rewrites ``proven.json``."""

import os

import pytest


class Recorder:
    """Collects reports of categories in the process that receives all of them."""

    def __init__(self) -> None:
        self.passed: dict[str, str] = {}
        self.failed: set[str] = set()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        facts = dict(report.user_properties)
        key, proof = facts.get("category"), facts.get("proof")
        if report.failed and isinstance(key, str):
            self.failed.add(key)
        elif report.when == "call" and report.passed and isinstance(proof, str):
            self.passed[str(key)] = proof

    def pytest_sessionfinish(self) -> None:
        import proofs

        if self.passed or self.failed:
            proofs.record(self.passed, self.failed)


def pytest_configure(config: pytest.Config) -> None:
    worker = hasattr(config, "workerinput")
    if os.environ.get("TABLETOPGEN_RECORD_PROOFS") and not worker:
        config.pluginmanager.register(Recorder(), "proofs")
