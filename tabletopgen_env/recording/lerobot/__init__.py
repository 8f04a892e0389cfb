"""LeRobot datasets, version 3.0: Parquet tables and one video per camera.

The format is described at https://huggingface.co/docs/lerobot/lerobot-dataset-v3.

======================================================  =========================================
``meta/info.json``                                      features, control rate, totals, file paths
``meta/stats.json``                                     range, mean, deviation and quantiles of each
                                                        feature
``meta/tasks.parquet``                                  the instructions, numbered
``meta/episodes/chunk-000/file-000.parquet``            a row for each episode
``meta/tabletopgen.json``                               the settings of the recording
``data/chunk-000/file-000.parquet``                     a row for each step, a row group for each
                                                        episode
``videos/<feature>/chunk-000/file-000.mp4``             the pictures of a camera, episode after
                                                        episode
======================================================  =========================================

An episode is written to its own folder as soon as it is complete (``segments``), and the dataset is
assembled from these folders at the end (``assembly``). Nothing is encoded twice. An interrupted
recording can be resumed, and the result has identical bytes.
"""
