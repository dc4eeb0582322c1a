"""What is raised for bytes that are no snapshot; known without the classes that stand in one."""

from __future__ import annotations


class SnapshotError(ValueError):
    """No snapshot of a rig, or one of another version; one clear line."""
