#include "app/console/commands/import_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/console/channels.h"
#include "app/console/commands/option_checks.h"
#include "app/console/format_texts.h"
#include "app/console/output_file.h"
#include "app/console/session_input.h"
#include "core/base/clock.h"
#include "core/base/file_bytes.h"
#include "core/base/file_target.h"
#include "core/base/list_text.h"
#include "core/base/sha256.h"
#include "core/base/visible_text.h"
#include "core/exchange/import.h"
#include "core/exchange/recognise.h"
#include "core/exchange/text_lines.h"
#include "core/session/measurement.h"
#include "core/session/row_fields.h"
#include "core/session/session_file.h"

namespace alidade::console {

namespace {

constexpr const char* aboutMarks =
    "How the file of an instrument states more than angles, in GSI by code blocks, in M5 and R4/R5 by texts, "
    "in\n"
    "SDR, JobXML and LandXML by notes:  0 or 180 (or AXIS0, AXIS180) is the position of the axis for what "
    "follows, ROUND2 the round;\n"
    "point 0 or ZERO, or what follows ZERO, is the pointing zero. A CSV table begins with the names of its "
    "columns:\n";

constexpr const char* aboutCsv =
    "horizontal and vertical are needed, point ZERO is the pointing zero. A unit in a name, such as Hz "
    "[gon],\n"
    "holds for the plain numbers below it. What the session then still lacks is reported on stderr and can "
    "be\n"
    "typed in the window.";

std::string about() {
  std::string columns = "axis";
  for (const RowField& field : rowFields) columns += ", " + std::string(field.key);
  return readableFormatsSentence() + "The content decides which.\n" + aboutMarks + columns + ";\n" + aboutCsv;
}

/// Writes the value of an option into its field of the session.
std::optional<Problem> setNumber(const char* option, const char* field, const std::string& given,
                                 std::string& text) {
  if (given.empty()) return std::nullopt;
  if (const auto value = numberEntry(field, given); !value)
    return Problem{std::string(option) + ": " + value.problem().what};
  text = given;
  return std::nullopt;
}

std::optional<Problem> checkZero(const char* option, const PointingZero& zero, VerticalCircle circle) {
  for (const auto& [rule, text] :
       {std::pair(horizontalRule, zero.horizontal), std::pair(verticalRule, zero.vertical)})
    if (const auto angle = angleEntry(rule, text, circle); !angle)
      return Problem{std::string(option) + ": " + angle.problem().what};
  return std::nullopt;
}

std::vector<Position>::iterator firstAt(int axis, Session& session) {
  return std::ranges::find_if(session.positions, [axis](const Position& position) {
    const Result<int> has = axisEntry(position.axisDeg);
    return has && *has == axis;
  });
}

/// Sets the pointing zero of the first position at `axis`. Checks the vertical reading against the range of
/// elevations, which is the wider one: a column name may still state the kind of circle.
std::optional<Problem> setZero(const char* option, const std::vector<std::string>& given, AngleUnit unit,
                               int axis, Session& session) {
  if (given.empty()) return std::nullopt;
  const auto found = firstAt(axis, session);
  if (found == session.positions.end())
    return Problem{std::string(option) + ": the session has no position at " + std::to_string(axis) + "°"};
  PointingZero& zero = found->zero;
  zero.horizontal = withUnit(given.at(0), unit);
  zero.vertical = withUnit(given.at(1), unit);
  return checkZero(option, zero, VerticalCircle::Elevation);
}

/// Checks the given zeros against the range of the session's circle.
std::optional<Problem> checkZeros(const ImportRequest& request, const ImportOptions& options,
                                  const Session& session) {
  const auto circle = verticalCircleEntry(session.geometry.verticalCircle);
  if (!circle) return std::nullopt;
  Session base = options.base;
  std::optional<Problem> problem;
  if (!request.zero0.empty()) problem = checkZero("--zero-0", firstAt(0, base)->zero, *circle);
  if (!problem && !request.zero180.empty())
    problem = checkZero("--zero-180", firstAt(180, base)->zero, *circle);
  return problem;
}

Result<std::string> readBytes(const std::string& file) {
  return file == "-" ? readStandardInput() : readFile(file);
}

std::string nameOf(const std::string& file) {
  return file == "-" ? "standard input" : std::filesystem::path(file).filename().string();
}

/// The entry for one file; empty if the option is not given or the entry is `-`.
Result<std::string> entryFor(const char* option, const std::vector<std::string>& entries, std::size_t file,
                             std::size_t files) {
  if (entries.empty()) return std::string();
  if (entries.size() != files)
    return Problem{std::string(option) + ": give one for each of the " + counted(files, "file") +
                   ", - where the file says it"};
  return entries[file] == "-" ? std::string() : entries[file];
}

/// The table layout from the options; absent if no option of the layout is given.
std::optional<TableLayout> layoutOf(const ImportRequest& request, std::string_view bytes) {
  if (request.columns.empty() && !request.headRows && request.decimalSign.empty()) return std::nullopt;
  TableLayout layout;
  const Result<std::string> text = readingsText(bytes);
  if (const auto recognised = text ? recognise(*text) : Result<Recognised>(text.problem())) {
    layout.separator = recognised->table.separator;
    layout.headRows = recognised->table.headRows;
  }
  if (request.headRows) layout.headRows = *request.headRows;
  for (const std::string& column : request.columns) layout.columns.push_back(column == "-" ? "" : column);
  if (request.decimalSign == "point") layout.decimalSign = DecimalSign::Point;
  if (request.decimalSign == "comma") layout.decimalSign = DecimalSign::Comma;
  layout.unit = angleUnitNamed(request.unit);
  return layout;
}

/// The files to import. They refer to `bytes`, which must outlive them.
Result<std::vector<ReadingsFile>> filesOf(const ImportRequest& request,
                                          const std::vector<std::string>& bytes) {
  std::vector<ReadingsFile> files;
  const std::size_t count = request.files.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Result<std::string> axis = entryFor("--axis", request.axes, i, count),
                              round = entryFor("--round", request.rounds, i, count);
    if (!axis) return axis.problem();
    if (!round) return round.problem();
    files.push_back(
        {.name = nameOf(request.files[i]),
         .bytes = bytes[i],
         .axis = *axis,
         .round = *round,
         .turnedAtLine = request.turnedAtLine > 0 ? std::optional(request.turnedAtLine) : std::nullopt,
         .table = layoutOf(request, bytes[i])});
  }
  return files;
}

Result<std::vector<std::string>> readAll(const std::vector<std::string>& files) {
  std::vector<std::string> bytes;
  for (const std::string& file : files) {
    Result<std::string> read = readBytes(file);
    if (!read)
      return files.size() == 1 ? read.problem() : Problem{quotation(file) + " " + read.problem().what};
    bytes.push_back(*std::move(read));
  }
  return bytes;
}

/// Enters the origin of the session's rows into the journal.
void enterOrigins(Session& session, const Import& import, const std::vector<ReadingsFile>& files) {
  const std::string at = timeInUtc();
  std::vector<ImportedFile> read;
  for (const ReadingsFile& file : files) read.push_back({file.name, sha256(file.bytes)});
  for (JournalEntry& entry : importEntries(import, read)) {
    entry.at = at;
    entry.by = session.operatorName;
    enterInJournal(session.journal, std::move(entry));
  }
}

std::string listOf(const Session& session) {
  std::string list;
  for (const Position& position : session.positions)
    list += (list.empty() ? "" : ", ") + std::to_string(position.readings.size()) + " at " +
            position.axisDeg + "°";
  return list;
}

std::string roundCheck(const std::string& entry) {
  return entry == "-" ? std::string() : wholeFrom(1, 1'000'000'000)(entry);
}

std::string columnCheck(const std::string& key) {
  return key == "-" || tableColumn(key) ? std::string() : quotation(key) + " is no column of readings";
}

}  // namespace

void addImportCommand(CLI::App& app, ImportRequest& request) {
  CLI::App* import = app.add_subcommand(
      "import", "A session from files of readings: " + formatNames() + " or tables (CSV).");
  import->add_option("FILE", request.files, "Files to read, in the order taken; - reads standard input")
      ->required();
  import->add_option("--out", request.out, "Session file to write (*.alidade)")->required();
  import->add_option("--add-to", request.addTo, "Session whose readings they are added to");
  import->add_option("--title", request.title, "Title of the session; else the file's name")
      ->check(textCheck());
  import->add_option("--distance", request.distance, "Theodolite to arc plane, mm");
  import->add_option("--sigma-distance", request.sigmaDistance, "Its σ, mm");
  import->add_option("--radius", request.radius, "Nominal radius of the arc, mm");
  import->add_option("--tolerance", request.tolerance, "Of the intersection, mm");
  import->add_option("--sigma", request.sigma, "σ of both circles and of the zeros, arcsec; else 2");
  import->add_option("--zero-0", request.zero0, "Pointing zero at 0°: horizontal and vertical reading")
      ->expected(2)
      ->type_name("H V");
  import->add_option("--zero-180", request.zero180, "Pointing zero at 180°")->expected(2)->type_name("H V");
  import->add_option("--zero-point", request.zeroPoint, "Name of the point that is the pointing zero");
  import
      ->add_option("--turned-at", request.turnedAtLine,
                   "Line from which on the axis stood at 180°, where the file does not say")
      ->check(wholeFrom(1, 1'000'000'000));
  import
      ->add_option("--axis", request.axes,
                   "Position of the axis of each FILE, 0 or 180, parted by commas; - as it says")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"0", "180", "-"}));
  import->add_option("--round", request.rounds, "Round of each FILE, parted by commas; - as it says")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(roundCheck);
  import->add_option("--columns", request.columns, "What the columns of a table hold, in turn; - for nothing")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(columnCheck);
  import->add_option("--head-rows", request.headRows, "Rows of a table before its readings")
      ->check(wholeFrom(0, 1000));
  import->add_option("--decimal", request.decimalSign, "Decimal sign of a table: point or comma; else either")
      ->check(CLI::IsMember({"point", "comma"}));
  import
      ->add_option("--unit", request.unit,
                   "Unit of plain numbers in a table: deg, gon, or dms (341.5224 is 341°52'24\")")
      ->check(CLI::IsMember({"deg", "gon", "dms"}));
  import->add_option("--vertical-circle", request.verticalCircle, "zenith or elevation; else zenith")
      ->check(CLI::IsMember({"zenith", "elevation"}));
  import->footer(about());
}

