"""Who may visit the terminal in a browser, and how much a visitor can ask for.

textual-serve starts a program for each visitor and carries its screen to a page. By itself it lets
every page of the web in that knows the port. Here a request must come to this computer's own name,
from a page of this server, and with the token that was made at the start; the rest is limits.
"""

from __future__ import annotations

import asyncio
import contextlib
import ipaddress
import json
import logging
import os
import re
import secrets
import socket
from asyncio.subprocess import PIPE, Process
from collections.abc import Awaitable, Callable, Sequence
from functools import partial
from typing import Any

from aiohttp import WSMsgType, web
from textual_serve.app_service import AppService
from textual_serve.server import Server

from trs80arm.ui.start import SERVER
from trs80arm.ui.visitor_folders import VisitorFolders, environment_for, words_for

VISITORS = 8
"""Machines at a time."""
IDLE_SECONDS = 3600.0
"""Seconds without a key or a click after which a visitor's machine ends."""
_AT_ONCE = 0.001
"""Seconds; aiohttp takes 0 to mean as long as it takes."""
LARGEST_MESSAGE = 256 * 1024
"""Bytes of what a page may send at once, as a listing that is pasted."""
COLUMNS, ROWS = (20, 500), (5, 200)
"""The least and the most of a visitor's window."""
PATIENCE = 5.0
"""Seconds that a visitor's program has to end when its page was closed."""
COOKIE = "trs80arm"
"""Holds the token."""
VISITOR = "trs80arm-visitor"
"""Holds the name of a visitor's folder."""
_LINK = re.compile(rb"<link\b[^>]*\bhref=[\"'](https?://[^\"'>]*)[^>]*>")
_POLICY = (
    "default-src 'self'; script-src 'self' 'unsafe-inline'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data:; font-src 'self' data:; worker-src 'self' blob:; "
    "connect-src 'self' ws://{host} wss://{host}; frame-ancestors 'none'; form-action 'none'"
)
"""The page is given nothing from elsewhere, not even letters, and stands in no other page."""

Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]


class Visitors(Server):
    """A server that lets in who has its address.

    Args:
        words: the command that a visitor's program is started with, word by word.
        host: the address to listen at.
        port: the port.
        allow_files: whether visitors reach the files of this computer; otherwise each has a
            folder of his own.

    Attributes:
        address: what is to be opened in a browser, token and all.
    """

    def __init__(
        self, words: Sequence[str], host: str, port: int, *, allow_files: bool = False
    ) -> None:
        name = f"[{host}]" if ":" in host else host
        super().__init__(" ".join(words), host, port, "trs80arm", f"http://{name}:{port}")
        self._words = list(words)
        self._folders = None if allow_files else VisitorFolders()
        self._token = secrets.token_urlsafe(24)
        self.machines = 0
        self.address = f"{self.public_url}/?token={self._token}"

    def forget_visitors(self) -> None:
        """Remove the folders that visitors had."""
        if self._folders is not None:
            self._folders.forget()

    def initialize_logging(self) -> None:
        """Tell of troubles only: a line for each request would show the token."""
        logging.basicConfig(level=logging.WARNING)

    async def on_startup(self, app: web.Application) -> None:
        """Say nothing: the address was told already."""

    async def _make_app(self) -> web.Application:
        app = await super()._make_app()
        app.middlewares.append(self._guard)
        return app

    # -- who comes in -------------------------------------------------------------------------

    @web.middleware
    async def _guard(self, request: web.Request, handler: Handler) -> web.StreamResponse:
        """Let a request through that comes from a page of ours, or from who has the address."""
        if not self._is_own_name(request.host):
            raise web.HTTPForbidden(text="Not by this name.")
        origin = request.headers.get("Origin")
        here = (f"http://{request.host}", f"https://{request.host}")
        if origin not in here and (origin is not None or request.path == "/ws"):
            raise web.HTTPForbidden(text="Not from another page.")
        shown = request.query.get("token", "")
        held = request.cookies.get(COOKIE, "")
        if not any(secrets.compare_digest(self._token, each) for each in _ascii(shown, held)):
            raise web.HTTPForbidden(text="Open the address that trs80arm serve has printed.")
        if request.path == "/ws":
            return await handler(request)
        # The page opens its socket at the name that it was opened by.
        self.public_url = f"http://{request.host}"
        response = await handler(request)
        if isinstance(response, web.Response) and isinstance(response.body, bytes):
            response.body = _without_outside(response.body, self.public_url)
        response.headers["Content-Security-Policy"] = _POLICY.format(host=request.host)
        response.headers["Referrer-Policy"] = "no-referrer"
        response.headers["X-Content-Type-Options"] = "nosniff"
        if request.path == "/":
            response.set_cookie(COOKIE, self._token, httponly=True, samesite="Strict")
            if not VisitorFolders.is_name(request.cookies.get(VISITOR, "")):
                name = VisitorFolders.new_name()
                response.set_cookie(VISITOR, name, httponly=True, samesite="Strict")
        return response

    def _is_own_name(self, host: str) -> bool:
        """Whether a request's Host is a name of this computer, and not one of somebody's page."""
        name, _, port = host.rpartition(":") if not host.endswith("]") else (host, "", "")
        if not name:
            name, port = port, ""
        name = name.strip("[]").lower()
        if (port or "80") != str(self.port):
            return False
        known = {"localhost", "127.0.0.1", "::1", self.host.lower()}
        if name in known:
            return True
        # Listening to all: by number, or by the name that the computer has itself.
        if self.host not in ("0.0.0.0", "::"):
            return False
        with contextlib.suppress(ValueError):
            return bool(ipaddress.ip_address(name))
        return name in (socket.gethostname().lower(), f"{socket.gethostname().lower()}.local")

    # -- what a visitor can ask for -----------------------------------------------------------

    async def handle_websocket(self, request: web.Request) -> web.WebSocketResponse:
        """One visitor's machine, from the page's opening to its end."""
        if self.machines >= VISITORS:
            raise web.HTTPServiceUnavailable(text="All machines are taken.")
        words = self._words
        change: Callable[[dict[str, str]], dict[str, str]] = dict
        if self._folders is not None:
            name = request.cookies.get(VISITOR, "")
            name = name if VisitorFolders.is_name(name) else VisitorFolders.new_name()
            folder = self._folders.of(name)
            if folder is None:
                raise web.HTTPServiceUnavailable(text="There are too many visitors.")
            words = [*words, *words_for(folder)]
            change = partial(environment_for, folder)
        socket_ = web.WebSocketResponse(heartbeat=15, max_msg_size=LARGEST_MESSAGE)
        self.machines += 1
        try:
            await socket_.prepare(request)
            service = _Machine(
                words,
                change,
                self.command,
                write_bytes=socket_.send_bytes,
                write_str=socket_.send_str,
                close=socket_.close,
                download_manager=self.download_manager,
            )
            await service.start(
                _number(request.query.get("width"), 80), _number(request.query.get("height"), 24)
            )
            try:
                await self._process_messages(socket_, service)
            finally:
                await asyncio.shield(service.stop())
        finally:
            self.machines -= 1
        return socket_

    async def _process_messages(
        self, websocket: web.WebSocketResponse, app_service: AppService
    ) -> None:
        """Take what the page sends until it leaves or nobody has touched a key for long."""
        touched = asyncio.get_running_loop().time()
        while not websocket.closed:
            left = touched + IDLE_SECONDS - asyncio.get_running_loop().time()
            try:
                message = await websocket.receive(timeout=max(left, _AT_ONCE))
            except TimeoutError:
                await websocket.close(message=b"Nobody was there.")
                return
            if message.type != WSMsgType.TEXT:
                if message.type in (WSMsgType.CLOSE, WSMsgType.CLOSING, WSMsgType.CLOSED):
                    return
                continue
            kind, data = _message(message.data)
            match kind, data:
                case "stdin", str():
                    touched = asyncio.get_running_loop().time()
                    await app_service.send_bytes(data.encode("utf-8", "replace"))
                case "resize", {"width": width, "height": height}:
                    await app_service.set_terminal_size(_number(width, 80), _number(height, 24))
                case "ping", _:
                    await websocket.send_json(["pong", data])
                case "blur", _:
                    await app_service.blur()
                case "focus", _:
                    await app_service.focus()


