"""A served terminal opens to who has its address, and to nobody else."""

from __future__ import annotations

import ast
import asyncio
import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import aiohttp
import pytest
from aiohttp import WSServerHandshakeError
from aiohttp.test_utils import TestClient, TestServer

from tests.ui.piloted import piloted
from trs80arm.ui import visitor_folders, visitors
from trs80arm.ui.visitors import Visitors

PROGRAM = r"""
import os, sys, struct
out = sys.stdout.buffer
def say(text):
    data = text.encode()
    out.write(b"D" + struct.pack(">I", len(data)) + data)
    out.flush()
out.write(b"__GANGLION__\\n")
say(f"size {os.environ['COLUMNS']}x{os.environ['ROWS']}")
while head := sys.stdin.buffer.read(5):
    body = sys.stdin.buffer.read(struct.unpack(">I", head[1:])[0]).decode()
    if '"quit"' in body:
        break
    if '"where"' in body:
        own = {name: it for name, it in os.environ.items() if name.startswith("TRS80ARM_")}
        say(repr((sys.argv[1:], own)))
        continue
    say("got " + body)
"""
"""Stands for the terminal program: says its size, and what it is sent."""


@asynccontextmanager
async def served(
    host: str = "127.0.0.1", *, allow_files: bool = False
) -> AsyncIterator[tuple[Visitors, TestClient]]:
    words = [sys.executable, "-c", PROGRAM.replace("\\\\", "\\")]
    server = Visitors(words, host, 1, allow_files=allow_files)
    async with TestClient(TestServer(await server._make_app())) as client:
        assert client.port is not None
        server.port = client.port
        try:
            yield server, client
        finally:
            server.forget_visitors()


def token(server: Visitors) -> dict[str, str]:
    return {"token": server.address.partition("token=")[2]}


@piloted
async def test_the_address_opens_the_page_and_its_socket() -> None:
    async with served() as (server, client):
        page = await client.get("/", params=token(server))
        assert page.status == 200
        text = await page.text()
        assert "googleapis" not in text
        assert "css/xterm.css" in text
        assert f"ws://127.0.0.1:{client.port}/ws" in text
        assert "default-src 'self'" in page.headers["Content-Security-Policy"]
        assert "HttpOnly" in page.headers["Set-Cookie"]
        assert "SameSite=Strict" in page.headers["Set-Cookie"]
        here = {"Origin": f"http://127.0.0.1:{client.port}"}
        async with client.ws_connect("/ws?width=90&height=30", headers=here) as machine:
            assert await machine.receive_bytes() == b"size 90x30"
            await machine.send_json(["stdin", "A"])
            assert await machine.receive_bytes() == b"got A"


@pytest.mark.parametrize("path", ["/", "/ws", "/static/js/textual.js", "/download/x"])
@piloted
async def test_without_the_token_there_is_nothing(path: str) -> None:
    async with served() as (_, client):
        here = {"Origin": f"http://127.0.0.1:{client.port}"}
        for wrong in ({}, {"token": ""}, {"token": "x"}, {"token": "ü"}):
            answer = await client.get(path, params=wrong, headers=here)
            assert answer.status == 403


@pytest.mark.parametrize("origin", ["http://evil.example", "null", "http://127.0.0.1:1", ""])
@piloted
async def test_another_page_cannot_open_the_socket_even_with_the_token(origin: str) -> None:
    async with served() as (server, client):
        with pytest.raises(WSServerHandshakeError) as refused:
            await client.ws_connect("/ws", params=token(server), headers={"Origin": origin})
        assert refused.value.status == 403


@piloted
async def test_a_socket_without_an_origin_is_refused() -> None:
    async with served() as (server, client):
        with pytest.raises(WSServerHandshakeError):
            await client.ws_connect("/ws", params=token(server))


@pytest.mark.parametrize("name", ["evil.example", "evil.example:80", "127.0.0.1.evil.example"])
@piloted
async def test_a_name_of_somebody_else_is_refused(name: str) -> None:
    async with served() as (server, client):
        for host in (name, f"{name.partition(':')[0]}:{client.port}"):
            answer = await client.get("/", params=token(server), headers={"Host": host})
            assert answer.status == 403


@piloted
async def test_a_server_for_all_is_reached_by_number_and_by_its_own_name() -> None:
    async with served("0.0.0.0") as (server, client):
        for name, status in (("192.168.1.5", 200), (socket.gethostname(), 200), ("x.example", 403)):
            host = {"Host": f"{name}:{client.port}"}
            assert (await client.get("/", params=token(server), headers=host)).status == status


@pytest.mark.parametrize(
    ("asked", "given"), [("1000000000", "500x200"), ("-5", "20x5"), ("x", "80x24"), ("9" * 99, "")]
)
@piloted
async def test_a_window_has_a_size_that_windows_have(asked: str, given: str) -> None:
    async with served() as (server, client):
        here = {"Origin": f"http://127.0.0.1:{client.port}"}
        query = {"width": asked, "height": asked} | token(server)
        async with client.ws_connect("/ws", params=query, headers=here) as machine:
            assert (await machine.receive_bytes()).decode() == f"size {given or '500x200'}"
            await machine.send_json(["resize", {"width": 10**12, "height": 10**12}])
            assert b'"width": 500, "height": 200' in await machine.receive_bytes()


