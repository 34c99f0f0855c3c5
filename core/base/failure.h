#pragma once

#include <functional>
#include <optional>
#include <string>

namespace alidade {

/// What to say of an exception that nothing expected, as the end of a sentence "The fit failed: …". Lack of
/// memory is called so; anything else is a fault of the program and is called one, with what the exception
/// says.

/// Of the exception being handled: only within a catch block.
std::string thrownReason();

/// Does `work` and keeps what it throws. Empty: it came to its end.
std::optional<std::string> failureOf(const std::function<void()>& work);

}  // namespace alidade
