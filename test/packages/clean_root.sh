#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# The Debian packages in a Debian of nothing but the base: apt finds what they depend on, and
# tools, headers, CMake's package and the Python module are used as their users would.
#
#   clean_root.sh FOLDER_OF_PACKAGES ROOT

set -euo pipefail
packages=$(realpath "$1")
root=$2
source_dir=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")

[ -e "$root" ] && { echo "$root: is there already; choose another folder" >&2; exit 1; }
debootstrap --variant=minbase bookworm "$root"
mkdir -p "$root/work"
cp "$packages"/*.deb "$source_dir/data/room.pcd" "$source_dir/doc/examples/segment_and_abstract.cpp" "$root/work"
cp /etc/resolv.conf "$root/etc/resolv.conf"
# How this machine reaches Debian, updates included.
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
rm "$root/etc/apt/sources.list"
for source in sources.list sources.list.d keyrings; do
  if [ -e "/etc/apt/$source" ]; then cp -r "/etc/apt/$source" "$root/etc/apt/"; fi
done
cp -rn /usr/share/keyrings/. "$root/usr/share/keyrings/"

# Java's packages, which VTK's want, look there.
mount -t proc proc "$root/proc"
trap 'umount "$root/proc"' EXIT

inside() {
  chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive \
    bash -euo pipefail -c "cd /work; $1"
}
inside 'apt-get -qq update; apt-get -qq install --yes --no-install-recommends ./*.deb'
inside 'pcl_cid_segment room.pcd labelled.pcd --seeds 20; pcl_cid_abstract room.pcd hulls.obj --parts 10 --verify'
inside 'python3 -c "
import pcl_cid
cloud = pcl_cid.read(\"room.pcd\")
scan = pcl_cid.Scan(cloud.points)
scan.propose(20)
assert len(set(scan.labels())) == 20
print(\"coverage\", scan.coverage)"'
inside 'apt-get -qq install --yes --no-install-recommends build-essential cmake ninja-build pkg-config'
inside 'cat > CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.22)
project(user LANGUAGES C CXX)
find_package(pcl_cid REQUIRED)
find_package(PCL REQUIRED COMPONENTS io)
add_executable(user segment_and_abstract.cpp)
target_link_libraries(user PRIVATE pcl_cid::pcl_cid pcl_cid::pcl_cid_io pcl_io)
END
cmake -G Ninja -B by_cmake; cmake --build by_cmake; by_cmake/user room.pcd'
inside 'c++ -std=c++17 segment_and_abstract.cpp $(pkg-config --cflags --libs pcl_cid_io pcl_io) -o by_pkg_config
./by_pkg_config room.pcd'
echo "All four packages were installed and used in $root."
