# SPDX-License-Identifier: Apache-2.0
import gc
import json
import os
import pickle
import resource
import signal
import subprocess
import sys
import threading
import time

import jsonschema
import numpy as np
import pytest
from PIL import Image

import foamtex

SMALL = {"foam.bubbles": 60, "image.size": [64, 64], "frames.count": 4}


def test_pixels_are_those_of_the_program(tmp_path):
    values = {**SMALL, "image.maps": ["lit", "albedo", "normal", "height", "motion", "pressure"]}
    preset = foamtex.Preset("sea_foam", values)
    preset.fit_ranges()
    arguments = [f"{key}={json.dumps(value)}" for key, value in values.items()]
    command = [os.environ["FOAMTEX"], "bake", "sea_foam", "--out", str(tmp_path / "{map}.####.png"), "-q"]
    subprocess.run(command + [word for one in arguments for word in ("--set", one)], check=True)
    for frame in preset.simulate():
        for name in values["image.maps"]:
            baked = tmp_path / f"{name}.{frame.number:04}.png"
            bits = baked.read_bytes()[24]  # of the header IHDR
            image = frame.map(name, f"uint{bits}")
            foamtex.write_png(str(tmp_path / "drawn.png"), image)
            assert all(foamtex.compare(str(baked), str(tmp_path / "drawn.png"), sample=0)), name
            if bits == 8:
                assert (np.asarray(Image.open(baked)).reshape(image.shape) == image).all(), name


def test_float_images_are_numbers_and_linear_light():
    frame = next(foamtex.Preset("lava", {"image.size": [64, 64]}).simulate("1"))
    light = frame.map("albedo")
    codes = frame.map("albedo", np.uint8) / 255.0
    assert light.dtype == np.float32 and light.shape == (64, 64, 3)
    srgb = np.where(light <= 0.0031308, 12.92 * light, 1.055 * np.maximum(light, 1e-9) ** (1 / 2.4) - 0.055)
    assert np.abs(srgb - codes).max() < 0.51 / 255
    assert frame.map("id").dtype == np.float32
    assert set(np.unique(frame.map("id"))) <= set(frame.bubbles["identity"] + 1)  # 0 is the surroundings


def test_images_are_not_copied_and_the_top_row_is_first():
    frame = next(foamtex.Preset("sea_foam", SMALL).simulate("1"))
    image = frame.map("pressure")
    assert image.base is not None and image.strides[0] < 0  # rows of an image run upward in memory
    highest = frame.bubbles[np.argmax(frame.bubbles["area"])]
    width = np.sqrt(60)
    column = int(highest["x"] % width / width * 64)
    row = 63 - int(highest["y"] % width / width * 64)
    assert frame.map("id")[row, column, 0] == highest["identity"] + 1


def test_records_are_views_of_the_frame():
    frame = next(foamtex.Preset("sea_foam", SMALL).simulate("1"))
    bubbles = frame.bubbles
    assert bubbles.base is frame and not bubbles.flags.writeable
    total = bubbles["area"].sum()
    del frame
    gc.collect()
    assert bubbles["area"].sum() == total == pytest.approx(60)


def test_frames_come_in_order_and_may_be_selected():
    preset = foamtex.Preset("sea_foam", SMALL)
    assert [frame.number for frame in preset.simulate()] == [1, 2, 3, 4]
    assert [frame.number for frame in preset.simulate("2-4x2")] == [2, 4]
    assert preset.frame_count == 4 and (preset.width, preset.height) == (64, 64)


def test_a_simulation_may_be_left_early():
    started = time.monotonic()
    simulation = foamtex.Preset("sea_foam", {"frames.count": 1000, "loop.kind": "none"}).simulate()
    next(simulation)
    del simulation
    assert time.monotonic() - started < 60


@pytest.mark.parametrize(
    "work",
    [
        "for frame in foamtex.Preset('sea_foam', {'foam.bubbles': 30000}).simulate('400'): pass",
        "foamtex.Foam.torus(60000).relax(threads=1)",
        "foam = foamtex.Foam.torus(2000); foam.relax(); foam.step(1000, settings=foamtex.StepSettings(kappa=1))",
    ],
)
def test_ctrl_c_ends_long_work(work):
    program = f"import foamtex\nprint('ready', flush=True)\n{work}\nprint('done')\n"
    process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    process.stdout.readline()
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    output, error = process.communicate(timeout=120)
    assert b"KeyboardInterrupt" in error, error
    assert b"done" not in output


def test_other_threads_run_during_a_simulation():
    counted = []
    stop = threading.Event()
    thread = threading.Thread(target=lambda: [counted.append(1) or time.sleep(0.001) for _ in iter(stop.is_set, True)])
    thread.start()
    for frame in foamtex.Preset("sea_foam", {"image.size": [512, 512], "frames.count": 2}).simulate():
        frame.map("lit")
    stop.set()
    thread.join()
    assert len(counted) > 20


