"""Open models that ``transformers`` runs on this machine: the paper's Segmenter and Encoder.

``models.toml`` pins the models to commits; ``tabletopgen models`` downloads them. Inference never
uses the network.
"""
