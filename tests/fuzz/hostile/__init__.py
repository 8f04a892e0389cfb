"""Hostile input for all code that reads foreign files, answers or numbers.

A *target* crafts one hostile input from a seed and hands it to the product's own entry points. Each
case runs in a monitored worker process, so that a hang, a crash or excessive memory use is counted
instead of ending the run. The property: a case ends, within ``harness.SECONDS`` and
``harness.MOST_MIB``, in a result or in a child of ``generator.errors.TabletopError``, and nothing
outside its folder changes.
"""