def test_keys_that_are_set_during_fit_ranges_are_kept():
    preset = foamtex.Preset("sea_foam", {**SMALL, "foam.bubbles": 2000, "image.maps": ["height"]})
    thread = threading.Thread(target=preset.fit_ranges)
    thread.start()
    time.sleep(0.1)
    preset.set({"foam.seed": 5})
    thread.join()
    assert preset.get("foam.seed") == "5"


def test_threads_may_draw_one_frame():
    frame = next(foamtex.Preset("sea_foam", SMALL).simulate("1"))
    images = []
    threads = [threading.Thread(target=lambda: images.append(frame.map("lit", np.uint8))) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all((image == images[0]).all() for image in images)


def test_no_memory_is_lost_over_10000_frames():
    frame = next(foamtex.Preset("sea_foam", {**SMALL, "image.size": [16, 16]}).simulate("1"))

    def draw(count):
        for _ in range(count):
            frame.map("pressure")
            frame.bubbles["area"].sum()
        gc.collect()
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # KiB

    before = draw(1000)
    assert draw(9000) - before < 4096


def test_no_memory_is_lost_over_a_simulation_of_10000_frames():
    values = {**SMALL, "foam.bubbles": 16, "image.size": [16, 16], "frames.count": 10000, "loop.kind": "none",
              "dynamics.kappa": 0}
    before = None
    for frame in foamtex.Preset("relax", values).simulate(threads=1):
        frame.map("pressure")
        frame.bubbles["area"].sum()
        if frame.number == 1000:
            before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    assert frame.number == 10000
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 4096


def test_no_memory_is_lost_over_many_simulations():
    def run(count):
        for _ in range(count):
            for frame in foamtex.Preset("sea_foam", {**SMALL, "foam.bubbles": 20}).simulate():
                frame.map("albedo")
        gc.collect()
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    before = run(20)
    assert run(100) - before < 8192


def test_bake_reports_progress_and_returns_files(tmp_path):
    seen = []
    files = foamtex.bake(
        foamtex.Preset("sea_foam", {**SMALL, "image.maps": ["albedo"]}), str(tmp_path / "out"), frames="1-2",
        progress=lambda progress: seen.append((progress.phase, progress.done, str(progress))))
    assert [os.path.basename(name) for name in files] == ["sea_foam_albedo.0001.png", "sea_foam_albedo.0002.png"]
    assert all(os.path.exists(name) for name in files) and (tmp_path / "out" / "manifest.json").exists()
    assert seen[-1] == ("frames", 2, "frames 2/2")


def test_an_exception_of_progress_ends_a_bake(tmp_path):
    def fail(progress):
        raise KeyError("enough")

    with pytest.raises(KeyError):
        foamtex.bake(foamtex.Preset("sea_foam", SMALL), str(tmp_path), progress=fail)


def test_compare_finds_the_largest_difference(tmp_path):
    a = np.zeros((4, 5, 3), np.uint8)
    b = a.copy()
    b[1, 3, 2] = 51
    for name, image in (("a.png", a), ("b.png", b)):
        foamtex.write_png(str(tmp_path / name), image)
    (found,) = foamtex.compare(str(tmp_path / "a.png"), str(tmp_path / "b.png"), picture=str(tmp_path / "d.png"))
    assert not found and (found.x, found.y, found.channel) == (3, 1, "B")
    assert found.largest == pytest.approx(0.2) and found.reasons and (tmp_path / "d.png").exists()
    assert all(foamtex.compare(str(tmp_path / "a.png"), str(tmp_path / "b.png"), sample=0.21))
    for name, limit in (("sample", float("nan")), ("rms", -1), ("angle", -2), ("allowed_percent", 101)):
        with pytest.raises(foamtex.ArgumentError, match=rf"limits\.{name}: must be .*, but is {limit}$"):
            foamtex.compare(tmp_path / "a.png", tmp_path / "b.png", **{name: limit})
    foamtex.write_png(tmp_path / "c.png", pickle.loads(pickle.dumps(b)))
    assert all(foamtex.compare(tmp_path / "b.png", tmp_path / "c.png"))
    with pytest.raises(foamtex.InputError, match="missing.png"):
        foamtex.compare(str(tmp_path / "a.png"), str(tmp_path / "missing.png"))


@pytest.mark.parametrize("type", [np.uint8, np.uint16])
@pytest.mark.parametrize("channels", [1, 3, 4])
def test_write_png_keeps_every_sample(tmp_path, type, channels):
    image = np.random.default_rng(1).integers(0, np.iinfo(type).max, (7, 5, channels)).astype(type)
    name = str(tmp_path / "a.png")
    foamtex.write_png(name, image)
    foamtex.write_png(str(tmp_path / "b.png"), image[::-1][::-1])
    assert all(foamtex.compare(name, str(tmp_path / "b.png")))
    if type == np.uint8:
        assert (np.asarray(Image.open(name)).reshape(image.shape) == image).all()
    with pytest.raises(foamtex.ArgumentError, match="write_png"):
        foamtex.write_png(name, image.astype(np.float32))


def test_ranges_are_fitted_for_any_files():
    heights = []
    for pattern in ("{map}.####.png", "{map}.####.exr"):
        preset = foamtex.Preset("sea_foam", {**SMALL, "image.maps": ["height"], "output.pattern": pattern})
        preset.fit_ranges()
        heights.append(next(preset.simulate("1")).map("height", "uint16"))
        assert preset.get("output.pattern") == f'"{pattern}"'
    assert (heights[0] == heights[1]).all()


def test_texts_in_lists_are_kept():
    preset = foamtex.Preset("sea_foam")
    with pytest.raises(foamtex.ArgumentError, match="None"):
        preset.set({"foam.seed": None})
    with pytest.raises(foamtex.ArgumentError, match="color"):
        preset.set({"albedo.colors": ["a\\b", "#ffffff"]})


def test_values_of_numpy_are_values_of_keys():
    preset = foamtex.Preset("sea_foam", {
        "foam.bubbles": np.int64(70), "loop.amplitude": np.float64(0.25), "image.size": np.array([64, 32])})
    keys = ["foam.bubbles", "loop.amplitude", "image.size"]
    assert [preset.get(key) for key in keys] == ["70", "0.25", "[64, 32]"]


def test_a_running_simulation_is_dropped_without_the_gil():
    simulation = foamtex.Preset("sea_foam", {"foam.bubbles": 20000, "loop.kind": "none"}).simulate("50")
    ticks = []
    stop = threading.Event()
    thread = threading.Thread(target=lambda: [ticks.append(time.sleep(0.001)) for _ in iter(stop.is_set, True)])
    thread.start()
    time.sleep(0.3)
    before = len(ticks)
    started = time.monotonic()
    del simulation
    waited = time.monotonic() - started
    stop.set()
    thread.join()
    assert len(ticks) - before > waited * 50  # at 1 kHz, unless the machine is very busy


def test_presets_and_keys():
    schema = foamtex.key_schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    assert "sea_foam" in foamtex.presets()
    assert {"albedo", "height", "motion"} <= {one.name for one in foamtex.maps()}
    preset = foamtex.Preset("sea_foam")
    preset.set({"foam.bubbles": 77, "image.size": [64, 32], "albedo.colors": ["#ff0000", "#00ff00"]})
    assert preset.get("foam.bubbles") == "77" and (preset.width, preset.height) == (64, 32)
    assert "bubbles = 77" in preset.toml()


@pytest.mark.parametrize(
    "call, text",
    [
        (lambda: foamtex.Preset("sea_form"), "sea_foam"),
        (lambda: foamtex.Preset("sea_foam", {"foam.bubbels": 3}), "foam.bubbles"),
        (lambda: foamtex.Preset("sea_foam", {"foam.bubbles": -3}), "-3"),
        (lambda: foamtex.Preset("sea_foam").get("foam.x"), "unknown key"),
        (lambda: foamtex.Preset("sea_foam").simulate("x"), "x"),
        (lambda: next(foamtex.Preset("sea_foam", SMALL).simulate("1")).map("albdeo"), "albedo"),
        (lambda: next(foamtex.Preset("sea_foam", SMALL).simulate("1")).map("motion"), "image.maps"),
        (lambda: next(foamtex.Preset("sea_foam", SMALL).simulate("1")).map("height", np.uint8), "fit_ranges"),
        (lambda: next(foamtex.Preset("sea_foam", SMALL).simulate("1")).map("lit", np.uint16), "8 bits"),
        (lambda: next(foamtex.Preset("sea_foam", SMALL).simulate("1")).map("lit", np.int64), "dtype"),
    ],
)
def test_bad_arguments_name_what_is_allowed(call, text):
    with pytest.raises(foamtex.ArgumentError) as caught:
        call()
    assert text in str(caught.value)


def test_a_loop_that_does_not_close_is_an_error():
    preset = foamtex.Preset("sea_foam", {**SMALL, "loop.kind": "breathe", "loop.amplitude": 0.9, "loop.cycles": 1})
    with pytest.raises(foamtex.EquilibriumError):
        list(preset.simulate())
