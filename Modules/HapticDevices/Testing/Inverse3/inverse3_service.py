#!/usr/bin/python3
"""A peer of Inverse3Device by another library (python3-websockets): Haply's service of 3.5 as docs.haply.co describes
it. Prints its ports, answers each message with one state, and on the end of the session the number of messages, the
largest force (N) and how often the force's field had another name.
"""
import asyncio
import json

import websockets

IDENTITY = "049D"


def state(force, idle, full):
    device = {
        "device_id": IDENTITY,
        "state": {
            "cursor_position": {"x": 0.001, "y": 0.002, "z": 0.003},
            "current_cursor_force": force,
            "control_mode": "idle" if idle else "force",
        },
    }
    if full:
        device["config"] = {"type": "inverse3", "preset": "defaults"}
    return json.dumps({"session_id": 1, "inverse3": [device], "wireless_verse_grip": []})


async def serve_states(socket):
    force = {"x": 0.0, "y": 0.0, "z": 0.0}
    messages = refused = 0
    largest = 0.0
    await socket.send(state(force, True, True))
    try:
        async for text in socket:
            command = json.loads(text)["inverse3"][0]["commands"]["set_cursor_force"]
            messages += 1
            refused += "vector" not in command
            force = command.get("vector", force)
            largest = max(largest, sum(part**2 for part in force.values()) ** 0.5)
            await socket.send(state(force, "vector" not in command, False))
    except websockets.ConnectionClosed:
        pass
    print(f"{messages} {largest:.3f} {refused} {force['x']} {force['y']} {force['z']}", flush=True)


async def serve_events(socket):
    await socket.wait_closed()


async def main():
    async with websockets.serve(serve_states, "127.0.0.1", 0) as states:
        async with websockets.serve(serve_events, "127.0.0.1", 0) as events:
            print(states.sockets[0].getsockname()[1], events.sockets[0].getsockname()[1], flush=True)
            await asyncio.Future()


asyncio.run(main())
