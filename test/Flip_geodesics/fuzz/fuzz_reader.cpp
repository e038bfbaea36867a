// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A program of libFuzzer for the target whose name it is linked with.

#include "reader_targets.h"

#include <cstddef>
#include <cstdint>
#include <string>

extern const char* const fuzz_target;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const reader_targets::Target target = reader_targets::all().at(fuzz_target);
  target(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
