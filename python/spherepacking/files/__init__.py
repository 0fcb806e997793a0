"""Reading and writing: packings, pictures, layers of pictures, surfaces."""
