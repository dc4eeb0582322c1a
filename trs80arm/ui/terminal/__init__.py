"""Textual's private hooks: key releases, and what is drawn behind a dialog."""
