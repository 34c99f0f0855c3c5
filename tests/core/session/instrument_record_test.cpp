#include "core/session/instrument_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace alidade {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

Json completeRecord() {
  return Json::parse(R"({
    "format": "alidade-instrument", "version": 1, "name": "T-1", "serial": "4711", "certificate": "K-7",
    "traceability": "PTB", "date": "2026-03-01", "sigma_horizontal_arcsec": 1.5, "sigma_vertical_arcsec": 2,
    "sigma_zero_arcsec": 1,
    "known": [{"effect": "collimation", "value": 3.2, "sigma": 0.5, "unit": "arcsec", "from": "check", "date": "2026-02-27"},
              {"effect": "horizontal_circle_eccentricity", "parameter": "sine", "sigma": 1, "unit": "arcsec"}]})");
}

std::string sayingOf(const Json& json) {
  const Result<InstrumentRecord> record = readInstrumentRecord(json.dump());
  return record ? "accepted" : record.problem().text();
}

std::string sayingWith(const char* pointer, const Json& value) {
  Json json = completeRecord();
  json[Json::json_pointer(pointer)] = value;
  return sayingOf(json);
}

TEST(InstrumentRecord, KeepsEveryTextAndNumber) {
  const InstrumentRecord record = *readInstrumentRecord(completeRecord().dump());
  EXPECT_EQ(record.name, "T-1");
  EXPECT_EQ(record.serial, "4711");
  EXPECT_EQ(record.certificate, "K-7");
  EXPECT_EQ(record.traceability, "PTB");
  EXPECT_EQ(record.date, "2026-03-01");
  EXPECT_EQ(record.sigmaHorizontalArcsec, "1.5");
  EXPECT_EQ(record.sigmaVerticalArcsec, "2");
  EXPECT_EQ(record.sigmaZeroArcsec, "1");
  EXPECT_EQ(record.known,
            (std::vector<KnownSize>{{"collimation", "", "3.2", "0.5", "arcsec", "check", "2026-02-27"},
                                    {"horizontal_circle_eccentricity", "sine", "", "1", "arcsec", "", ""}}));
}

TEST(InstrumentRecord, LosesNothingOfUnknownKeysAtEveryLevel) {
  Json json = completeRecord();
  for (const char* level : {"", "/known/0", "/known/1"})
    json[Json::json_pointer(std::string(level) + "/x-unknown")] = {{"deep", {1, 2.5, nullptr}}};
  EXPECT_EQ(Json::parse(writeInstrumentRecord(*readInstrumentRecord(json.dump()))).dump(), json.dump());
}

TEST(InstrumentRecord, IsWrittenFromScratch) {
  const InstrumentRecord record{.serial = "1", .date = "2026-03-01"};
  EXPECT_EQ(Json::parse(writeInstrumentRecord(record)).dump(),
            R"({"format":"alidade-instrument","version":1,"serial":"1","date":"2026-03-01"})");
  const InstrumentRecord whole = *readInstrumentRecord(completeRecord().dump());
  InstrumentRecord copy = whole;
  copy.origin = {};
  for (KnownSize& size : copy.known) size.origin = {};
  EXPECT_EQ(*readInstrumentRecord(writeInstrumentRecord(copy)), whole);
}

TEST(InstrumentRecord, NamesWhatIsNoRecordAtAll) {
  EXPECT_EQ(sayingWith("/format", "alidade-session"),
            "format: “alidade-session” is not \"alidade-instrument\": choose an instrument record");
  EXPECT_THAT(sayingOf(Json::object()), HasSubstr("format: is missing, so this is no instrument record"));
  EXPECT_THAT(sayingWith("/version", 2), HasSubstr("version: 2 is newer"));
  EXPECT_EQ(sayingWith("/version", 0), "version: 0 is no version of an instrument record: it must be 1");
  EXPECT_THAT(sayingOf(Json::array()), HasSubstr("must be an object in braces, not a list"));
  EXPECT_THAT(readInstrumentRecord("").problem().text(), HasSubstr("is empty"));
}

TEST(InstrumentRecord, NamesEveryEntryThatMeansNothing) {
  EXPECT_EQ(sayingWith("/date", "March"),
            "date: “March” is no date: type year-month-day, such as 2018-01-31");
  EXPECT_THAT(sayingWith("/date", ""), HasSubstr("date: is empty"));
  EXPECT_THAT(sayingWith("/date", 2026), HasSubstr("date: must be a text"));
  EXPECT_THAT(sayingWith("/sigma_horizontal_arcsec", 0),
              HasSubstr("sigma_horizontal_arcsec: “0” is out of range"));
  EXPECT_THAT(sayingWith("/sigma_zero_arcsec", "abc"), HasSubstr("sigma_zero_arcsec: “abc”"));
  EXPECT_THAT(sayingWith("/known", 7), HasSubstr("known: must be a list"));
  EXPECT_THAT(sayingWith("/known/1", 7), HasSubstr("known[1]: must be an object"));
  EXPECT_THAT(sayingWith("/known/1/sigma", 0), HasSubstr("known[1].sigma: “0” is out of range"));
  EXPECT_THAT(sayingWith("/known/1/value", 1e7), HasSubstr("known[1].value: “10000000” is out of range"));
  EXPECT_THAT(sayingWith("/known/1/effect", ""), HasSubstr("known[1].effect: is empty"));
  EXPECT_THAT(sayingWith("/known/0/date", "2026-02-30"), HasSubstr("known[0].date: “2026-02-30” is no date"));
  Json json = completeRecord();
  json.erase("date");
  EXPECT_THAT(sayingOf(json), HasSubstr("date: is missing: add the day"));
  json = completeRecord();
  json["known"][1].erase("sigma");
  EXPECT_THAT(sayingOf(json), HasSubstr("known[1].sigma: is empty"));
}

TEST(InstrumentRecord, NamesAFileThatCannotBeOpened) {
  EXPECT_FALSE(loadInstrumentRecord("/nowhere/t.alidade-instrument").problem().text().empty());
}

}  // namespace
}  // namespace alidade
