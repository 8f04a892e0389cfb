"""Workers that step the slots of a ``vector.TabletopVectorEnv``: threads or processes (shards).

================  =================================================================================
``arrays``        actions and observations as arrays with one row per slot, in shared memory
``slots``         ``SlotSet``: the environments of some slots, stepped into their rows
``threads``       ``ThreadSlots``: all slots in this process, on threads
``shards``        ``ShardSlots``: slots in several processes; ``shard`` runs in each of them
``infos``         infos in Gymnasium's vector format; numbers pass between processes in an array
``scene_server``  one scene source for the slots of several processes
``pickling``      pickling of values, jobs and errors for other processes
================  =================================================================================
"""
