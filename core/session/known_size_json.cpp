#include "core/session/known_size_json.h"

#include <nlohmann/json.hpp>

namespace alidade {

namespace {

KnownSize readKnownSize(const ObjectReader& reader) {
  return {.effect = reader.text("effect"),
          .parameter = reader.text("parameter"),
          .value = reader.number("value"),
          .sigma = reader.number("sigma"),
          .unit = reader.text("unit"),
          .from = reader.text("from"),
          .date = reader.text("date"),
          .origin = reader.origin()};
}

}  // namespace

std::vector<KnownSize> readKnown(const ObjectReader& reader) {
  std::vector<KnownSize> known;
  for (const nlohmann::ordered_json& entry : reader.list("known"))
    known.push_back(readKnownSize(reader.member("known", known.size(), entry)));
  return known;
}

nlohmann::ordered_json knownJson(const std::vector<KnownSize>& known) {
  nlohmann::ordered_json entries = nlohmann::ordered_json::array();
  for (const KnownSize& size : known) {
    ObjectWriter writer(size.origin);
    writer.text("effect", size.effect);
    writer.text("parameter", size.parameter);
    writer.number("value", size.value);
    writer.number("sigma", size.sigma);
    writer.text("unit", size.unit);
    writer.text("from", size.from);
    writer.text("date", size.date);
    entries.push_back(writer.take());
  }
  return entries;
}

LineOfSight readLineOfSight(const ObjectReader& reader) {
  return {.offsetMm = reader.number("line_of_sight_mm"),
          .sigmaMm = reader.number("sigma_line_of_sight_mm"),
          .correlation = reader.number("line_of_sight_correlation")};
}

void writeLineOfSight(ObjectWriter& writer, const LineOfSight& lineOfSight) {
  writer.number("line_of_sight_mm", lineOfSight.offsetMm);
  writer.number("sigma_line_of_sight_mm", lineOfSight.sigmaMm);
  writer.number("line_of_sight_correlation", lineOfSight.correlation);
}

}  // namespace alidade
