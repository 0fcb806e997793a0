"""Speed beside error, of this package's techniques and of others that are installed.

``rays`` and ``window`` are this package's techniques, ``peers`` and ``embree`` those of others,
``catalog`` lists them all; ``measure``, ``light`` and ``fields`` let them take turns and find their
errors with the oracles of ``spherepacking.testing``; ``table`` and ``chart`` show what came out.
Used by the command ``spherepacking bench`` and by the scripts in ``benchmarks/``.
"""
