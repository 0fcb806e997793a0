"""One module per program: ``write(installed, folder)`` returns its version and files."""
