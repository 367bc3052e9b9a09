#!/usr/bin/env python3
"""Writes SphericalHarmonicReferences.inc: radii, surface gradients and surface Hessians of
spherical-harmonic sums to 50 digits, rounded once to double and written as hexadecimal floats.

Needed only to make the table again (python3-mpmath; five minutes):
    Testing/References/make_references.py

A direction in the table is a vector of three doubles whose length differs from 1 by rounding. The
reference belongs to exactly that vector divided by exactly its length: the function is taken as
constant along rays. Coefficients are small whole numbers times powers of two, from a generator that
SphericalHarmonicReferences.h repeats.

How: with z, w = x + iy on the sphere, R = Re sum_m D_m(z) w^m and D_m = sum_l c_lm Q_lm(z), where
Q_lm = N_lm P_l^(m) is a multiple of the m-th derivative of the Legendre polynomial. So the slope
of Q_lm is N_lm / N_l(m+1) Q_l(m+1), and no recurrence for slopes is needed. The script checks itself
against mpmath's spherical harmonics, the addition theorem and differences along great circles.
"""

import pathlib
import sys

from mpmath import mp, mpf

mp.dps = 70  # the recurrence loses a few of them at degree 1000

LCG_FACTOR = 6364136223846793005
LCG_STEP = 1442695040888963407
MASK = (1 << 64) - 1


def coefficients(degree, seed):
    """Exact multiples of powers of two. Seed 0 is organ-like: radius about 20, relief falling as
    (l + 1)^-2. Seed 3 is the worst for the poles: order 0 and +-1 are 1, so that all degrees add up
    there; the rest is 0. Other seeds are white, in [-1, 1)."""
    if seed == 3:
        return [mpf(1 if abs(m) <= 1 else 0) for l in range(degree + 1) for m in range(-l, l + 1)]
    state = seed
    result = []
    for l in range(degree + 1):
        fall = 2 * ((l + 1).bit_length() - 1) if seed == 0 else 0
        for _ in range(2 * l + 1):
            state = (state * LCG_FACTOR + LCG_STEP) & MASK
            result.append(mp.ldexp(mpf((state >> 43) - (1 << 20)), -20 - fall))
    if seed == 0:
        result[0] = mpf(71)  # a radius of 71 / sqrt(4 pi) = 20.03
    return result


def column(degree, m, z, diagonal):
    """Q_lm(z) for l = m..degree."""
    values = [diagonal]
    previous, current = mpf(0), diagonal
    for l in range(m + 1, degree + 1):
        a, b = STEPS[(l, m)]
        previous, current = current, a * (z * current - b * previous)
        values.append(current)
    return values


STEPS = {}


def prepare_steps(degree):
    """Factors of the recurrence, shared by the directions of a degree."""
    STEPS.clear()
    for m in range(degree + 1):
        for l in range(m + 1, degree + 1):
            a = mp.sqrt(mpf(4 * l * l - 1) / (l * l - m * m))
            b = mp.sqrt(mpf((l - 1) ** 2 - m * m) / (4 * (l - 1) ** 2 - 1)) if l > m + 1 else mpf(0)
            STEPS[(l, m)] = (a, b)


def slope_ratio(l, m):
    """N_lm / N_l(m+1): dQ_lm/dz in units of Q_l(m+1)."""
    product = (l - m) * (l + m + 1)
    return mp.sqrt(mpf(product) / 2) if m == 0 else mp.sqrt(mpf(product))


def index(l, m):
    return l * (l + 1) + m


class Sums:
    """C_m, S_m (cosine and sine part of D_m) and their first two derivatives in z."""

    def __init__(self, degree, c, z):
        self.cosine = [[mpf(0)] * (degree + 3) for _ in range(3)]
        self.sine = [[mpf(0)] * (degree + 3) for _ in range(3)]
        diagonal = 1 / mp.sqrt(4 * mp.pi)
        for k in range(degree + 1):
            if k > 0:
                diagonal *= mp.sqrt(mpf(2 * k + 1) / (1 if k == 1 else 2 * k))
            q = column(degree, k, z, diagonal)
            for order in range(min(k, 2) + 1):  # Q_lk is the slope of order k - 1, and so on
                self.add(degree, c, k - order, order, k, q)

    def add(self, degree, c, m, derivative, k, q):
        cosines, sines = [], []
        for l in range(k, degree + 1):
            factor = q[l - k]
            for step in range(m, k):
                factor = factor * RATIOS[(l, step)]
            cosines.append((c[index(l, m)], factor))
            if m > 0:
                sines.append((c[index(l, -m)], factor))
        self.cosine[derivative][m] = mp.fdot(cosines)
        self.sine[derivative][m] = mp.fdot(sines)


