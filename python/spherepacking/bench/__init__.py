"""Speed beside error, of this package's techniques and of others that are there.

``scenes`` makes packings, ``reference`` casts float64 rays, ``accuracy`` compares windows with
them; ``techniques``, ``peers`` and ``embree`` are what is measured, ``measure`` lets them take
turns, and ``table`` and ``chart`` show what came out. Used by the command ``spherepacking bench``
and by the scripts in ``benchmarks/``.
"""
