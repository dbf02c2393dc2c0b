# SPDX-License-Identifier: Apache-2.0
import json
import math
import threading
import time

import numpy as np
import pytest

import foamtex


def relaxed(bubbles=60, **options):
    foam = foamtex.Foam.torus(bubbles, **options)
    foam.relax()
    return foam


def test_relax_reaches_equilibrium():
    foam = foamtex.Foam.torus(60, seed=3)
    found = foam.relax()
    assert found.area_error < 1e-9 and found.angle_error < 1e-9
    assert np.abs(foam.bubbles["area"] / foam.bubbles["target_area"] - 1).max() < 1e-9
    assert foam.bubbles["area"].sum() == pytest.approx(60, rel=1e-12)


def test_records_are_those_of_the_access():
    foam = relaxed(40, seed=5)
    before = foam.bubbles
    assert not before.flags.writeable
    assert before.__array_interface__["data"] == foam.bubbles.__array_interface__["data"]  # computed once
    pressures = before["pressure"].copy()
    foam.step(1.0)
    assert (before["pressure"] == pressures).all() and (foam.bubbles["pressure"] != pressures).any()
    del foam
    assert (before["pressure"] == pressures).all()


def test_records_describe_one_foam():
    foam = relaxed(80, seed=2)
    bubbles, films, junctions = foam.bubbles, foam.films, foam.junctions
    assert len(foam) == len(bubbles) == 80 and len(films) == 240 and len(junctions) == 160  # Euler
    sides = np.bincount(np.concatenate([films["left"], films["right"]]), minlength=80)
    assert (sides == bubbles["sides"]).all()
    perimeters = np.zeros(80)
    np.add.at(perimeters, films["left"], films["length"])
    np.add.at(perimeters, films["right"], films["length"])
    assert perimeters == pytest.approx(bubbles["perimeter"], rel=1e-12)
    assert foam.energy == pytest.approx(foam.film_tension * films["length"].sum(), rel=1e-12)
    # Laplace-Young: the pressure difference is the tension times the curvature, 2 sin(half angle) / chord.
    chord = np.hypot(films["chord_x"], films["chord_y"])
    difference = bubbles["pressure"][films["left"]] - bubbles["pressure"][films["right"]]
    assert 2 * np.sin(films["half_angle"]) / chord * foam.film_tension == pytest.approx(difference, abs=1e-12)
    assert films["x"] == pytest.approx(junctions["x"][films["tail"]])


def test_outside_of_a_patch_is_minus_one():
    foam = foamtex.Foam.disk(30, seed=1)
    foam.relax()
    assert foam.periods is None
    assert (np.minimum(foam.films["left"], foam.films["right"]) == -1).sum() > 5
    assert np.abs(foam.stress()).max() < 1e-9  # nothing pulls at it


def test_growth_follows_von_neumann():
    foam = relaxed(100, seed=5)
    before = {b["identity"]: b for b in foam.bubbles}
    foam.step(1e-3, settings=foamtex.StepSettings(kappa=0.1))
    assert foam.time == pytest.approx(1e-3)
    for bubble in foam.bubbles:
        old = before[bubble["identity"]]
        if old["sides"] == bubble["sides"]:
            law = 2 * math.pi / 3 * foam.film_tension / 2 * 0.1 * (bubble["sides"] - 6)
            assert (bubble["area"] - old["area"]) / 1e-3 == pytest.approx(law, abs=1e-5)


def test_drive_imposes_areas_strain_and_pushes():
    foam = relaxed(60, seed=1)
    identity = int(foam.bubbles["identity"][7])
    foam.step(0, areas={identity: 2.5})
    assert foam.bubbles["area"][foam.bubbles["identity"] == identity] == pytest.approx(2.5, rel=1e-9)
    foam.step(0, strain=0.05)
    assert foam.periods[1][0] == pytest.approx(0.05 * foam.periods[1][1])
    before = foam.state()
    foam.step(0, pushes=[((2.0, 2.0), 2.0, (0.5, 0.0))])
    assert foam.state() != before


def test_no_bubble_has_a_huge_identity():
    foam = relaxed(20)
    before = foam.bubbles["area"]
    foam.step(0, areas={2**32 + int(foam.bubbles["identity"][3]): 3.0, -1: 2.0})
    assert foam.bubbles["area"] == pytest.approx(before, rel=1e-9)


def test_a_step_of_nothing_reports_the_present_errors():
    raw = foamtex.Foam.torus(40)
    with pytest.raises(foamtex.EquilibriumError):
        raw.step(0)
    raw.relax()
    assert raw.step(0).angle_error < 1e-9


def test_stress_is_the_slope_of_the_energy():
    foam = relaxed(60, seed=4)
    h = 1e-3

    def energy_at(strain):
        sheared = foam.copy()
        sheared.step(0, strain=strain, settings=foamtex.StepSettings(t1_distance=1e-9, tolerance=1e-11))
        return sheared.energy

    slope = (8 * (energy_at(h) - energy_at(-h)) - energy_at(2 * h) + energy_at(-2 * h)) / (12 * h)
    stress = foam.stress()
    assert stress.shape == (2, 2) and stress[0, 1] == stress[1, 0]
    assert stress[0, 1] == pytest.approx(slope / 60, abs=1e-8)


