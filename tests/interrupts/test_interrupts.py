"""Ctrl-C at any moment of any long call: KeyboardInterrupt, soon, and the results stay whole.

``SPHEREPACKING_INTERRUPTS`` is the number of interruptions over all calls,
``SPHEREPACKING_SPHERES`` that of spheres; ``pytest -s`` prints how long they took.
"""

import os
import random
import select
import signal
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

HERE = Path(__file__).parent
CALLS = [
    *("read", "reader", "read_bad", "steps", "read_vtp"),
    *("write", "write_dump", "write_vtp", "write_full"),
    *("pack", "contacts", "bvh_boxes", "grid_boxes", "pick", "ray_cast", "ray_cast_colors"),
    *("path_trace", "path_trace_fresh", "metaballs", "metaball_field", "live_picture", "draw"),
]
NUMBER = max(1, int(os.environ.get("SPHEREPACKING_INTERRUPTS", 2 * len(CALLS))) // len(CALLS))
SPHERES = os.environ.get("SPHEREPACKING_SPHERES", "30000")
# Seconds on a machine that does much else besides; 0.2 is what a quiet one takes.
LATEST = float(os.environ.get("SPHEREPACKING_LATEST", "1"))


@contextmanager
def child(*arguments, seconds=300):
    """A process that is killed should it hang."""
    with subprocess.Popen(
        [sys.executable, *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        watchdog = threading.Timer(seconds, process.kill)
        watchdog.start()
        try:
            yield process
        finally:
            watchdog.cancel()
            process.kill()


@pytest.mark.parametrize("call", CALLS)
def test_ctrl_c_at_any_moment(call, tmp_path):
    moments = random.Random(call)
    delays, ignored, unheard = [], 0, 0
    with child(HERE / "calls.py", call, SPHERES, tmp_path) as process:
        ready = process.stdout.readline().split()
        assert ready[:1] == ["ready"]
        for _ in range(NUMBER):
            process.stdin.write("\n")
            process.stdin.flush()
            assert process.stdout.readline() == "begin\n"
            time.sleep(moments.uniform(0.0, 1.5 * float(ready[1])))
            sent = time.monotonic()
            process.send_signal(signal.SIGINT)
            if not select.select([process.stdout], [], [], 20)[0]:
                # Raised, and lost in Python code that is not this package's.
                unheard += 1
                process.send_signal(signal.SIGINT)
            said = process.stdout.readline().split()
            if said[:1] == ["ignored"]:
                ignored += 1
                continue
            assert said[:1] == ["caught"], f"{said}, and the process ended with {process.poll()}"
            delays.append(float(said[1]) - sent)
        process.stdin.close()
        assert process.stdout.read() == "whole\n"
        assert process.wait(60) == 0
    print(
        f"\n{call}: {len(delays)} interruptions of a call of {float(ready[1]):.2f} s, seconds until"
        f" caught: median {np.median(delays):.3f}, 95 % {np.quantile(delays, 0.95):.3f}, longest"
        f" {max(delays):.3f}; {ignored} ignored in a destructor, {unheard} unheard"
    )
    assert unheard <= NUMBER // 500
    assert max(delays) < LATEST
    assert not list(tmp_path.glob(".spherepacking*")), "a temporary file is left"
