#include "core/session/instrument_record.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/base/file_bytes.h"
#include "core/base/phrase.h"
#include "core/session/entry.h"
#include "core/session/json_object_reader.h"
#include "core/session/json_object_writer.h"
#include "core/session/json_text.h"
#include "core/session/known_size_json.h"

namespace alidade {

namespace {

constexpr JsonFormat recordFormat = {
    "alidade-instrument",
    PHRASE_LATER(
        "Phrase",
        "is missing, so this is no instrument record: choose a file with \"format\": \"alidade-instrument\""),
    PHRASE_LATER("Phrase", "choose an instrument record"),
    PHRASE_LATER("Phrase", "%1 is no version of an instrument record: it must be %2")};

InstrumentRecord recordFrom(const ObjectReader& reader) {
  return {.name = reader.text("name"),
          .serial = reader.text("serial"),
          .certificate = reader.text("certificate"),
          .traceability = reader.text("traceability"),
          .date = reader.text("date"),
          .due = reader.text("next_check_due"),
          .verticalCircle = reader.text("vertical_circle"),
          .sigmaHorizontalArcsec = reader.number("sigma_horizontal_arcsec"),
          .sigmaVerticalArcsec = reader.number("sigma_vertical_arcsec"),
          .sigmaZeroArcsec = reader.number("sigma_zero_arcsec"),
          .lineOfSight = readLineOfSight(reader),
          .known = readKnown(reader),
          .origin = reader.origin({"known"})};
}

/// Examines the entries of a record and keeps the first problem.
class RecordExaminer {
 public:
  std::optional<Problem> examine(const InstrumentRecord& record) {
    number("sigma_horizontal_arcsec", record.sigmaHorizontalArcsec);
    number("sigma_vertical_arcsec", record.sigmaVerticalArcsec);
    number("sigma_zero_arcsec", record.sigmaZeroArcsec);
    number("line_of_sight_mm", record.lineOfSight.offsetMm);
    number("sigma_line_of_sight_mm", record.lineOfSight.sigmaMm);
    number("line_of_sight_correlation", record.lineOfSight.correlation);
    if (record.date.empty())
      report(Problem{Phrase::of("is empty: enter the day it was determined, as year-month-day")}, "date");
    date("date", record.date);
    date("next_check_due", record.due);
    if (!record.due.empty() && record.due <= record.date)
      report(Problem{Phrase::of("is not after the day of the check: correct one of the two")},
             "next_check_due");
    check(verticalCircleEntry(record.verticalCircle), "vertical_circle");
    for (std::size_t i = 0; i < record.known.size(); ++i)
      known("known[" + std::to_string(i) + "]", record.known[i]);
    return std::move(m_problem);
  }

 private:
  void known(const std::string& entry, const KnownSize& size) {
    if (size.effect.empty())
      report(Problem{Phrase::of("is empty: say which effect is known, such as collimation")},
             entry + ".effect");
    check(knownValueEntry(size.value), entry + ".value");
    check(knownSigmaEntry(size.sigma), entry + ".sigma");
    date(entry + ".date", size.date);
  }
  void number(const std::string& key, const std::string& text) {
    check(numberEntry("instrument." + key, text), key);
  }
  void date(const std::string& key, const std::string& text) {
    if (const auto problem = dateProblem(text)) report(*problem, key);
  }
  template <typename Value>
  void check(const Result<Value>& entry, const std::string& key) {
    if (!entry) report(entry.problem(), key);
  }
  void report(const Problem& problem, const std::string& key) {
    if (!m_problem) m_problem = Problem{problem.what, {.field = key}};
  }

  std::optional<Problem> m_problem;
};

}  // namespace

Result<InstrumentRecord> readInstrumentRecord(std::string_view text) {
  nlohmann::ordered_json json;
  if (auto problem = parseJson(text, json)) return *std::move(problem);
  std::optional<Problem> problem;
  const ObjectReader reader(json, {}, problem);
  reader.checkFormat(recordFormat);
  reader.require("date", PHRASE_LATER("Phrase", "add the day it was determined"));
  if (problem) return *problem;
  InstrumentRecord record = recordFrom(reader);
  if (!problem) problem = RecordExaminer().examine(record);
  if (problem) return *problem;
  return record;
}

std::string writeInstrumentRecord(const InstrumentRecord& record) {
  ObjectWriter writer(record.origin);
  writer.constant("format", recordFormat.id);
  writer.constant("version", 1);
  writer.text("name", record.name);
  writer.text("serial", record.serial);
  writer.text("certificate", record.certificate);
  writer.text("traceability", record.traceability);
  writer.set("date", record.date, ValueKind::Text, Presence::Required);
  writer.text("next_check_due", record.due);
  writer.text("vertical_circle", record.verticalCircle);
  writer.number("sigma_horizontal_arcsec", record.sigmaHorizontalArcsec);
  writer.number("sigma_vertical_arcsec", record.sigmaVerticalArcsec);
  writer.number("sigma_zero_arcsec", record.sigmaZeroArcsec);
  writeLineOfSight(writer, record.lineOfSight);
  writer.part("known", knownJson(record.known));
  return layoutJson(writer.take());
}

Result<InstrumentRecord> loadInstrumentRecord(const std::string& path) {
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.problem();
  return readInstrumentRecord(*bytes);
}

}  // namespace alidade