def test_events_have_a_time_and_a_place():
    foam = foamtex.Foam.torus(100, seed=1)
    found = foam.relax()
    assert len(foam.take_events()) == found.t1
    assert foam.take_events() == []
    before = set(foam.bubbles["identity"])
    vanished = 0
    for _ in range(20):
        found = foam.step(2.0)
        events = foam.take_events()
        assert [event.kind for event in events].count("T2") == found.t2
        for event in events:
            assert foam.time - 2.0 <= event.time <= foam.time and len(event.position) == 2
            vanished += event.kind == "T2" and event.bubbles[0] in before
    assert vanished == 100 - len(foam) > 0


def test_the_shear_modulus_of_a_foam_is_positive():
    foam = relaxed(60, seed=4)
    modulus = foam.shear_modulus()
    h = 1e-5
    stresses = []
    for strain in (-h, h):
        sheared = foam.copy()
        sheared.step(0, strain=strain, settings=foamtex.StepSettings(tolerance=1e-11))
        stresses.append(sheared.stress()[0, 1])
    assert modulus == pytest.approx((stresses[1] - stresses[0]) / (2 * h), rel=1e-4) and modulus > 0.3
    patch = foamtex.Foam.disk(20)
    patch.relax()
    assert patch.shear_modulus() is None


def test_shapes_of_bubbles():
    bubbles = relaxed(60, seed=4).bubbles
    assert (bubbles["elongation"] >= 1).all() and (np.abs(bubbles["orientation"]) <= math.pi / 2).all()
    # A disk has the smallest perimeter of its area.
    assert (bubbles["perimeter"] > 2 * np.sqrt(math.pi * bubbles["area"])).all()


def test_state_and_files_keep_every_bit(tmp_path):
    foam = relaxed(40, seed=9)
    again = foamtex.Foam.from_state(foam.state())
    for one in (foam, again):
        one.step(0.5)
    assert foam.state() == again.state()
    foam.write(tmp_path / "a.json")  # any path
    assert foamtex.Foam.read(str(tmp_path / "a.json")).state() == foam.state()
    assert json.loads(foam.state())["format"]
    foam.to_evolver(str(tmp_path / "a.fe"))
    read = foamtex.Foam.from_evolver(str(tmp_path / "a.fe"))
    read.relax()
    assert read.energy == pytest.approx(foam.energy, rel=1e-10)


def test_a_copy_is_independent():
    foam = relaxed(40)
    copy = foam.copy()
    copy.step(1.0)
    assert foam.time == 0 and copy.time == 1


def test_arrays_keep_what_they_show_alive():
    areas = relaxed(40).bubbles["area"]  # the foam is gone
    assert areas.sum() == pytest.approx(40)
    with pytest.raises(ValueError):
        areas[0] = 1


@pytest.mark.parametrize(
    "call, kind, text",
    [
        (lambda foam, path: foamtex.Foam.torus(1), foamtex.ArgumentError, ""),
        (lambda foam, path: foamtex.Foam.torus(aspect=math.inf), foamtex.ArgumentError, "aspect"),
        (lambda foam, path: foamtex.Foam.torus(area_ratio=math.inf), foamtex.ArgumentError, "area_ratio"),
        (lambda foam, path: foamtex.Foam.torus(lloyd_iterations=-3), foamtex.ArgumentError, "lloyd_iterations"),
        (lambda foam, path: foamtex.Foam.disk(surface_tension=math.nan), foamtex.ArgumentError, "surface_tension"),
        (lambda foam, path: foam.step(0, strain=1e17), foamtex.ArgumentError, "strain"),
        (lambda foam, path: foam.step(0, pushes=[((0, 0), 1, (1e9, 0))]), foamtex.ArgumentError, "by"),
        (lambda foam, path: foam.relax(threads=2**20), foamtex.ArgumentError, "threads"),
        (lambda foam, path: foamtex.Foam.read(path + "/none.fe"), foamtex.InputError, "none.fe"),
        (lambda foam, path: foamtex.Foam.read(path + "/none.txt"), foamtex.ArgumentError, ".fe, .dmp or .json"),
        (lambda foam, path: foamtex.Foam.from_state("{"), foamtex.InputError, "state:1"),
        (lambda foam, path: foamtex.Foam.from_evolver(path + "/a.json"), foamtex.ArgumentError, "ends in .fe"),
        (lambda foam, path: foam.write(path + "/no/folder.fe"), foamtex.OutputError, "folder.fe"),
        (lambda foam, path: foam.step(-1), foamtex.ArgumentError, "time"),
        (lambda foam, path: foam.step(1, areas={0: -1}), foamtex.ArgumentError, "target_area"),
        (lambda foam, path: foam.step(1, pushes=[((0, 0), 99, (1, 0))]), foamtex.ArgumentError, "radius"),
        (lambda foam, path: foam.shear(math.nan), foamtex.ArgumentError, "strain"),
    ],
)
def test_errors_by_kind(tmp_path, call, kind, text):
    with pytest.raises(kind) as caught:
        call(relaxed(20), str(tmp_path))
    assert text in str(caught.value) and isinstance(caught.value, foamtex.Error)


def test_long_functions_release_the_gil():
    foam = foamtex.Foam.torus(4000, seed=1)
    ticks = 0
    done = threading.Event()

    def tick():
        nonlocal ticks
        while not done.is_set():
            ticks += 1
            time.sleep(0.001)

    ticker = threading.Thread(target=tick)
    ticker.start()
    foam.relax(threads=1)
    done.set()
    ticker.join()
    assert ticks > 20


def test_threads_may_share_a_foam():
    foam = relaxed(40, seed=2)
    threads = [threading.Thread(target=lambda: [foam.step(0.01) for _ in range(10)]) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert foam.time == pytest.approx(0.4)
