#include "core/series/history/record_history.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/series/history/history_json.h"
#include "core/series/history/history_statement.h"

namespace alidade {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

KeptRecord kept(const std::string& month, const KnownSize& size) {
  InstrumentRecord record{.name = "T", .serial = "1", .date = "2024-" + month + "-01"};
  record.known = {size};
  return {month + ".alidade-instrument", record};
}

TEST(RecordHistory, PoolsOnlyConstantsInTheUnitOfTheCatalogue) {
  const InstrumentHistories histories = instrumentHistories(
      {kept("01", {.effect = "collimation", .value = "0.001", .sigma = "0.0001", .unit = "deg"}),
       kept("02", {.effect = "collimation", .value = "3", .sigma = "0.5", .unit = "arcsec"}),
       kept("03", {.effect = "collimation",
                   .parameter = "collimation",
                   .value = "3.2",
                   .sigma = "0.5",
                   .unit = "arcsec"}),
       kept("04", {.effect = "collimation", .value = "9.9", .sigma = "0.5", .unit = "mgon"})});
  ASSERT_THAT(histories.instruments, SizeIs(1));
  const InstrumentHistory& instrument = histories.instruments.front();
  EXPECT_THAT(instrument.records, SizeIs(4));
  ASSERT_THAT(instrument.quantities, SizeIs(1));
  EXPECT_EQ(instrument.quantities.front().id, "collimation");
  EXPECT_THAT(instrument.quantities.front().history.values, SizeIs(2));
  EXPECT_NEAR(instrument.quantities.front().history.mean.value, 3.1, 1e-12);
  EXPECT_THAT(instrument.leftOut,
              ElementsAre("01.alidade-instrument states collimation in the unit “deg”, not in “arcsec”: the "
                          "value is left out until it is converted.",
                          HasSubstr("04.alidade-instrument states collimation in the unit “mgon”")));
  EXPECT_EQ(recordTable(instrument, "2025-01-01").sentences, instrument.leftOut);
  EXPECT_EQ(nlohmann::json::parse(historyJson("h", histories, {}))["remarks"], instrument.leftOut);
}

TEST(RecordHistory, PoolsAnEffectOfTheUserInOneUnit) {
  const InstrumentHistories histories =
      instrumentHistories({kept("01", {.effect = "dent", .value = "3", .sigma = "0.5", .unit = "mm"}),
                           kept("02", {.effect = "dent", .value = "4", .sigma = "0.5", .unit = "arcsec"}),
                           kept("03", {.effect = "dent", .value = "3", .sigma = "0.5", .unit = "mm"})});
  const InstrumentHistory& instrument = histories.instruments.front();
  EXPECT_THAT(instrument.quantities.front().history.values, SizeIs(2));
  EXPECT_THAT(instrument.leftOut, SizeIs(1));
}

}  // namespace
}  // namespace alidade
