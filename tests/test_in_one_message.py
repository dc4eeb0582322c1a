"""What xdist is told of a test arrives as it was told, in one message."""

from __future__ import annotations

from typing import Any

from tests.in_one_message import ALL, Receiver, Sender


class Worker:
    """The two ends of a worker as xdist has them."""

    def __init__(self) -> None:
        self.workerinput: dict[str, Any] = {}
        self.sent: list[tuple[str, dict[str, Any]]] = []
        self.taken: list[Any] = []

    def sendevent(self, name: str, **told: Any) -> None:
        self.sent.append((name, told))

    def process_from_remote(self, event: Any) -> None:
        self.taken.append(event)

    def deliver(self) -> None:
        """What was sent arrives."""
        for event in self.sent:
            self.process_from_remote(event)


def joined() -> Worker:
    worker = Worker()
    Receiver().pytest_configure_node(worker)
    assert worker.workerinput == {ALL: True}
    Sender(worker)
    return worker


TOLD: list[tuple[str, dict[str, Any]]] = [
    ("logstart", {"nodeid": "test", "location": ("file", 3, "test")}),
    ("testreport", {"data": {"when": "setup", "duration": 0.5, "longrepr": None}}),
    ("testreport", {"data": {"when": "call", "sections": [("out", "a\ud800\n")], "n": 1 << 70}}),
    ("logfinish", {"nodeid": "test"}),
    ("runtest_protocol_complete", {"item_index": 7, "duration": 1.5}),
]


def test_what_is_told_of_a_test_goes_out_at_its_end_and_arrives_as_it_was() -> None:
    worker = joined()
    for name, told in TOLD[:-1]:
        worker.sendevent(name, **told)
    assert not worker.sent
    name, told = TOLD[-1]
    worker.sendevent(name, **told)
    assert [name for name, _ in worker.sent] == [ALL]
    worker.deliver()
    assert worker.taken == TOLD


def test_what_another_thread_tells_does_not_wait_and_lets_nothing_go_early() -> None:
    worker = joined()
    worker.sendevent("logstart", nodeid="test")
    worker.sendevent("unscheduled", indices=[3])
    assert worker.sent == [("unscheduled", {"indices": [3]})]


def test_what_cannot_be_packed_is_left_to_xdist() -> None:
    worker = joined()
    odd = object()
    worker.sendevent("testreport", data=odd)
    worker.sendevent("workerfinished", workeroutput={})
    assert worker.sent == [("testreport", {"data": odd}), ("workerfinished", {"workeroutput": {}})]
    worker.process_from_remote("the end")
    assert worker.taken == ["the end"]
