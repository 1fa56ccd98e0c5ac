# SPDX-License-Identifier: BSD-3-Clause
#
# pcl_cid: Concavity-Induced Distance for point clouds
# Copyright (c) 2026, pcl_cid contributors
#
# Prints the folder for modules below a prefix.
#
#   site_folder.py PREFIX

import sys
import sysconfig
from pathlib import Path


def main(prefix):
    own = Path(sysconfig.get_path("platlib"))
    if own.is_relative_to(prefix):
        return own.relative_to(prefix)
    places = {"base": "/prefix", "platbase": "/prefix"}
    return Path(sysconfig.get_path("platlib", "posix_prefix", places)).relative_to("/prefix")


if __name__ == "__main__":
    print(main(sys.argv[1]))
