"""The servo at 1 kHz with a simulated hand: "falcon" instead of "simulated" is a real device."""

import time

import numpy
import palpate

scene = palpate.Scene(tool_radius=1.0)
organ = scene.add(palpate.Model([20.0 * numpy.sqrt(4 * numpy.pi)]), stiffness=0.5)

with palpate.Session("simulated") as session:
    session.show(scene)
    session.lead_hand((0.0, 19.0, 0.0))  # 2 mm deep for a tool of 1 mm
    state = session.read()
    while state.is_ramping or state.id != organ:
        time.sleep(0.02)
        state = session.read()
    print(f"tick {state.tick}: {state.depth:.2f} mm deep, {state.force.round(2)} N")
    assert state.is_armed and not session.problem

    session.stop_force()
    while session.read().is_armed:
        time.sleep(0.02)
    print("problem:", session.problem or "none")
    assert numpy.linalg.norm(session.read().force) == 0.0
