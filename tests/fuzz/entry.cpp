#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "tests/fuzz/targets.h"

// One program for each target, with the main of libFuzzer. A failed expectation ends it as an exception.

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  testing::InitGoogleTest();
  GTEST_FLAG_SET(throw_on_failure, true);
  return 0;
}

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const alidade::fuzz::Target& target : alidade::fuzz::targets())
    if (target.name == ALIDADE_FUZZ_TARGET) {
      target.run(bytes);
      return 0;
    }
  std::abort();
}
