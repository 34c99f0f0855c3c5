#include "core/base/failure.h"

#include <exception>
#include <new>

namespace alidade {

std::string thrownReason() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::exception& error) {
    return "a fault in the program (" + std::string(error.what()) + ")";
  } catch (...) {
    return "a fault in the program (of a kind that says nothing)";
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
