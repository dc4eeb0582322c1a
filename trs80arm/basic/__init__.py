"""Level II BASIC: the language, which knows no hardware and no clock on the wall."""
