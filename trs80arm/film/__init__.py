"""A run of the terminal as a film: its pictures, and the kinds of files that show them."""
