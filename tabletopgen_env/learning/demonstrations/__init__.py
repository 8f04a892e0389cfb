"""The expert's demonstrations: recorded, cloned, put into replay buffers."""
