"""Oracles that tests and benchmarks stand on: exact pictures, their errors, packings."""
