"""The Textual front end: draws the rig, and turns key and mouse events into matrix keys."""