RATIOS = {}


def prepare_ratios(degree):
    RATIOS.clear()
    for l in range(degree + 1):
        for m in range(l):
            RATIOS[(l, m)] = slope_ratio(l, m)


def evaluate(degree, c, direction):
    """Radius, surface gradient and surface Hessian (xx, xy, xz, yy, yz, zz) at the normalised
    direction. The Hessian is the covariant one as a tangent 3x3 matrix: t.H.t is the second
    derivative along the great circle with tangent t."""
    length = mp.sqrt(mp.fsum(v * v for v in direction))
    x, y, z = (v / length for v in direction)
    sums = Sums(degree, c, z)
    w = mp.mpc(x, y)
    powers = [mp.mpc(1)]
    for _ in range(degree):
        powers.append(powers[-1] * w)

    def total(derivative, drop):
        """sum over m of m (m-1) ... (drop factors) (C - iS) w^(m - drop), a complex number."""
        result = mp.mpc(0)
        for m in range(drop, degree + 1):
            weight = 1
            for i in range(drop):
                weight *= m - i
            d = mp.mpc(sums.cosine[derivative][m], -sums.sine[derivative][m])
            result += weight * d * powers[m - drop]
        return result

    value = total(0, 0).real
    first = total(0, 1)
    gradient = mp.matrix([first.real, -first.imag, total(1, 0).real])
    second = total(0, 2)
    mixed = total(1, 1)
    hessian = mp.matrix([[second.real, -second.imag, mixed.real],
                         [-second.imag, -second.real, -mixed.imag],
                         [mixed.real, -mixed.imag, total(2, 0).real]])
    n = mp.matrix([x, y, z])
    tangent = mp.eye(3) - n * n.T
    radial = (n.T * gradient)[0]
    hessian = tangent * hessian * tangent - radial * tangent
    gradient = tangent * gradient
    return value, list(gradient), [hessian[i, j] for i in range(3) for j in range(i, 3)]


def check_against_mpmath():
    degree = 6
    prepare_steps(degree)
    prepare_ratios(degree)
    direction = [mpf("0.3"), mpf("-0.5"), mpf("0.7")]
    length = mp.sqrt(mp.fsum(v * v for v in direction))
    theta = mp.acos(direction[2] / length)
    phi = mp.atan2(direction[1], direction[0])
    for l in range(degree + 1):
        for m in range(-l, l + 1):
            c = [mpf(0)] * (degree + 1) ** 2
            c[index(l, m)] = mpf(1)
            complex_value = mp.spherharm(l, abs(m), theta, phi) * (-1) ** m
            scale = 1 if m == 0 else mp.sqrt(2)
            exact = scale * (complex_value.imag if m < 0 else complex_value.real)
            assert abs(evaluate(degree, c, direction)[0] - exact) < mpf(10) ** -60, (l, m)


def check_addition_theorem():
    degree = 60
    prepare_steps(degree)
    z = mpf("0.4")
    s2 = 1 - z * z
    diagonal = 1 / mp.sqrt(4 * mp.pi)
    sums = [mpf(0)] * (degree + 1)
    for m in range(degree + 1):
        if m > 0:
            diagonal *= mp.sqrt(mpf(2 * m + 1) / (1 if m == 1 else 2 * m))
        for l, q in enumerate(column(degree, m, z, diagonal), m):
            sums[l] += q * q * s2**m
    for l in range(degree + 1):
        assert abs(sums[l] - (2 * l + 1) / (4 * mp.pi)) < mpf(10) ** -55, l


def check_against_differences():
    degree = 9
    prepare_steps(degree)
    prepare_ratios(degree)
    c = coefficients(degree, 4)
    length = mp.sqrt(mpf(14))
    n = [mpf(1) / length, mpf(-2) / length, mpf(3) / length]
    t = [mpf(2) / mp.sqrt(5), mpf(1) / mp.sqrt(5), mpf(0)]
    h = mpf(10) ** -18

    def at(angle):
        point = [mp.cos(angle) * a + mp.sin(angle) * b for a, b in zip(n, t)]
        return evaluate(degree, c, point)[0]

    value, gradient, (xx, xy, xz, yy, yz, zz) = evaluate(degree, c, n)
    hessian = mp.matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    along = mp.matrix(t)
    slope = (at(h) - at(-h)) / (2 * h)
    bend = (at(h) - 2 * value + at(-h)) / (h * h)
    assert abs(mp.fdot(gradient, t) - slope) < mpf(10) ** -30
    assert abs((along.T * hessian * along)[0] - bend) < mpf(10) ** -30