async def told_where(server: Visitors, client: TestClient) -> tuple[list[str], dict[str, str]]:
    """The words that a visitor's program is started with, and its own variables."""
    here = {"Origin": f"http://127.0.0.1:{client.port}"}
    async with client.ws_connect("/ws", params=token(server), headers=here) as machine:
        await machine.receive_bytes()
        await machine.send_json(["stdin", '"where"'])
        told = (await machine.receive_bytes()).decode()
    words, variables = ast.literal_eval(told)
    return words, variables


@piloted
async def test_a_visitor_has_a_folder_of_his_own_that_goes_with_the_server(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("TRS80ARM_PRINTER", "/their/paper")
    async with served() as (server, client):
        await client.get("/", params=token(server))
        words, variables = await told_where(server, client)
        folder = Path(words[words.index("--own-folder") + 1])
        assert folder.is_dir()
        assert words[words.index("--tapes") + 1] == str(folder / "tapes")
        assert Path(words[words.index("--config") + 1]).parent == folder.parent
        assert set(variables) == {"TRS80ARM_STATE", "TRS80ARM_SERVER"}
        assert Path(variables["TRS80ARM_STATE"]).parent == folder.parent
        again, _ = await told_where(server, client)
        assert again == words
        client.session.cookie_jar.clear()
        await client.get("/", params=token(server))
        another, _ = await told_where(server, client)
        assert another != words
    assert not folder.exists()


@piloted
async def test_visitors_who_are_allowed_to_have_the_files_of_who_serves(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("TRS80ARM_PRINTER", "/their/paper")
    async with served(allow_files=True) as (server, client):
        words, variables = await told_where(server, client)
    assert words == []
    assert variables["TRS80ARM_PRINTER"] == "/their/paper"


@piloted
async def test_a_cookie_leads_to_no_folder_elsewhere(monkeypatch: pytest.MonkeyPatch) -> None:
    async with served() as (server, client):
        client.session.cookie_jar.update_cookies({visitors.VISITOR: "../../../elsewhere"})
        words, _ = await told_where(server, client)
        assert "elsewhere" not in str(words)


@piloted
async def test_there_are_so_many_visitors_and_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(visitor_folders, "MOST", 1)
    async with served() as (server, client):
        await told_where(server, client)
        with pytest.raises(WSServerHandshakeError) as refused:
            await told_where(server, client)
        assert refused.value.status == 503


@piloted
async def test_odd_messages_of_a_page_are_passed_over() -> None:
    async with served() as (server, client):
        here = {"Origin": f"http://127.0.0.1:{client.port}"}
        async with client.ws_connect("/ws", params=token(server), headers=here) as machine:
            await machine.receive_bytes()
            for odd in (
                "",
                "{",
                "[]",
                "5",
                '["stdin"]',
                '["stdin", 5]',
                '["resize", 7]',
                "[" * 9999,
            ):
                await machine.send_str(odd)
            await machine.send_bytes(b"\xff")
            await machine.send_json(["stdin", "B"])
            assert await machine.receive_bytes() == b"got B"


@piloted
async def test_there_are_so_many_machines_and_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(visitors, "VISITORS", 1)
    async with served() as (server, client):
        here = {"Origin": f"http://127.0.0.1:{client.port}"}
        async with client.ws_connect("/ws", params=token(server), headers=here) as machine:
            await machine.receive_bytes()
            with pytest.raises(WSServerHandshakeError) as refused:
                await client.ws_connect("/ws", params=token(server), headers=here)
            assert refused.value.status == 503
        while server.machines:
            await asyncio.sleep(0.01)
        async with client.ws_connect("/ws", params=token(server), headers=here) as machine:
            await machine.receive_bytes()


@piloted
async def test_a_machine_that_nobody_touches_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    async with served() as (server, client):
        here = {"Origin": f"http://127.0.0.1:{client.port}"}
        async with client.ws_connect("/ws", params=token(server), headers=here) as machine:
            await machine.receive_bytes()
            monkeypatch.setattr(visitors, "IDLE_SECONDS", 0.0)
            await machine.send_json(["ping", "1"])
            kinds = [(await machine.receive()).type for _ in range(2)]
    assert kinds == [aiohttp.WSMsgType.TEXT, aiohttp.WSMsgType.CLOSE]


SERVER = """
import os, subprocess, sys, time
code = (
    "import os, signal, sys, time\\n"
    "from trs80arm.ui import start\\n"
    "start.LOOK_SECONDS = 0.05\\n"
    "start._end_with_server()\\n"
    "print(os.getpid(), flush=True)\\n"
    "time.sleep(600)\\n"
)
environment = os.environ | {"TRS80ARM_SERVER": str(os.getpid())}
subprocess.run([sys.executable, "-c", code], env=environment)
"""


def test_a_machine_ends_when_its_server_is_killed() -> None:
    with subprocess.Popen(
        [sys.executable, "-c", SERVER.replace("\\\\", "\\")], stdout=subprocess.PIPE
    ) as server:
        assert server.stdout is not None
        machine = int(server.stdout.readline())
        server.send_signal(signal.SIGKILL)
        for _ in range(3000):
            try:
                os.kill(machine, 0)
            except ProcessLookupError:
                break
            time.sleep(0.01)
        else:
            pytest.fail("the machine is still there")