Result<ImportOptions> importOptions(const ImportRequest& request) {
  std::vector<std::string> read = request.files;
  if (!request.addTo.empty()) read.push_back(request.addTo);
  for (const std::string& file : read)
    if (isSameFile(file, request.out))
      return Problem{"--out names the file that is read: give the session a file of its own"};
  ImportOptions options;
  if (!request.addTo.empty()) {
    const Result<SessionRead> base = readSessionOf(request.addTo);
    if (!base) return Problem{"--add-to: " + base.problem().text()};
    options.base = base->session;
  }
  options.unit = angleUnitNamed(request.unit);
  options.zeroPoint = request.zeroPoint;
  Session& base = options.base;
  if (!request.title.empty()) base.title = request.title;
  if (!request.verticalCircle.empty()) base.geometry.verticalCircle = request.verticalCircle;
  Geometry& geometry = base.geometry;
  Instrument& instrument = base.instrument;
  for (const auto& problem : {
           setNumber("--distance", "geometry.distance_mm", request.distance, geometry.distanceMm),
           setNumber("--sigma-distance", "geometry.sigma_distance_mm", request.sigmaDistance,
                     geometry.sigmaDistanceMm),
           setNumber("--radius", "geometry.radius_mm", request.radius, geometry.radiusMm),
           setNumber("--tolerance", "acceptance.tolerance_mm", request.tolerance,
                     base.acceptance.toleranceMm),
           setNumber("--sigma", "instrument.sigma_horizontal_arcsec", request.sigma,
                     instrument.sigmaHorizontalArcsec),
           setNumber("--sigma", "instrument.sigma_vertical_arcsec", request.sigma,
                     instrument.sigmaVerticalArcsec),
           setNumber("--sigma", "instrument.sigma_zero_arcsec", request.sigma, instrument.sigmaZeroArcsec),
           setZero("--zero-0", request.zero0, options.unit, 0, base),
           setZero("--zero-180", request.zero180, options.unit, 180, base),
       })
    if (problem) return *problem;
  return options;
}

