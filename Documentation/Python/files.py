"""Models as files: Palpate's JSON keeps them exactly, SPHARM-PDM's .coef is for other tools."""

import pathlib
import tempfile

import numpy
import palpate

random = numpy.random.default_rng(2)
model = palpate.Model([80.0, *random.normal(scale=2.0, size=48)], center=(10.0, 20.0, 30.0))
print("power of each degree, mm^2:", model.spectrum().round(1))

with tempfile.TemporaryDirectory() as folder:
    for name in ("model.json", "model.coef"):
        path = pathlib.Path(folder) / name
        model.write(path)
        again = palpate.read_model(path)
        print(f"{name}: {path.stat().st_size} bytes, {again}")
        assert abs(again.measures().volume - model.measures().volume) < 1e-6
    assert (palpate.read_model(f"{folder}/model.json").coefficients == model.coefficients).all()

    try:
        palpate.read_model(f"{folder}/absent.json")
    except palpate.Error as error:
        print("refused:", error)
