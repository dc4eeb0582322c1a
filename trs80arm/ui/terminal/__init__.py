"""Textual's private hooks, one module each: key releases, which Textual itself does not report."""
