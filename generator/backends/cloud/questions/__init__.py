"""Questions to a chat model in the generation stages: their prompts, answers and checks."""
