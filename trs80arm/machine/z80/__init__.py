"""The Z-80 of the machine: the processor itself, a user's own ROM, and the whole machine on it."""
