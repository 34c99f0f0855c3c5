#include <cmath>
#include <nlohmann/json.hpp>

#include "app/console/history_text.h"
#include "app/console/instrument_text.h"
#include "core/base/utf8.h"
#include "core/series/history/history_json.h"
#include "core/series/instrument_check/check_files.h"
#include "core/series/instrument_check/check_findings.h"
#include "core/series/instrument_check/instrument_json.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/targets.h"

namespace alidade::fuzz {

namespace {

const std::string fuzzedFile = "fuzzed";

void requireAnswer(const std::string& text, const std::string& json) {
  require(!text.empty() && !firstIllFormedByte(text), "an answer that is no text");
  require(nlohmann::json::accept(json), "JSON that is none");
}

void requireChance(double chance, const char* what) {
  require(std::isnan(chance) || (chance >= 0 && chance <= 1 + 1e-12), what);
}

void overTime(std::string_view bytes) {
  const Result<ValueTable> table = readValueTable(bytes);
  if (!table) return require(!table.problem().what.empty(), "a table refused without words");
  for (const DatedValue& value : table->values)
    require(std::isfinite(value.value) && std::isfinite(value.day) && value.u > 0, "a value that is none");
  const History history = historyOf(table->values);
  require(history.values.size() == table->values.size(), "a value is lost");
  require(std::isfinite(history.mean.value) && history.mean.u >= 0, "a mean that is no number");
  if (history.chance) requireChance(*history.chance, "a chance beyond 1");
  double sum = 0;
  for (const CourseProbability& course : history.courses) {
    requireChance(course.probability, "an account beyond 1");
    sum += course.probability;
  }
  constexpr double rounding = 1e-9;
  require(history.courses.empty() || std::abs(sum - 1) < rounding, "accounts that are not all there are");
  requireAnswer(console::historyText(fuzzedFile, *table, history), historyJson(fuzzedFile, *table, history));
}

void fieldCheck(std::string_view bytes, const CheckFileOptions& options) {
  const auto readings = readCheckFiles({{fuzzedFile, bytes}}, options);
  if (!readings) return require(!readings.problem().what.empty(), "a check refused without words");
  const InstrumentCheck check =
      checkInstrument(completeRounds(*readings), {.sigmaDirection = 1, .sigmaVertical = 1});
  for (const auto& test : {check.directionTest, check.verticalTest})
    if (test) requireChance(test->pValue, "a test beyond 1");
  const std::vector<Finding> findings = checkFindings(check);
  for (const Finding& finding : findings) require(!finding.text.empty(), "a finding without words");
  requireAnswer(console::instrumentText(fuzzedFile, readings->identity, check, findings),
                instrumentJson(readings->identity, check, findings, readings->remarks));
  require(!firstIllFormedByte(instrumentCsv(readings->identity, check)), "a table that is no text");
}

}  // namespace

void throwValues(std::string_view bytes) {
  overTime(bytes);
  fieldCheck(bytes, {});
  fieldCheck(bytes, {.unit = AngleUnit::Dms, .verticalCircle = "elevation"});
}

}  // namespace alidade::fuzz
