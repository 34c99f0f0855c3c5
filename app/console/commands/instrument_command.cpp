#include "app/console/commands/instrument_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/console/channels.h"
#include "app/console/commands/option_checks.h"
#include "app/console/format_texts.h"
#include "app/console/instrument_text.h"
#include "app/console/output_file.h"
#include "core/base/clock.h"
#include "core/base/file_bytes.h"
#include "core/base/visible_text.h"
#include "core/series/instrument_check/check_files.h"
#include "core/series/instrument_check/check_findings.h"
#include "core/series/instrument_check/check_record.h"
#include "core/series/instrument_check/instrument_check.h"
#include "core/series/instrument_check/instrument_json.h"

namespace alidade::console {

namespace {

constexpr const char* aboutInstrumentFiles =
    "The first row of a table names the columns: horizontal, vertical and target, and perhaps station, "
    "round,\n"
    "face and distance (m). A file is a station unless it names stations, in GSI by a code block STATION 5,\n"
    "word 16 or a block with 84-86 or 88. Rounds follow from targets that come again. --sigma is what is\n"
    "stated of a direction and a zenith angle observed once in both faces, as in a data sheet after\n"
    "ISO 17123-3.";

/// The name of a file in sentences.
std::string checkFileName(const std::string& file) {
  return file == "-" ? inputName(file) : wellFormed(std::filesystem::path(file).filename().string());
}

/// Writes the record unless it is empty. Without a stated day of the check, the record has today's date.
std::optional<Problem> writeRecord(const InstrumentRequest& request, CheckIdentity identity,
                                   std::vector<std::string>& remarks, const InstrumentCheck& check) {
  if (identity.measuredOn.empty()) {
    identity.measuredOn = localDay();
    remarks.push_back("the files do not say the day of the readings: the record is of today, " +
                      identity.measuredOn + "; --date states another day");
    if (const auto again = identityOf(identity, {}); !again) return again.problem();
  }
  const InstrumentRecord record = checkedRecord(check, identity);
  if (record.known.empty() && record.sigmaHorizontalArcsec.empty() && record.sigmaVerticalArcsec.empty())
    return Problem{"--record: no figure of this check has an uncertainty: observe three rounds or more"};
  return writeOutputs({{"--record", request.record, writeInstrumentRecord(record)}}, request.files);
}

}  // namespace

void addInstrumentCommand(CLI::App& app, InstrumentRequest& request) {
  CLI::App* instrument = app.add_subcommand(
      "instrument",
      "Field check of a theodolite after ISO 17123-3, from rounds in two faces to several targets.");
  instrument
      ->add_option("FILE", request.files,
                   "Files of readings, of instruments or tables; - reads standard input")
      ->required();
  constexpr double leastSigma = 1e-6, mostSigma = 3600;
  instrument->add_option("--sigma", request.sigma, "Stated σ that s is tested against, arcsec")
      ->check(numberFrom(leastSigma, mostSigma));
  instrument
      ->add_option("--sigma-vertical", request.sigmaVertical, "That of a zenith angle, where it is another")
      ->check(numberFrom(leastSigma, mostSigma));
  instrument
      ->add_option(
          "--unit", request.unit,
          "Unit of plain numbers in a table: deg, gon, or dms (341.5224 is 341°52'24\"); else what lets "
          "both faces add up to a full turn")
      ->check(CLI::IsMember({"deg", "gon", "dms"}));
  instrument->add_option("--vertical-circle", request.verticalCircle, "zenith or elevation; else as read")
      ->check(CLI::IsMember({"zenith", "elevation"}));
  instrument->add_option(
      "--record", request.record,
      "Instrument record to write (*.alidade-instrument), for sessions to take: σ, collimation, "
      "index, tilt, offset of the line of sight");
  instrument->add_option("--name", request.identity.name,
                         "Name of the instrument; else as the files have it");
  instrument->add_option("--serial", request.identity.serial, "Its serial number, likewise");
  instrument->add_option("--date", request.identity.measuredOn, "Day of the check, year-month-day, likewise");
  instrument->add_option("--due", request.identity.due, "Day on which the next check is due");
  instrument->add_flag("--json", request.json, "Print one JSON document");
  instrument->footer(readableFormatsSentence() + aboutInstrumentFiles);
}

Result<InstrumentAnswer> runInstrument(const InstrumentRequest& request) {
  std::vector<std::string> bytes;
  for (const std::string& file : request.files) {
    Result<std::string> content = file == "-" ? readStandardInput() : readFile(file);
    if (!content)
      return request.files.size() == 1 ? content.problem()
                                       : Problem{quotation(inputName(file)) + " " + content.problem().what};
    bytes.push_back(*std::move(content));
  }
  std::vector<CheckFile> files;
  for (std::size_t i = 0; i < bytes.size(); ++i) files.push_back({checkFileName(request.files[i]), bytes[i]});
  Result<CheckReadings> read =
      readCheckFiles(files, {.unit = angleUnitNamed(request.unit), .verticalCircle = request.verticalCircle});
  if (!read) return read.problem();
  CheckReadings readings = *std::move(read);
  const Result<InstrumentCheck> check = checkReadings(
      readings, {.sigmaDirection = request.sigma,
                 .sigmaVertical = request.sigmaVertical ? request.sigmaVertical : request.sigma});
  if (!check) return check.problem();
  const Result<CheckIdentity> identity = identityOf(request.identity, readings.identity);
  if (!identity) return identity.problem();
  if (!request.record.empty())
    if (auto problem = writeRecord(request, *identity, readings.remarks, *check)) return *std::move(problem);
  const std::vector<Finding> findings = checkFindings(*check);
  std::string name = files.front().name;
  if (!identity->name.empty()) name = identity->name;
  if (!identity->serial.empty()) name += ", " + identity->serial;
  return InstrumentAnswer{request.json ? instrumentJson(*identity, *check, findings, readings.remarks)
                                       : instrumentText(name, *identity, *check, findings),
                          readings.remarks};
}

}  // namespace alidade::console
