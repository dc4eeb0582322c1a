"""From keys of the host's keyboard to keys of the TRS-80."""
