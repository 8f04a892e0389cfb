"""Hostile input for everything that reads files, answers or numbers of others.

A *target* crafts one hostile input from a seed and hands it to the product's own entry points. Each
case runs in a worker process that is watched from outside, so that a hang, a crash or a memory hog
counts instead of ending the run. The property: a case ends, within ``harness.SECONDS`` and
``harness.MOST_MIB``, in a result or in a child of ``generator.errors.TabletopError``, and nothing
outside its folder changes.
"""
