#include "core/session/next_session.h"

#include <algorithm>

#include "core/session/session_fields.h"

namespace alidade {

namespace {

constexpr std::string_view ofOneMeasurement[] = {"title",
                                                 "notes",
                                                 "measured_on",
                                                 "report.number",
                                                 "device.serial",
                                                 "device.condition",
                                                 "device.received_on",
                                                 "environment.temperature_c",
                                                 "environment.sigma_temperature_c",
                                                 "geometry.distance_mm",
                                                 "geometry.sigma_distance_mm",
                                                 "acceptance.reference_intersection_mm",
                                                 "acceptance.sigma_reference_mm"};

}  // namespace

Session nextSession(const Session& session) {
  Session next = blankSession();
  for (const SessionField& field : sessionFields())
    if (std::ranges::find(ofOneMeasurement, field.key) == std::end(ofOneMeasurement))
      field.at(next) = field.get(session);
  next.instrument.record = session.instrument.record;
  next.instrument.known = session.instrument.known;
  next.protocol = session.protocol;
  return next;
}

}  // namespace alidade
