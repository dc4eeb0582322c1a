"""What the user can ask the program to do, by key, palette or mouse."""
