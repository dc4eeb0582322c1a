"""A picture of a rig as rows of text: scenes, canvases, readings. No Textual."""
