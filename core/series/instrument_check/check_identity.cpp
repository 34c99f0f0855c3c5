#include "core/base/phrase.h"
#include "core/series/instrument_check/check_readings.h"
#include "core/session/entry.h"

namespace alidade {

Result<CheckIdentity> identityOf(const CheckIdentity& typed, const CheckIdentity& read) {
  const auto either = [](const std::string& one, const std::string& other) {
    return one.empty() ? other : one;
  };
  CheckIdentity identity{.name = either(typed.name, read.name),
                         .serial = either(typed.serial, read.serial),
                         .measuredOn = either(typed.measuredOn, read.measuredOn),
                         .due = typed.due,
                         .circle = read.circle};
  if (const auto problem = dateProblem(typed.measuredOn))
    return Problem{Phrase::of("The day of the check %1", problem->what)};
  if (dateProblem(identity.measuredOn)) identity.measuredOn.clear();
  if (const auto problem = dateProblem(identity.due))
    return Problem{Phrase::of("The day of the next check %1", problem->what)};
  if (!identity.due.empty() && identity.due <= identity.measuredOn)
    return Problem{
        Phrase::of("The day of the next check, %1, is not after that of this check, %2: correct one "
                   "of the two",
                   identity.due, identity.measuredOn)};
  return identity;
}

}  // namespace alidade
