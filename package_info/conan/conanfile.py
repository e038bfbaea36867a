# SPDX-License-Identifier: LGPL-3.0-or-later
"""conan create package_info/conan"""

import os

from conan import ConanFile
from conan.tools.files import copy


class FlipGeodesics(ConanFile):
    name = "flip-geodesics"
    version = "0.1.0"
    description = "Geodesic curves on triangle meshes by edge flips, for CGAL"
    license = "LGPL-3.0-or-later"
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    requires = "cgal/[>=5.5]"

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..")
        for pattern in ("LICENSE", "include/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        copy(self, "*.h", os.path.join(self.source_folder, "include"), os.path.join(self.package_folder, "include"))

    def package_id(self):
        self.info.clear()

    def package_info(self):
        self.cpp_info.bindirs = self.cpp_info.libdirs = []
        self.cpp_info.cxxflags = ["-frounding-math", "-ffp-contract=off"]
        self.cpp_info.set_property("cmake_file_name", "Flip_geodesics")
        self.cpp_info.set_property("cmake_target_name", "CGAL::Flip_geodesics")
        self.cpp_info.requires = ["cgal::cgal"]
