#!/bin/sh
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# What CMake asks of Doxygen when it looks for it: its version, and a template of settings: -s -g FILE.
if [ "$1" = --version ]; then
  echo 1.9.4
else
  echo '# Doxyfile 1.9.4' > "$3"
fi
