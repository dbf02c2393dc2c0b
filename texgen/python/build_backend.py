# SPDX-License-Identifier: Apache-2.0
"""Builds wheels and source packages of foamtex as PEP 517 asks: CMake compiles, and pyproject.toml has the metadata."""
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib

from wheel.wheelfile import WheelFile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def project():
    return tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def version():
    """The version of the project, which CMakeLists.txt contains."""
    return re.search(r"project\(foamtex VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def metadata():
    """The content of the file METADATA of a wheel, and of the file PKG-INFO of a source package."""
    facts = project()
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {facts['name']}",
        f"Version: {version()}",
        f"Summary: {facts['description']}",
        f"License: {facts['license']['text']}",
        f"Requires-Python: {facts['requires-python']}",
        *(f"Requires-Dist: {name}" for name in facts["dependencies"]),
        "Description-Content-Type: text/markdown",
        "",
        (ROOT / facts["readme"]).read_text(),
    ]
    return "\n".join(lines)


def entry_points():
    lines = []
    for group, entries in project()["entry-points"].items():
        lines += [f"[{group}]", *(f"{name} = {target}" for name, target in entries.items()), ""]
    return "\n".join(lines)


def compile_package(folder):
    """Compiles the package and installs it into a folder."""
    with tempfile.TemporaryDirectory() as build:
        settings = {
            "CMAKE_BUILD_TYPE": "Release", "CMAKE_UNITY_BUILD": "ON", "FOAM_TESTS": "OFF", "FOAM_BENCHMARKS": "OFF",
            "FOAM_LIBRARIES": "OFF", "FOAM_PYTHON": "ON", "FOAMTEX_PYTHON_FOLDER": ".",
            "Python3_EXECUTABLE": sys.executable,
        }
        build = os.environ.get("FOAMTEX_BUILD", build)  # a folder that is kept, to compile less the next time
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja"] +
                       [f"-D{key}={value}" for key, value in settings.items()], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "_foamtex"], check=True)
        subprocess.run(["cmake", "--install", build, "--prefix", folder, "--component", "python", "--strip"], check=True)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    name = f"foamtex-{version()}-{tag}.whl"
    information = f"foamtex-{version()}.dist-info"
    with tempfile.TemporaryDirectory() as folder, WheelFile(os.path.join(wheel_directory, name), "w") as wheel:
        compile_package(folder)
        wheel.write_files(folder)
        wheel.writestr(f"{information}/METADATA", metadata())
        wheel.writestr(f"{information}/entry_points.txt", entry_points())
        wheel.writestr(f"{information}/LICENSE", (ROOT / "LICENSE").read_text())
        wheel.writestr(f"{information}/WHEEL",
                       f"Wheel-Version: 1.0\nGenerator: foamtex\nRoot-Is-Purelib: false\nTag: {tag}\n")
    return name


def source_files():
    """The files of the source package: those that git tracks or, without git, all files that are not generated."""
    if (ROOT / ".git").exists():
        names = subprocess.check_output(["git", "ls-files", "-z"], cwd=ROOT, text=True).split("\0")[:-1]
        return [ROOT / name for name in names]
    left_out = {"build", "__pycache__", "PKG-INFO"}
    return [path for path in ROOT.rglob("*")
            if path.is_file() and not left_out & set(path.relative_to(ROOT).parts)]


def build_sdist(sdist_directory, config_settings=None):
    name = f"foamtex-{version()}"
    with tempfile.TemporaryDirectory() as folder:
        information = pathlib.Path(folder, "PKG-INFO")
        information.write_text(metadata())
        with tarfile.open(os.path.join(sdist_directory, f"{name}.tar.gz"), "w:gz") as archive:
            for path in source_files():
                archive.add(path, f"{name}/{path.relative_to(ROOT)}", recursive=False)
            archive.add(information, f"{name}/PKG-INFO")
    return f"{name}.tar.gz"
