"""Open models by ``transformers``, on this machine: the Segmenter and the Encoder of the paper.

``models.toml`` says which models at which commit; ``tabletopgen models`` fetches them. Answering
never touches the network.
"""
