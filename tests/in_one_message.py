"""What a worker of xdist tells of a test, in one message where xdist sends six.

Most tests take less than a millisecond, and six messages would take as long: each goes through a
lock, a pipe and two threads, in bytes that xdist makes of it one by one. A message goes out when
the test has ended, as xdist's own last one does. Where xdist has not what this stands in for, all
goes its usual way.
"""

from __future__ import annotations

import marshal
from typing import Any

import pytest

ALL = "all_of_a_test"
"""The name of such a message."""
_CAN_WAIT = {"logstart", "testreport", "logfinish", "warning_recorded"}
"""What is kept until the test has ended."""
_FROM_A_THREAD = {"unscheduled"}
"""What is told while a test runs, of others."""


class Sender:
    """In a worker: keeps what there is to tell until a test has ended.

    Args:
        interactor: xdist's own part there, by which all goes.
    """

    def __init__(self, interactor: Any) -> None:
        self._send = interactor.sendevent
        self._kept: list[tuple[str, dict[str, Any]]] = []
        interactor.sendevent = self.send

    def send(self, name: str, **told: Any) -> None:
        """Send it, or keep it for later."""
        if name in _FROM_A_THREAD:
            self._send(name, **told)
            return
        self._kept.append((name, told))
        if name not in _CAN_WAIT:
            self._send_kept()

    def _send_kept(self) -> None:
        kept, self._kept = self._kept, []
        try:
            packed = marshal.dumps(kept) if len(kept) > 1 else None
        except ValueError:
            # xdist says best what of it cannot be sent.
            packed = None
        if packed is not None:
            self._send(ALL, packed=packed)
            return
        for name, told in kept:
            self._send(name, **told)


class Receiver:
    """Where workers are started: takes such messages apart."""

    def pytest_configure_node(self, node: Any) -> None:
        """A worker is to be started."""
        take = getattr(node, "process_from_remote", None)
        if take is None:
            return
        node.workerinput[ALL] = True

        def process(event: Any) -> None:
            if isinstance(event, tuple) and event[0] == ALL:
                for one in marshal.loads(event[1]["packed"]):
                    take(one)
            else:
                take(event)

        node.process_from_remote = process


def tell_in_one_message(config: pytest.Config) -> None:
    """Have it so, where xdist is at work."""
    if not config.pluginmanager.hasplugin("xdist"):
        return
    told = getattr(config, "workerinput", None)
    if told is None:
        config.pluginmanager.register(Receiver())
    elif ALL in told:
        for plugin in config.pluginmanager.get_plugins():
            if type(plugin).__name__ == "WorkerInteractor" and hasattr(plugin, "sendevent"):
                Sender(plugin)
