#pragma once

#include <functional>
#include <optional>
#include <string>

namespace alidade {

/// The text for an unexpected exception, as the end of a sentence "The fit failed: …". It names a lack of
/// memory; anything else is reported as a fault of the program, with the exception's text.

/// Describes the exception being handled; call it only within a catch block.
std::string thrownReason();

/// Runs `work` and catches its exception. Empty: it completed.
std::optional<std::string> failureOf(const std::function<void()>& work);

}  // namespace alidade
