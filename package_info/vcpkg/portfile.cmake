# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Installs the sources that contain this file: vcpkg install flip-geodesics --overlay-ports=FOLDER/package_info/vcpkg

set(VCPKG_BUILD_TYPE release) # headers only
get_filename_component(SOURCE_PATH "${CURRENT_PORT_DIR}/../.." ABSOLUTE)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS -DFLIP_GEODESICS_BUILD_TESTS=OFF
                                                           -DFLIP_GEODESICS_BUILD_EXAMPLES=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME Flip_geodesics CONFIG_PATH share/cmake/Flip_geodesics)
vcpkg_fixup_pkgconfig()
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