def rounded_direction(x, y, z, to_float=False):
    """The unit vector along (x, y, z), rounded once to double (or float)."""
    x, y, z = mpf(x), mpf(y), mpf(z)
    length = mp.sqrt(x * x + y * y + z * z)
    parts = [float(v / length) for v in (x, y, z)]
    if to_float:
        import struct
        parts = [struct.unpack("f", struct.pack("f", v))[0] for v in parts]
    return parts


GENERAL = [(1, 2, 3), (-3, 1, 2), (2, -5, -1), (-1, -1, 4), (5, 3, -7), (1, 0, 0), (0, -1, 0),
           (-7, 2, 0), (3, 4, 1), (-2, 9, -6), (8, -1, 5), (1, 1, -1)]


def near_poles(distance):
    """Two directions at this angle (rad) from each pole."""
    d = mpf(distance)
    return [("3/5", "4/5", 1), ("-5/13", "12/13", 1), ("4/5", "-3/5", -1), ("-12/13", "-5/13", -1)], d


def directions(kinds):
    result = []
    for kind in kinds:
        if kind == "General" or kind == "Few":
            result += [("General", rounded_direction(*v))
                       for v in (GENERAL if kind == "General" else GENERAL[:4])]
        elif kind == "Float":
            result += [("Float", rounded_direction(*v, to_float=True)) for v in GENERAL]
        elif kind == "Pole":
            result += [("Pole", [0.0, 0.0, 1.0]), ("Pole", [0.0, 0.0, -1.0])]
        else:
            places, d = near_poles(kind)
            for x, y, z in places:
                result.append(("NearPole", rounded_direction(d * mp.mpmathify(x),
                                                             d * mp.mpmathify(y), z)))
    return result


# Degree: (seeds, kinds of directions). A number is a distance from the poles.
CASES = {
    0: ([1], ["Few", "Pole"]),
    1: ([1], ["Few", "Pole", "1e-8"]),
    2: ([1], ["Few", "Pole", "1e-8"]),
    12: ([0, 1, 3], ["General", "Pole", "1e-3", "1e-8", "1e-15", "1e-300", "Float"]),
    16: ([1, 3], ["General", "Pole", "1e-8", "1e-15"]),
    40: ([1, 3], ["Few", "Pole", "1e-3", "1e-8", "1e-15"]),
    100: ([1, 3], ["Few", "Pole", "1e-3", "1e-8", "1e-15"]),
    300: ([1, 3], ["Few", "Pole", "1e-8", "1e-15"]),
    1000: ([1, 3], ["Few", "Pole", "1e-3", "1e-8"]),
}

HEADER = """// Made by make_references.py; do not edit. One row a case: degree, kind, seed, direction, radius,
// surface gradient (x, y, z), surface Hessian (xx, xy, xz, yy, yz, zz). Rounded once from 50 digits.
"""


def row(degree, seed, kind, direction, sample):
    value, gradient, hessian = sample

    def text(numbers):
        return "{" + ", ".join(float(v).hex() for v in numbers) + "}"

    return (f"{{{degree}, ReferenceKind::{kind}, {seed}, {text(direction)}, {float(value).hex()},\n"
            f" {text(gradient)},\n {text(hessian)}}},\n")


def main():
    check_against_mpmath()
    check_addition_theorem()
    check_against_differences()
    rows = [HEADER]
    for degree, (seeds, kinds) in CASES.items():
        prepare_steps(degree)
        prepare_ratios(degree)
        for seed in seeds:
            c = coefficients(degree, seed)
            for kind, direction in directions(kinds):
                sample = evaluate(degree, c, [mpf(v) for v in direction])
                rows.append(row(degree, seed, kind, direction, sample))
        print(f"degree {degree} done", file=sys.stderr)
    target = pathlib.Path(__file__).parent / "SphericalHarmonicReferences.inc"
    target.write_text("".join(rows))


if __name__ == "__main__":
    main()
