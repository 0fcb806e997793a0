"""Rays and paths of light on the processor, and the boxes of the structures that they use."""
