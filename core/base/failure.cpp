#include "core/base/failure.h"

#include <exception>
#include <new>

#include "core/base/phrase.h"

namespace alidade {

std::string thrownReason() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return Phrase::of("out of memory");
  } catch (const std::exception& error) {
    return Phrase::of("a fault in the program (%1)", error.what());
  } catch (...) {
    return Phrase::of("a fault in the program (of a kind that says nothing)");
  }
}

std::optional<std::string> failureOf(const std::function<void()>& work) {
  try {
    work();
    return std::nullopt;
  } catch (...) {
    return thrownReason();
  }
}

}  // namespace alidade
