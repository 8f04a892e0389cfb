"""A Ray cluster of two nodes with one CPU each, both on this machine."""

import contextlib
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from unittest.mock import patch

import pytest

TESTS = Path(__file__).parent


@contextlib.contextmanager
def two_nodes(*folders: Path) -> Iterator[str]:
    """Start the cluster and return its address; its workers also import from ``folders``."""
    pytest.importorskip("ray")
    from ray.cluster_utils import Cluster

    path = os.pathsep.join([*map(str, (TESTS, *folders)), *sys.path])
    own = {"PYTHONPATH": path, "RAY_USAGE_STATS_ENABLED": "0"}
    with patch.dict(os.environ, own):
        head = {"num_cpus": 1, "include_dashboard": False}
        cluster = Cluster(initialize_head=True, head_node_args=head)
        try:
            cluster.add_node(num_cpus=1)
            cluster.wait_for_nodes(timeout=60)
            yield cluster.address
        finally:
            cluster.shutdown()
