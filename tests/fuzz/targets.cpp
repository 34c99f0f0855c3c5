#include "tests/fuzz/targets.h"

namespace alidade::fuzz {

std::span<const Target> targets() {
  static constexpr Target all[] = {{"session", throwSession}, {"typing", throwTyping}, {"gsi", throwGsi},
                                   {"csv", throwCsv},         {"angles", throwAngles}, {"truth", throwTruth},
                                   {"records", throwRecords}, {"values", throwValues}, {"talk", throwTalk},
                                   {"formula", throwFormula}};
  return all;
}

}  // namespace alidade::fuzz
