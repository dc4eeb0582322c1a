"""Every test of the desk keeps its files in its own folder."""

from tests.own_places import own_places

__all__ = ["own_places"]
