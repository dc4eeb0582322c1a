"""The memory map of the Model I: 64K addresses, and who answers at each of them.

ROM below 3000H (none of ours is in it), the keyboard at 3800H, the video memory at 3C00H, RAM from
4000H up. The language, the display driver and PEEK and POKE all come here; the devices are
attached as regions and see only their own addresses.
"""

from __future__ import annotations

from typing import Any, Protocol

ADDRESSES = 0x10000
RAM_START = 0x4000
EMPTY = 0xFF
"""What the bus reads where nothing answers: the pull-ups give all ones."""
RAM_SIZES_KIB = (4, 16, 32, 48)
"""The sizes a Model I was sold with; 32 and 48 are 16 and an expansion interface."""
_PAGE_BITS = 8
_PAGES = ADDRESSES >> _PAGE_BITS


class Region(Protocol):
    """The owner of a range of addresses."""

    def peek(self, address: int) -> int:
        """The byte at a 16-bit address of the range."""

    def poke(self, address: int, value: int) -> None:
        """Store a byte at a 16-bit address of the range."""


class _ReadOnly:
    """Addresses that hold their byte whatever is stored: ROM, and where nothing answers."""

    def __init__(self, ram: bytearray) -> None:
        self._ram = ram

    def peek(self, address: int) -> int:
        return self._ram[address]

    def poke(self, address: int, value: int) -> None:
        """Stored nowhere."""


class _Page:
    """A page of 256 addresses with more than one owner."""

    def __init__(self, ram: bytearray, owner: Region | None) -> None:
        self._ram = ram
        self.owners: list[Region | None] = [owner] * (1 << _PAGE_BITS)

    def peek(self, address: int) -> int:
        owner = self.owners[address & 0xFF]
        return self._ram[address] if owner is None else owner.peek(address)

    def poke(self, address: int, value: int) -> None:
        owner = self.owners[address & 0xFF]
        if owner is None:
            self._ram[address] = value
        else:
            owner.poke(address, value)


class Memory:
    """64K addresses, some of them RAM, some of them devices, the rest empty.

    Attributes:
        ram: 65536 bytes, the storage behind every address that no region claims. It cannot grow or
            shrink: a slice of it takes as many bytes as it has. Whoever changes it directly must
            stay within RAM: the bytes below 4000H and from `top` on read 255 and stand for what
            is not there. `read` and `write` take any address.
        view: the same storage: bytes are stored through it in a third of the time.
        top: the first address without RAM: 8000H on a 16K machine.
    """

    def __init__(self, ram_kib: int = 16) -> None:
        """A map with RAM and nothing else; the devices are attached afterwards.

        Args:
            ram_kib: RAM in units of 1024 bytes: 4, 16, 32 or 48.

        Raises:
            ValueError: another size.
        """
        if ram_kib not in RAM_SIZES_KIB:
            raise ValueError(f"RAM is 4, 16, 32 or 48 KiB, not {ram_kib}")
        self.top = RAM_START + ram_kib * 1024
        self.ram = bytearray(ADDRESSES)
        self.ram[:RAM_START] = bytes((EMPTY,)) * RAM_START
        self.ram[self.top :] = bytes((EMPTY,)) * (ADDRESSES - self.top)
        self._pin()
        self._owners: list[Region | None] = [None] * _PAGES
        read_only = _ReadOnly(self.ram)
        self.attach(0, RAM_START, read_only)
        self.attach(self.top, ADDRESSES, read_only)

    def _pin(self) -> None:
        """Hold a view of the storage, for as long as there is one Python does not resize it."""
        self.view = memoryview(self.ram)

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name != "view"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._pin()

    def read(self, address: int, length: int) -> bytes:
        """The bytes that the Z-80 would read from an address on, around the end of memory."""
        end = address + length
        if address >= RAM_START and end <= self.top:
            return self.view[address:end].tobytes()
        return bytes(self.peek(place & 0xFFFF) for place in range(address, end))

    def write(self, address: int, data: bytes) -> None:
        """Store bytes as the Z-80 would from an address on, around the end of memory."""
        end = address + len(data)
        if address >= RAM_START and end <= self.top:
            self.view[address:end] = data
        else:
            for place, value in enumerate(data, address):
                self.poke(place & 0xFFFF, value)

    def peek(self, address: int) -> int:
        """The byte that the Z-80 would read at an address, 0 to 65535."""
        owner = self._owners[address >> _PAGE_BITS]
        return self.ram[address] if owner is None else owner.peek(address)

    def poke(self, address: int, value: int) -> None:
        """Store a byte as the Z-80 would; ROM and empty addresses ignore it."""
        owner = self._owners[address >> _PAGE_BITS]
        if owner is None:
            self.ram[address] = value
        else:
            owner.poke(address, value)

    def attach(self, start: int, stop: int, region: Region) -> None:
        """Let `region` answer for `start <= address < stop` from now on.

        A later region takes addresses from an earlier one.
        """
        address = start
        while address < stop:
            page = address >> _PAGE_BITS
            page_end = (page + 1) << _PAGE_BITS
            end = min(stop, page_end)
            if end - address == 1 << _PAGE_BITS:
                self._owners[page] = region
            else:
                self._shared(page).owners[address & 0xFF : ((end - 1) & 0xFF) + 1] = [region] * (
                    end - address
                )
            address = end

    def _shared(self, page: int) -> _Page:
        owner = self._owners[page]
        if not isinstance(owner, _Page):
            owner = _Page(self.ram, owner)
            self._owners[page] = owner
        return owner
