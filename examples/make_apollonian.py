"""Write apollonian.spheres, the example packing of this folder."""

import sys
from pathlib import Path

import spherepacking

LEVELS = 6


def main(path):
    spherepacking.write(spherepacking.apollonian(LEVELS), path)


if __name__ == "__main__":
    default = Path(__file__).with_name("apollonian.spheres")
    main(sys.argv[1] if len(sys.argv) > 1 else default)
