"""The panels of the screen: each a widget that draws what it is shown."""
