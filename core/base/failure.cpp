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
    return Phrase::of("a fault in the program (cause not reported)");
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

std::string sentencesOf(const FailedWork& failed) {
  const std::string work = Phrase::of(failed.work.c_str());
  return failed.isRecorded ? Phrase::of(
                                 "The %1 failed: %2. Nothing typed is lost; save the session and go on. A "
                                 "description of the fault is in %3.",
                                 work, failed.reason, failed.record)
                           : Phrase::of(
                                 "The %1 failed: %2. Nothing typed is lost; save the session and go on. A "
                                 "description of the fault could not be written to %3.",
                                 work, failed.reason, failed.record);
}

}  // namespace alidade
