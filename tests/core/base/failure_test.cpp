#include "core/base/failure.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

namespace alidade {
namespace {

TEST(Failure, IsNoneOfWorkThatComesToItsEnd) {
  int done = 0;
  EXPECT_FALSE(failureOf([&] { done = 1; }));
  EXPECT_EQ(done, 1);
}

TEST(Failure, CallsLackOfMemorySo) {
  // Thrown as by `new`: a sanitizer would end the program at such an allocation.
  EXPECT_EQ(failureOf([] { throw std::bad_alloc(); }), "out of memory");
}

TEST(Failure, SaysWhatTheExceptionSays) {
  EXPECT_EQ(failureOf([] { throw std::out_of_range("row 7 of 5"); }), "a fault in the program (row 7 of 5)");
}

TEST(Failure, HoldsWhateverIsThrown) {
  EXPECT_EQ(failureOf([] { throw 7; }), "a fault in the program (cause not reported)");
}

}  // namespace
}  // namespace alidade
