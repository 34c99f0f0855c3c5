#include "tests/fuzz/pipeline.h"
#include "tests/fuzz/targets.h"
#include "tests/fuzz/typed_session.h"

namespace alidade::fuzz {

void throwTyping(std::string_view bytes) {
  workThrough(typedSession(bytes));
}

}  // namespace alidade::fuzz
