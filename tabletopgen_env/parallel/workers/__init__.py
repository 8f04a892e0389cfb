"""Workers that step the slots of a ``vector.TabletopVectorEnv``: threads, or processes (shards).

================  =================================================================================
``arrays``        actions and observations, an array each with one row per slot; in shared memory
``slots``         ``SlotSet``: the environments of some slots, stepped into their rows
``threads``       ``ThreadSlots``: all slots in this process, on threads
``shards``        ``ShardSlots``: some slots in each of several processes; ``shard`` is one of them
``infos``         infos in Gymnasium's vector format; between processes numbers in an array
``scene_server``  one scene source for the slots of several processes
``pickling``      checks that a value can be sent to another process; its errors; jobs
================  =================================================================================
"""
