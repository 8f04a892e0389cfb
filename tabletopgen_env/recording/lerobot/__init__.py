"""LeRobot datasets, version 3.0: tables of Parquet, a video for each camera.

The format is described at https://huggingface.co/docs/lerobot/lerobot-dataset-v3.

======================================================  =========================================
``meta/info.json``                                      features, control rate, totals, where files
                                                        are
``meta/stats.json``                                     range, mean, deviation and quantiles of each
                                                        feature
``meta/tasks.parquet``                                  the instructions, numbered
``meta/episodes/chunk-000/file-000.parquet``            a row for each episode
``meta/tabletopgen.json``                               what was recorded, and how
``data/chunk-000/file-000.parquet``                     a row for each step, a row group for each
                                                        episode
``videos/<feature>/chunk-000/file-000.mp4``             the pictures of a camera, episode after
                                                        episode
======================================================  =========================================

An episode is written to a folder of its own as soon as it was played (``segments``), and the
dataset is put together from these at the end (``assembly``): nothing is encoded twice, and what was
interrupted goes on where it stopped and ends in the same bytes.
"""
