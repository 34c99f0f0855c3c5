#include "core/base/given_arguments.h"

#include <gmock/gmock.h>

#include <vector>

namespace alidade {
namespace {

std::optional<std::string> emptyOf(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "program");
  return emptyArgument(static_cast<int>(arguments.size()), arguments.data());
}

TEST(GivenArguments, AreTakenWhereEachSaysSomething) {
  for (const std::vector<const char*>& call :
       {std::vector<const char*>{}, {"fit", "a"}, {"--out", "a"}, {"--out=a"}, {"--", "a"}, {"a=", " "}})
    EXPECT_EQ(emptyOf(call), std::nullopt);
}

TEST(GivenArguments, NameTheOptionWhoseValueIsEmpty) {
  for (const std::vector<const char*>& call :
       {std::vector<const char*>{"--out", ""}, {"--out="}, {"fit", "--out", "", "b"}, {"--a", "b", "--out="}})
    EXPECT_EQ(emptyOf(call), "--out is given an empty value: give a value, or leave the option out");
}

TEST(GivenArguments, CountWhereNoOptionStandsBefore) {
  EXPECT_EQ(emptyOf({""}), "argument 1 is empty: name a file, or leave it out");
  EXPECT_EQ(emptyOf({"fit", ""}), "argument 2 is empty: name a file, or leave it out");
  EXPECT_EQ(emptyOf({"fit", "--", ""}), "argument 3 is empty: name a file, or leave it out");
}

}  // namespace
}  // namespace alidade
