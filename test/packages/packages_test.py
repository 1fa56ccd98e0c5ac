# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The Debian packages: made by CPack, unpacked below a root of their own, and used there.
#
#   packages_test.py BUILD_DIR

import gzip
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
SCAN = SOURCE / "data" / "room.pcd"
TOOLS = [f"pcl_cid_{verb}" for verb in ("abstract", "evaluate", "segment", "simulate", "studio")]


def run(*command, **options):
    """What a command prints; it must succeed."""
    done = subprocess.run([str(part) for part in command], text=True, capture_output=True, **options)
    if done.returncode != 0:
        sys.exit(f"{command}: exit {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class Packages:
    """The packages of a build folder, and a root with their files."""

    def __init__(self, build):
        self.build = build
        self.work = build / "packages_test"
        self.root = self.work / "root"
        self.usr = self.root / "usr"
        cache = (build / "CMakeCache.txt").read_text()
        shutil.rmtree(self.work, ignore_errors=True)
        shutil.rmtree(build / "packages", ignore_errors=True)
        self.root.mkdir(parents=True)
        run("cpack", "--config", build / "CPackConfig.cmake", cwd=build)
        self.debs = {run("dpkg-deb", "-f", deb, "Package").strip(): deb for deb in (build / "packages").glob("*.deb")}
        for deb in self.debs.values():
            run("dpkg-deb", "-x", deb, self.root)
        self.libraries = next(self.usr.glob("lib/*/libpcl_cid.so")).parent
        self.environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1")
        # Without a search path of their own, tools look where the system says.
        if "CMAKE_SKIP_INSTALL_RPATH:BOOL=ON" in cache or "CMAKE_SKIP_INSTALL_RPATH:STRING=ON" in cache:
            self.environment["LD_LIBRARY_PATH"] = str(self.libraries)

    def field(self, package, name):
        return run("dpkg-deb", "-f", self.debs[package], name)

    def use(self, *command, **options):
        return run(*command, env=self.environment, **options)


def the_four_packages_are_there(packages):
    assert re.fullmatch(
        r"libpcl-cid-dev libpcl-cid\d+\.\d+ pcl-cid-tools python3-pcl-cid", " ".join(sorted(packages.debs))
    ), packages.debs


def each_says_what_it_needs(packages):
    library = next(name for name in packages.debs if re.fullmatch(r"libpcl-cid[\d.]+", name))
    version = packages.field(library, "Version").strip()
    assert "libpcl-surface" in packages.field(library, "Depends")
    for package in packages.debs.keys() - {library}:
        assert f"{library} (= {version})" in packages.field(package, "Depends"), package
    assert "libpcl-dev" in packages.field("libpcl-cid-dev", "Depends")
    assert "libboost-program-options" in packages.field("pcl-cid-tools", "Depends")
    python = packages.field("python3-pcl-cid", "Depends")
    minor = int(run("/usr/bin/python3", "-c", "import sys; print(sys.version_info.minor)"))
    assert f"python3 (>= 3.{minor}), python3 (<< 3.{minor + 1})" in python and "python3-numpy" in python, python
    for package in packages.debs:
        documents = packages.usr / "share/doc" / package
        assert "Redistribution and use" in (documents / "copyright").read_text(), package
        assert b"pcl_cid_segment" in gzip.open(documents / "changelog.gz").read(), package


def nothing_is_lost_between_them(packages):
    """All that an installation has, but for what is for reading."""
    whole = packages.work / "whole"
    run("cmake", "--install", packages.build, env=dict(os.environ, DESTDIR=str(whole)))

    def files(root):
        there = (path.relative_to(root) for path in root.rglob("*") if not path.is_dir())
        return {str(path) for path in there if not str(path).startswith("usr/share/doc/")}

    assert files(whole) == files(packages.root), files(whole) ^ files(packages.root)


def the_tools_work(packages):
    for tool in TOOLS:
        assert packages.use(packages.usr / "bin" / tool, "--version").startswith(f"{tool} ")
    made = {}
    for place in (packages.usr / "bin", packages.build / "bin"):
        made[place] = packages.work / f"{place.parent.name}.ply"
        packages.use(place / "pcl_cid_segment", SCAN, made[place], "--seeds", 5, "--quiet")
    first, second = (path.read_bytes() for path in made.values())
    assert first == second


def a_project_is_built_with_cmake(packages):
    print(packages.use(
        "cmake", f"-DPREFIX={packages.usr}", f"-DWORK_DIR={packages.work / 'consumer'}", "-P",
        SOURCE / "test/consumer/run.cmake",
    ))


def a_project_is_built_with_pkg_config(packages):
    environment = dict(packages.environment, PKG_CONFIG_PATH=str(packages.libraries / "pkgconfig"))
    flags = run("pkg-config", "--cflags", "--libs", "pcl_cid_io", env=environment).split()
    program = packages.work / "by_pkg_config"
    run(
        "c++", "-std=c++17", SOURCE / "doc/examples/segment_and_abstract.cpp", *flags,
        *run("pkg-config", "--libs", "pcl_io").split(), f"-Wl,-rpath,{packages.libraries}", "-o", program,
    )
    run(program, SCAN, cwd=packages.work)


def the_module_is_imported(packages):
    script = "import pcl_cid, numpy; scan = pcl_cid.Scan(numpy.eye(3)); scan.propose(2); print(pcl_cid.__file__)"
    module = packages.usr / "lib/python3/dist-packages"
    packages.environment["PYTHONPATH"] = str(module)
    assert str(module) in packages.use("/usr/bin/python3", "-c", script)


def the_manual_pages_are_clean(packages):
    """man finds nothing to warn of, and shows every option that the help has."""
    for tool in TOOLS:
        page = packages.usr / f"share/man/man1/{tool}.1.gz"
        shown = subprocess.run(
            ["man", "--warnings", "-E", "UTF-8", "-l", str(page)],
            env=dict(os.environ, MANWIDTH="1000", LC_ALL="C.UTF-8"), text=True, capture_output=True,
        )
        assert shown.returncode == 0 and not shown.stderr, shown.stderr
        assert not re.search(r"\.(PP|TP|br|E[XE]|S[HS])\b", shown.stdout), shown.stdout
        options = re.findall(r"^  (?:-\w \[ )?(--[\w-]+)", packages.use(packages.usr / "bin" / tool, "--help"), re.M)
        assert len(options) > 8, options
        for option in options:
            assert re.search(rf"^ +(-\w, )?{option}( |$)", shown.stdout, re.M), (tool, option)


def completed(packages, *words, folder=None):
    """What bash would offer for the last word."""
    script = (
        f"source {packages.usr}/share/bash-completion/completions/{words[0]}; "
        'COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '
        f"read -r _ _ function _ < <(complete -p {words[0]}); $function; "
        'printf "%s\\n" "${COMPREPLY[@]}"'
    )
    offered = run("bash", "-c", script, "bash", *words, cwd=folder or packages.work)
    return sorted(offered.split("\n")[:-1])


def bash_completes(packages):
    folder = packages.work / "completion"
    folder.mkdir()
    (folder / "more scans").mkdir()
    for name in ("a room.pcd", "b.PLY", "seeds.csv", "hulls.obj", "notes.md"):
        (folder / name).touch()

    def offers(*words):
        return completed(packages, *words, folder=folder)

    scans = ["a room.pcd", "b.PLY", "hulls.obj", "more scans", "seeds.csv"]
    assert offers("pcl_cid_segment", "") == scans
    assert offers("pcl_cid_segment", "a") == ["a room.pcd"]
    assert offers("pcl_cid_segment", "--labels", "") == ["more scans", "seeds.csv"]
    assert offers("pcl_cid_segment", "--labels", "=", "s") == ["seeds.csv"]
    assert offers("pcl_cid_segment", "--labels", "=") == ["more scans", "seeds.csv"]
    assert offers("pcl_cid_segment", "--density", "") == ["auto", "off", "on"]
    assert offers("pcl_cid_segment", "--seeds", "") == [""]
    assert offers("pcl_cid_segment", "a.pcd", "--lab") == ["--label-type", "--labels", "--labels-from"]
    assert offers("pcl_cid_abstract", "a.pcd", "") == scans
    # An option's value is no file.
    assert "hulls.obj" in offers("pcl_cid_abstract", "--parts", "5", "a.pcd", "")
    assert offers("pcl_cid_abstract", "--parts", "5", "--curve", "") != scans
    assert "hulls.obj" in offers("pcl_cid_abstract", "--parts", "=", "5", "a.pcd", "")
    assert offers("pcl_cid_abstract", "--viewpoints", "c") == ["cloud"]
    assert offers("pcl_cid_evaluate", "--classes", "s") == ["s3dis", "scannet", "seeds.csv"]
    assert offers("pcl_cid_simulate", "a.pcd", "b.PLY", "") == scans
    assert "--no-browser" in offers("pcl_cid_studio", "--")


def the_desktop_knows_the_studio(packages):
    share = packages.usr / "share"
    run("desktop-file-validate", share / "applications/pcl_cid_studio.desktop")
    run("appstreamcli", "validate", "--no-net", share / "metainfo/pcl_cid_studio.metainfo.xml")
    mime = packages.work / "mime"
    shutil.copytree(share / "mime", mime)
    shutil.copy("/usr/share/mime/packages/freedesktop.org.xml", mime / "packages")
    run("update-mime-database", mime)
    # Kodak's pictures have the same extension; the heavier one of the two wins.
    of_pcd = [line.split(":") for line in (mime / "globs2").read_text().splitlines() if line.endswith(":*.pcd")]
    assert max(of_pcd, key=lambda weight: int(weight[0]))[1] == "application/x-pcd", of_pcd


def main(build):
    packages = Packages(build.resolve())
    for check in (
        the_four_packages_are_there,
        each_says_what_it_needs,
        nothing_is_lost_between_them,
        the_tools_work,
        a_project_is_built_with_cmake,
        a_project_is_built_with_pkg_config,
        the_module_is_imported,
        the_manual_pages_are_clean,
        bash_completes,
        the_desktop_knows_the_studio,
    ):
        check(packages)
        print(check.__name__.replace("_", " "), flush=True)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
