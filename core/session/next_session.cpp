#include "core/session/next_session.h"

#include "core/session/session_fields.h"

namespace alidade {

Session nextSession(const Session& session) {
  Session next = blankSession();
  for (const SessionField& field : sessionFields())
    if (!field.isOfOneMeasurement) field.at(next) = field.get(session);
  next.instrument.record = session.instrument.record;
  next.instrument.known = session.instrument.known;
  next.protocol = session.protocol;
  return next;
}

}  // namespace alidade
