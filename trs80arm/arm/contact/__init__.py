"""Rigid parts in contact: shapes, friction, gravity, rest."""
