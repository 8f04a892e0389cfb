"""What steps the slots of a ``vector.TabletopVectorEnv``: threads here, or processes (shards).

==============  ===================================================================================
``arrays``      what slots are told and show, an array each with a row a slot; in shared memory
``slots``       ``SlotSet``: the environments of some slots, stepped into their rows
``threads``     ``ThreadSlots``: all slots in this process, on threads
``shards``      ``ShardSlots``: some slots in each of several processes; ``shard`` is one of them
``infos``       infos in Gymnasium's vector format; between processes numbers in an array
``lending``     one scene source for the slots of several processes
``crossing``    what can be sent to another process, and errors from there
==============  ===================================================================================
"""
