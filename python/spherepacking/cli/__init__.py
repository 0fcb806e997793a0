"""The command ``spherepacking``."""
