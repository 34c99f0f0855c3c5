#pragma once

#include <functional>
#include <optional>
#include <string>

namespace alidade {

/// The text for the exception being handled, as the end of a sentence "The fit failed: …". It names a lack of
/// memory; anything else is reported as a fault of the program, with the exception's text. Call it only
/// within a catch block.
std::string thrownReason();

/// Runs `work`. If it throws, returns the `thrownReason`; absent if it completes.
std::optional<std::string> failureOf(const std::function<void()>& work);

/// Work that an exception ended, and the record for reporting the fault.
struct FailedWork {
  std::string work;         ///< "fit": a phrase, as in "The fit failed"
  std::string reason;       ///< text of `thrownReason`
  std::string record = {};  ///< path of the record, or of the folder where it could not be written
  bool isRecorded = false;
};

/// Sentences that say what failed and why, that nothing typed is lost, and where the record is.
std::string sentencesOf(const FailedWork& failed);

}  // namespace alidade
