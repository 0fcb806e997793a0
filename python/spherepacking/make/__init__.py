"""Making packings."""
