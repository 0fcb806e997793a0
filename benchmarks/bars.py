"""Tables of what is measured, beside what it has to be."""

from __future__ import annotations

from rich.table import Table


class Bars:
    """A table of what is measured and whether it is good enough."""

    def __init__(self, title: str, *names: str) -> None:
        self.table = Table(title=title)
        self.good = True
        for name in (*names, "bar", ""):
            self.table.add_column(name, justify="right")

    def add(self, *values: str, bar: str, met: bool) -> None:
        self.good &= met
        self.table.add_row(*values, bar, "met" if met else "NOT MET")
