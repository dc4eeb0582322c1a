"""A sitting at the machine: its files, recordings, lessons, pace and recovery. No Textual."""
