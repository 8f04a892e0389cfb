"""The stages' questions to a chat model."""
