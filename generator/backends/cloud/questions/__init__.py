"""The questions of the stages, asked of a chat model."""
