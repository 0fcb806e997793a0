"""``python -m spherepacking``, and what the command ``spherepacking`` runs."""

import sys


def main() -> int:
    """Run the command line and return its exit status, also when stopped while it is loaded."""
    try:
        from .cli.main import main as run

        return run()
    except KeyboardInterrupt:
        print("spherepacking: stopped", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main())
