"""The TRS-80 around the language: clock, memory, keyboard, video, tape, printer, card, driver."""