Result<ImportAnswer> runImport(const ImportRequest& request, const ImportOptions& options) {
  const Result<std::vector<std::string>> bytes = readAll(request.files);
  if (!bytes) return bytes.problem();
  const Result<std::vector<ReadingsFile>> files = filesOf(request, *bytes);
  if (!files) return files.problem();
  Result<Import> read = importReadings(*files, options);
  if (!read) return read.problem();
  Import import = *std::move(read);
  if (const auto& problems = import.problems; !problems.empty()) {
    const std::string more =
        problems.size() > 1 ? " (and " + std::to_string(problems.size() - 1) + " more)" : "";
    return Problem{problems.front().text() + more};
  }
  if (!import.missingZeroPoint.empty()) return Problem{import.missingZeroPoint};
  if (auto problem = checkZeros(request, options, import.session)) return *std::move(problem);
  Session& session = import.session;
  const std::string& first = request.files.front();
  if (session.title.empty() && first != "-")
    session.title = wellFormed(std::filesystem::path(first).stem().string());
  enterOrigins(session, import, *files);
  std::vector<std::string> inputs = request.files;
  inputs.push_back(request.addTo);
  if (auto problem = writeOutputs({{"--out", request.out, writeSession(session)}}, inputs))
    return *std::move(problem);

  ImportAnswer answer;
  answer.result = visibleText(request.out) + ": " + counted(import.rows, "row") + " from " + import.format +
                  " (" + listOf(session) + ")\n";
  answer.remarks = import.remarks;
  for (const Problem& problem : examine(session).problems)
    answer.remarks.push_back("still to be typed or mended: " + problem.text());
  return answer;
}

}  // namespace alidade::console