class _Machine(AppService):
    """A visitor's program: started without a shell, of a bounded size.

    Args:
        words: its command line.
        change: makes its environment of that of the server.
        command: the command line as textual-serve has it; it is not used.
        more: what textual-serve gives.
    """

    def __init__(
        self,
        words: Sequence[str],
        change: Callable[[dict[str, str]], dict[str, str]],
        command: str,
        **more: Any,
    ) -> None:
        super().__init__(command, **more)
        self._words = list(words)
        self._change = change

    async def _open_app_process(self, width: int = 80, height: int = 24) -> Process:
        width, height = _within(width, COLUMNS), _within(height, ROWS)
        environment = self._change(self._build_environment(width=width, height=height))
        environment[SERVER] = str(os.getpid())
        self._process = process = await asyncio.create_subprocess_exec(
            *self._words, stdin=PIPE, stdout=PIPE, stderr=PIPE, env=environment
        )
        self._stdin = process.stdin
        return process

    async def stop(self) -> None:
        """Ask the program to end, and see that it does."""
        await super().stop()
        process, self._process = self._process, None
        if process is None:
            return
        if process.stdin is not None:
            process.stdin.close()
        try:
            await asyncio.wait_for(process.wait(), PATIENCE)
        except TimeoutError:
            process.kill()
            await process.wait()

    async def set_terminal_size(self, width: int, height: int) -> None:
        """Tell the program its size, within what a window can be."""
        await super().set_terminal_size(_within(width, COLUMNS), _within(height, ROWS))


def _message(text: str) -> tuple[Any, Any]:
    """What the page says, and about what; nothing for what no page of ours would send."""
    try:
        envelope = json.loads(text)
    except (ValueError, RecursionError):
        return None, None
    if not isinstance(envelope, list) or not envelope:
        return None, None
    return envelope[0], envelope[1] if len(envelope) > 1 else None


def _number(value: Any, default: int) -> int:
    try:
        return int(value)
    except (TypeError, ValueError, OverflowError):
        return default


def _within(value: int, limits: tuple[int, int]) -> int:
    return min(max(value, limits[0]), limits[1])


def _ascii(*texts: str) -> list[str]:
    """Those that can be compared in constant time."""
    return [text for text in texts if text.isascii()]


def _without_outside(page: bytes, own: str) -> bytes:
    """A page without links to elsewhere; its own style sheet stays."""
    ours = f"{own}/".encode()
    return _LINK.sub(lambda link: link[0] if link[1].startswith(ours) else b"", page)
